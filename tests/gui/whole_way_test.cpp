// The whole way of setting a slope up, by clicks and keys alone: from a template, and from nothing to a solved pit
// wall, back to nothing and again to all of it. The session is read, never told.
#include <gmock/gmock.h>

#include <QClipboard>
#include <QListWidget>
#include <array>
#include <cmath>

#include "answers.hpp"
#include "base/units.hpp"
#include "driven_form.hpp"
#include "geometry/solid_surface.hpp"
#include "io/whole_file.hpp"
#include "listed_runs.hpp"
#include "mesh/volume_sum.hpp"
#include "templates/templates.hpp"
#include "widgets/begin/new_dialog.hpp"
#include "widgets/begin/project_preview.hpp"
#include "widgets/blocks/quality_chart.hpp"
#include "widgets/blocks/rule_dialog.hpp"
#include "widgets/blocks/splinter_panel.hpp"
#include "widgets/geometry/import_dialog.hpp"
#include "widgets/joints/joint_handles.hpp"
#include "widgets/kit/plain_table.hpp"
#include "widgets/orientation/paste_joints.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;
using testing::SizeIs;

/// The ground in front of the wall, as a survey gives it: 30 m from point to point, the west edge at the wall's foot.
const char* const surveyed_ground = R"(ncols 5
nrows 5
xllcenter 160
yllcenter 0
cellsize 30
NODATA_value -9999
20 19 18 17 16
20 18 17 16 15
20 18 16 15 14
20 18 17 16 15
20 19 18 17 16
)";

/// Three sets as a spreadsheet has them. The last side joint runs a hand's breadth within the wall's northern end.
const char* const measured_joints =
    "dip;dip direction;set;x;y;z\n"
    "35;90;bedding;73;60;68\n"
    "75;90;rear;36;60;100\n"
    "90;0;side;60;60;60\n"
    "90;0;side;60;119.9;60\n";

class WholeWay : public DrivenForm {
 public:
  // The steps.
  void aTemplateIsMadeAProject();
  void anEmptyProjectIsBegunAndNamed();
  void theWallIsImportedFromAStepFile();
  void theGroundIsImportedFromAGridOfHeights();
  void threeSetsArePastedAndBeddingIsMadeStronger();
  void aSideJointIsMovedByItsHandle();
  void theRockIsCutAndItsSplintersAreDropped();
  void theMassifIsFixedByRule();
  void whatCanSlideIsMadeRigidByRule();
  void rockAndGroundAreGivenTheirMaterials();
  void theMeshIsGivenItsSizeAndMade();
  void aLoadIsPicked();
  void aMonitorIsPicked();
  void twoStagesAreDescribed();
  void theProjectIsSavedAndEqualsTheReference();
  void itIsSolvedAndTheSlabsSlide();
  void allIsUndone();
  void allIsRedone();

  // What hands do.
  /// Asks for a new project, and chooses in the list by these letters.
  NewDialog* newDialog(const char* letters);
  /// The dialog that a file is imported by, once it has read it.
  ImportDialog* importOf(const fs::path& file);
  /// Takes what it has read, and waits until the solid is seen.
  void takeImport(const char* name);
  void typeIn(QWidget& dialog, const char* field, const QString& words);
  /// By the large button over the view.
  void cutAndMesh();

  // What is looked at.
  const Project& rock() { return session->project.document().project(); }
  std::string textNow() { return session->project.document().text(); }
  std::vector<std::string> selectedBlocks();
  /// Kept for who wants to see it, once the view is still.
  void picture(QWidget& widget, const char* name);

  fs::path saved;
  std::string atTheBeginning;
  std::vector<std::string> slabs;  ///< names of the blocks that can slide, from the north
  std::shared_ptr<const BlockSystem> built;
};

NewDialog* WholeWay::newDialog(const char* letters) {
  press(Qt::Key_N, Qt::ControlModifier);
  auto* dialog = window->findChild<NewDialog*>();
  if (dialog) QTest::keyClicks(dialog->findChild<QListWidget*>(), QLatin1String(letters));
  return dialog;
}

