#pragma once

#include <QLineEdit>
#include <optional>

namespace talus {

/// A number with its unit that can be typed over. Red, and not committed, when it is none.
class NumberField : public QLineEdit {
  Q_OBJECT
 public:
  /// Shows `value`, which the program keeps in SI, divided by `scale`: Pa as MPa with a scale of 1e6.
  NumberField(std::optional<double> value, double scale, const QString& unit);
  /// It may be left empty, which means this.
  void allowNone(const QString& meaning);
  /// Marks what was typed as impossible and says why; an empty sentence takes the mark away.
  void setProblem(const QString& sentence);

 signals:
  /// In SI, when the user has finished and the number has changed.
  void committed(double value);
  /// The user has taken the number away.
  void cleared();

 protected:
  void focusInEvent(QFocusEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void commit();
  void show();
  std::optional<double> value_;
  double scale_;
  QString unit_;
  bool mayBeEmpty_ = false;
};

}  // namespace talus
