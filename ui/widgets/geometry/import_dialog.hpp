#pragma once

#include <QDialog>

#include "jobs/latest_job.hpp"
#include "widgets/geometry/solid_reading.hpp"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace talus {

class CurrentProject;
class NumberField;
class SolidViewport;

/// A file of geometry on its way into the project: how it is to be understood beside what it then is, in 3-D and in
/// figures, with what is wrong in it and what was mended. It is read on a thread of its own after each choice;
/// importing is one step that can be undone.
class ImportDialog : public QDialog {
  Q_OBJECT
 public:
  ImportDialog(CurrentProject& project, std::filesystem::path file, QWidget* parent);

  bool isReading() const { return job_.isBusy(); }
  const SolidReading& reading() const { return reading_; }
  const ImportChoices& choices() const { return choices_; }

 private:
  QWidget* makeChoices();
  QWidget* makeView();
  QWidget* makeFoot();
  void addKind(QFormLayout& rows);
  void addUnit(QFormLayout& rows);
  void addUpwards(QFormLayout& rows);
  void addTerrain(QFormLayout& rows);
  void addOrigin(QVBoxLayout& column);
  void read(bool anotherPlace);
  void take(const SolidReading& reading, bool anotherPlace);
  void offerOrigin(const SolidSurface& surface);
  void showReading();
  void showFindings();
  void showTerrainRows();
  void import();

  CurrentProject& project_;
  std::filesystem::path file_;
  ImportChoices choices_;
  SolidReading reading_;
  std::optional<Vec3> offered_;  ///< origin

  QLineEdit* name_;
  QComboBox *kind_ = nullptr, *unit_, *up_;
  NumberField *scale_, *base_, *tolerance_;
  QFormLayout* rows_;
  QCheckBox* shift_;
  QLabel *originNote_, *extent_, *volume_, *triangles_, *state_, *refusal_;
  QVBoxLayout* findings_;
  SolidViewport* view_;
  QPushButton* import_;
  LatestJob job_;  ///< last: its thread ends before the others go
};

}  // namespace talus
