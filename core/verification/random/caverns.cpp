#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "geometry/block_builder.hpp"
#include "model/number_text.hpp"
#include "model/stages.hpp"
#include "verification/random/families.hpp"
#include "verification/random/node_laws.hpp"
#include "verification/random/random_parts.hpp"

// A cavern whose roof three joint sets divide, within rock that stands.
namespace talus {

namespace {

constexpr double most_into_rock = 1e-3;  // of the span
constexpr double cavern_gravity = 9.81;  // m/s²

/// Lengths in m. The roof lies on an abutment on either side and is walled in all round; above it is rock, too.
struct Cavern {
  double span, depth, height, roof, ledge;

  Vec3 low() const { return {-span / 2 - ledge, 0, 0}; }
  Vec3 high() const { return {span / 2 + ledge, depth, height + roof}; }
};

Solid rock_box(const std::string& name, const Vec3& min, const Vec3& max, BodyKind body,
               std::optional<double> mesh_size = {}) {
  return {name, BoxShape{min, max}, "rock", body, mesh_size};
}

std::vector<Solid> solids_of(const Cavern& cavern, BodyKind body) {
  const Vec3 low = cavern.low(), high = cavern.high();
  const double half = cavern.span / 2, wall = cavern.span, top = cavern.height;
  return {rock_box("floor", {low.x() - wall, low.y(), -wall}, {high.x() + wall, high.y(), 0}, BodyKind::fixed),
          rock_box("west abutment", low, {-half, high.y(), top}, BodyKind::fixed),
          rock_box("east abutment", {half, low.y(), 0}, {high.x(), high.y(), top}, BodyKind::fixed),
          rock_box("west wall", {low.x() - wall, low.y(), 0}, {low.x(), high.y(), high.z()}, BodyKind::fixed),
          rock_box("east wall", {high.x(), low.y(), 0}, {high.x() + wall, high.y(), high.z()}, BodyKind::fixed),
          rock_box("front", {low.x(), low.y() - wall, 0}, {high.x(), low.y(), high.z()}, BodyKind::fixed),
          rock_box("back", {low.x(), high.y(), 0}, {high.x(), high.y() + wall, high.z()}, BodyKind::fixed),
          rock_box("overburden", {low.x(), low.y(), high.z()}, {high.x(), high.y(), high.z() + wall}, BodyKind::fixed),
          rock_box("roof", {low.x(), low.y(), top}, high, body, 0.5 * cavern.roof)};
}

/// Planes about the middle of the roof.
Cut roof_set(SceneNumbers& numbers, const Cavern& cavern, double least_dip, double most_dip, int most_planes,
             double spacing) {
  Cut cut;
  cut.joint = "joint";
  cut.dip = numbers.between(least_dip, most_dip);
  cut.dip_direction = numbers.between(0, 360);
  cut.spacing = spacing;
  cut.count = std::min(numbers.whole(1, 3), most_planes);
  cut.through = {0, cavern.depth / 2, cavern.height + cavern.roof / 2};
  // Its planes begin half of them below the middle.
  const double dip = radians(cut.dip), way = radians(cut.dip_direction);
  const Vec3 upward(std::sin(dip) * std::sin(way), std::sin(dip) * std::cos(way), std::cos(dip));
  cut.through -= (numbers.between(0, 1) + 0.5 * (*cut.count - 2)) * spacing * upward;
  cut.solids = {"roof"};
  return cut;
}

}  // namespace

HardCase random_cavern(Draw& draw) {
  SceneNumbers& numbers = draw.numbers;
  const double span = numbers.logarithmic(2, 20);
  const Cavern cavern{span, span * numbers.between(0.3, 0.8), span * numbers.between(0.3, 0.8),
                      span * numbers.between(0.2, 0.5), span * numbers.between(0.1, 0.3)};
  const double friction = numbers.between(5, 50);
  const BodyKind body = draw.body();
  CaseScene rock = random_rock_scene(numbers, friction);
  rock.project.solids = solids_of(cavern, body);
  const int most_planes = body == BodyKind::tetrahedra ? 1 : 3;  // what is meshed takes a hundred times as long
  rock.project.cuts = {roof_set(numbers, cavern, 0, 30, most_planes, 0.6 * cavern.roof),
                       roof_set(numbers, cavern, 45, 90, most_planes, 0.4 * span),
                       roof_set(numbers, cavern, 45, 90, most_planes, 0.4 * span)};
  const double falling = std::sqrt(2 * cavern.height / cavern_gravity),
               step = falling * numbers.logarithmic(5e-3, 2e-2);
  if (numbers.chance(0.3)) rock.project.stages = {static_stage(step, 20)};
  rock.project.stages.push_back(dynamic_stage(step, std::min(1.5 * falling, 60 * step)));
  HardCase drawn;
  drawn.title = "cavern of " + significant(span) + " m, roof of " + significant(cavern.roof) + " m, " +
                std::string(to_string(body)) + ", friction " + significant(friction) + "°, steps of " +
                significant(step) + " s";
  drawn.keeps_nodes = true;
  drawn.expected = {nodes_stay_in_box(cavern.low(), cavern.high(), most_into_rock * span)};
  drawn.build = [project = rock.project] {
    CaseScene scene{.project = project, .system = {}};
    NoProgress nobody;
    scene.system = build_blocks(scene.project, {}, nobody);
    return scene;
  };
  return drawn;
}

}  // namespace talus
