#pragma once

#include <vector>

#include "widgets/forms/field.hpp"
#include "widgets/kit/plot.hpp"

class QTableWidget;

namespace talus {

class CurveEditor;

/// Rows of numbers: a time table with its curves, corners, faces. Typed into cells, pasted from a spreadsheet, or, of a
/// time table, drawn.
class TableField : public FormField {
  Q_OBJECT
 public:
  TableField(const FieldSite& site, QWidget* parent);

 private:
  struct Column {
    QString title, kept, shown;
  };

  void makeColumns();
  void makeTable();
  QWidget* makeTools();
  QWidget* makePlot();
  std::vector<Curve> curves() const;
  /// The row with a point of its curve elsewhere, in units that are shown.
  Json movedRow(int row, int curve, double time, double value) const;
  void choosePoint(int row, int curve);
  QString cellText(const Json& number, const Column& column) const;
  Json cellValue(const QString& typed, const Column& column) const;
  Json rowValue(const QStringList& cells) const;
  void commitCell(int row, int column);
  void paste();
  void addRow();
  void insertRow(double time);
  void removeRow(int row);
  int presentRow() const;

  Json rows_;
  bool oneCell_ = false;  ///< rows of any length, typed as one text
  std::vector<Column> columns_;
  QTableWidget* table_ = nullptr;
  CurveEditor* plot_ = nullptr;  ///< of a time table
};

}  // namespace talus