void WholeWay::typeIn(QWidget& dialog, const char* field, const QString& words) {
  for (auto* entry : dialog.findChildren<QLineEdit*>())
    if (entry->accessibleName() == QString::fromUtf8(field) && entry->isVisibleTo(&dialog)) {
      entry->setFocus();
      entry->selectAll();
      QTest::keyClicks(entry, words);
      return QTest::keyClick(entry, Qt::Key_Tab);
    }
  FAIL() << "no field " << field;
}

ImportDialog* WholeWay::importOf(const fs::path& file) {
  const FileAnswer answer(file);
  press(Qt::Key_I, Qt::ControlModifier | Qt::ShiftModifier);
  auto* dialog = window->findChild<ImportDialog*>();
  if (dialog) wait([&] { return !dialog->isReading(); });
  return dialog;
}

void WholeWay::takeImport(const char* name) {
  picture(*window->findChild<ImportDialog*>(), name);
  click("import");
  ASSERT_TRUE(wait([&] { return session->surfaces.current() && !session->surfaces.isBusy(); }));
}

void WholeWay::cutAndMesh() {
  click("primary");
  ASSERT_TRUE(session->run.job().isBusy());
  ASSERT_TRUE(wait([&] { return !session->run.job().isBusy(); }));
  rest(50);
}

std::vector<std::string> WholeWay::selectedBlocks() {
  std::vector<std::string> names;
  for (const int block : session->project.selection().blocks())
    names.push_back(session->project.blockName(block).toStdString());
  return names;
}

void WholeWay::picture(QWidget& widget, const char* name) {
  if (qEnvironmentVariableIsSet("TALUS_PICTURES")) rest(600);
  keepPicture(widget, name);
}

void WholeWay::aTemplateIsMadeAProject() {
  auto* dialog = newDialog("Wed");
  ASSERT_NE(dialog, nullptr);
  typeIn(*dialog, "Slope height", QStringLiteral("18 m"));
  typeIn(*dialog, "Friction angle φ", QStringLiteral("25"));
  ASSERT_TRUE(wait([&] { return dialog->preview().isUpToDate(); }));
  picture(*dialog, "whole_way_new.png");
  talus::click(button(*dialog, "Create"));
  ASSERT_TRUE(wait([&] { return !session->run.job().isBusy() && session->project.system(); }));
  EXPECT_EQ(rock(), project_from(template_named("wedge"), {{"height", 18}, {"friction", 25}}));
}

void WholeWay::anEmptyProjectIsBegunAndNamed() {
  const Answer answer(QStringLiteral("Discard"));
  auto* dialog = newDialog("Emp");
  ASSERT_NE(dialog, nullptr) << answer.asked().toStdString();
  talus::click(button(*dialog, "Create"));
  rest(30);
  EXPECT_TRUE(answer.asked().contains(QStringLiteral("Rock wedge"))) << answer.asked().toStdString();
  ASSERT_EQ(rock(), emptyProject());
  atTheBeginning = textNow();
  type("/name", QStringLiteral("Pit wall"));
  EXPECT_EQ(rock().name, "Pit wall");
}

void WholeWay::theWallIsImportedFromAStepFile() {
  fs::create_directories(folder / "survey");
  fs::copy(fs::path(TALUS_SOURCE_DIR) / "samples/step_slope/slope.step", folder / "survey/slope.step");
  auto* dialog = importOf(folder / "survey/slope.step");
  ASSERT_NE(dialog, nullptr);
  typeIn(*dialog, "Name of the solid", QStringLiteral("wall"));
  takeImport("whole_way_step.png");
  ASSERT_THAT(rock().solids, SizeIs(1));
  EXPECT_LT((session->surfaces.current()->at(0).max - Vec3(160, 120, 100)).norm(), 1e-6);
}

