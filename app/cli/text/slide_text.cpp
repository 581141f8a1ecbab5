#include "text/slide_text.hpp"

#include <cmath>

#include "model/number_text.hpp"
#include "results/motion_class.hpp"
#include "text/table.hpp"

namespace talus::cli {

namespace {

using Json = nlohmann::ordered_json;

std::string name_of(const FarthestBlock& farthest, const BlockSystem& system) {
  return farthest.block < 0 ? "–" : system.blocks[static_cast<std::size_t>(farthest.block)].name;
}

/// Both ends of a descent, without digits that its length makes meaningless.
std::string place_text(const Vec3& place, const Descent& descent) {
  const double step = (descent.to - descent.from).norm() / 1e5;
  const auto rounded = [step](double value) { return std::abs(value) < step ? std::string("0") : number(value, 5); };
  return rounded(place.x()) + ", " + rounded(place.y()) + ", " + rounded(place.z());
}

std::string descent_text(const Descent& descent) {
  return "falls " + number(descent.height(), 4) + " m over " + number(descent.length(), 4) +
         " m in plan: " + decimals(descent.angle(), 1) + "°";
}

Json vector_json(const Vec3& vector) { return {vector.x(), vector.y(), vector.z()}; }

Json json_of(const FarthestBlock& farthest, const BlockSystem& system) {
  return {{"block", farthest.block < 0 ? Json() : Json(name_of(farthest, system))}, {"length", farthest.length}};
}

Json json_of(const Descent& descent) {
  return {{"from", vector_json(descent.from)},
          {"to", vector_json(descent.to)},
          {"height", descent.height()},
          {"length", descent.length()},
          {"angle", descent.angle()}};
}

Json json_of(const Deposit& deposit) {
  return {{"area", deposit.area},           {"bulk", deposit.bulk},      {"mean_depth", deposit.mean_depth},
          {"max_depth", deposit.max_depth}, {"cell", deposit.grid.cell}, {"outline", deposit.outline}};
}

/// Azimuth of forward; none where the rock went straight down.
std::string azimuth_text(const MovedRock& rock) {
  const std::string attitude = attitude_text(rock.forward);  // "090°/00°"
  return attitude.substr(0, attitude.find('/'));
}

}  // namespace

std::string slide_text(const Slide& slide, const BlockSystem& system) {
  const RunOut& out = slide.run_out;
  const MovedRock& rock = out.rock;
  std::string text = "t = " + number(slide.time) + " s: " + std::to_string(rock.blocks.size()) + " of " +
                     counted_text(slide.movable, "movable block", "movable blocks") + " went further than " +
                     number(rock.further_than, 3) + " m, " + number(rock.volume, 5) + " m³ of " +
                     number(slide.movable_volume, 5) + " m³\n";
  if (rock.blocks.empty()) return text;
  text += rock.forward.isZero() ? "The rock went straight down\n"
                                : "Forward is towards " + azimuth_text(rock) + ", clockwise from north\n";
  Table table({"Run-out", "Block", "Length [m]"}, "llr");
  table.add({"farthest", name_of(out.in_space, system), number(out.in_space.length, 5)});
  table.add({"farthest in plan", name_of(out.in_plan, system), number(out.in_plan.length, 5)});
  table.add({"farthest forward", name_of(out.forward, system), number(out.forward.length, 5)});
  table.add({"front, forward", "", number(out.front, 5)});
  text += '\n' + table.text() + '\n';
  text += "Crown of the scar (" + place_text(out.crown_to_toe.from, out.crown_to_toe) + ") to toe (" +
          place_text(out.crown_to_toe.to, out.crown_to_toe) + ")\n  " + descent_text(out.crown_to_toe) +
          ", the travel angle\n";
  text += "Centre of the rock that moved\n  " + descent_text(out.of_centre) + '\n';
  text += "Deposit\n  covers " + number(slide.deposit.area, 4) + " m², " + number(slide.deposit.bulk, 4) +
          " m³ with voids, up to " + number(slide.deposit.max_depth, 3) + " m deep, " +
          number(slide.deposit.mean_depth, 3) + " m on average; cells of " + number(slide.deposit.grid.cell, 3) +
          " m\n";
  if (const FrontMoment* fastest = slide.fastest())
    text += "Front\n  fastest at " + number(fastest->time, 4) + " s: " + number(fastest->velocity, 4) + " m/s, " +
            number(fastest->advance, 4) + " m from where it was; at the end " + number(slide.front.back().velocity, 3) +
            " m/s\n";
  return text;
}

nlohmann::ordered_json slide_json(const Slide& slide, const BlockSystem& system) {
  const RunOut& out = slide.run_out;
  Json front = Json::array();
  for (const FrontMoment& moment : slide.front)
    front.push_back(
        {{"time", moment.time}, {"advance", moment.advance}, {"velocity", moment.velocity}, {"volume", moment.volume}});
  Json blocks = Json::array();
  for (const int block : out.rock.blocks) blocks.push_back(system.blocks[static_cast<std::size_t>(block)].name);
  return {{"time", slide.time},
          {"further_than", out.rock.further_than},
          {"moved",
           {{"blocks", blocks}, {"volume", out.rock.volume}, {"displacement", vector_json(out.rock.displacement)}}},
          {"movable", {{"blocks", slide.movable}, {"volume", slide.movable_volume}}},
          {"forward", vector_json(out.rock.forward)},
          {"run_out",
           {{"in_space", json_of(out.in_space, system)},
            {"in_plan", json_of(out.in_plan, system)},
            {"forward", json_of(out.forward, system)},
            {"front", out.front}}},
          {"crown_to_toe", json_of(out.crown_to_toe)},
          {"centre", json_of(out.of_centre)},
          {"deposit", json_of(slide.deposit)},
          {"front", front}};
}

}  // namespace talus::cli
