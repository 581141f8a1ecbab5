#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QToolButton>

#include "driven_form.hpp"
#include "listed_runs.hpp"
#include "unit/io/sample_project.hpp"
#include "widgets/kit/model_words.hpp"
#include "widgets/kit/number_field.hpp"
#include "widgets/setup/property_panel.hpp"

namespace talus {
namespace {

/// What the panel says of a project whose base is shaken and whose joint softens.
class PropertyPanelTest : public DrivenWindow {
 protected:
  void SetUp() override {
    DrivenWindow::SetUp();
    const auto file = write("shaken.talus", R"({
      "talus": 1, "materials": {"rock": {"density": 2600, "young": 25e9, "poisson": 0.24, "damping": 0.5}},
      "joints": {"J1": {"friction_angle": 30, "cohesion": 1e6}}, "default_joint": "J1",
      "solids": [
        {"name": "base", "material": "rock", "body": "fixed", "box": {"min": [0, 0, 0], "max": [9, 9, 1]}},
        {"name": "cube", "material": "rock", "box": {"min": [1, 1, 1], "max": [2, 2, 2]}}],
      "constraints": [{"block": "base", "table": [[0, 0, 0, 0], [0.5, 0.02, 0, 0], [1, 0, 0, 0]]}],
      "loads": [{"block": "cube", "at": [1, 1, 2], "table": [[0, 0, 0, 0], [2, 1e3, 0, 0]]}],
      "in_situ": [{"stress": [-1e6, -2e6, -4e6, 0, 0, 0]}],
      "stages": [
        {"name": "settle", "type": "static", "time_step": 0.01, "steps": 50, "until_equilibrium": true,
         "blocks": [{"name": "cube", "body": "fixed"}]},
        {"name": "shake", "type": "dynamic", "time_step": 0.01, "duration": 1, "damping": 0.1, "loads": [],
         "joints": {"J1": {"friction_angle": 20, "cohesion": 0}}, "blocks": [{"name": "cube", "body": "tetrahedra"}]}],
      "solver": {"integrator": "generalized-alpha", "spectral_radius": 0.9, "contact": "facet-wise",
                 "time_step_control": "adaptive", "adaptive": {"iterations": 6}}})");
    ASSERT_TRUE(session.open(file));
  }

  /// All that stands in the panel once a thing is selected, row by row.
  std::string shown(const Item& item) {
    session.project.selection().select(item);
    QStringList words;
    for (const auto* label : panel.findChildren<QLabel*>()) words << label->text();
    return words.join(u'|').toStdString();
  }