void WholeWay::theGroundIsImportedFromAGridOfHeights() {
  auto* dialog = importOf(write("survey/ground.asc", surveyed_ground));
  ASSERT_NE(dialog, nullptr);
  typeIn(*dialog, "Name of the solid", QStringLiteral("ground"));
  typeIn(*dialog, "Base of the rock", QStringLiteral("10 m"));
  ASSERT_TRUE(wait([&] { return !dialog->isReading(); }));
  takeImport("whole_way_terrain.png");
  ASSERT_THAT(rock().solids, SizeIs(2));
  const SolidSurface& ground = session->surfaces.current()->at(1);
  EXPECT_LT((ground.min - Vec3(160, 0, 10)).norm(), 1e-6);
  EXPECT_LT((ground.max - Vec3(280, 120, 20)).norm(), 1e-6);
}

void WholeWay::threeSetsArePastedAndBeddingIsMadeStronger() {
  QApplication::clipboard()->setText(QString::fromUtf8(measured_joints));
  press(Qt::Key_V, Qt::ControlModifier | Qt::ShiftModifier);
  auto* dialog = window->findChild<PasteJoints*>();
  ASSERT_NE(dialog, nullptr);
  picture(*dialog, "whole_way_paste.png");
  talus::click(button(*dialog, "Add 4 joints"));
  ASSERT_THAT(rock().joints, SizeIs(3));
  EXPECT_THAT(rock().cuts, SizeIs(4));
  EXPECT_EQ(rock().default_joint, "bedding") << "contacts on no cut need a joint as soon as there are joints";
  goTo(WorkflowPage::joints);
  selectRow({Item::Kind::joint, 0});
  type("/joints/bedding/friction_angle", QStringLiteral("40°"));
  EXPECT_EQ(rock().joints[0].friction_angle, 40);
}

void WholeWay::aSideJointIsMovedByItsHandle() {
  selectRow({Item::Kind::cut, 2});
  const auto& handles = *window->findChild<JointHandles*>();
  const CutHandle arrow{CutHandle::Kind::move};
  const auto from = handles.knobOf(arrow), to = handles.knobOf(arrow, -4);
  ASSERT_TRUE(from && to);
  drag(area(), *from, *to, Qt::ShiftModifier);
  EXPECT_EQ(rock().cuts[2].through, Vec3(60, 56, 60));
}

void WholeWay::theRockIsCutAndItsSplintersAreDropped() {
  goTo(WorkflowPage::blocks);
  selectRow({Item::Kind::splinters, 0});
  type("/splinters/thickness", QStringLiteral("30 cm"));
  choose("/splinters/rule", QStringLiteral("refuse"));
  cutAndMesh();
  EXPECT_EQ(session->project.system(), nullptr);
  const auto& splinters = *window->findChild<PlainTable*>(QStringLiteral("splinters"));
  ASSERT_TRUE(splinters.isVisible());
  EXPECT_EQ(splinters.item(0, 1)->text(), QStringLiteral("refused"));
  EXPECT_NEAR(splinters.item(0, 2)->text().toDouble(), 0.1, 1e-3) << "a sheet along the wall's end";
  picture(*window, "whole_way_splinters.png");
  talus::click(button(*window->findChild<SplinterPanel*>(), "Drop them"));
  cutAndMesh();
  ASSERT_NE(session->project.system(), nullptr);
  EXPECT_TRUE(volume_sum(*session->project.system()).adds_up());
  EXPECT_EQ(splinters.item(0, 1)->text(), QStringLiteral("left out"));
}

void WholeWay::theMassifIsFixedByRule() {
  press(Qt::Key_F, Qt::ControlModifier);
  ASSERT_TRUE(wait([&] { return session->survey.facts() != nullptr; }));
  choose("question", QStringLiteral("volume above"));
  type("number", QStringLiteral("40000 m3"));  // Enter selects
  EXPECT_THAT(selectedBlocks(), SizeIs(6));
  talus::click(button(*window->findChild<RuleDialog*>(), "Close"));
  choose("body", QStringLiteral("fixed"));
  cutAndMesh();
}

