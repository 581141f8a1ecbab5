#pragma once

#include <QDialog>
#include <vector>

#include "model/project.hpp"

class QLabel;
class QListWidget;
class QPushButton;
class QStackedWidget;

namespace talus {

class ProjectPreview;
class TemplateForm;

inline constexpr const char* empty_key = "empty";

/// A new project: empty, or of a template whose numbers are typed beside a picture of what they make.
class NewDialog : public QDialog {
  Q_OBJECT
 public:
  explicit NewDialog(QWidget* parent);
  /// A template by its key, or `empty_key`.
  void choose(const std::string& key);
  /// What has been chosen, as it is typed.
  Project project() const;
  ProjectPreview& preview() { return *preview_; }

 private:
  QWidget* makeChoice();
  QWidget* makeForms();
  void refresh();
  TemplateForm* form() const;  ///< null for the empty project

  QListWidget* list_;
  QStackedWidget* forms_;
  std::vector<TemplateForm*> templates_;
  QLabel *title_, *description_;
  ProjectPreview* preview_;
  QPushButton* create_;
};

/// A project with nothing in it but its name, gravity and the solver's settings.
Project emptyProject();

}  // namespace talus
