#include "widgets/view/field_chooser.hpp"

#include <QComboBox>
#include <QCoreApplication>

#include "session/display.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

constexpr int block_colours = -1;

QString axisTitle(const Field& field) {
  if (field.measure == Field::Measure::magnitude) return QObject::tr("Magnitude");
  const char* axes[] = {"East, x", "North, y", "Up, z"};
  return QObject::tr(axes[field.index]);
}

/// The field's title without its quantity, which the first box says.
QString componentTitle(const Field& field) {
  // What is left of titles: the translators' tool finds it here.
  static const char* const known[] = {QT_TRANSLATE_NOOP("component", "Von Mises"),
                                      QT_TRANSLATE_NOOP("component", "Largest principal"),
                                      QT_TRANSLATE_NOOP("component", "Smallest principal"),
                                      QT_TRANSLATE_NOOP("component", "Largest shear"),
                                      QT_TRANSLATE_NOOP("component", "Mean"),
                                      QT_TRANSLATE_NOOP("component", "Safety factor of rock"),
                                      QT_TRANSLATE_NOOP("component", "Blocks that sleep"),
                                      QT_TRANSLATE_NOOP("component", "Volumetric"),
                                      QT_TRANSLATE_NOOP("component", "Rotation"),
                                      QT_TRANSLATE_NOOP("component", "Kind of body"),
                                      QT_TRANSLATE_NOOP("component", "Motion of blocks"),
                                      QT_TRANSLATE_NOOP("component", "Normal stress"),
                                      QT_TRANSLATE_NOOP("component", "Shear stress"),
                                      QT_TRANSLATE_NOOP("component", "Mobilised shear strength"),
                                      QT_TRANSLATE_NOOP("component", "Slip"),
                                      QT_TRANSLATE_NOOP("component", "Opening"),
                                      QT_TRANSLATE_NOOP("component", "State"),
                                      QT_TRANSLATE_NOOP("component", "Bonds"),
                                      QT_TRANSLATE_NOOP("component", "Cohesion left")};
  static_cast<void>(known);
  using Source = Field::Source;
  if (field.source == Source::displacement || field.source == Source::velocity) return axisTitle(field);
  QString title = text(field.title);
  if (field.source == Source::stress) title.remove(QStringLiteral(" stress")).remove(QStringLiteral("Stress "));
  if (field.source == Source::strain) title.remove(QStringLiteral(" strain"));
  if (field.source == Source::joint) title.remove(QStringLiteral(" on joints")).remove(QStringLiteral(" of joints"));
  return QCoreApplication::translate("component", title.toUtf8().constData());
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