void WholeWay::whatCanSlideIsMadeRigidByRule() {
  press(Qt::Key_F, Qt::ControlModifier);
  ASSERT_TRUE(wait([&] { return session->survey.facts() != nullptr; }));
  choose("question", QStringLiteral("can leave"));
  choose("way", QStringLiteral("slides on one face"));
  click("select");
  EXPECT_THAT(selectedBlocks(), SizeIs(4));
  choose("question", QStringLiteral("volume above"));
  choose("how", QStringLiteral("all that stays of it"));
  type("number", QStringLiteral("10000 m3"));
  picture(*window->findChild<RuleDialog*>(), "whole_way_rule.png");
  ASSERT_THAT(selectedBlocks(), SizeIs(2)) << "not the slivers of the berm";
  slabs = selectedBlocks();
  talus::click(button(*window->findChild<RuleDialog*>(), "Close"));
  choose("body", QStringLiteral("rigid"));
}

void WholeWay::rockAndGroundAreGivenTheirMaterials() {
  goTo(WorkflowPage::materials);
  selectRow({Item::Kind::material, 0});
  type("/materials/rock#name", QStringLiteral("limestone"));
  enter(Place("/materials/limestone"), {{"density", 2650}, {"young", 20e9}, {"poisson", 0.25}});
  enterThings("materials", {{"marl", {{"density", 2300}, {"young", 5e9}, {"poisson", 0.3}}}});
  goTo(WorkflowPage::geometry);
  selectRow({Item::Kind::solid, 1});
  choose("/solids/1/material", QStringLiteral("marl"));
}

void WholeWay::theMeshIsGivenItsSizeAndMade() {
  goTo(WorkflowPage::mesh);
  selectRow({Item::Kind::mesh, 0});
  type("/mesh/size", QStringLiteral("8 m"));
  cutAndMesh();
  ASSERT_TRUE(session->project.systemIsCurrent());
  EXPECT_GT(window->findChild<QualityChart*>()->count(), 0);
}

void WholeWay::aLoadIsPicked() {
  goTo(WorkflowPage::loads);
  const Vec3 crane(48, 25, 100);
  chooseInMenus({"Model", "Loads and supports", "Load at a point…"});
  clickOnRock(crane);
  type("vector#amount", QStringLiteral("10 MN"));  // Enter creates
  ASSERT_THAT(rock().loads, SizeIs(1));
  EXPECT_EQ(rock().loads[0].block, slabs[1]);
  EXPECT_EQ(rock().loads[0].force, Vec3(0, 0, -10e6));
  EXPECT_LT((rock().loads[0].at - crane).norm(), 2 * window->viewport().metresPerPixel(crane));
  enter(Place("/loads/0/at"), {48, 25, 100});
}

void WholeWay::aMonitorIsPicked() {
  const Vec3 crest(54, 90, 100);
  chooseInMenus({"Model", "Loads and supports", "Monitor here"});
  clickOnRock(crest);
  ASSERT_THAT(rock().monitors, SizeIs(1));
  EXPECT_EQ(rock().monitors[0].block, slabs[0]);
  EXPECT_LT((rock().monitors[0].at - crest).norm(), 2 * window->viewport().metresPerPixel(crest));
  enter(Place("/monitors/0"), {{"name", "crest"}, {"block", slabs[0]}, {"at", {54, 90, 100}}});
}

void WholeWay::twoStagesAreDescribed() {
  goTo(WorkflowPage::stages);
  enterThings("stages", {{{"name", "settle"}, {"type", "static"}, {"time_step", 0.01}, {"steps", 20}},
                         {{"name", "bedding softens"},
                          {"type", "dynamic"},
                          {"time_step", 0.01},
                          {"duration", 0.5},
                          {"joints", {{"bedding", {{"friction_angle", 20}}}}}}});
  selectRow({Item::Kind::output, 0});
  type("/output/every", QStringLiteral("0.1 s"));
}

void WholeWay::theProjectIsSavedAndEqualsTheReference() {
  saved = folder / "pit_wall.talus";
  const FileAnswer answer(saved);
  press(Qt::Key_S, Qt::ControlModifier);
  ASSERT_TRUE(fs::exists(saved)) << answer.asked().toStdString();
  EXPECT_EQ(answer.proposed(), QStringLiteral("pit_wall.talus"));
  EXPECT_TRUE(fs::exists(folder / "slope.step") && fs::exists(folder / "ground.asc")) << "what it names comes along";
  const fs::path reference = fs::path(TALUS_SOURCE_DIR) / "tests/gui/whole_way.talus";
  if (fs::exists(reference) && read_whole_file(saved) == read_whole_file(reference)) return;
  fs::copy_file(saved, fs::current_path() / "whole_way.talus", fs::copy_options::overwrite_existing);
  ADD_FAILURE() << "another project than " << reference << ", see whole_way.talus";
}

