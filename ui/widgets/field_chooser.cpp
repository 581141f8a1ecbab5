#include "widgets/field_chooser.hpp"

namespace talus {

namespace {

constexpr int block_colours = -1;

QString text(std::string_view s) { return QString::fromUtf8(s.data(), static_cast<qsizetype>(s.size())); }

/// The field's title without its quantity, which the first box says.
QString componentTitle(const Field& field) {
  if (field.source == Field::Source::stress) {
    QString title = text(field.title);
    title.remove(QStringLiteral(" stress")).remove(QStringLiteral("Stress "));
    return title;
  }
  if (field.measure == Field::Measure::magnitude) return QObject::tr("Magnitude");
  const char* axes[] = {"East, x", "North, y", "Up, z"};
  return QObject::tr(axes[field.index]);
}

}  // namespace

QComboBox* makeCombo(const QStringList& items, const QString& name) {
  auto* box = new QComboBox;
  box->addItems(items);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(4);
  box->setMinimumWidth(60);
  box->setAccessibleName(name);
  return box;
}

FieldChooser::FieldChooser(Workspace& workspace, QObject* parent)
    : QObject(parent),
      workspace_(workspace),
      quantity_(makeCombo({}, tr("Colour by"))),
      component_(makeCombo({}, tr("Component"))) {
  quantity_->addItem(tr("Block"), block_colours);
  quantity_->addItem(tr("Displacement"), static_cast<int>(Field::Source::displacement));
  quantity_->addItem(tr("Velocity"), static_cast<int>(Field::Source::velocity));
  quantity_->addItem(tr("Stress"), static_cast<int>(Field::Source::stress));
  quantity_->setToolTip(tr("What the blocks are coloured by"));
  component_->setToolTip(tr("Component or measure"));
  connect(quantity_, &QComboBox::activated, this, [this] {
    component_->clear();
    choose();
  });
  connect(component_, &QComboBox::activated, this, &FieldChooser::choose);
  connect(&workspace_, &Workspace::displayChanged, this, &FieldChooser::show);
  show();
}

void FieldChooser::choose() {
  SceneSettings display = workspace_.display();
  const int source = quantity_->currentData().toInt();
  display.field.reset();
  if (source != block_colours) {
    const std::string name = component_->currentData().toString().toStdString();
    for (const Field& field : all_fields()) {
      if (static_cast<int>(field.source) != source || (!name.empty() && field.name != name)) continue;
      display.field = field;
      break;
    }
  }
  workspace_.setDisplay(display);
}

void FieldChooser::show() {
  const auto& field = workspace_.display().field;
  const int source = field ? static_cast<int>(field->source) : block_colours;
  quantity_->setCurrentIndex(quantity_->findData(source));
  component_->clear();
  component_->setEnabled(field.has_value());
  if (!field) return;
  for (const Field& other : all_fields())
    if (other.source == field->source) component_->addItem(componentTitle(other), text(other.name));
  component_->setCurrentIndex(component_->findData(text(field->name)));
}

}  // namespace talus
