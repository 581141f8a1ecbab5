#include "widgets/study/accuracy_panel.hpp"

#include <QAction>
#include <QComboBox>
#include <QLineEdit>
#include <QScrollBar>
#include <QTest>

#include "io/project_file.hpp"
#include "listed_runs.hpp"
#include "studied_window.hpp"
#include "widgets/kit/theme.hpp"

namespace talus {
namespace {

class AccuracyPanelTest : public StudiedWindow {
 protected:
  /// From the menu, as a user does.
  AccuracyPanel& opened() {
    for (auto* action : window->findChildren<QAction*>())
      if (action->text() == QStringLiteral("Accuracy…")) action->trigger();
    rest(50);
    return *window->findChild<AccuracyPanel*>();
  }
  static PlainTable& table(AccuracyPanel& panel, const char* name) {
    return *panel.findChild<PlainTable*>(QLatin1String(name));
  }
  static void typeOver(QLineEdit& field, const char* words) {
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, QLatin1String(words));
    QTest::keyClick(&field, Qt::Key_Return);
  }
  static bool says(AccuracyPanel& panel, const QString& words) {
    const auto labels = panel.findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(), [&](const QLabel* one) { return one->text().contains(words); });
  }
};

TEST_F(AccuracyPanelTest, SaysHowToGetAStudyWhereThereIsNone) {
  window->open(slidingCube(100));
  AccuracyPanel& panel = opened();
  EXPECT_TRUE(panel.isVisible());
  EXPECT_TRUE(says(panel, QStringLiteral("talus-cli study accuracy")));
  EXPECT_FALSE(panel.findChild<AccuracyChart*>()->isVisible());
  keepPicture(panel, "accuracy_none.png");
}

TEST_F(AccuracyPanelTest, BeginsAStudyWhereThereIsNone) {
  qputenv("TALUS_CLI", TALUS_CLI);
  window->open(slidingCube(20));
  AccuracyPanel& panel = opened();
  QPushButton& begin = button(panel, "Study accuracy");
  ASSERT_TRUE(begin.isVisible() && begin.isEnabled()) << begin.toolTip().toStdString();
  click(begin);
  ASSERT_TRUE(session->study.isBusy());
  EXPECT_EQ(begin.text(), QStringLiteral("Stop"));
  ASSERT_TRUE(wait([&] { return !session->study.isBusy(); }, 300000));
  ASSERT_TRUE(session->project.study());
  EXPECT_TRUE(panel.findChild<AccuracyChart*>()->isVisible()) << "it shows what has been made";
  EXPECT_FALSE(begin.isVisible());
  EXPECT_EQ(table(panel, "runs").rowCount(), static_cast<int>(session->project.study()->study.rows.size()));
}

TEST_F(AccuracyPanelTest, GoesOnWithMoreRunsOfEachSettingAndAnotherMeasure) {
  qputenv("TALUS_CLI", TALUS_CLI);
  const auto file = slidingCube(20);
  study(file);
  window->open(file);
  AccuracyPanel& panel = opened();
  const auto buttons = panel.findChildren<QPushButton*>();
  const auto shown = std::ranges::find_if(buttons, [](const QPushButton* one) {
    return one->isVisible() && one->text() == QStringLiteral("Study further");
  });
  ASSERT_NE(shown, buttons.end());
  QPushButton& further = **shown;
  EXPECT_FALSE(further.isEnabled());
  EXPECT_EQ(further.toolTip(), QStringLiteral("The study has all of these runs"));

  auto& repeats = *further.parentWidget()->findChild<QLineEdit*>(QStringLiteral("repeats"));
  typeOver(repeats, "1.5");
  EXPECT_FALSE(further.isEnabled()) << "no whole number";
  typeOver(repeats, "2");
  further.parentWidget()->findChild<QComboBox*>(QStringLiteral("studyMeasure"))->setCurrentIndex(1);
  rest(50);
  keepPicture(panel, "accuracy_further.png");
  ASSERT_TRUE(further.isEnabled());
  click(further);
  ASSERT_TRUE(wait([&] { return !session->study.isBusy(); }, 300000));
  const AccuracyStudy& made = session->project.study()->study;
  EXPECT_EQ(made.repeats, 2);
  EXPECT_EQ(made.measure, StudyMeasure::run_out);
  EXPECT_TRUE(says(panel, QStringLiteral("mean of 2 runs")));
  EXPECT_FALSE(further.isEnabled());
}

