#pragma once

#include <QDialog>
#include <optional>

#include "orientation/project_joints.hpp"
#include "orientation/set_window.hpp"
#include "render/stereonet/stereonet.hpp"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace talus {

class CurrentProject;
class Display;
class DrawnJoints;
class Messages;
class NumberField;
class Picking;
class PlainTable;
class StereonetView;

/// The stereonet of the project's joints, a pole a plane: what is selected here is selected everywhere. Its sets with
/// mean and κ, what lies in a window that is drawn in the net, and what can fail in a face.
class StereonetPanel : public QDialog {
  Q_OBJECT
 public:
  StereonetPanel(CurrentProject& project, DrawnJoints& drawn, Messages& messages, Display& display, Picking& picking,
                 QWidget* parent = nullptr);
  /// To the front.
  void present();

 signals:
  /// The user wants to add joints.
  void pasteWanted();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* makeNet();
  QWidget* makeSide();
  QWidget* makeChoices();
  QWidget* makeSlope();
  QWidget* makeWindow();
  NumberField* addAngle(const QString& name, std::optional<double> value, std::optional<double>& kept, double most);

  void refresh();
  void showSets();
  void showCounts();
  void showSelection();
  void showWindow();
  void choose(std::optional<std::size_t> joint);
  /// Makes way for the view until a face is clicked there, or the asking ends.
  void pickFace();
  void takeFace(const Vec3& outwards);
  void assign();
  void savePicture();
  Stereonet net() const;
  std::optional<KinematicSetting> slope() const;

  CurrentProject& project_;
  DrawnJoints& drawn_;
  Messages& messages_;
  Display& display_;
  Picking& picking_;
  bool awaitsFace_ = false;
  std::optional<double> faceDip_, faceDirection_, friction_ = 30, limit_ = 20;  ///< degrees
  std::optional<SetWindow> window_;
  ProjectJoints joints_;  ///< of the project as it was shown last
  StereonetView* view_;
  QLabel *note_, *density_, *picked_, *countsNote_;
  QComboBox *projection_, *contours_, *mode_;
  QCheckBox* planes_;
  NumberField *dipField_, *directionField_;
  PlainTable *sets_, *counts_;
  QLineEdit* setName_;
  QPushButton *assign_, *forget_;
};

}  // namespace talus
