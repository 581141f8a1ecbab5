#pragma once

#include <QDialog>
#include <optional>
#include <vector>

#include "base/vector.hpp"
#include "model/project.hpp"

class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace talus {

class NumberField;
class CurrentProject;
class SolidSurfaces;

/// Moves, turns, scales or copies some solids: the numbers are typed, the view shows what they make of the rock, and
/// Apply is one step that can be undone.
class MoveDialog : public QDialog {
  Q_OBJECT
 public:
  enum class Kind { move, turn, scale, copy };
  /// `solids`: their numbers in the project; the dialog closes when that changes otherwise.
  MoveDialog(CurrentProject& project, SolidSurfaces& surfaces, Kind kind, std::vector<int> solids, QWidget* parent);
  ~MoveDialog() override;

 private:
  NumberField* addNumber(const QString& name, double& kept, const QString& unit);
  void addVector(const QString& name, Vec3& kept);
  void addAxis();
  Project changed() const;
  QString title() const;
  void propose();
  void apply();

  CurrentProject& project_;
  SolidSurfaces& surfaces_;
  Kind kind_;
  std::vector<int> solids_;
  Vec3 step_ = Vec3::Zero(), about_ = Vec3::Zero();  ///< m
  Vec3 axis_ = Vec3::UnitZ();
  double angle_ = 0;  ///< degrees
  double factor_ = 1, count_ = 1;
  QFormLayout* rows_;
  QLabel* refusal_;
  QPushButton* apply_;
};

}  // namespace talus
