#include "widgets/study/run_profile.hpp"

#include <QHeaderView>
#include <algorithm>

#include "widgets/kit/numbers.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

RunProfile::RunProfile() {
  setObjectName(QStringLiteral("profile"));
  setAccessibleName(tr("Where the time of the run went"));
  setSelectionMode(QAbstractItemView::NoSelection);
  setFocusPolicy(Qt::NoFocus);
}

void RunProfile::show(const StudyRun& run) {
  const double whole = std::max(run.wall_seconds, 1e-9);
  std::vector<QStringList> rows;
  const auto add = [&](const QString& kind, const QString& name, double seconds) {
    rows.push_back(
        {kind, name, numbers::significant(seconds, 2), tr("%1 %").arg(numbers::significant(100 * seconds / whole, 2))});
  };
  const Phases& p = run.phases;
  const std::pair<QString, double> phases[] = {{tr("find contacts"), p.detect}, {tr("assemble"), p.assemble},
                                               {tr("factor"), p.factor},        {tr("solve"), p.solve},
                                               {tr("update"), p.update},        {tr("write"), p.write}};
  for (const auto& [name, seconds] : phases) add(rows.empty() ? tr("Phase") : QString(), name, seconds);
  std::vector<EffectOutcome> effects = run.effects;
  std::erase_if(effects, [](const EffectOutcome& effect) { return !effect.active; });
  std::stable_sort(effects.begin(), effects.end(), [](const auto& a, const auto& b) { return a.seconds > b.seconds; });
  for (const EffectOutcome& effect : effects)
    add(&effect == &effects.front() ? tr("Effect") : QString(), text(effect.name), effect.seconds);
  setContent({QString(), tr("Where the time went"), tr("s"), tr("of the run")}, rows, {true, true, false, false});
  horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
  fitHeight(rowCount());
}

}  // namespace talus
