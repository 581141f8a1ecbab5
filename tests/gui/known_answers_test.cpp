#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "base/error.hpp"
#include "driven_window.hpp"
#include "listed_runs.hpp"
#include "widgets/kit/theme.hpp"
#include "widgets/verification/known_answers.hpp"

namespace talus {
namespace {

KnownCase quickCase(const std::string& name, double computed) {
  KnownCase known;
  known.name = name;
  known.title = "Case " + name;
  known.source = "arithmetic";
  known.run = [computed](const CaseOptions&, Progress&) {
    CaseOutcome outcome;
    outcome.findings.push_back({"number", "m", 1, computed, 1e-3});
    outcome.tables.push_back({"Rows", {"word", "number"}, {{"one", "1"}, {"two", "2"}}});
    outcome.remarks.emplace_back("A remark about the case.");
    return outcome;
  };
  return known;
}

/// Runs until it is told to stop.
KnownCase endlessCase() {
  KnownCase known = quickCase("endless", 1);
  known.takes_long = true;
  known.run = [](const CaseOptions&, Progress& progress) -> CaseOutcome {
    for (double fraction = 0;; fraction += (1 - fraction) / 100) {
      if (progress.cancelled()) throw Cancelled{};
      progress.report(fraction, "step");
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  };
  return known;
}

TEST_F(DrivenWindow, RunsAKnownAnswerFromTheHelpMenuAndExportsIt) {
  for (auto* action : window->findChildren<QAction*>())
    if (action->text() == QStringLiteral("Known answers…")) action->trigger();
  auto* dialog = window->findChild<KnownAnswers*>();
  ASSERT_NE(dialog, nullptr);
  ASSERT_TRUE(dialog->isVisible());
  EXPECT_FALSE(dialog->window()->isModal());

  PlainTable& list = listOf(*dialog);
  const int row = rowOf(list, "Free fall");
  ASSERT_GE(row, 0);
  list.setCurrentCell(row, 0);
  click(button(*dialog, "Run selected"));
  EXPECT_TRUE(dialog->job().isBusy());
  EXPECT_FALSE(button(*dialog, "Run all quick ones").isEnabled());
  ASSERT_TRUE(wait([&] { return !dialog->job().isBusy(); }));
  EXPECT_EQ(list.item(row, 1)->text(), QStringLiteral("passed"));
  rest(50);
  keepPicture(*dialog->window(), "known_answers.png");

  const auto* findings = dialog->findChild<PlainTable*>(QStringLiteral("findings"));
  ASSERT_NE(findings, nullptr);
  ASSERT_EQ(findings->rowCount(), 5);
  EXPECT_EQ(findings->item(1, 0)->text(), QStringLiteral("P1.displacement.z at 1 s"));
  EXPECT_EQ(findings->item(1, 1)->text(), QStringLiteral("m"));
  EXPECT_EQ(findings->item(1, 3)->text(), QString::fromUtf8("−4.905"));
  EXPECT_EQ(findings->item(1, 6)->text(), QStringLiteral("yes"));

  ASSERT_TRUE(dialog->exportJson(folder / "answers.json"));
  const auto json = nlohmann::json::parse(std::ifstream(folder / "answers.json"));
  EXPECT_TRUE(json["passed"]);
  EXPECT_EQ(json["cases"][0]["case"], "samples/free_fall");
  EXPECT_FALSE(dialog->exportJson(folder / "no_such_folder" / "answers.json"));
}

TEST_F(DrivenWindow, ShowsWhatFailedAndWhatWasRepeated) {
  KnownAnswers dialog({quickCase("right", 1), quickCase("wrong", 1.5), endlessCase()});
  dialog.show();
  dialog.findChild<QCheckBox*>()->setChecked(true);
  click(button(dialog, "Run all quick ones"));
  ASSERT_TRUE(wait([&] { return !dialog.job().isBusy(); }));
  const PlainTable& list = listOf(dialog);
  EXPECT_EQ(list.item(0, 1)->text(), QStringLiteral("passed"));
  EXPECT_EQ(list.item(1, 1)->text(), QStringLiteral("failed"));
  EXPECT_EQ(list.item(2, 1)->text(), QStringLiteral("long; not run"));
  ASSERT_EQ(dialog.results().size(), 2U);
  EXPECT_EQ(dialog.results()[0].repetitions.size(), 2U);

  listOf(dialog).setCurrentCell(1, 0);
  const auto* findings = dialog.findChild<PlainTable*>(QStringLiteral("findings"));
  EXPECT_EQ(findings->item(0, 6)->text(), QStringLiteral("no"));
  QStringList words;
  for (const auto* label : dialog.findChildren<QLabel*>()) words << label->text();
  EXPECT_TRUE(words.contains(QStringLiteral("Source: arithmetic")));
  EXPECT_TRUE(words.contains(QStringLiteral("A remark about the case.")));
  EXPECT_TRUE(words.contains(QStringLiteral("2 threads at scale 1: the same bits")));
  rest(50);
  keepPicture(dialog, "known_answers_failed.png");
  theme::install(true);
  rest(50);
  keepPicture(dialog, "known_answers_dark.png");
  theme::install(false);
}

TEST_F(DrivenWindow, CancelsACaseAndStaysUsableMeanwhile) {
  warmUp();
  KnownAnswers dialog({quickCase("right", 1), endlessCase(), quickCase("after", 1)});
  dialog.show();
  PlainTable& list = listOf(dialog);
  list.selectAll();
  click(button(dialog, "Run selected"));
  ASSERT_TRUE(wait([&] { return list.item(1, 1)->text() == QStringLiteral("running"); }));
  EXPECT_EQ(list.item(0, 1)->text(), QStringLiteral("passed"));
  EXPECT_EQ(list.item(2, 1)->text(), QStringLiteral("waits"));
  expectNoWait([&](const Watchdog&) { rest(800); });
  keepPicture(dialog, "known_answers_running.png");
  click(button(dialog, "Cancel"));
  ASSERT_TRUE(wait([&] { return !dialog.job().isBusy(); }, 5000));
  EXPECT_EQ(list.item(1, 1)->text(), QStringLiteral("long; not run"));
  EXPECT_EQ(list.item(2, 1)->text(), QStringLiteral("not run"));
  EXPECT_TRUE(button(dialog, "Run selected").isEnabled());

  click(button(dialog, "Run selected"));  // the destructor ends what goes on
  EXPECT_TRUE(dialog.job().isBusy());
}

}  // namespace
}  // namespace talus
