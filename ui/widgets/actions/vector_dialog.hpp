#pragma once

#include <QDialog>
#include <functional>
#include <optional>

#include "mesh/picked_face.hpp"

class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace talus {

class NumberField;

/// Asks how large something is that has a direction, and which way it goes: a force, a velocity. On a face it may be
/// said as a pressure, and across the face.
class VectorDialog : public QDialog {
  Q_OBJECT
 public:
  struct Question {
    QString title, about;  ///< "New load", "On block cube, at 1, 2, 3 m"
    QString kept, shown;   ///< units: "N", "kN"
    double preset = 0;     ///< in the unit that is kept
    std::optional<PickedFace> face{};
  };
  VectorDialog(Question question, QWidget* parent);
  /// In the unit that is kept.
  Vec3 vector() const;

 private:
  /// A row whose number goes into `value`.
  NumberField* addNumber(const QString& name, const QString& tip, double& value, const QString& kept,
                         const QString& shown);
  void addAmounts();
  void addDirections();
  void refresh();
  double size() const;
  Vec3 direction() const;

  Question question_;
  double amount_, pressure_ = 0;   ///< in the unit that is kept; Pa
  double trend_ = 0, plunge_ = 0;  ///< degrees
  QFormLayout* rows_;
  QComboBox *as_ = nullptr, *way_ = nullptr;
  NumberField *amountField_ = nullptr, *pressureField_ = nullptr, *trendField_ = nullptr, *plungeField_ = nullptr;
  QLabel* outcome_;
  QPushButton* create_;
};

}  // namespace talus
