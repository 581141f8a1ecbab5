#include "model/number_text.hpp"
#include "render/paint/numbers.hpp"
#include "report/sections.hpp"
#include "report/words.hpp"

namespace talus::report {

namespace {

constexpr std::size_t most_first = 40, most_last = 20;

}  // namespace

Section events(const RunRecord& run) {
  Section section{"Events", {}};
  if (!run.report) return section;
  const std::vector<Event>& events = run.report->events;
  if (events.empty()) {
    section.parts.emplace_back(
        Paragraph{"Nothing happened that the run takes for an event: no joint opened, no block lost contact or changed "
                  "its way of moving."});
    return section;
  }
  const bool all = events.size() <= most_first + most_last;
  if (!all)
    section.parts.emplace_back(
        Paragraph{"The first " + std::to_string(most_first) + " and the last " + std::to_string(most_last) + " of " +
                  count_text(static_cast<long>(events.size())) + "; summary.json has them all."});
  const int decimals = decimals_for(run.last.time, 5);
  Table table{"", {"Time (s)", "What happened"}, "rl", {}};
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (!all && i == most_first) {
      table.rows.push_back({"…", "…"});
      i = events.size() - most_last;
    }
    table.rows.push_back({format_decimals(events[i].time, decimals), events[i].what});
  }
  section.parts.emplace_back(table);
  return section;
}

}  // namespace talus::report
