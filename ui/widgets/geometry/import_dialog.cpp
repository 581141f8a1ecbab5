#include "widgets/geometry/import_dialog.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "model/rules/solid_rules.hpp"
#include "session/current_project.hpp"
#include "widgets/kit/number_field.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"
#include "widgets/view/solid_viewport.hpp"

namespace talus {

namespace {

const QSize usual_import_size(1000, 640);
constexpr int choices_width = 312, pause_ms = 60;

struct FileUnit {
  const char* name;
  double metres;
};
constexpr FileUnit file_units[] = {{"m", 1}, {"cm", 1e-2}, {"mm", 1e-3}, {"ft", 0.3048}, {"in", 0.0254}};

/// "12.5 … 80 m".
QString between(double low, double high) {
  return QObject::tr("%1 … %2 m").arg(numbers::fixed(low, 1), numbers::fixed(high, 1));
}

NumberField* makeLength(std::optional<double> value, const QString& name) {
  auto* field = new NumberField(value, {QStringLiteral("m"), QStringLiteral("m")});
  field->setAccessibleName(name);
  return field;
}

}  // namespace

ImportDialog::ImportDialog(CurrentProject& project, std::filesystem::path file, QWidget* parent)
    : QDialog(parent), project_(project), file_(std::filesystem::absolute(file)), job_(pause_ms) {
  setWindowTitle(tr("Import %1").arg(text(file_.filename().string())));
  resizeWithin(*this, usual_import_size);
  choices_.asTerrain = !is_solid_file(file_.string()) && is_terrain_file(file_.string());
  choices_.origin = project_.document().project().origin;
  auto* column = new QVBoxLayout(this);
  setMargins(column, 0, 0);
  auto* row = new QHBoxLayout;
  setMargins(row, 0, 0);
  row->addWidget(makeChoices());
  row->addWidget(makeLine(Qt::Vertical));
  row->addWidget(makeView(), 1);
  column->addLayout(row, 1);
  column->addWidget(makeFoot());
  showTerrainRows();
  read(true);
}

QWidget* ImportDialog::makeChoices() {
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(16, 14, 16, 12);
  column->setSpacing(8);
  rows_ = new QFormLayout;
  setMargins(rows_, 0, 6);
  rows_->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  rows_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  name_ = new QLineEdit(text(file_.stem().string()));
  name_->setAccessibleName(tr("Name of the solid"));
  rows_->addRow(tr("Name"), name_);
  addKind(*rows_);
  addUnit(*rows_);
  addUpwards(*rows_);
  addTerrain(*rows_);
  column->addWidget(makeLabel(tr("How it is to be read"), "section"));
  column->addLayout(rows_);
  addOrigin(*column);
  column->addSpacing(8);
  column->addWidget(makeLabel(tr("What it is"), "section"));
  extent_ = makeLabel({});
  volume_ = makeLabel({});
  triangles_ = makeLabel({});
  auto* facts = new QFormLayout;
  setMargins(facts, 0, 4);
  for (const auto& [name, fact] :
       {std::pair(tr("Extent"), extent_), {tr("Volume"), volume_}, {tr("Surface"), triangles_}}) {
    auto* title = makeLabel(name, "muted");
    title->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    facts->addRow(title, fact);
  }
  facts->setHorizontalSpacing(16);
  column->addLayout(facts);
  findings_ = new QVBoxLayout;
  setMargins(findings_, 0, 6);
  column->addLayout(findings_);
  column->addStretch();
  auto* plane = makePlane("surface");
  plane->setFixedWidth(choices_width);
  auto* whole = new QVBoxLayout(plane);
  setMargins(whole, 0, 0);
  whole->addWidget(makeScrolled(content));
  return plane;
}

void ImportDialog::addKind(QFormLayout& rows) {
  if (!is_solid_file(file_.string()) || !is_terrain_file(file_.string())) return;
  kind_ = makeCombo({tr("a body of rock"), tr("ground, with rock below it")}, tr("What the file holds"));
  rows.addRow(tr("The file holds"), kind_);
  connect(kind_, &QComboBox::activated, this, [this](int index) {
    choices_.asTerrain = index == 1;
    showTerrainRows();
    read(true);
  });
}

void ImportDialog::addUnit(QFormLayout& rows) {
  QStringList names;
  for (const FileUnit& unit : file_units) names << QLatin1String(unit.name);
  unit_ = makeCombo(names << tr("other"), tr("Unit of the file"));
  scale_ = new NumberField(1, {{}, {}});
  scale_->setAccessibleName(tr("Metres per unit of the file"));
  scale_->setToolTip(tr("Metres per unit of the file"));
  rows.addRow(tr("Unit"), unit_);
  rows.addRow(tr("Metres per unit"), scale_);
  connect(unit_, &QComboBox::activated, this, [this](int index) {
    showTerrainRows();
    if (index >= static_cast<int>(std::size(file_units))) return scale_->setFocus();
    choices_.scale = file_units[index].metres;
    scale_->setValue(choices_.scale);
    read(true);
  });
  connect(scale_, &NumberField::committed, this, [this](double value) {
    if (value <= 0) return scale_->setProblem(tr("a unit is longer than nothing; give metres per unit of the file"));
    choices_.scale = value;
    scale_->setValue(value);
    read(true);
  });
}

void ImportDialog::addUpwards(QFormLayout& rows) {
  up_ = makeCombo({tr("z"), tr("y"), tr("x")}, tr("Axis of the file that points upwards"));
  rows.addRow(tr("Upwards is"), up_);
  connect(up_, &QComboBox::activated, this, [this](int index) {
    choices_.up = static_cast<ImportChoices::Up>(index);
    read(true);
  });
}

void ImportDialog::addTerrain(QFormLayout& rows) {
  base_ = makeLength(std::nullopt, tr("Base of the rock"));
  base_->allowNone(tr("below the ground"));
  base_->setToolTip(tr("Level of the flat underside, below all of the ground"));
  tolerance_ = makeLength(0, tr("Tolerance of the ground"));
  tolerance_->setToolTip(tr("How far the thinned surface may lie from what the file has; 0 keeps every point"));
  rows.addRow(tr("Base at z"), base_);
  rows.addRow(tr("Tolerance"), tolerance_);
  connect(base_, &NumberField::committed, this, [this](double value) {
    choices_.base = value;
    read(false);
  });
  connect(base_, &NumberField::cleared, this, [this] {
    choices_.base.reset();
    read(false);
  });
  connect(tolerance_, &NumberField::committed, this, [this](double value) {
    if (value < 0) return tolerance_->setProblem(tr("a tolerance is not below 0; 0 keeps every point"));
    choices_.tolerance = value;
    tolerance_->setValue(value);
    read(false);
  });
}

void ImportDialog::addOrigin(QVBoxLayout& column) {
  shift_ = new QCheckBox;
  shift_->setObjectName(QStringLiteral("shift"));
  shift_->hide();
  originNote_ = makeWrappedLabel({}, "small");
  originNote_->setObjectName(QStringLiteral("origin-note"));
  const Vec3& origin = project_.document().project().origin;
  if (!origin.isZero())
    originNote_->setText(
        tr("The project's origin is %1, %2, %3: the file's coordinates are taken less this.")
            .arg(numbers::figure(origin.x(), 9), numbers::figure(origin.y(), 9), numbers::figure(origin.z(), 9)));
  originNote_->setVisible(!origin.isZero());
  column.addWidget(shift_);
  column.addWidget(originNote_);
  connect(shift_, &QCheckBox::clicked, this, [this](bool shifted) {
    choices_.origin = shifted ? *offered_ : Vec3::Zero();
    read(true);
  });
}

QWidget* ImportDialog::makeView() {
  auto* plane = makePlane("window");
  auto* column = new QVBoxLayout(plane);
  setMargins(column, 0, 0);
  state_ = makeWrappedLabel({}, "muted");
  state_->setObjectName(QStringLiteral("state"));
  state_->setAlignment(Qt::AlignCenter);
  state_->setContentsMargins(40, 8, 40, 8);
  view_ = new SolidViewport;
  column->addWidget(view_, 1);
  column->addWidget(state_);
  return plane;
}

QWidget* ImportDialog::makeFoot() {
  auto* foot = makePlane("bottom");
  auto* buttons = new QHBoxLayout(foot);
  buttons->setContentsMargins(16, 10, 16, 10);
  refusal_ = makeWrappedLabel({}, "error");
  refusal_->setObjectName(QStringLiteral("refusal"));
  buttons->addWidget(refusal_, 1);
  auto* cancel = makeButton(tr("Cancel"));
  import_ = makeButton(tr("Import"), "primary");
  import_->setObjectName(QStringLiteral("import"));
  for (auto* button : {cancel, import_}) {
    button->setAutoDefault(false);
    buttons->addWidget(button);
  }
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  connect(import_, &QPushButton::clicked, this, &ImportDialog::import);
  connect(&job_, &LatestJob::progressed, this, [this](double, const QString& what) {
    if (!what.isEmpty()) state_->setText(what);
  });
  return foot;
}

/// Which rows mean something for what the file is taken for.
void ImportDialog::showTerrainRows() {
  const bool other = unit_->currentIndex() >= static_cast<int>(std::size(file_units));
  const std::pair<QWidget*, bool> shown[] = {{unit_, !choices_.asTerrain},
                                             {scale_, !choices_.asTerrain && other},
                                             {up_, !choices_.asTerrain},
                                             {base_, choices_.asTerrain},
                                             {tolerance_, choices_.asTerrain}};
  for (const auto& [field, isShown] : shown) {
    field->setVisible(isShown);
    rows_->labelForField(field)->setVisible(isShown);
  }
}

void ImportDialog::read(bool anotherPlace) {
  import_->setEnabled(false);
  refusal_->clear();
  state_->setText(tr("Reading %1 …").arg(text(file_.filename().string())));
  job_.begin([file = file_, choices = choices_](Progress& progress) { return readSolid(file, choices, progress); },
             [this, anotherPlace](const SolidReading& reading) { take(reading, anotherPlace); });
}

void ImportDialog::take(const SolidReading& reading, bool anotherPlace) {
  reading_ = reading;
  if (reading_.surface && choices_.asTerrain && !choices_.base) base_->setValue(reading_.base);
  showReading();
  if (reading_.surface)
    view_->setSolid(*reading_.surface, anotherPlace);
  else
    view_->clear();
  if (reading_.surface) offerOrigin(*reading_.surface);
}

void ImportDialog::offerOrigin(const SolidSurface& surface) {
  if (!project_.document().project().origin.isZero() || !choices_.origin.isZero() || shift_->isVisibleTo(this)) return;
  offered_ = localOrigin(surface);
  if (!offered_) return;
  const Vec3& origin = *offered_;
  shift_->setText(
      tr("Shift by %1, %2, %3")
          .arg(numbers::figure(origin.x(), 9), numbers::figure(origin.y(), 9), numbers::figure(origin.z(), 9)));
  shift_->setChecked(true);
  shift_->show();
  const bool others = !project_.document().project().solids.empty();
  originNote_->setText(
      tr("It lies far from zero: near a local origin it keeps all its digits. What the window shows of "
         "places is still in the file's coordinates.") +
      (others ? tr(" Solids from files follow; those that have coordinates of their own keep them.") : QString()));
  originNote_->show();
  choices_.origin = origin;
  read(true);
}

void ImportDialog::showReading() {
  const bool good = reading_.surface.has_value();
  for (auto* fact : {extent_, volume_, triangles_}) fact->setText(good ? QString() : QStringLiteral("–"));
  state_->setText(good ? tr("Drag turns it, the wheel zooms.")
                       : tr("%1: %2; %3")
                             .arg(text(reading_.problem->place()), text(reading_.problem->problem()),
                                  text(reading_.problem->remedy())));
  setRole(state_, good ? "small" : "error");
  view_->setVisible(good);
  clearLayout(*findings_);
  import_->setEnabled(good);
  if (!good) return;
  const SolidSurface& surface = *reading_.surface;
  const Vec3 low = surface.min + choices_.origin, high = surface.max + choices_.origin;
  extent_->setText(
      tr("E %1\nN %2\nZ %3").arg(between(low.x(), high.x()), between(low.y(), high.y()), between(low.z(), high.z())));
  volume_->setText(surface.closed ? tr("%1 m³").arg(numbers::significant(surface.volume, 5))
                                  : tr("none, it is not closed"));
  triangles_->setText(tr("%1 triangles").arg(numbers::whole(surface.triangles.size())));
  showFindings();
}

void ImportDialog::showFindings() {
  const auto& findings = reading_.surface->findings;
  const auto add = [this](const char* icon, theme::Tone tone, const QString& words) {
    auto* line = new QWidget;
    auto* row = new QHBoxLayout(line);
    setMargins(row, 0, 8);
    row->addWidget(new Glyph(QLatin1String(icon), tone), 0, Qt::AlignTop);
    row->addWidget(makeWrappedLabel(words, "small"), 1);
    findings_->addWidget(line);
  };
  if (findings.empty()) return add("check", theme::Tone::ok, tr("Nothing is wrong with its surface"));
  bool fatal = false;
  for (const SurfaceFinding& finding : findings) {
    const bool refused = is_fatal(finding);
    fatal = fatal || refused;
    add(finding.mended ? "check"
        : refused      ? "error"
                       : "warning",
        finding.mended ? theme::Tone::ok
        : refused      ? theme::Tone::error
                       : theme::Tone::warn,
        text(text_of(finding)));
  }
  if (!fatal) return;
  import_->setEnabled(false);
  refusal_->setText(tr("No rock can be made of this surface; it is marked where it is wrong."));
}

void ImportDialog::import() {
  Solid solid = solidFrom(file_, choices_);
  solid.name = name_->text().trimmed().toStdString();
  if (auto* terrain = std::get_if<TerrainShape>(&solid.shape)) terrain->base = reading_.base;
  try {
    const bool shifted = choices_.origin != project_.document().project().origin;
    project_.addSolid(solid, file_, shifted ? std::optional(choices_.origin) : std::nullopt);
    project_.selection().select({Item::Kind::solid, static_cast<int>(project_.document().project().solids.size()) - 1});
    accept();
  } catch (const InputError& error) {
    refusal_->setText(tr("%1; %2").arg(text(error.problem()), text(error.remedy())));
  }
}

}  // namespace talus
