#pragma once

#include <vector>

#include "widgets/forms/field.hpp"

class QTableWidget;

namespace talus {

/// Rows of numbers: a time table with its curves, corners, faces. Typed into cells, or pasted from a spreadsheet.
class TableField : public FormField {
  Q_OBJECT
 public:
  explicit TableField(const FieldSite& site);

 private:
  struct Column {
    QString title, kept, shown;
  };

  void makeColumns();
  void makeTable();
  QWidget* makeTools();
  QWidget* makePlot() const;
  QString cellText(const Json& number, const Column& column) const;
  Json cellValue(const QString& typed, const Column& column) const;
  Json rowValue(const QStringList& cells) const;
  void commitCell(int row, int column);
  void paste();
  void addRow();
  void removeRow();

  Json rows_;
  bool oneCell_ = false;  ///< rows of any length, typed as one text
  std::vector<Column> columns_;
  QTableWidget* table_ = nullptr;
};

}  // namespace talus
