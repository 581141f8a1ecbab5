#pragma once

#include <QWidget>

#include "render/scene/scene.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/view/field_chooser.hpp"

class QCheckBox;

namespace talus {

class CurrentRun;
class Display;

/// How results are drawn: field, range, deformation, edges, overlays.
class DisplayPanel : public QWidget {
  Q_OBJECT
 public:
  DisplayPanel(Display& display, CurrentRun& run);

 private:
  void show();
  void chooseRange(int index);
  void showTypedRange();
  QCheckBox* addSwitch(Section* section, const QString& name, bool SceneSettings::*member);

  Display& display_;
  FieldChooser* field_;
  Section* colours_;
  QComboBox *range_, *deformation_, *edges_;
  std::vector<std::pair<double ValueRange::*, QWidget*>> ends_;  ///< of the range that is typed
  std::vector<std::pair<QCheckBox*, bool SceneSettings::*>> switches_;
};

}  // namespace talus