/// As a block does without side walls: by g (sin 35° − tan 20° cos 35°).
void WholeWay::itIsSolvedAndTheSlabsSlide() {
  press(Qt::Key_F5);
  ASSERT_TRUE(wait([&] { return session->display.page() == WorkflowPage::results && session->playback.frame(); }))
      << session->run.whyNotSolve().toStdString();
  ASSERT_TRUE(session->run.report());
  EXPECT_EQ(session->run.report()->status, RunStatus::completed);
  const auto& history = session->run.history();
  const auto settled = std::ranges::find(history, 1, &HistoryRow::stage);
  ASSERT_TRUE(settled != history.begin() && settled != history.end());
  const Vec3 before = std::prev(settled)->monitors.at(0).displacement;
  EXPECT_LT(before.norm(), 0.01) << "40° of friction hold it";
  const Vec3 slid = history.back().monitors.at(0).displacement - before;
  const double dip = radians(35), acceleration = 9.81 * (std::sin(dip) - std::tan(radians(20)) * std::cos(dip));
  EXPECT_NEAR(slid.x(), std::cos(dip) * acceleration * 0.125, 0.001 * acceleration * 0.125);
  EXPECT_NEAR(slid.z(), -std::sin(dip) * acceleration * 0.125, 0.001 * acceleration * 0.125);
}

void WholeWay::allIsUndone() {
  built = session->project.system();
  const int steps = session->project.document().undoStack().count();
  EXPECT_GT(steps, 30);
  EXPECT_EQ(clickWhileItCan("Undo"), steps);
  EXPECT_EQ(textNow(), atTheBeginning) << "to the byte";
}

void WholeWay::allIsRedone() {
  EXPECT_EQ(clickWhileItCan("Redo"), session->project.document().undoStack().count());
  EXPECT_EQ(textNow(), read_whole_file(saved)) << "to the byte";
  EXPECT_TRUE(session->project.document().isSaved());
  EXPECT_EQ(session->project.system(), built);
  EXPECT_TRUE(session->project.systemIsCurrent());
  EXPECT_TRUE(session->playback.isCurrent()) << "the results are those of the project again";
}

TEST_F(WholeWay, FromATemplateAndFromNothingToASolvedSlopeAndBack) {
  constexpr std::array steps{&WholeWay::aTemplateIsMadeAProject,
                             &WholeWay::anEmptyProjectIsBegunAndNamed,
                             &WholeWay::theWallIsImportedFromAStepFile,
                             &WholeWay::theGroundIsImportedFromAGridOfHeights,
                             &WholeWay::threeSetsArePastedAndBeddingIsMadeStronger,
                             &WholeWay::aSideJointIsMovedByItsHandle,
                             &WholeWay::theRockIsCutAndItsSplintersAreDropped,
                             &WholeWay::theMassifIsFixedByRule,
                             &WholeWay::whatCanSlideIsMadeRigidByRule,
                             &WholeWay::rockAndGroundAreGivenTheirMaterials,
                             &WholeWay::theMeshIsGivenItsSizeAndMade,
                             &WholeWay::aLoadIsPicked,
                             &WholeWay::aMonitorIsPicked,
                             &WholeWay::twoStagesAreDescribed,
                             &WholeWay::theProjectIsSavedAndEqualsTheReference,
                             &WholeWay::itIsSolvedAndTheSlabsSlide,
                             &WholeWay::allIsUndone,
                             &WholeWay::allIsRedone};
  int number = 0;
  for (const auto step : steps) {
    (this->*step)();
    ++number;
    picture(*window, QStringLiteral("whole_way_%1.png").arg(number, 2, 10, QLatin1Char('0')).toLatin1());
    ASSERT_FALSE(HasFatalFailure());
  }
}

}  // namespace
}  // namespace talus
