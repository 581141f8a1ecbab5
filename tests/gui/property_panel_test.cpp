#include <QApplication>
#include <QComboBox>
#include <QLabel>

#include "driven_window.hpp"
#include "listed_runs.hpp"
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
  PropertyPanel panel{session.project, session.playback, session.messages};
};

void expectWords(const std::string& shown, std::initializer_list<const char*> expected) {
  for (const char* words : expected) EXPECT_NE(shown.find(words), std::string::npos) << words << "\n" << shown;
}

TEST_F(PropertyPanelTest, ShowsTheSolverAndTheStressInSitu) {
  expectWords(shown({}),
              {"Strain|corotational", "Integrator|generalized-alpha", "Spectral radius|0.900", "Contact|facet-wise",
               "Time steps|adaptive", "Iterations|6", "every block|−1.000, −2.000, −4.000"});
}

TEST_F(PropertyPanelTest, ShowsWhatActsByTable) {
  expectWords(shown({Item::Kind::load, 0}), {"Force by table|2 rows, 0 … 2.000 s"});
  expectWords(shown({Item::Kind::constraint, 0}), {"At, m|whole block", "3 rows, 0 … 1.000 s", "East|by table"});
}

TEST_F(PropertyPanelTest, ShowsHowAStageEndsAndWhatItChanges) {
  expectWords(shown({Item::Kind::stage, 0}), {"Until equilibrium|1", "cube|held"});
  expectWords(shown({Item::Kind::stage, 1}),
              {"Damping|0.100 1/s", "J1|φ 20.0°, c 0 MPa", "Point loads|none", "cube|let go"});
}

TEST_F(PropertyPanelTest, ABodyIsChosenAndTakenBack) {
  ASSERT_EQ(session.project.document().project().solids[1].name, "cube");
  session.project.selection().select({Item::Kind::solid, 1});
  auto* box = panel.findChild<QComboBox*>();
  ASSERT_NE(box, nullptr);
  EXPECT_EQ(box->currentText().toStdString(), "tetrahedra");
  // The stages hold the cube and let it go as tetrahedra.
  emit box->activated(box->findText(QStringLiteral("rigid")));
  EXPECT_EQ(session.project.document().project().solids[1].body, BodyKind::tetrahedra);
  ASSERT_EQ(session.messages.problems().size(), 1u);
  EXPECT_NE(session.messages.problems()[0].problem.indexOf(QStringLiteral("cannot become 'tetrahedra'")), -1);
  EXPECT_EQ(box->currentText().toStdString(), "tetrahedra");
  emit box->activated(box->findText(QStringLiteral("auto")));
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
  Solid changed = session.project.document().project().solids[0];
  changed.body = BodyKind::tetrahedra;
  session.project.document().changeSolid(0, changed);
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
