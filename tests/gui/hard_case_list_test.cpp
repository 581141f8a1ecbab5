#include "widgets/verification/hard_case_list.hpp"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <QTest>
#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "driven_window.hpp"
#include "listed_runs.hpp"
#include "verification/hard_cases/scenes/all_hard_cases.hpp"
#include "widgets/kit/theme.hpp"
#include "widgets/verification/verification.hpp"

namespace talus {
namespace {

/// Those of these names, in the suite's order.
std::vector<HardCase> casesNamed(const std::vector<std::string>& names) {
  std::vector<HardCase> chosen;
  for (const HardCase& one : hard_cases())
    if (std::find(names.begin(), names.end(), one.name) != names.end()) chosen.push_back(one);
  return chosen;
}

QStringList wordsOf(const QWidget& widget) {
  QStringList words;
  for (const auto* label : widget.findChildren<QLabel*>()) words << label->text();
  return words;
}

TEST_F(DrivenWindow, OpensTheHardCasesFromTheHelpMenuBesideTheKnownAnswers) {
  for (auto* action : window->findChildren<QAction*>())
    if (action->text() == QStringLiteral("Hard cases…")) action->trigger();
  auto* dialog = window->findChild<Verification*>();
  ASSERT_NE(dialog, nullptr);
  auto* list = dialog->findChild<HardCaseList*>();
  ASSERT_TRUE(list->isVisible());
  EXPECT_EQ(listOf(*list).rowCount(), static_cast<int>(hard_cases().size()));
  rest(50);
  keepPicture(*dialog, "hard_cases.png");
  dialog->findChild<QTabWidget*>()->setCurrentIndex(0);
  EXPECT_FALSE(list->isVisible());
}

TEST_F(DrivenWindow, RunsHardCasesAndShowsWhatTheyCameTo) {
  HardCaseList list(casesNamed({"incline_49", "incline_50"}));
  list.resize(1200, 700);
  list.show();
  ASSERT_EQ(listOf(list).rowCount(), 2);
  click(button(list, "Run all quick ones"));
  ASSERT_TRUE(wait([&] { return !list.job().isBusy(); }));
  ASSERT_EQ(list.results().size(), 2u);
  for (const Trial& trial : list.results()) {
    int row = 0;
    while (listOf(list).item(row, 0)->text().toStdString() != trial.title) ++row;
    EXPECT_EQ(listOf(list).item(row, 1)->text() == QStringLiteral("holds"), trial.passed()) << trial.name;
    EXPECT_EQ(listOf(list).item(row, 3)->text().toStdString(), to_string(trial.ending));
    EXPECT_EQ(listOf(list).item(row, 8)->text(), QString::number(trial.cuts));
  }
  const int known = rowOf(listOf(list), list.results().back().title.c_str());
  listOf(list).setCurrentCell(known, 0);
  rest(50);
  keepPicture(list, "hard_cases_ran.png");
  ASSERT_TRUE(list.exportJson(folder / "hard_cases.json"));
  const auto json = nlohmann::json::parse(std::ifstream(folder / "hard_cases.json"));
  EXPECT_EQ(json["scenes"].size(), list.results().size());
}

TEST_F(DrivenWindow, AKnownShortfallIsMarkedWithItsCauseBeforeAndAfterTheRun) {
  auto falling_short = casesNamed({"heavy_on_light"});
  falling_short[0].expected.push_back({"it flies", [](const Trajectory&) { return std::string("it does not"); }});
  falling_short[0].shortfall = "it has no wings";
  HardCaseList list(falling_short);
  list.show();
  const QString cause = QStringLiteral("it has no wings");
  EXPECT_EQ(listOf(list).item(0, 1)->toolTip(), cause);
  EXPECT_TRUE(wordsOf(list).contains(QStringLiteral("Known to fall short: ") + cause));
  listOf(list).selectRow(0);
  click(button(list, "Run selected"));
  ASSERT_TRUE(wait([&] { return !list.job().isBusy(); }));
  EXPECT_EQ(listOf(list).item(0, 1)->text(), QStringLiteral("falls short, known"));
}

TEST_F(DrivenWindow, AGroupIsListedAndRunAlone) {
  HardCaseList list(hard_cases());
  list.show();
  auto* groups = list.findChild<QComboBox*>();
  groups->setCurrentIndex(1);
  const PlainTable& table = listOf(list);
  int shown = 0;
  for (int row = 0; row < table.rowCount(); ++row) shown += table.isRowHidden(row) ? 0 : 1;
  EXPECT_GT(shown, 0);
  EXPECT_LT(shown, table.rowCount());
  click(button(list, "Run all quick ones"));
  EXPECT_TRUE(list.job().isBusy());
  for (int row = 0; row < table.rowCount(); ++row) {
    const QString result = table.item(row, 1)->text();
    EXPECT_FALSE(table.isRowHidden(row) && (result == QStringLiteral("waits") || result == QStringLiteral("running")));
  }
  click(button(list, "Cancel"));
  ASSERT_TRUE(wait([&] { return !list.job().isBusy(); }));
}

}  // namespace
}  // namespace talus
