#include <cmath>

#include "templates/shapes.hpp"
#include "templates/structures.hpp"

namespace talus {

namespace {

/// A cavern in bedded rock: its roof is a bed that vertical joints divide into voussoirs, with a second bed on top
/// whose joints lie between those of the first.
Project make_cavern(const TemplateValues& values) {
  const double span = values.at("span"), height = values.at("height"), bed = values.at("bed");
  const int count = static_cast<int>(values.at("count"));
  const double stone = span / count, side = span / 3, half = span / 6;
  const auto box = [&](double x0, double x1, double z0, double z1) {
    return BoxShape{{x0, -half, z0}, {x1, half, z1}};
  };
  Project project = rock_with_joints("Cavern in bedded rock", values.at("friction"));
  const double edge = span / 2, top = height + 2 * bed;
  project.solids = {fixed_rock("floor", box(-edge - side, edge + side, -side / 2, 0), span / 4),
                    fixed_rock("west abutment", box(-edge - side, -edge, 0, top), span / 4),
                    fixed_rock("east abutment", box(edge, edge + side, 0, top), span / 4)};
  for (int i = 0; i < count; ++i) {
    const double from = -edge + i * stone;
    project.solids.push_back(free_rock("roof " + std::to_string(i + 1),
                                       box(from, i + 1 < count ? from + stone : edge, height, height + bed)));
  }
  for (int i = 0; i <= count; ++i) {
    const double from = i == 0 ? -edge : -edge + (i - 0.5) * stone, to = i == count ? edge : -edge + (i + 0.5) * stone;
    project.solids.push_back(free_rock("upper bed " + std::to_string(i + 1), box(from, to, height + bed, top)));
  }
  const int middle = count / 2;
  const double at = -edge + (middle + 0.5) * stone;
  add_monitor(project, "roof " + std::to_string(middle + 1), {at, 0, height + bed / 2});
  add_stages(project, bed, std::sqrt(2 * height / 9.81));
  return project;
}

}  // namespace

ProjectTemplate cavern() {
  return {"cavern",
          "Cavern",
          "A cavern under two beds that vertical joints divide into voussoirs. Thrust between the abutments holds the "
          "roof, or it snaps through.",
          {{"span", "Span", "width of the cavern", "m", 4, 40, 15},
           {"height", "Height", "from floor to roof", "m", 2, 40, 10},
           {"bed", "Bed thickness", "of each of the two beds", "m", 0.3, 8, 2},
           {"count", "Voussoirs", "across the span, in the lower bed", "", 2, 12, 5, true},
           {"friction", "Friction angle", "of beds and joints", "°", 5, 60, 35}},
          make_cavern};
}

}  // namespace talus