TEST_F(AccuracyPanelTest, SaysWhyNoStudyCanBeBegun) {
  AccuracyPanel& panel = opened();
  EXPECT_FALSE(button(panel, "Study accuracy").isEnabled());
  EXPECT_EQ(button(panel, "Study accuracy").toolTip(), QStringLiteral("Open a project first"));
  window->open(write("empty.talus", R"({"talus": 1, "materials": {}, "solids": [], "stages": []})"));
  EXPECT_FALSE(button(panel, "Study accuracy").isEnabled());
  EXPECT_EQ(button(panel, "Study accuracy").toolTip(), QStringLiteral("The project has no solid"));
}

TEST_F(AccuracyPanelTest, APointThatIsClickedSelectsItsRunAndGivesItsSetting) {
  const auto file = slidingCube(100);
  study(file);
  window->open(file);
  AccuracyPanel& panel = opened();
  const AccuracyStudy& made = session->project.study()->study;
  ASSERT_EQ(table(panel, "runs").rowCount(), static_cast<int>(made.rows.size()));
  EXPECT_EQ(table(panel, "runs").currentRow(), 0) << "the project's own";
  EXPECT_FALSE(button(panel, "Use this setting").isEnabled());

  auto& chart = *panel.findChild<AccuracyChart*>();
  const int run = best_by_cost(made).front() == 0 ? best_by_cost(made).back() : best_by_cost(made).front();
  ASSERT_TRUE(chart.pointOf(run));
  QTest::mouseClick(&chart, Qt::LeftButton, {}, chart.pointOf(run)->toPoint());
  EXPECT_EQ(table(panel, "runs").currentRow(), run);
  EXPECT_TRUE(says(panel, QStringLiteral("Run %1: ").arg(run)));
  EXPECT_GE(table(panel, "profile").rowCount(), 7) << "six phases and the effects that were on";
  rest(50);
  keepPicture(panel, "accuracy.png");

  const Project before = session->project.document().project();
  ASSERT_TRUE(button(panel, "Use this setting").isEnabled());
  click(button(panel, "Use this setting"));
  EXPECT_EQ(session->project.document().project(), under(made.rows[static_cast<std::size_t>(run)].setting, before));
  EXPECT_FALSE(button(panel, "Use this setting").isEnabled());
  session->project.document().undoStack().undo();
  EXPECT_EQ(session->project.document().project(), before);
}

TEST_F(AccuracyPanelTest, LeavesNoWordOfItsTablesOutOnASmallScreen) {
  const auto file = slidingCube(100);
  study(file);
  window->open(file);
  AccuracyPanel& panel = opened();
  panel.resize(1220, 680);  // on 1280 x 720
  rest(50);
  for (const char* name : {"runs", "orders"}) {
    const PlainTable& shown = table(panel, name);
    ASSERT_GT(shown.rowCount(), 0) << name;
    for (int row = 0; row < shown.rowCount(); ++row)
      for (int column = 0; column < shown.columnCount(); ++column) {
        const QTableWidgetItem& cell = *shown.item(row, column);
        EXPECT_GE(shown.columnWidth(column), shown.fontMetrics().horizontalAdvance(cell.text()) + 10)
            << name << ": " << cell.text().toStdString();
      }
    EXPECT_FALSE(shown.horizontalScrollBar()->isVisible()) << name << " has room for all";
  }
}

TEST_F(AccuracyPanelTest, ChoosesTheCheapestRunWithinATarget) {
  const auto file = slidingCube(100);
  study(file);
  window->open(file);
  AccuracyPanel& panel = opened();
  auto& target = *panel.findChild<QLineEdit*>(QStringLiteral("target"));
  typeOver(target, "1000%");
  const int cheapest = table(panel, "runs").currentRow();
  const auto& rows = session->project.study()->study.rows;
  for (const AccuracyRow& row : rows)
    EXPECT_LE(rows[static_cast<std::size_t>(cheapest)].run->cpu_seconds, row.run->cpu_seconds);
  EXPECT_TRUE(says(panel, QStringLiteral("is the cheapest within")));
  rest(50);
  theme::install(true);
  rest(100);
  keepPicture(panel, "accuracy_dark.png");
  theme::install(false);
  typeOver(target, "1e-13");
  EXPECT_TRUE(says(panel, QStringLiteral("No run of this study is within")));
  typeOver(target, "soon");
  EXPECT_FALSE(says(panel, QStringLiteral("No run of this study is within")));
}

