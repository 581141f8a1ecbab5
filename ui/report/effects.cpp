#include <algorithm>

#include "model/number_text.hpp"
#include "render/paint/numbers.hpp"
#include "report/sections.hpp"
#include "report/words.hpp"

namespace talus::report {

namespace {

/// Those that were on, the dearest first; or those that were off.
std::vector<EffectOutcome> chosen(const RunReport& report, bool active) {
  std::vector<EffectOutcome> effects;
  std::ranges::copy_if(report.effects, std::back_inserter(effects),
                       [&](const EffectOutcome& effect) { return effect.active == active; });
  std::ranges::stable_sort(effects, std::greater{}, &EffectOutcome::seconds);
  return effects;
}

}  // namespace

Section effects(const RunRecord& run) {
  Section section{"What was computed: effects", {}};
  if (!run.report || run.report->effects.empty()) return section;
  Table on{"On", {"Effect", "Why", "Time (s)", "Share", "Evaluations", "Assemblies"}, "llrrrr", {}};
  const std::vector<EffectOutcome> active = chosen(*run.report, true);
  const int decimals = active.empty() ? 0 : decimals_for(active.front().seconds);
  for (const EffectOutcome& effect : active)
    on.rows.push_back({effect.name, effect.reason, format_decimals(effect.seconds, decimals),
                       run.report->wall_seconds > 0 ? percent(effect.seconds / run.report->wall_seconds) : "–",
                       count_text(effect.evaluations), count_text(effect.assemblies)});
  Table off{"Off", {"Effect", "Why"}, "ll", {}};
  for (const EffectOutcome& effect : chosen(*run.report, false)) off.rows.push_back({effect.name, effect.reason});
  section.parts.emplace_back(
      Paragraph{"A scene has the effects that it calls for. Shares are of the wall time of the run; what was off was "
                "neither built nor evaluated."});
  section.parts.emplace_back(on);
  if (!off.rows.empty()) section.parts.emplace_back(off);
  return section;
}

}  // namespace talus::report
