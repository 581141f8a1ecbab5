#pragma once

#include <QWidget>

#include "render/scene/scene.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/view/field_chooser.hpp"

class QCheckBox;

namespace talus {

class CurrentRun;
class Display;
class RangeFields;

/// How results are drawn: field, range, deformation, edges, overlays.
class DisplayPanel : public QWidget {
  Q_OBJECT
 public:
  DisplayPanel(Display& display, CurrentRun& run);

 private:
  void show();
  void chooseRange(int index);
  void setOnly(const std::optional<ValueRange>& range);
  void showRanges();
  /// The choices of a box are the values of a setting, in their order.
  template <class Choice>
  void follow(QComboBox* box, Choice SceneSettings::*member);
  QCheckBox* addSwitch(Section* section, const QString& name, bool SceneSettings::*member);

  Display& display_;
  FieldChooser* field_;
  Section* colours_;
  QComboBox *range_, *deformation_, *edges_, *arrows_, *trails_;
  RangeFields *typed_, *only_;
  QCheckBox* onlySome_;
  std::vector<std::pair<QCheckBox*, bool SceneSettings::*>> switches_;
};

}  // namespace talus
