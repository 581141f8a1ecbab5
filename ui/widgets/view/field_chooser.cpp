#include "widgets/view/field_chooser.hpp"

#include <QComboBox>

#include "session/display.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

constexpr int block_colours = -1;

/// The field's title without its quantity, which the first box says.
QString componentTitle(const Field& field) {
  if (field.source == Field::Source::stress) {
    QString title = text(field.title);
    title.remove(QStringLiteral(" stress")).remove(QStringLiteral("Stress "));
    return title;
  }
  const bool isVector = field.source == Field::Source::displacement || field.source == Field::Source::velocity;
  if (!isVector) return text(field.title);
  if (field.measure == Field::Measure::magnitude) return QObject::tr("Magnitude");
  const char* axes[] = {"East, x", "North, y", "Up, z"};
  return QObject::tr(axes[field.index]);
}

}  // namespace

FieldChooser::FieldChooser(Display& display, QObject* parent)
    : QObject(parent),
      display_(display),
      quantity_(makeCombo({}, tr("Colour by"))),
      component_(makeCombo({}, tr("Component"))) {
  quantity_->addItem(tr("Block"), block_colours);
  quantity_->addItem(tr("Displacement"), static_cast<int>(Field::Source::displacement));
  quantity_->addItem(tr("Velocity"), static_cast<int>(Field::Source::velocity));
  quantity_->addItem(tr("Rotation"), static_cast<int>(Field::Source::rotation));
  quantity_->addItem(tr("Stress"), static_cast<int>(Field::Source::stress));
  quantity_->addItem(tr("Strain"), static_cast<int>(Field::Source::strain));
  quantity_->addItem(tr("Kind"), static_cast<int>(Field::Source::block));
  quantity_->addItem(tr("Joints"), static_cast<int>(Field::Source::joint));
  quantity_->setToolTip(tr("What the blocks are coloured by"));
  component_->setToolTip(tr("Component or measure"));
  connect(quantity_, &QComboBox::activated, this, [this] {
    component_->clear();
    choose();
  });
  connect(component_, &QComboBox::activated, this, &FieldChooser::choose);
  connect(&display_, &Display::changed, this, &FieldChooser::show);
  show();
}

void FieldChooser::choose() {
  SceneSettings settings = display_.settings();
  const int source = quantity_->currentData().toInt();
  settings.field.reset();
  if (source != block_colours) {
    const std::string name = component_->currentData().toString().toStdString();
    for (const Field& field : all_fields()) {
      if (static_cast<int>(field.source) != source || (!name.empty() && field.name != name)) continue;
      settings.field = field;
      break;
    }
  }
  display_.set(settings);
}

void FieldChooser::show() {
  const auto& field = display_.settings().field;
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
