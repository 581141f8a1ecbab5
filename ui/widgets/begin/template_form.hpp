#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include "templates/templates.hpp"

class QLabel;

namespace talus {

class NumberField;

/// The numbers that a template asks for: each a field with its unit, its meaning and range below, and what is wrong
/// with it in place of these as soon as it is typed.
class TemplateForm : public QWidget {
  Q_OBJECT
 public:
  explicit TemplateForm(const ProjectTemplate& chosen);
  /// Every number is one that the template takes.
  bool isGood() const;
  /// The project of the numbers as they are typed; `isGood` holds.
  Project project() const;

 signals:
  void changed();

 private:
  struct Row {
    const TemplateNumber* number;
    NumberField* field;
    QLabel* note;
    double value;
    bool good = true;
  };
  void check(Row& row, const QString& typed);

  const ProjectTemplate& chosen_;
  std::vector<Row> rows_;
};

}  // namespace talus
