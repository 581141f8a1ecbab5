#pragma once

#include <QPointer>
#include <QWidget>
#include <functional>
#include <optional>

#include "model/project.hpp"
#include "widgets/kit/parts.hpp"

namespace talus {

class CurrentProject;
class Messages;
class Playback;
struct Block;

class NumberField;

/// What the selected thing is, with units. Strengths of joints and the constants of materials can be typed
/// over, the body of solids chosen.
class PropertyPanel : public QWidget {
  Q_OBJECT
 public:
  PropertyPanel(CurrentProject& project, Playback& playback, Messages& messages);

 private:
  void rebuild();
  /// Of the number that has the keyboard; empty: none here.
  QString nameOfFieldInUse() const;
  /// Gives the keyboard to the number of that name, if it is there.
  void goOnIn(const QString& name);
  void showProject();
  void showSolver(const SolverSettings& solver);
  void showSolid(int index);
  /// Lets the user choose what a solid's blocks may do.
  void addBody(Section* section, int solid);
  /// The body a block was built as, and why where that was left open.
  void showBody(Section* section, const Block& block);
  void showCut(const Cut& cut);
  void showJoint(int index);
  void showBlock(int index);
  /// Puts how the block moves in the frame in view into its label.
  void showMotion();
  void showMaterial(int index);
  void showLoad(const PointLoad& load);
  void showConstraint(const Constraint& constraint);
  void showVelocity(const InitialVelocity& velocity);
  void showStage(const Stage& stage);
  void showMonitor(int index);

  Section* addSection(const QString& title, const QString& note = {});
  /// What a field shows is the SI value divided by `scale`, with `unit`.
  struct Quantity {
    double scale = 1;
    QString unit;
  };
  /// A choice among words; `change` is called with the number of the one that was chosen, and may throw InputError.
  void addChoice(Section* section, const QString& name, const QString& tip, const QStringList& words, int present,
                 const std::function<void(int)>& change);
  /// A number that can be typed over; `change` may throw InputError, which the field then shows.
  NumberField* addNumber(Section* section, const QString& name, const Quantity& quantity, std::optional<double> value,
                         const std::function<void(double)>& change);

  CurrentProject& project_;
  Playback& playback_;
  Messages& messages_;
  PanelHeader* header_;
  QVBoxLayout* column_;
  QWidget* content_ = nullptr;
  QWidget* scrolled_ = nullptr;
  QPointer<QLabel> motion_;  ///< goes with the content
};

}  // namespace talus