  Session session;
  PropertyPanel panel{session.project,  session.survey,  session.playback,
                      session.messages, session.display, session.picking};
};

void expectWords(const std::string& shown, std::initializer_list<const char*> expected) {
  for (const char* words : expected) EXPECT_NE(shown.find(words), std::string::npos) << words << "\n" << shown;
}

TEST_F(PropertyPanelTest, AFieldThatIsLeftOutSaysWhatThatMeans) {
  expectWords(shown({Item::Kind::stage, 0}), {"Damping", "Joint strength|as before"});
  session.project.selection().select({Item::Kind::joint, 0});
  auto* stiffness = panel.findChild<NumberField*>(QStringLiteral("/joints/J1/normal_stiffness"));
  ASSERT_NE(stiffness, nullptr);
  EXPECT_TRUE(stiffness->text().isEmpty());
  EXPECT_EQ(stiffness->placeholderText(), QStringLiteral("automatic"));
}

TEST_F(PropertyPanelTest, TheTableOfStagesSaysWhatEachChanges) {
  const auto& stages = session.project.document().project().stages;
  EXPECT_EQ(words::changes(stages[0]).toStdString(), "cube held");
  EXPECT_EQ(words::changes(stages[1]).toStdString(), "J1 φ 20°, c 0 MPa; no loads; cube let go; damping 0.1 1/s");
}

TEST_F(PropertyPanelTest, ABodyIsChosenAndTakenBack) {
  ASSERT_EQ(session.project.document().project().solids[1].name, "cube");
  session.project.selection().select({Item::Kind::solid, 1});
  const auto box = [&] { return panel.findChild<QComboBox*>(QStringLiteral("/solids/1/body")); };
  ASSERT_NE(box(), nullptr);
  EXPECT_EQ(box()->currentText().toStdString(), "tetrahedra (usual)");
  // The stages hold the cube and let it go as tetrahedra.
  emit box()->activated(box()->findText(QStringLiteral("rigid")));
  EXPECT_EQ(session.project.document().project().solids[1].body, BodyKind::tetrahedra);
  EXPECT_EQ(box()->currentText().toStdString(), "tetrahedra (usual)");
  auto* said = panel.findChild<QLabel*>(QStringLiteral("/solids/1/body#problem"));
  ASSERT_NE(said, nullptr);
  EXPECT_TRUE(said->text().contains(QStringLiteral("cannot become 'tetrahedra'"))) << said->text().toStdString();
  emit box()->activated(box()->findText(QStringLiteral("auto")));
  EXPECT_EQ(session.project.document().project().solids[1].body, BodyKind::automatic);
  session.project.document().undoStack().undo();
  EXPECT_EQ(session.project.document().project().solids[1].body, BodyKind::tetrahedra);
}

TEST_F(PropertyPanelTest, SaysWhatAutoBecameAndMeshesAnewAfterAChange) {
  ASSERT_TRUE(session.open(write("cube.talus", R"({
      "talus": 1, "materials": {"rock": {"density": 2600, "young": 25e9, "poisson": 0.24}},
      "solids": [{"name": "cube", "material": "rock", "body": "auto", "box": {"min": [1, 1, 1], "max": [2, 2, 2]}}],
      "stages": [{"name": "fall", "type": "dynamic", "time_step": 0.01, "steps": 2}]})")));
  session.run.mesh();
  ASSERT_TRUE(wait([&] { return session.project.systemIsCurrent() && !session.run.job().isBusy(); }));
  expectWords(shown({Item::Kind::block, 0}),
              {"Body|rigid", "chosen: hard rock: the model's weight strains it by 1e-6"});
  const size_t coarse = session.project.system()->blocks[0].mesh.nodes.size();
  Project changed = session.project.document().project();
  changed.solids[0].body = BodyKind::tetrahedra;
  session.project.document().change(changed, {});
  EXPECT_FALSE(session.project.systemIsCurrent());
  session.solve();
  ASSERT_TRUE(wait([&] { return !session.run.job().isBusy(); }));
  EXPECT_TRUE(session.project.systemIsCurrent());
  EXPECT_GT(session.project.system()->blocks[0].mesh.nodes.size(), 10 * coarse);
}

TEST_F(DrivenWindow, TheRestitutionOfAJointIsEditedAsAShareOfSpeed) {
  window->open(slidingCube());
  session->project.selection().select({Item::Kind::joint, 0});
  const auto restitutionField = [&]() -> NumberField* {
    for (auto* candidate : window->findChildren<NumberField*>())
      if (candidate->accessibleName().startsWith(QStringLiteral("Restitution"))) return candidate;
    return nullptr;
  };
  NumberField* field = restitutionField();
  ASSERT_NE(field, nullptr);
  const auto type = [&](const char* number) {
    field->setFocus();
    rest(20);
    field->selectAll();
    QTest::keyClicks(field, QLatin1String(number));
    QTest::keyClick(field, Qt::Key_Return);
  };
  const auto restitution = [&] { return session->project.document().project().joints[0].restitution; };
  EXPECT_TRUE(field->text().isEmpty());
  EXPECT_EQ(field->placeholderText(), QStringLiteral("by stiffness"));
  type("1.5");
  EXPECT_EQ(field->property("state").toString(), QStringLiteral("error"));
  EXPECT_EQ(restitution(), std::nullopt);
  keepPicture(*window, "joint_panel_refused.png");
  type("0,4");
  EXPECT_EQ(restitution(), 0.4);
  rest(50);
  keepPicture(*window, "joint_panel.png");
  field = restitutionField();
  ASSERT_NE(field, nullptr);
  field->setFocus();
  rest(20);
  field->selectAll();
  QTest::keyClick(field, Qt::Key_Delete);
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_EQ(restitution(), std::nullopt) << "an empty field takes it away";
  rest(50);
  keepPicture(*window, "joint_panel_emptied.png");
}

TEST_F(DrivenForm, AnyUnitOfTheKindIsUnderstoodAndAnyOtherSaysWhy) {
  window->open(slidingCube());
  session->project.selection().select({Item::Kind::joint, 0});
  type("/joints/J1/cohesion", QStringLiteral("50 kPa"));
  EXPECT_EQ(project()["joints"]["J1"]["cohesion"], 50000);
  EXPECT_EQ(widget<NumberField>("/joints/J1/cohesion")->text(), QStringLiteral("0.05 MPa"));
  type("/joints/J1/cohesion", QStringLiteral("3 mm"));
  EXPECT_EQ(project()["joints"]["J1"]["cohesion"], 50000);
  auto* said = widget<QLabel>("/joints/J1/cohesion#problem");
  ASSERT_NE(said, nullptr);
  EXPECT_TRUE(said->isVisible());
  EXPECT_TRUE(said->text().contains(QStringLiteral("'mm' is a length, and a stress is wanted here")));
  keepPicture(*window, "wrong_unit.png");
}

TEST_F(DrivenForm, TheUnitsThatAreShownAreChosen) {
  window->open(slidingCube());
  session->project.selection().select({Item::Kind::material, 0});
  const auto shown = [&](const char* name) { return widget<NumberField>(name)->text(); };
  EXPECT_EQ(shown("/materials/rock/young"), QStringLiteral("1 GPa"));
  const auto choose_unit = [&](const QString& quantity, const QString& unit) {
    auto* button = window->findChild<QToolButton*>(QStringLiteral("units"));
    for (auto* kind : button->menu()->actions())
      if (kind->text() == quantity)
        for (auto* entry : kind->menu()->actions())
          if (entry->text() == unit) entry->trigger();
    rest(10);
  };
  choose_unit(QStringLiteral("Stress"), QStringLiteral("kPa"));
  choose_unit(QStringLiteral("Density"), QStringLiteral("kN/m³"));
  EXPECT_EQ(shown("/materials/rock/young"), QStringLiteral("1000000 kPa"));
  EXPECT_EQ(shown("/materials/rock/density"), QStringLiteral("25.506 kN/m³"));
  type("/materials/rock/density", QStringLiteral("26.487"));
  EXPECT_NEAR(project()["materials"]["rock"]["density"].get<double>(), 2700, 1e-9);
  for (const char* quantity : {"Stress", "Density"})
    choose_unit(QLatin1String(quantity), QStringLiteral("as usual for each"));
  EXPECT_EQ(shown("/materials/rock/young"), QStringLiteral("1 GPa"));
}

TEST_F(DrivenForm, AThingThatIsRenamedTakesAlongWhoNamesIt) {
  window->open(slidingCube());
  session->project.selection().select({Item::Kind::material, 0});
  type("/materials/rock#name", QStringLiteral("granite"));
  EXPECT_EQ(project()["solids"][0]["material"], "granite");
  EXPECT_EQ(project()["solids"][1]["material"], "granite");
  session->project.selection().select({Item::Kind::solid, 1});
  type("/solids/1/name", QStringLiteral("boulder"));
  EXPECT_EQ(project()["monitors"][0]["block"], "boulder");
  EXPECT_EQ(session->project.document().undoStack().undoText(), QStringLiteral("rename solid cube"));
}

TEST_F(DrivenForm, ThingsAreCopiedMovedAndDeletedUnlessTheyAreNamed) {
  window->open(slidingCube());
  Selection& selection = session->project.selection();
  selection.select({Item::Kind::material, 0});
  const auto tool = [&](const char* name) {
    for (auto* button : window->findChild<PropertyPanel*>()->findChildren<QToolButton*>())
      if (button->accessibleName() == QLatin1String(name)) QTest::mouseClick(button, Qt::LeftButton);
    rest(10);
  };
  tool("Delete");
  EXPECT_TRUE(project()["materials"].contains("rock"));
  ASSERT_EQ(session->messages.problems().size(), 1u);
  EXPECT_EQ(session->messages.problems()[0].problem.toStdString(), "material rock is used by solid base, solid cube");
  tool("Duplicate");
  EXPECT_TRUE(project()["materials"].contains("rock 1"));
  EXPECT_EQ(selection.current(), (Item{Item::Kind::material, 1}));
  tool("Move up the list");
  EXPECT_EQ(project()["materials"].begin().key(), "rock 1");
  EXPECT_EQ(selection.current(), (Item{Item::Kind::material, 0}));
  tool("Delete");
  EXPECT_FALSE(project()["materials"].contains("rock 1"));
  EXPECT_EQ(session->project.document().undoStack().count(), 3);
}

TEST_F(DrivenForm, ABlockThatWasCutIsNamedFromItsPanel) {
  openAndMesh(slidingCube());
  session->project.selection().select({Item::Kind::block, 1});
  click("wish");
  rest(20);
  EXPECT_EQ(session->project.selection().current(), (Item{Item::Kind::blockWish, 0}));
  type("/blocks/0/name", QStringLiteral("slider"));
  choose("/blocks/0/body", QStringLiteral("rigid"));
  session->run.mesh();
  ASSERT_TRUE(wait([&] { return !session->run.job().isBusy(); }));
  EXPECT_EQ(session->project.system()->blocks[1].name, "slider");
  EXPECT_EQ(session->project.system()->blocks[1].body, BodyKind::rigid);
}

TEST_F(DrivenForm, ATimeTableIsPastedFromASpreadsheet) {
  window->open(slidingCube());
  const Place load = addThing("loads");
  choose(load.to_string() + "#variant", QStringLiteral("By time"));
  QApplication::clipboard()->setText(QStringLiteral("t\tx\ty\tz\n0\t0\t0\t-1\n0.5\t0,25\t0\t-2\r\n2\t0\t0\t-4\n"));
  click("/loads/0/table#paste");
  EXPECT_EQ(project()["loads"][0]["table"], Json::parse("[[0,0,0,-1000],[0.5,250,0,-2000],[2,0,0,-4000]]"))
      << "kN are shown";
  rest(20);
  keepPicture(*window, "time_table.png");
  QApplication::clipboard()->setText(QStringLiteral("0\t1\n"));
  click("/loads/0/table#paste");
  EXPECT_TRUE(widget<QLabel>("/loads/0/table#problem")->text().contains(QStringLiteral("2 numbers; 4 are wanted")));
  EXPECT_EQ(project()["loads"][0]["table"].size(), 3u);
  click("/loads/0/table#add");
  EXPECT_EQ(project()["loads"][0]["table"].size(), 4u);
  click("/loads/0/table#remove");
  EXPECT_EQ(project()["loads"][0]["table"].size(), 3u);
}

TEST_F(DrivenForm, TheSolverHasReadySettingsAndAllItsFields) {
  window->open(slidingCube());
  selectRow({Item::Kind::solver, 0});
  EXPECT_EQ(widget<QComboBox>("/solver#preset")->currentText(), QStringLiteral("standard"));
  choose("/solver#preset", QStringLiteral("draft"));
  EXPECT_EQ(project()["solver"]["adaptive"]["error_limit"], 1e-3);
  EXPECT_EQ(project()["solver"]["tolerance"], "draft");
  choose("/solver#depth", QStringLiteral("nothing more"));
  rest(20);
  EXPECT_EQ(window->findChild<QWidget*>(QStringLiteral("/solver/contact_stiffness")), nullptr);
  choose("/solver#depth", QStringLiteral("what the file says"));
  rest(20);
  EXPECT_NE(window->findChild<QWidget*>(QStringLiteral("/solver/time_step_control")), nullptr);
  EXPECT_EQ(window->findChild<QWidget*>(QStringLiteral("/solver/contact_stiffness")), nullptr);
  choose("/solver#depth", QStringLiteral("all fields"));
  rest(20);
  type("/solver/contact_stiffness", QStringLiteral("12"));
  EXPECT_EQ(widget<QComboBox>("/solver#preset")->currentText(), QStringLiteral("own"));
  choose("/solver#preset", QStringLiteral("standard"));
  EXPECT_FALSE(project().contains("solver"));
}

TEST_F(DrivenForm, AToleranceIsChosenByItsNameOrTypedAsANumber) {
  window->open(slidingCube());
  selectRow({Item::Kind::solver, 0});
  const std::string field = "/solver/tolerance";
  EXPECT_EQ(widget<QComboBox>(field)->currentText(), QString());
  EXPECT_EQ(widget<QComboBox>(field)->lineEdit()->placeholderText(), QStringLiteral("standard (usual)"));
  choose(field, QStringLiteral("reference"));
  EXPECT_EQ(project()["solver"]["tolerance"], "reference");
  EXPECT_EQ(widget<QComboBox>(field)->currentText(), QStringLiteral("reference"));
  type(field, QStringLiteral("2.5e-5"));
  EXPECT_EQ(project()["solver"]["tolerance"], 2.5e-5);
  type(field, QStringLiteral("draft"));
  EXPECT_EQ(project()["solver"]["tolerance"], "draft");
  for (const char* wrong : {"standart", "0.5"}) {
    type(field, QLatin1String(wrong));
    EXPECT_EQ(project()["solver"]["tolerance"], "draft") << wrong << " was taken";
    EXPECT_TRUE(widget<QLabel>(field + "#problem")->isVisible()) << wrong;
  }
  type(field, QString());
  EXPECT_FALSE(project().contains("solver") && project()["solver"].contains("tolerance"));
  rest(50);
  keepPicture(*window, "solver_tolerance.png");
}

TEST_F(DrivenWindow, AQuantityIsReadWholeOnASmallScreen) {
  window->resize(1280, 720);
  window->open(write("full.talus", test::full_project));
  session->display.goTo(WorkflowPage::loads);
  session->project.selection().select({Item::Kind::expectation, 1});
  rest(50);
  const auto* box = window->findChild<QComboBox*>(QStringLiteral("/expect/1/quantity"));
  ASSERT_NE(box, nullptr);
  ASSERT_EQ(box->currentText(), QStringLiteral("slope.2.velocity.magnitude"));
  const QLineEdit& entry = *box->lineEdit();
  EXPECT_LE(entry.fontMetrics().horizontalAdvance(entry.text()) + 2 * 3, entry.width()) << "beside the text's margins";
}

TEST_F(DrivenWindow, OneGoesOnTypingAfterANumberWasAccepted) {
  window->open(slidingCube());
  session->project.selection().select({Item::Kind::joint, 0});
  const auto field = [&](const char* name) -> NumberField* {
    for (auto* one : window->findChildren<NumberField*>())
      if (one->accessibleName() == QString::fromUtf8(name)) return one;
    return nullptr;
  };
  ASSERT_NE(field("Friction angle φ"), nullptr);
  window->activateWindow();
  field("Friction angle φ")->setFocus();
  rest(20);
  QTest::keyClicks(field("Friction angle φ"), QStringLiteral("25"));
  QTest::keyClick(field("Friction angle φ"), Qt::Key_Return);
  rest(50);
  EXPECT_EQ(session->project.document().project().joints[0].friction_angle, 25);
  EXPECT_EQ(QApplication::focusWidget(), field("Friction angle φ")) << "Return stays";
  QTest::keyClicks(field("Friction angle φ"), QStringLiteral("26"));
  QTest::keyClick(field("Friction angle φ"), Qt::Key_Tab);
  rest(50);
  EXPECT_EQ(session->project.document().project().joints[0].friction_angle, 26);
  EXPECT_EQ(QApplication::focusWidget(), field("Cohesion c")) << "Tab goes on";
}

}  // namespace
}  // namespace talus
