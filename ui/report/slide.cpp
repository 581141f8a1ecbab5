#include "measures/slide.hpp"

#include <algorithm>

#include "model/number_text.hpp"
#include "orientation/attitude.hpp"
#include "render/charts/slide_charts.hpp"
#include "render/paint/numbers.hpp"
#include "render/stereonet/slipped_joints.hpp"
#include "render/stereonet/stereonet_picture.hpp"
#include "report/sections.hpp"
#include "report/words.hpp"

namespace talus::report {

namespace {

/// Where blocks slid on the planes that they lay on: an equal-area net of these.
void add_slipped_joints(const RunRecord& run, Section& section) {
  NoProgress nobody_waits;
  Stereonet net;
  net.joints = joints_that_slipped(slipped_faces(run.results, nobody_waits), run.system().joint_names);
  if (net.joints.empty()) return;
  section.parts.emplace_back(Chart{stereonet_painting(net, "Joints that slipped"), 700, 440, ""});
}

std::string block_text(const RunRecord& run, const FarthestBlock& farthest) {
  return quantity(farthest.length, "m") + ", " + run.system().blocks[static_cast<std::size_t>(farthest.block)].name;
}

std::string descent_text(const Descent& descent) {
  return quantity(descent.height(), "m") + " down over " + quantity(descent.length(), "m") + " in plan, " +
         format_decimals(descent.angle(), 1) + "°";
}

Facts facts_of(const RunRecord& run, const Slide& slide) {
  const RunOut& out = slide.run_out;
  const Deposit& deposit = slide.deposit;
  Facts facts;
  const auto say = [&](const std::string& name, const std::string& value) { facts.rows.emplace_back(name, value); };
  say("Moved further than " + quantity(out.rock.further_than, "m", 2),
      count_text(static_cast<long>(out.rock.blocks.size())) + " of " +
          counted_text(slide.movable, "movable block", "movable blocks") + ", " + format_number(out.rock.volume, 4) +
          " m³ of " + format_number(slide.movable_volume, 4) + " m³");
  say("Forward", out.rock.forward.isZero()
                     ? "none: the rock went straight down"
                     : attitude_text(out.rock.forward).substr(0, 3) + "°, as the moved rock went");
  say("Farthest block", block_text(run, out.in_space));
  say("Farthest block in plan", block_text(run, out.in_plan));
  say("Farthest block forward", block_text(run, out.forward));
  say("Run-out of the front", quantity(out.front, "m"));
  say("Crown of the scar to toe of the deposit", descent_text(out.crown_to_toe) + " (travel angle, Fahrböschung)");
  say("Centre of the rock that moved", descent_text(out.of_centre));
  say("Deposit", format_number(deposit.area, 4) + " m², " + format_number(deposit.bulk, 4) + " m³ with voids");
  say("Depth of the deposit",
      quantity(deposit.max_depth, "m") + " at most, " + quantity(deposit.mean_depth, "m") + " on average");
  if (const FrontMoment* fastest = slide.fastest())
    say("Front at its fastest", quantity(fastest->velocity, "m/s") + " at " + format_number(fastest->time, 3) + " s");
  return facts;
}

}  // namespace

Section slide(const RunRecord& run) {
  Section section{"Run-out and deposit", {}};
  NoProgress nobody_waits;
  const Slide measured = measure_slide(run.results, run.last.index, {}, nobody_waits);
  if (measured.run_out.rock.blocks.empty()) {
    section.parts.emplace_back(Paragraph{"No block went further than " +
                                         quantity(measured.run_out.rock.further_than, "m", 2) +
                                         ", a hundredth of the diagonal of all blocks."});
    return section;
  }
  section.parts.emplace_back(facts_of(run, measured));
  constexpr double wide = 700, highest = 400;  // pixels
  section.parts.emplace_back(
      Chart{deposit_map(measured), wide, std::min(deposit_map_height(measured, wide), highest), ""});
  if (measured.front.size() > 1) section.parts.emplace_back(Chart{chart_painting(front_plot(measured)), 700, 300, ""});
  section.parts.emplace_back(Paragraph{
      "Depth is the height of the deposit's top above the highest rock below it that has not moved, in cells of " +
          quantity(measured.deposit.grid.cell, "m") + ". The velocity of the front is that of the foremost point.",
      Paragraph::Kind::note});
  add_slipped_joints(run, section);
  return section;
}

}  // namespace talus::report
