#include "widgets/verification/trial_page.hpp"

#include <QHeaderView>

#include "widgets/kit/numbers.hpp"
#include "widgets/kit/plain_table.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

constexpr int most_trial_rows = 8;

}  // namespace

void TrialPage::show(const HardCase& hardCase, const Trial* trial) {
  const std::string& known = hardCase.shortfall;
  if (!trial)
    begin(numbers::inSentence(hardCase.title), "chip", tr("not run yet"));
  else if (trial->passed())
    begin(numbers::inSentence(hardCase.title), "chipOk", tr("holds, %1").arg(numbers::duration(trial->seconds)));
  else
    begin(numbers::inSentence(hardCase.title), known.empty() ? "chipError" : "chipWarn",
          (known.empty() ? tr("does not hold, %1") : tr("falls short, known, %1"))
              .arg(numbers::duration(trial->seconds)));
  QStringList expectations;
  for (const HardCaseExpectation& expectation : hardCase.expected)
    expectations << numbers::inSentence(expectation.words);
  addSentence(tr("Must come to: %1").arg(expectations.join(QStringLiteral("; "))));
  if (trial) addFaults(*trial);
  if (!known.empty()) addSentence(tr("Known to fall short: %1").arg(numbers::inSentence(known)), "warn");
  if (trial) addFigures(*trial);
  addSentence(tr("Group: %1").arg(text(hardCase.group)), "muted");
  if (!hardCase.source.empty()) addSentence(tr("Source: %1").arg(text(hardCase.source)), "muted");
  if (!trial && hardCase.takes_long) addSentence(tr("This case takes minutes."), "muted");
  content().addStretch();
}

void TrialPage::addFaults(const Trial& trial) {
  for (const std::string& fault : faults(trial)) addSentence(numbers::inSentence(fault), "error");
  for (const TrialRepetition& again : trial.repetitions)
    if (again.difference.empty())
      addSentence(tr("Again on %1: the same bits").arg(numbers::counted(again.threads, "thread")));
}

void TrialPage::addFigures(const Trial& trial) {
  auto* table = new PlainTable;
  table->setObjectName(QStringLiteral("figures"));
  const auto figure = [](double value) { return numbers::figure(value, 2); };
  table->setContent(
      {tr("What no case may break"), tr("Came to"), tr("Below")},
      {{tr("Deepest contact, of the mesh size"), figure(trial.penetration), figure(most_penetration)},
       {tr("Interpenetration of blocks, of the mesh size"), figure(trial.interpenetration), figure(most_penetration)},
       {tr("Growth of energy, of what moved"), figure(trial.energy_growth), figure(most_energy_growth)},
       {tr("Least volume of a tetrahedron, of that at the start"), figure(trial.least_volume), tr("above 0")}},
      {true, false, false});
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  table->fitHeight(most_trial_rows);
  content().addWidget(table);
}

}  // namespace talus
