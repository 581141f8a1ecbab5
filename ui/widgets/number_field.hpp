#pragma once

#include <QLineEdit>

namespace talus {

/// A number with its unit that can be typed over. Red, and not committed, when it is none.
class NumberField : public QLineEdit {
  Q_OBJECT
 public:
  /// Shows `value`, which the program keeps in SI, divided by `scale`: Pa as MPa with a scale of 1e6.
  NumberField(double value, double scale, const QString& unit);
  /// Marks what was typed as impossible and says why; an empty sentence takes the mark away.
  void setProblem(const QString& sentence);

 signals:
  /// In SI, when the user has finished and the number has changed.
  void committed(double value);

 protected:
  void focusInEvent(QFocusEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void commit();
  void show();
  double value_, scale_;
  QString unit_;
};

}  // namespace talus
