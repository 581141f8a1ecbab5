#include "widgets/trial_page.hpp"

#include <QHeaderView>

#include "widgets/numbers.hpp"
#include "widgets/plain_table.hpp"

namespace talus {

namespace {

constexpr int most_rows = 8;

QString text(const std::string& s) { return QString::fromStdString(s); }

}  // namespace

void TrialPage::show(const StabilityScene& scene, const Trial* trial) {
  const std::string& known = scene.shortfall;
  if (!trial)
    begin(text(scene.title), "chip", tr("not run yet"));
  else if (trial->passed())
    begin(text(scene.title), "chipOk", tr("holds, %1").arg(numbers::duration(trial->seconds)));
  else
    begin(text(scene.title), known.empty() ? "chipError" : "chipWarn",
          (known.empty() ? tr("does not hold, %1") : tr("falls short, known, %1"))
              .arg(numbers::duration(trial->seconds)));
  QStringList demands;
  for (const Demand& demand : scene.expected) demands << text(demand.words);
  addSentence(tr("Must come to: %1").arg(demands.join(QStringLiteral("; "))));
  if (trial) addFaults(*trial);
  if (!known.empty()) addSentence(tr("Known to fall short: %1").arg(text(known)), "warn");
  if (trial) addFigures(*trial);
  addSentence(tr("Group: %1").arg(text(scene.group)), "muted");
  if (!scene.source.empty()) addSentence(tr("Source: %1").arg(text(scene.source)), "muted");
  if (!trial && scene.takes_long) addSentence(tr("This scene takes minutes."), "muted");
  content().addStretch();
}

void TrialPage::addFaults(const Trial& trial) {
  for (const std::string& fault : faults(trial)) addSentence(text(fault), "error");
  for (const TrialRepetition& again : trial.repetitions)
    if (again.difference.empty())
      addSentence(tr("Again on %1: the same bits").arg(numbers::counted(again.threads, "thread")));
}

void TrialPage::addFigures(const Trial& trial) {
  auto* table = new PlainTable;
  table->setObjectName(QStringLiteral("figures"));
  const auto figure = [](double value) { return numbers::figure(value, 2); };
  table->setContent(
      {tr("What no scene may break"), tr("Came to"), tr("Below")},
      {{tr("Deepest contact, of the mesh size"), figure(trial.penetration), figure(most_penetration)},
       {tr("Block in another, of the mesh size"), figure(trial.intrusion), figure(most_penetration)},
       {tr("Growth of energy, of what moved"), figure(trial.energy_growth), figure(most_energy_growth)},
       {tr("Least volume of a tetrahedron, of that at the start"), figure(trial.least_volume), tr("above 0")}},
      {true, false, false});
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  table->fitHeight(most_rows);
  content().addWidget(table);
}

}  // namespace talus
