#include "widgets/orientation/stereonet_panel.hpp"

#include <QCheckBox>
#include <QFileDialog>
#include <QHeaderView>
#include <QLineEdit>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "base/units.hpp"
#include "render/paint/picture_words.hpp"
#include "render/stereonet/stereonet_picture.hpp"
#include "session/current_project.hpp"
#include "session/display.hpp"
#include "session/drawn_joints.hpp"
#include "session/messages.hpp"
#include "session/picking.hpp"
#include "widgets/kit/number_field.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/plain_table.hpp"
#include "widgets/kit/text.hpp"
#include "widgets/orientation/net_artist.hpp"
#include "widgets/orientation/stereonet_view.hpp"

namespace talus {

namespace {

const QSize stereonet_size(1120, 780);
constexpr int side_width = 400, set_row_height = 24;
constexpr int most_sets = 6, most_counts = 8;  // rows that are seen without scrolling
constexpr int most_of_a_cut = 1000;            // planes that are drawn by chance: more would hold up the window …
constexpr std::size_t most_paired = 1500;      // … and so would half this number squared of intersections
constexpr int stereonet_width = 1600, picture_height = 1000;

QString kappaOf(const SetStatistics& set) {
  return set.fisher.kappa ? numbers::significant(*set.fisher.kappa) : QStringLiteral("–");
}

QString coneOf(const SetStatistics& set) {
  const auto cone = confidence_cone(set.fisher, 0.95);
  return cone ? numbers::fixed(*cone, 1) + u'°' : QStringLiteral("–");
}

QString meanOf(const SetStatistics& set) {
  const PlaneAttitude mean = set.mean_plane();
  return numbers::fixed(mean.dip, 1) + u'/' + numbers::fixed(mean.dip_direction, 1);
}

/// The set's symbol in its colour, as the net has it.
QIcon symbolOf(std::size_t set, Theme theme) {
  constexpr int side = 16;
  QPixmap picture(side * 2, side * 2);
  picture.setDevicePixelRatio(2);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  const NetArtist artist(painter, QPointF(side / 2.0, side / 2.0), 1);
  artist(NetMarker{Vec2(0, 0), set_symbol(set), set_colour(set, theme), set_colour(set, theme), 1});
  return QIcon(picture);
}

/// The contours' levels behind their colours.
QString legendOf(const DrawnNet& drawn, DensityMethod method, Theme theme) {
  QString legend;
  for (std::size_t i = 0; i < drawn.levels.size(); ++i)
    legend +=
        QStringLiteral("<span style='color:%1'>■</span> %2&nbsp; ")
            .arg(colourOf(band_colour(i, drawn.levels.size(), theme)).name(), numbers::figure(drawn.levels[i], 3));
  return legend + text(picture_word(PoleDensity({}, method).unit())) +
         QObject::tr("; densest %1").arg(numbers::significant(drawn.densest));
}

/// Two widgets in one row of a form.
QWidget* beside(QWidget* left, QWidget* right) {
  auto* both = new QWidget;
  auto* row = new QHBoxLayout(both);
  setMargins(row, 0, 6);
  row->addWidget(left, 1);
  row->addWidget(right, 1);
  return both;
}

}  // namespace

StereonetPanel::StereonetPanel(CurrentProject& project, DrawnJoints& drawn, Messages& messages, Display& display,
                               Picking& picking, QWidget* parent)
    : QDialog(parent), project_(project), drawn_(drawn), messages_(messages), display_(display), picking_(picking) {
  setWindowTitle(tr("Stereonet"));
  resizeWithin(*this, stereonet_size);
  auto* row = new QHBoxLayout(this);
  setMargins(row, 0, 0);
  row->addWidget(makeNet(), 1);
  row->addWidget(makeLine(Qt::Vertical));
  row->addWidget(makeSide());
  connect(&project_, &CurrentProject::opened, this, [this] {
    window_.reset();
    refresh();
  });
  connect(&drawn_, &DrawnJoints::changed, this, [this] {
    if (isVisible()) refresh();
  });
  connect(&display_, &Display::themeChanged, this, &StereonetPanel::refresh);
  connect(&project_.selection(), &Selection::changed, this, &StereonetPanel::showSelection);
  connect(&picking_, &Picking::changed, this, [this] {
    if (!picking_.isAsking() && std::exchange(awaitsFace_, false)) present();
  });
  refresh();
}

/// What has changed meanwhile was not looked at.
void StereonetPanel::showEvent(QShowEvent* event) {
  refresh();
  QDialog::showEvent(event);
}

void StereonetPanel::present() {
  show();
  raise();
  activateWindow();
}

QWidget* StereonetPanel::makeNet() {
  auto* whole = makePlane("surface");
  auto* column = new QVBoxLayout(whole);
  column->setContentsMargins(8, 8, 8, 8);
  column->setSpacing(4);
  view_ = new StereonetView;
  column->addWidget(view_, 1);
  auto* foot = new QHBoxLayout;
  note_ = new ElidedLabel({}, "small");
  foot->addWidget(note_, 1);
  density_ = makeLabel({}, "small");
  density_->setObjectName(QStringLiteral("density"));
  foot->addWidget(density_);
  foot->addSpacing(8);
  auto* paste = makeButton(tr("Paste joints…"));
  auto* picture = makeButton(tr("Save picture…"));
  for (auto* button : {paste, picture}) {
    button->setAutoDefault(false);
    foot->addWidget(button);
  }
  connect(paste, &QPushButton::clicked, this, &StereonetPanel::pasteWanted);
  connect(picture, &QPushButton::clicked, this, &StereonetPanel::savePicture);
  column->addLayout(foot);
  connect(view_, &StereonetView::chosen, this, &StereonetPanel::choose);
  connect(view_, &StereonetView::windowDrawn, this, [this](const SetWindow& window) {
    window_ = window;
    showWindow();
  });
  return whole;
}

QWidget* StereonetPanel::makeSide() {
  auto* content = makePlane("surface");
  auto* column = new QVBoxLayout(content);
  setMargins(column, 0, 0);
  column->addWidget(makeChoices());
  auto* sets = new Section(tr("Sets"), tr("95 % cone of the mean"));
  sets_ = new PlainTable;
  sets_->setObjectName(QStringLiteral("sets"));
  sets_->setAccessibleName(tr("Sets with their means"));
  sets_->setSelectionMode(QAbstractItemView::NoSelection);
  sets->addWide(sets_);
  column->addWidget(sets);
  column->addWidget(makeWindow());
  column->addWidget(makeSlope());
  column->addStretch();
  // All counts are seen without scrolling on a small screen.
  for (auto* section : content->findChildren<Section*>()) section->layout()->setContentsMargins(12, 7, 12, 7);
  for (auto* table : {sets_, counts_}) {
    table->verticalHeader()->setDefaultSectionSize(set_row_height);
    table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  }
  auto* side = makeScrolled(content);
  side->setFixedWidth(side_width);
  return side;
}

QWidget* StereonetPanel::makeChoices() {
  auto* section = new Section(tr("Net"), tr("lower hemisphere"));
  projection_ = makeCombo({tr("equal area"), tr("equal angle")}, tr("Projection"));
  contours_ = makeCombo({tr("none"), tr("Fisher, % per 1 % area"), tr("Kamb, σ")}, tr("Density"));
  contours_->setCurrentIndex(1);
  planes_ = new QCheckBox(tr("mean planes"));
  planes_->setChecked(true);
  projection_->setToolTip(tr("Schmidt's net, for densities, or Wulff's, on which circles are circles"));
  planes_->setToolTip(tr("Great circles of the means of the sets"));
  section->addRow(tr("Projection"), beside(projection_, planes_));
  section->addRow(tr("Density"), contours_, tr("Contours of the density of poles"));
  for (auto* box : {projection_, contours_}) connect(box, &QComboBox::activated, this, &StereonetPanel::refresh);
  connect(planes_, &QCheckBox::toggled, this, &StereonetPanel::refresh);
  return section;
}

NumberField* StereonetPanel::addAngle(const QString& name, std::optional<double> value, std::optional<double>& kept,
                                      double most) {
  auto* field = new NumberField(value, {QStringLiteral("°"), QStringLiteral("°")});
  field->setAccessibleName(name);
  connect(field, &NumberField::committed, this, [this, field, &kept, most](double angle) {
    const bool within = angle >= 0 && angle <= most;
    if (!within) return field->setProblem(tr("Give 0 to %1 degrees").arg(most));
    kept = angle;
    field->setValue(angle);
    refresh();
  });
  connect(field, &NumberField::cleared, this, [this, field, &kept] {
    kept.reset();
    field->setValue({});
    refresh();
  });
  return field;
}

QWidget* StereonetPanel::makeSlope() {
  auto* section = new Section(tr("Kinematic check"));
  dipField_ = addAngle(tr("Face dip"), {}, faceDip_, 90);
  directionField_ = addAngle(tr("Face dip direction"), {}, faceDirection_, 360);
  dipField_->allowNone(tr("no face"));
  directionField_->allowNone(tr("no face"));
  auto* pick = makeTool(QStringLiteral("point"), tr("Pick the face in the view"));
  pick->setObjectName(QStringLiteral("pick face"));
  connect(pick, &QToolButton::clicked, this, &StereonetPanel::pickFace);
  auto* face = beside(dipField_, directionField_);
  face->layout()->addWidget(pick);
  section->addRow(tr("Face"), face, tr("Dip and dip direction, clockwise from north"));
  auto* friction = addAngle(tr("Friction angle of the check"), friction_, friction_, 90);
  friction->setToolTip(tr("φ of all joints in this check; it changes no joint of the project"));
  auto* limit = addAngle(tr("Lateral limits"), limit_, limit_, 90);
  limit->setToolTip(tr("How far a plane, or the direction of toppling, may be off the face's direction"));
  section->addRow(tr("φ, limits ±"), beside(friction, limit));
  QStringList modes;
  for (const FailureMode mode : {FailureMode::planar, FailureMode::wedge, FailureMode::flexural, FailureMode::direct})
    modes << text(to_string(mode));
  mode_ = makeCombo(modes, tr("Failure mode that is shown"));
  section->addRow(tr("Zone shown"), mode_, tr("Whose critical zone the net shows"));
  connect(mode_, &QComboBox::activated, this, &StereonetPanel::refresh);
  countsNote_ = makeWrappedLabel(tr("Give the face to see what can slide or topple in it."), "muted");
  section->addWide(countsNote_);
  counts_ = new PlainTable;
  counts_->setObjectName(QStringLiteral("counts"));
  counts_->setAccessibleName(tr("Critical poles and intersections"));
  counts_->setSelectionMode(QAbstractItemView::NoSelection);
  section->addWide(counts_);
  return section;
}

QWidget* StereonetPanel::makeWindow() {
  auto* section = new Section(tr("Window"), tr("drag in the net; Shift: a cone"));
  picked_ = makeWrappedLabel({}, "muted");
  picked_->setObjectName(QStringLiteral("picked"));
  section->addWide(picked_);
  auto* line = new QWidget;
  auto* row = new QHBoxLayout(line);
  setMargins(row, 0, 6);
  setName_ = new QLineEdit;
  setName_->setPlaceholderText(tr("name of a joint set"));
  setName_->setAccessibleName(tr("Name of the joint set"));
  assign_ = makeButton(tr("Assign"));
  assign_->setToolTip(tr("Gives the joints in the window to this set"));
  forget_ = makeButton(tr("Clear"));
  row->addWidget(setName_, 1);
  for (auto* button : {assign_, forget_}) {
    button->setAutoDefault(false);
    row->addWidget(button);
  }
  section->addWide(line);
  connect(assign_, &QPushButton::clicked, this, &StereonetPanel::assign);
  connect(setName_, &QLineEdit::returnPressed, this, &StereonetPanel::assign);
  connect(setName_, &QLineEdit::textChanged, this, &StereonetPanel::showWindow);
  connect(forget_, &QPushButton::clicked, this, [this] {
    window_.reset();
    showWindow();
  });
  return section;
}

std::optional<KinematicSetting> StereonetPanel::slope() const {
  if (!faceDip_ || !faceDirection_ || !friction_ || !limit_) return std::nullopt;
  return KinematicSetting{upright({*faceDip_, *faceDirection_}), *friction_, *limit_};
}

Stereonet StereonetPanel::net() const {
  Stereonet net;
  net.joints = joints_.joints;
  net.projection = projection_->currentIndex() == 0 ? Projection::equal_area : Projection::equal_angle;
  if (contours_->currentIndex() > 0)
    net.density = contours_->currentIndex() == 1 ? DensityMethod::fisher : DensityMethod::kamb;
  net.slope = slope();
  net.mode = static_cast<FailureMode>(mode_->currentIndex());
  net.great_circles = planes_->isChecked();
  net.theme = display_.isDark() ? Theme::dark : Theme::light;
  return net;
}

void StereonetPanel::refresh() {
  Project shownProject;  // its cuts are all that there is to see
  shownProject.cuts = drawn_.cuts();
  joints_ = joints_of(shownProject, most_of_a_cut);
  Stereonet shown = net();
  const QColor surface = theme::colours().surface;
  shown.paper = Rgb{static_cast<std::uint8_t>(surface.red()), static_cast<std::uint8_t>(surface.green()),
                    static_cast<std::uint8_t>(surface.blue())};
  const auto count = shown.joints.size();
  const std::optional<DensityMethod> density = shown.density;
  view_->show(std::move(shown));
  note_->setText(count == 0 ? tr("The project has no joints yet: paste a table of them")
                            : numbers::counted(count, "pole") +
                                  (joints_.complete ? tr(", one for each plane")
                                                    : tr(", of the first %1 planes of a cut").arg(most_of_a_cut)));
  const DrawnNet& drawn = view_->drawn();
  density_->setText(density ? legendOf(drawn, *density, display_.isDark() ? Theme::dark : Theme::light) : QString());
  showSets();
  showCounts();
  showSelection();
  showWindow();
}

void StereonetPanel::showSets() {
  const std::vector<SetStatistics> sets = statistics_by_set(joints_.joints);
  std::vector<QStringList> rows;
  for (const SetStatistics& set : sets)
    rows.push_back({text(set.name), numbers::whole(set.members.size()), meanOf(set), kappaOf(set), coneOf(set)});
  sets_->setContent({tr("Set"), tr("Poles"), tr("Mean"), tr("κ"), tr("Cone")}, rows,
                    {true, false, false, false, false});
  for (std::size_t i = 0; i < sets.size(); ++i)
    sets_->item(static_cast<int>(i), 0)->setIcon(symbolOf(i, display_.isDark() ? Theme::dark : Theme::light));
  sets_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  sets_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  sets_->fitHeight(most_sets);
}

void StereonetPanel::showCounts() {
  const auto setting = slope();
  countsNote_->setVisible(!setting);
  counts_->setVisible(setting.has_value());
  if (!setting) return;
  std::vector<PlaneAttitude> planes;
  for (const MeasuredJoint& joint : joints_.joints) planes.push_back(joint.plane);
  const bool paired = planes.size() <= most_paired;
  const KinematicCounts counts = kinematic_counts(planes, *setting, paired);
  std::vector<QStringList> rows;
  const auto add = [&rows](const QString& what, const KinematicCount& count) {
    if (count.total == 0) return rows.push_back({what, tr("not counted"), {}});
    rows.push_back({what, tr("%1 of %2").arg(numbers::whole(count.count), numbers::whole(count.total)),
                    numbers::fixed(count.percent(), 1) + QStringLiteral(" %")});
  };
  add(tr("Planar sliding"), counts.planar);
  add(tr("– without limits"), counts.planar_unlimited);
  add(tr("Wedge sliding"), counts.wedge);
  add(tr("– on one plane"), counts.on_one_plane);
  add(tr("Flexural toppling"), counts.flexural);
  add(tr("Direct toppling"), counts.direct);
  add(tr("– oblique"), counts.direct_oblique);
  add(tr("– base planes"), counts.base);
  counts_->setContent({tr("Critical"), tr("Count"), tr("Share")}, rows, {true, false, false});
  counts_->setToolTip(paired ? QString()
                             : tr("Intersections of more than %1 planes are not counted here").arg(most_paired));
  counts_->fitHeight(most_counts);
}

void StereonetPanel::showSelection() {
  const Item& current = project_.selection().current();
  const Project& project = project_.document().project();
  const auto isSelected = [&](int cut) {
    if (current.kind == Item::Kind::cut) return current.index == cut;
    return current.kind == Item::Kind::joint && current.index >= 0 &&
           current.index < static_cast<int>(project.joints.size()) &&
           project.joints[static_cast<std::size_t>(current.index)].name ==
               project.cuts[static_cast<std::size_t>(cut)].joint;
  };
  std::vector<std::size_t> selected;
  for (std::size_t i = 0; i < joints_.cuts.size(); ++i)
    if (joints_.cuts[i] < static_cast<int>(project.cuts.size()) && isSelected(joints_.cuts[i])) selected.push_back(i);
  view_->setSelected(std::move(selected));
}

void StereonetPanel::showWindow() {
  view_->setWindow(window_);
  std::vector<std::size_t> members;
  if (window_) members = picked(*window_, poles_of(joints_.joints));
  forget_->setEnabled(window_.has_value());
  assign_->setEnabled(!members.empty() && !setName_->text().trimmed().isEmpty());
  if (!window_) return picked_->setText(tr("Picks a set of poles and tells its mean."));
  const QString window = text(window_text(*window_));
  if (members.empty()) return picked_->setText(tr("No pole in %1").arg(window));
  const SetStatistics set = statistics_of(joints_.joints, std::move(members), {});
  picked_->setText(
      tr("%1 in %2\nmean %3,  κ %4,  95 % cone %5")
          .arg(numbers::counted(set.members.size(), "pole"), window, meanOf(set), kappaOf(set), coneOf(set)));
}

void StereonetPanel::choose(std::optional<std::size_t> joint) {
  if (joint)
    project_.selection().select({Item::Kind::cut, joints_.cuts.at(*joint)});
  else
    project_.selection().clear();
}

void StereonetPanel::pickFace() {
  awaitsFace_ = true;
  hide();
  picking_.ask(tr("Click the face in which blocks could fail"), 1,
               [this](const std::vector<PickedPlace>& places) { takeFace(places.front().normal); });
}

void StereonetPanel::takeFace(const Vec3& outwards) {
  constexpr double level = 1e-6;
  PlaneAttitude face = attitude_of_normal(outwards);
  // An upright face looks to where its normal points; a plane alone has two sides.
  if (std::abs(outwards.z()) < level)
    face = {90, azimuth_within_circle(degrees(std::atan2(outwards.x(), outwards.y())))};
  if (outwards.z() < -level)
    return messages_.add({.severity = Problem::Severity::warning,
                          .place = tr("Stereonet"),
                          .problem = tr("the face that was picked overhangs"),
                          .remedy = tr("pick a face that looks upwards, or type dip and dip direction")});
  const auto rounded = [](double angle) { return std::round(10 * angle) / 10; };
  faceDip_ = rounded(face.dip);
  faceDirection_ = std::fmod(rounded(face.dip_direction), 360);
  dipField_->setValue(faceDip_);
  directionField_->setValue(faceDirection_);
  refresh();
}

void StereonetPanel::assign() {
  if (!assign_->isEnabled()) return;
  Project changed = project_.document().project();
  const std::string name = setName_->text().trimmed().toStdString();
  std::set<int> cuts;  // a cut goes as a whole, with all planes that are drawn for it
  for (const std::size_t member : picked(*window_, poles_of(joints_.joints))) cuts.insert(joints_.cuts[member]);
  if (std::ranges::find(changed.joints, name, &Joint::name) == changed.joints.end()) {
    const std::string& before = changed.cuts[static_cast<std::size_t>(*cuts.begin())].joint;
    const auto source = std::ranges::find(changed.joints, before, &Joint::name);
    Joint joint = source == changed.joints.end() ? Joint() : *source;
    joint.name = name;
    changed.joints.push_back(joint);
  }
  for (const int cut : cuts) changed.cuts[static_cast<std::size_t>(cut)].joint = name;
  try {
    project_.document().change(changed, tr("assign %1 to %2").arg(numbers::counted(cuts.size(), "cut"), text(name)));
  } catch (const InputError& error) {
    messages_.add(problemOf(error));
  }
}

void StereonetPanel::savePicture() {
  const QString name = QFileDialog::getSaveFileName(this, tr("Save the stereonet"), {}, tr("Pictures (*.png)"));
  if (name.isEmpty()) return;
  Stereonet drawn = net();
  drawn.window = window_;
  try {
    std::filesystem::path file(name.toStdString());
    if (!file.has_extension()) file += ".png";
    write_png(draw_stereonet(drawn, project_.document().name().toStdString(), stereonet_width, picture_height), file);
    messages_.log(tr("wrote %1").arg(text(file.string())));
  } catch (const InputError& error) {
    messages_.add(problemOf(error));
  }
}

}  // namespace talus
