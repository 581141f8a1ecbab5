#include "widgets/results/display_panel.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QSignalBlocker>

#include "session/current_run.hpp"
#include "session/display.hpp"
#include "widgets/kit/number_field.hpp"
#include "widgets/kit/text.hpp"
#include "widgets/run/trouble_panel.hpp"

namespace talus {

namespace {
constexpr double deformation_scales[] = {1, 10, 100, 1000};
}

DisplayPanel::DisplayPanel(Display& display, CurrentRun& run)
    : display_(display), field_(new FieldChooser(display, this)) {
  auto* column = new QVBoxLayout(this);
  setMargins(column, 0, 0);
  column->addWidget(new PanelHeader(tr("Display")));
  auto* content = new QWidget;
  auto* inner = new QVBoxLayout(content);
  setMargins(inner, 0, 0);

  auto* field = colours_ = new Section(tr("Field"));
  field->addRow(tr("Colour by"), field_->quantityBox());
  field->addRow(tr("Component"), field_->componentBox());
  range_ = makeCombo({tr("all frames"), tr("this frame"), tr("typed")}, tr("Range of the legend"));
  connect(range_, &QComboBox::activated, this, &DisplayPanel::chooseRange);
  range_->setToolTip(tr("The legend spans the values of all frames, those of the one in view, or what is typed"));
  field->addRow(tr("Range"), range_);
  for (auto& [end, name] : {std::pair(&ValueRange::low, tr("Lowest")), std::pair(&ValueRange::high, tr("Highest"))}) {
    QWidget*& row = ends_.emplace_back(end, new QWidget).second;
    setMargins(new QHBoxLayout(row), 0, 0);
    field->addRow(name, row);
  }
  inner->addWidget(field);
  inner->addWidget(makeLine(Qt::Horizontal));

  auto* shape = new Section(tr("Shape"));
  deformation_ = makeCombo({tr("true"), QStringLiteral("10 ×"), QStringLiteral("100 ×"), QStringLiteral("1000 ×")},
                           tr("Deformation"));
  connect(deformation_, &QComboBox::activated, this, [this](int index) {
    SceneSettings settings = display_.settings();
    settings.deformation_scale = deformation_scales[index];
    display_.set(settings);
  });
  deformation_->setToolTip(tr("Displacements are drawn this many times as large"));
  shape->addRow(tr("Deformation"), deformation_);
  edges_ = makeCombo({tr("none"), tr("block edges"), tr("mesh")}, tr("Edges"));
  connect(edges_, &QComboBox::activated, this, [this](int index) {
    SceneSettings settings = display_.settings();
    settings.edges = static_cast<Edges>(index);
    display_.set(settings);
  });
  edges_->setToolTip(tr("Lines along the edges of blocks, of all tetrahedra at the surface, or none"));
  shape->addRow(tr("Edges"), edges_);
  inner->addWidget(shape);
  inner->addWidget(makeLine(Qt::Horizontal));

  auto* overlays = new Section(tr("Overlays"));
  addSwitch(overlays, tr("Contact points"), &SceneSettings::contacts)
      ->setToolTip(tr("Open grey, stick blue, slip orange"));
  addSwitch(overlays, tr("Convergence trouble"), &SceneSettings::troubles)
      ->setToolTip(tr("Marks the contacts at which steps were cut or took many iterations"));
  addSwitch(overlays, tr("Legend"), &SceneSettings::legend)->setToolTip(tr("Which colour stands for which value"));
  addSwitch(overlays, tr("Time stamp"), &SceneSettings::time_stamp)
      ->setToolTip(tr("Model time and stage of the frame in view"));
  addSwitch(overlays, tr("Axes"), &SceneSettings::triad)->setToolTip(tr("Where east, north and up are"));
  addSwitch(overlays, tr("Scale bar"), &SceneSettings::scale_bar)
      ->setToolTip(tr("A length at the depth of the middle of the view"));
  inner->addWidget(overlays);
  inner->addWidget(new TroublePanel(run, display));
  inner->addStretch();
  column->addWidget(makeScrolled(content), 1);
  connect(&display_, &Display::changed, this, &DisplayPanel::show);
  show();
}

void DisplayPanel::chooseRange(int index) {
  display_.setTypedRange(index == 2 ? std::optional<ValueRange>(display_.spannedRange()) : std::nullopt);
  if (index < 2) display_.setRangeFollowsRun(index == 0);
}

/// The fields' unit is that of what is coloured by.
void DisplayPanel::showTypedRange() {
  const SceneSettings& settings = display_.settings();
  const auto& typed = display_.typedRange();
  for (auto& [end, row] : ends_) {
    colours_->setRowVisible(row, typed && settings.field && !settings.field->is_class());
    if (!typed || !settings.field) continue;
    auto* number = row->findChild<NumberField*>();
    const QString unit = text(settings.field->unit);
    if (!number || number->property("unit").toString() != unit) {
      delete number;
      number = new NumberField(typed.value().*end, {unit, unit});
      number->setProperty("unit", unit);
      number->setAccessibleName(end == &ValueRange::low ? tr("Lowest value of the legend")
                                                        : tr("Highest value of the legend"));
      connect(number, &NumberField::committed, this, [this, end = end, number](double value) {
        ValueRange range = *display_.typedRange();
        range.*end = value;
        if (range.low < range.high)
          display_.setTypedRange(range);
        else
          number->setProblem(tr("The lowest value must be below the highest"));
      });
      row->layout()->addWidget(number);
    }
    number->setValue(typed.value().*end);
  }
}

QCheckBox* DisplayPanel::addSwitch(Section* section, const QString& name, bool SceneSettings::*member) {
  auto* box = new QCheckBox(name);
  connect(box, &QCheckBox::toggled, this, [this, member](bool on) {
    SceneSettings settings = display_.settings();
    settings.*member = on;
    display_.set(settings);
  });
  section->addWide(box);
  switches_.emplace_back(box, member);
  return box;
}

void DisplayPanel::show() {
  const SceneSettings& settings = display_.settings();
  range_->setCurrentIndex(display_.typedRange() ? 2 : display_.rangeFollowsRun() ? 0 : 1);
  colours_->setRowVisible(field_->componentBox(), settings.field.has_value());
  colours_->setRowVisible(range_, settings.field && !settings.field->is_class());
  showTypedRange();
  edges_->setCurrentIndex(static_cast<int>(settings.edges));
  for (int i = 0; i < 4; ++i)
    if (deformation_scales[i] == settings.deformation_scale) deformation_->setCurrentIndex(i);
  for (auto& [box, member] : switches_) {
    const QSignalBlocker silent(box);
    box->setChecked(settings.*member);
  }
}

}  // namespace talus
