#pragma once

#include <QDialog>
#include <QTimer>

#include "widgets/forms/field.hpp"
#include "widgets/geometry/section_plot.hpp"

class QLabel;
class QScrollArea;
class QVBoxLayout;

namespace talus {

class CurrentProject;

/// The profile of the solid with a section that is selected: drawn, and beside it in numbers. Both change the project;
/// a drag is one step that can be undone.
class SectionEditor : public QDialog {
  Q_OBJECT
 public:
  SectionEditor(CurrentProject& project, QWidget* parent);
  /// To the front, with the solid that is selected.
  void present();
  SectionPlot& plot() { return *plot_; }

 private:
  void choose();
  void refresh();
  void rebuildForm();
  void take(const SectionPlot::Corners& corners, bool ends);

  CurrentProject& project_;
  FormContext context_;
  int solid_ = -1;    ///< whose section is shown
  int gesture_ = -1;  ///< of the drag that goes on
  SectionPlot* plot_;
  QLabel *title_, *problem_;
  QVBoxLayout* side_;
  QScrollArea* form_ = nullptr;
  QTimer soon_;  ///< the form follows a drag with a little delay
};

}  // namespace talus
