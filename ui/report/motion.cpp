#include <algorithm>

#include "model/number_text.hpp"
#include "render/charts/charts.hpp"
#include "render/paint/numbers.hpp"
#include "report/sections.hpp"
#include "report/words.hpp"

namespace talus::report {

namespace {

constexpr std::size_t most_travels = 25, most_monitors = 8;

Table travels(const RunRecord& run) {
  const std::size_t shown = std::min(most_travels, run.travels.size());
  double farthest = 0, fastest = 0;
  for (const BlockTravel& travel : run.travels) {
    farthest = std::max(farthest, travel.displacement.norm());
    fastest = std::max(fastest, travel.velocity.norm());
  }
  const Prefixed length = prefixed("m", farthest), speed = prefixed("m/s", fastest);
  const int length_decimals = decimals_for(length.factor * farthest),
            speed_decimals = decimals_for(speed.factor * fastest, 3);
  const MotionNames names = motion_names(run.system());
  Table table{
      shown < run.travels.size() ? "The " + std::to_string(shown) + " blocks that went farthest" : "Movable blocks",
      {"Block", "Volume (m³)", "Displacement (" + length.unit + ")", "Trend/plunge", "Rotation (°)",
       "Velocity (" + speed.unit + ")", "Motion at the end"},
      "lrrrrrl",
      {}};
  for (std::size_t i = 0; i < shown; ++i) {
    const BlockTravel& travel = run.travels[i];
    const Block& block = run.system().blocks[static_cast<std::size_t>(travel.block)];
    table.rows.push_back({block.name, format_number(block.volume, 3),
                          format_decimals(length.factor * travel.displacement.norm(), length_decimals),
                          attitude_text(travel.displacement), format_decimals(travel.turn(), 2),
                          format_decimals(speed.factor * travel.velocity.norm(), speed_decimals),
                          run.last.motions.empty()
                              ? "–"
                              : motion_text(run.last.motions[static_cast<std::size_t>(travel.block)], names)});
  }
  return table;
}

bool lasts(const RunRecord& run) {
  return run.history.size() > 1 && run.history.back().time > run.history.front().time;
}

void add_histories(const RunRecord& run, Section& section) {
  const auto& monitors = run.results.history_monitors();
  if (monitors.empty()) {
    section.parts.emplace_back(
        Paragraph{"The project has no monitor, so there are no histories.", Paragraph::Kind::note});
    return;
  }
  if (!lasts(run)) return;
  for (std::size_t i = 0; i < std::min(monitors.size(), most_monitors); ++i) {
    std::vector<Quantity::Field> fields{Quantity::Field::displacement, Quantity::Field::velocity};
    if (monitors[i].stress) fields.push_back(Quantity::Field::stress);
    for (const Quantity::Field field : fields)
      section.parts.emplace_back(
          Chart{chart_painting(monitor_plot(monitors[i].name, static_cast<int>(i), run.history, field)), 700, 300, ""});
  }
  if (monitors.size() > most_monitors)
    section.parts.emplace_back(Paragraph{
        "… and " + counted_text(static_cast<long>(monitors.size() - most_monitors), "more monitor", "more monitors") +
            ": talus-cli plot draws them all.",
        Paragraph::Kind::note});
}

}  // namespace

Section motion(const RunRecord& run) {
  Section section{"How the blocks moved", {}};
  if (run.travels.empty())
    section.parts.emplace_back(Paragraph{"No block may move."});
  else
    section.parts.emplace_back(travels(run));
  add_histories(run, section);
  return section;
}

}  // namespace talus::report
