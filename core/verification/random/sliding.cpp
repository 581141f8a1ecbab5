#include <Eigen/LU>

#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "model/number_text.hpp"
#include "model/stages.hpp"
#include "verification/hard_cases/expectations.hpp"
#include "verification/hard_cases/shapes.hpp"
#include "verification/random/families.hpp"
#include "verification/random/random_parts.hpp"

// Blocks that slide on a plane, or on two, by an answer in closed form, or rest; anywhere on earth.
namespace talus {

namespace {

constexpr double weight = 9.81;                     // N/kg
constexpr double share = 1e-3, most_unrest = 1e-6;  // of the way and the acceleration; of the size

/// How a block on planes of friction φ goes in the direction in which it can: it is driven by g·drive, and pressed
/// onto its planes by forces that sum up to m·g·pressure.
struct Drive {
  double drive, pressure;
  double threshold() const { return degrees(std::atan(drive / pressure)); }  ///< friction at which it just rests
  double acceleration(double friction) const { return weight * (drive - pressure * std::tan(radians(friction))); }
};

/// Near the threshold or far from it, on either side, degrees.
double random_friction(SceneNumbers& numbers, const Drive& drive) {
  const double apart = numbers.logarithmic(0.02, 15), threshold = drive.threshold();
  const bool rests = numbers.chance(0.4);
  return rests ? std::min(threshold + apart, (threshold + 90) / 2) : std::max(0.0, threshold - apart);
}

/// How what slides starts. Gravity that comes at once sets an incline's block on its springs, and it has to slide a
/// little before they bear all that friction can: it is faster from then on by what that way gave it, and is held to
/// the acceleration of the closed answer. A wedge would settle along its flanks as well, where friction holds it, and
/// not along the line; it is let go, and so are half of the blocks: friction is lowered at rest until all of it is
/// hardly enough, for else some contacts would slide before the others are strained. A body that deforms is left with
/// shear across its way, which friction held in as it settled, and which turns along the way as it slides: until then
/// less of the friction brakes it, and it is held to the acceleration, too.
enum class Start { at_once, let_go };
constexpr double least_hold = 1e-2;  // of what friction is below the threshold in the end

/// What a scene of either kind has in common: `scene` in the frame of the plane or of the planes' line, whose +x dips
/// by `dip` degrees.
HardCase sliding_case(Draw& draw, CaseScene scene, const Drive& drive, double friction, double dip, double size,
                      Start start, const std::string& what) {
  SceneNumbers& numbers = draw.numbers;
  const bool rests_there = friction > drive.threshold();
  const double step = numbers.logarithmic(1e-3, 2e-2), seconds = numbers.between(0.5, 2);
  const Site site(numbers);
  const Mat3 turn = site.turn() * turn_about(Vec3::UnitY(), dip);
  place_scene(scene, turn, site.shift);
  scene.project.gravity = -weight * Vec3::UnitZ();
  Stage stage = dynamic_stage(step, seconds);
  const bool held_first = rests_there || start == Start::let_go;
  const bool is_rigid = scene.system.blocks.back().body == BodyKind::rigid;
  if (held_first) scene.project.stages.push_back(static_stage(step, 20));
  if (held_first && !rests_there) {
    Joint& joint = scene.project.joints[0];
    const auto friction_of = [&](double degrees) {
      return std::vector<JointChange>{{.name = joint.name,
                                       .friction_angle = degrees,
                                       .residual_friction_angle = {},
                                       .cohesion = {},
                                       .tensile_strength = {}}};
    };
    Stage hold = static_stage(step, 20);
    hold.name = "hardly hold";
    hold.joints = friction_of(drive.threshold() + least_hold * (drive.threshold() - friction));
    scene.project.stages.push_back(hold);
    stage.joints = friction_of(friction);
    joint.friction_angle = (drive.threshold() + 90) / 2;
  }
  scene.project.stages.push_back(stage);
  HardCase drawn;
  drawn.title = what + ", friction " + significant(std::abs(friction - drive.threshold())) + "° " +
                (rests_there ? "above" : "below") + " the threshold" + (held_first ? "" : " at once") + ", " +
                site.words() + ", steps of " + significant(step) + " s";
  const Vec3 down = turn * Vec3::UnitX();
  const double acceleration = drive.acceleration(friction), way = acceleration * seconds * seconds / 2;
  if (rests_there)
    drawn.expected = {rests("block", 0, most_unrest * size)};
  else if (start == Start::let_go && is_rigid)
    drawn.expected = {travels("block", down, way, share, static_cast<int>(scene.project.stages.size()) - 2)};
  else
    drawn.expected = {travels_at_least("block", down, (1 - share) * way),
                      accelerates("block", down, acceleration, share)};
  drawn.build = [scene] { return scene; };
  return drawn;
}

/// How far it may slide at most [m].
constexpr double longest_way = 25;

}  // namespace

HardCase random_incline(Draw& draw) {
  SceneNumbers& numbers = draw.numbers;
  const double dip = numbers.between(5, 60), size = numbers.logarithmic(0.1, 5);
  const Drive drive{std::sin(radians(dip)), std::cos(radians(dip))};
  const double friction = random_friction(numbers, drive);
  CaseScene scene = random_rock_scene(numbers, friction);
  scene.project.solver.sleep_tolerance = 0;  // friction is to hold it, not sleep
  // So low that what friction turns it by stays on its base.
  const double low = 0.7 / std::max({1.0, std::tan(radians(friction)), std::tan(radians(dip))});
  const Vec3 half = size / 2 * Vec3(1, numbers.between(0.5, 2), 0);
  const double height = size * low * numbers.between(0.2, 1);
  const BodyKind body = draw.body();
  scene.add_fixed_box("slab", {-3 * size, -3 * size, -size}, {longest_way + 3 * size, 3 * size, 0});
  const int cells = body == BodyKind::tetrahedra ? 2 : 1;
  scene.add_block("block", box_mesh({-half.x(), -half.y(), 0}, {half.x(), half.y(), height}, cells, cells, 1), body);
  const Start start = numbers.chance(0.5) ? Start::at_once : Start::let_go;
  return sliding_case(draw, std::move(scene), drive, friction, dip, size, start,
                      "block, " + std::string(to_string(body)) + ", on a plane that dips by " + significant(dip) + "°");
}

HardCase random_wedge(Draw& draw) {
  SceneNumbers& numbers = draw.numbers;
  const double plunge = numbers.between(5, 50), size = numbers.logarithmic(0.1, 5);
  const double left = numbers.between(20, 65), right = numbers.between(20, 65);  // degrees, of the flanks
  // In the section across the line: what presses on the flanks holds the weight.
  const Vec3 off_left(0, std::sin(radians(left)), std::cos(radians(left)));
  const Vec3 off_right(0, -std::sin(radians(right)), std::cos(radians(right)));
  Eigen::Matrix2d normals;
  normals << off_left.y(), off_right.y(), off_left.z(), off_right.z();
  const Eigen::Vector2d forces = normals.inverse() * Eigen::Vector2d(0, std::cos(radians(plunge)));
  const Drive drive{std::sin(radians(plunge)), forces.sum()};
  const double friction = random_friction(numbers, drive);
  CaseScene scene = random_rock_scene(numbers, friction);
  scene.project.solver.sleep_tolerance = 0;
  const BodyKind body = draw.body();
  // The wedge: a prism along the line with a flat top; long enough that friction at its flanks does not tip it.
  const double height = size * numbers.between(0.2, 0.5) / std::max(1.0, std::tan(radians(friction)));
  const auto corner = [](double x, double flank, double z) { return Vec3(x, z / std::tan(radians(flank)), z); };
  const auto prism_along = [&](double from, double to, double top) {
    return hull_mesh({Vec3(from, 0, 0),
                      corner(from, right, top),
                      {from, -top / std::tan(radians(left)), top},
                      Vec3(to, 0, 0),
                      corner(to, right, top),
                      {to, -top / std::tan(radians(left)), top}});
  };
  // The flanks: slabs along the line, below each plane.
  const double end = longest_way + 3 * size, up = 3 * size;
  const auto flank = [&](double side, double angle) {
    const double out = side * up / std::tan(radians(angle));
    return hull_mesh({Vec3(-3 * size, 0, 0),
                      {-3 * size, out, up},
                      {-3 * size, out, -size},
                      {-3 * size, 0, -size},
                      Vec3(end, 0, 0),
                      {end, out, up},
                      {end, out, -size},
                      {end, 0, -size}});
  };
  scene.add_block("left", flank(-1, left), BodyKind::fixed);
  scene.add_block("right", flank(1, right), BodyKind::fixed);
  const TetMesh prism_mesh = prism_along(-size / 2, size / 2, height);
  scene.add_block("block", body == BodyKind::tetrahedra ? refined(prism_mesh) : prism_mesh, body);
  return sliding_case(draw, std::move(scene), drive, friction, plunge, size, Start::let_go,
                      "wedge, " + std::string(to_string(body)) + ", on flanks of " + significant(left) + "° and " +
                          significant(right) + "°, line of " + significant(plunge) + "°");
}

}  // namespace talus
