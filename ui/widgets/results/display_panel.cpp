#include "widgets/results/display_panel.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QSignalBlocker>

#include "session/current_run.hpp"
#include "session/display.hpp"
#include "widgets/kit/text.hpp"
#include "widgets/results/range_fields.hpp"
#include "widgets/run/trouble_panel.hpp"

namespace talus {

namespace {
constexpr double deformation_scales[] = {1, 10, 100, 1000};
}

template <class Choice>
void DisplayPanel::follow(QComboBox* box, Choice SceneSettings::*member) {
  connect(box, &QComboBox::activated, this, [this, member](int index) {
    SceneSettings settings = display_.settings();
    settings.*member = static_cast<Choice>(index);
    display_.set(settings);
  });
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
  typed_ = new RangeFields(tr("Range of the legend"));
  connect(typed_, &RangeFields::typed, this, [this](const ValueRange& range) { display_.setTypedRange(range); });
  field->addRow(tr("From, to"), typed_);
  onlySome_ = new QCheckBox(tr("Only values"));
  onlySome_->setToolTip(tr("Faces on which the field has other values are not drawn; their edges stay"));
  connect(onlySome_, &QCheckBox::toggled, this,
          [this](bool on) { setOnly(on ? std::optional<ValueRange>(display_.spannedRange()) : std::nullopt); });
  field->addWide(onlySome_);
  only_ = new RangeFields(tr("Values that are drawn"));
  connect(only_, &RangeFields::typed, this, [this](const ValueRange& range) { setOnly(range); });
  field->addRow(tr("Between"), only_);
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
  follow(edges_, &SceneSettings::edges);
  edges_->setToolTip(tr("Lines along the edges of blocks, of all tetrahedra at the surface, or none"));
  shape->addRow(tr("Edges"), edges_);
  inner->addWidget(shape);
  inner->addWidget(makeLine(Qt::Horizontal));

  auto* overlays = new Section(tr("Overlays"));
  arrows_ = makeCombo({tr("none"), tr("velocity"), tr("contact force"), tr("principal stress")}, tr("Arrows"));
  follow(arrows_, &SceneSettings::arrows);
  arrows_->setToolTip(
      tr("How fast blocks go where, the forces by which each two push each other, or the principal stresses: heads "
         "point inwards where rock is pressed"));
  overlays->addRow(tr("Arrows"), arrows_);
  trails_ = makeCombo({tr("none"), tr("selected blocks"), tr("all blocks")}, tr("Trails"));
  follow(trails_, &SceneSettings::trails);
  trails_->setToolTip(tr("The ways that blocks' centres have gone up to the frame in view"));
  overlays->addRow(tr("Trails"), trails_);
  addSwitch(overlays, tr("Axes of rotation"), &SceneSettings::turning_axes)
      ->setToolTip(tr("About which blocks turn in the frame in view, by the right hand"));
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

void DisplayPanel::setOnly(const std::optional<ValueRange>& range) {
  SceneSettings settings = display_.settings();
  settings.only = range;
  display_.set(settings);
}

void DisplayPanel::showRanges() {
  const SceneSettings& settings = display_.settings();
  const bool hasScale = settings.field && !settings.field->is_class();
  const auto typed = display_.typedRange();
  range_->setCurrentIndex(typed ? 2 : display_.rangeFollowsRun() ? 0 : 1);
  colours_->setRowVisible(range_, hasScale);
  colours_->setRowVisible(typed_, hasScale && typed);
  if (hasScale && typed) typed_->show(*typed, text(settings.field->unit));
  const QSignalBlocker silent(onlySome_);
  onlySome_->setChecked(settings.only.has_value());
  onlySome_->setVisible(hasScale);
  colours_->setRowVisible(only_, hasScale && settings.only);
  if (hasScale && settings.only) only_->show(*settings.only, text(settings.field->unit));
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
  colours_->setRowVisible(field_->componentBox(), settings.field.has_value());
  showRanges();
  arrows_->setCurrentIndex(static_cast<int>(settings.arrows));
  trails_->setCurrentIndex(static_cast<int>(settings.trails));
  edges_->setCurrentIndex(static_cast<int>(settings.edges));
  for (int i = 0; i < 4; ++i)
    if (deformation_scales[i] == settings.deformation_scale) deformation_->setCurrentIndex(i);
  for (auto& [box, member] : switches_) {
    const QSignalBlocker silent(box);
    box->setChecked(settings.*member);
  }
}

}  // namespace talus
