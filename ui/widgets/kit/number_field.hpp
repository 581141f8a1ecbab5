#pragma once

#include <QLineEdit>
#include <optional>

namespace talus {

/// A number with its unit that can be typed over, also in another unit of the same kind: "50 kPa". Red, and not
/// committed, when it is none.
class NumberField : public QLineEdit {
  Q_OBJECT
 public:
  /// What the field is about: the unit that the program keeps, the one that is shown, and whether that stands behind
  /// the number.
  struct Units {
    QString kept, shown;
    bool behind = true;
  };
  NumberField(std::optional<double> value, Units units);
  /// It may be left empty, which means this.
  void allowNone(const QString& meaning);
  /// What its tooltip says while nothing is wrong.
  void setMeaning(const QString& sentence);
  /// Another value, from now on; no signal.
  void setValue(std::optional<double> value);
  /// Marks what was typed as impossible; an empty sentence takes the mark away.
  void setProblem(const QString& sentence);

 signals:
  /// In the unit that is kept, when the user has finished and the number has changed.
  void committed(double value);
  /// The user has taken the number away.
  void cleared();
  /// What was typed was given up: it shows the number from before again.
  void takenBack();
  /// Why what was typed is no number of this kind; empty once it is.
  void problemChanged(const QString& sentence);

 protected:
  bool event(QEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void commit();
  void show();
  void fitAnew();
  QString fitting() const;
  QString written(int figures) const;
  std::optional<double> value_;
  Units units_;
  QString meaning_;
  bool mayBeEmpty_ = false;
};

}  // namespace talus