TEST_F(AccuracyPanelTest, SaysOfARunThatDidNotConverge) {
  const std::filesystem::path file = sample("spinning_block");
  Project project = read_project(file);
  project.solids[0].body = BodyKind::rigid;
  project.solver.open_close_limit = 1;  // enough for a rigid block, and for no other
  std::ofstream(file) << write_project(project);
  study(file, parse_ladder_wish({"body"}, {"body=rigid,affine"}));
  window->open(file);
  AccuracyPanel& panel = opened();
  ASSERT_EQ(table(panel, "runs").rowCount(), 2);
  EXPECT_EQ(table(panel, "runs").item(1, 3)->text(), QStringLiteral("not converged"));
  EXPECT_FALSE(table(panel, "orders").isVisible()) << "there is none";
  keepPicture(panel, "accuracy_not_converged.png");
  theme::install(true);
  rest(100);
  keepPicture(panel, "accuracy_not_converged_dark.png");
  theme::install(false);
}

TEST_F(AccuracyPanelTest, GivesTheProjectThePapersScheme) {
  const auto file = slidingCube(100);
  study(file, parse_ladder_wish({"scheme"}, {}));
  window->open(file);
  AccuracyPanel& panel = opened();
  ASSERT_EQ(table(panel, "runs").rowCount(), 2);
  EXPECT_TRUE(table(panel, "runs").item(1, 1)->text().endsWith(QStringLiteral("scheme paper")));
  table(panel, "runs").setCurrentCell(1, 0);
  click(button(panel, "Use this setting"));
  EXPECT_EQ(session->project.document().project().solver, settings_of(Preset::paper));
  EXPECT_FALSE(button(panel, "Use this setting").isEnabled()) << "the project has it";
}

TEST_F(AccuracyPanelTest, ShowsAStudyOfAnotherProjectButGivesNoSettingFromIt) {
  const auto file = slidingCube(100);
  study(file);
  window->open(sample("free_fall"));
  AccuracyPanel& panel = opened();
  panel.load(folder / "cube.accuracy" / "accuracy.json");
  EXPECT_TRUE(says(panel, QStringLiteral("Sliding cube: what accuracy costs")));
  EXPECT_FALSE(button(panel, "Use this setting").isEnabled());
}

TEST_F(AccuracyPanelTest, ShowsAnAccuracyJsonThatCameAlone) {
  const auto file = slidingCube(100);
  study(file);
  window->open(file);
  const auto alone = folder / "from another machine.json";
  std::filesystem::rename(folder / "cube.accuracy" / "accuracy.json", alone);
  std::filesystem::remove_all(folder / "cube.accuracy");
  session->project.lookForStudy();
  AccuracyPanel& panel = opened();
  panel.load(alone);
  EXPECT_TRUE(says(panel, QStringLiteral("Sliding cube: what accuracy costs")));
  EXPECT_TRUE(says(panel, QStringLiteral("from another machine.json")));
  EXPECT_GE(table(panel, "runs").rowCount(), 4);
  EXPECT_GE(table(panel, "profile").rowCount(), 7);
  EXPECT_FALSE(button(panel, "Use this setting").isEnabled());
  EXPECT_EQ(button(panel, "Use this setting").toolTip(), QStringLiteral("The study came without its project"));
  auto& target = *panel.findChild<QLineEdit*>(QStringLiteral("target"));
  QTest::keyClicks(&target, QStringLiteral("1000%"));
  QTest::keyClick(&target, Qt::Key_Return);
  EXPECT_TRUE(says(panel, QStringLiteral("is the cheapest within")));
  rest(50);
  keepPicture(panel, "accuracy_alone.png");
  panel.load(file);
  EXPECT_TRUE(says(panel, QStringLiteral("is no accuracy.json"))) << "a project is none";
}

}  // namespace
}  // namespace talus
