#include "widgets/begin/new_dialog.hpp"

#include <QListWidget>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "widgets/begin/project_preview.hpp"
#include "widgets/begin/template_form.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

const QSize new_dialog_size(960, 580);
constexpr int list_width = 172, form_width = 300;
constexpr int key_role = Qt::UserRole;

}  // namespace

Project emptyProject() {
  Project project;
  project.name = "Untitled";
  return project;
}

NewDialog::NewDialog(QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("New project"));
  resize(new_dialog_size);
  auto* column = new QVBoxLayout(this);
  setMargins(column, 0, 0);
  auto* row = new QHBoxLayout;
  setMargins(row, 0, 0);
  row->addWidget(makeChoice());
  row->addWidget(makeForms());
  preview_ = new ProjectPreview;
  row->addWidget(preview_, 1);
  column->addLayout(row, 1);
  auto* bar = makePlane("bottom");
  auto* buttons = new QHBoxLayout(bar);
  buttons->setContentsMargins(16, 10, 16, 10);
  buttons->addStretch();
  auto* cancel = makeButton(tr("Cancel"));
  create_ = makeButton(tr("Create"), "primary");
  create_->setDefault(true);
  cancel->setAutoDefault(false);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  connect(create_, &QPushButton::clicked, this, &QDialog::accept);
  buttons->addWidget(cancel);
  buttons->addWidget(create_);
  column->addWidget(bar);
  connect(list_, &QListWidget::currentRowChanged, this, &NewDialog::refresh);
  list_->setCurrentRow(1);
}

QWidget* NewDialog::makeChoice() {
  auto* plane = makePlane("rail");
  plane->setFixedWidth(list_width);
  auto* column = new QVBoxLayout(plane);
  column->setContentsMargins(8, 12, 8, 12);
  list_ = new QListWidget;
  list_->setAccessibleName(tr("Templates"));
  list_->setProperty("kind", "plain");
  list_->setFrameShape(QFrame::NoFrame);
  auto add = [this](const QString& name, const std::string& key) {
    auto* item = new QListWidgetItem(name, list_);
    item->setData(key_role, text(key));
  };
  add(tr("Empty"), empty_key);
  for (const ProjectTemplate& candidate : project_templates()) add(text(candidate.name), candidate.key);
  column->addWidget(list_);
  return plane;
}

QWidget* NewDialog::makeForms() {
  auto* plane = makePlane("surface");
  plane->setFixedWidth(form_width);
  auto* column = new QVBoxLayout(plane);
  column->setContentsMargins(16, 16, 16, 12);
  column->setSpacing(8);
  title_ = makeLabel({}, "large");
  description_ = makeWrappedLabel({}, "muted");
  column->addWidget(title_);
  column->addWidget(description_);
  column->addSpacing(8);
  forms_ = new QStackedWidget;
  forms_->addWidget(new QWidget);
  for (const ProjectTemplate& candidate : project_templates()) {
    auto* one = new TemplateForm(candidate);
    connect(one, &TemplateForm::changed, this, &NewDialog::refresh);
    templates_.push_back(one);
    auto* page = new QWidget;
    auto* top = new QVBoxLayout(page);
    setMargins(top, 0, 0);
    top->addWidget(one);
    top->addStretch();
    forms_->addWidget(page);
  }
  column->addWidget(forms_, 1);
  return plane;
}

void NewDialog::choose(const std::string& key) {
  for (int row = 0; row < list_->count(); ++row)
    if (list_->item(row)->data(key_role).toString() == text(key)) list_->setCurrentRow(row);
}

TemplateForm* NewDialog::form() const {
  const int row = list_->currentRow();
  return row < 1 ? nullptr : templates_[static_cast<std::size_t>(row - 1)];
}

Project NewDialog::project() const { return form() ? form()->project() : emptyProject(); }

void NewDialog::refresh() {
  const int row = std::max(0, list_->currentRow());
  forms_->setCurrentIndex(row);
  const bool good = !form() || form()->isGood();
  if (row == 0) {
    title_->setText(tr("Empty project"));
    description_->setText(tr("To be filled in the window. What is still missing is listed under Problems."));
  } else {
    const ProjectTemplate& chosen = project_templates()[static_cast<std::size_t>(row - 1)];
    title_->setText(text(chosen.name));
    description_->setText(text(chosen.description));
  }
  create_->setEnabled(good);
  create_->setToolTip(good ? QString() : tr("A number is not one that the template takes"));
  preview_->setProject(form() ? std::optional(project()) : std::nullopt);  // of the last good numbers
}

}  // namespace talus
