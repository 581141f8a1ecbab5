#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QWidget>

#include "widgets/field_chooser.hpp"
#include "widgets/parts.hpp"
#include "widgets/workspace.hpp"

namespace talus {

/// How results are drawn: field, range, deformation, edges, overlays.
class DisplayPanel : public QWidget {
  Q_OBJECT
 public:
  explicit DisplayPanel(Workspace& workspace);

 private:
  void show();
  QCheckBox* addSwitch(Section* section, const QString& name, bool SceneSettings::*member);

  Workspace& workspace_;
  FieldChooser* field_;
  QComboBox *range_, *deformation_, *edges_;
  std::vector<std::pair<QCheckBox*, bool SceneSettings::*>> switches_;
};

}  // namespace talus
