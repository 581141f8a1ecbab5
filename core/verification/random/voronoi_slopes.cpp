#include <algorithm>
#include <cmath>
#include <limits>

#include "base/units.hpp"
#include "model/number_text.hpp"
#include "model/stages.hpp"
#include "verification/hard_cases/expectations.hpp"
#include "verification/hard_cases/shapes.hpp"
#include "verification/hard_cases/voronoi.hpp"
#include "verification/random/families.hpp"
#include "verification/random/random_parts.hpp"

// Rock of Voronoi cells on a bedding plane, with a face cut through them at its foot.
namespace talus {

namespace {

constexpr double slope_gravity = 9.81;                       // m/s²
constexpr double crowd_share = 0.01, settling_share = 1e-3;  // of the way; of the height

/// Whatever pieces do among themselves, what is fixed is touched at the bedding alone, and friction there is tan φ of
/// what presses at most: the mean displacement u obeys u·down + tan φ u·up ≥ g (sin α − tan φ cos α) t²/2. All may
/// settle by `settling` [m] before contacts bear.
HardCaseExpectation slides_as_friction_lets_it(const Mat3& turn, double dip, double friction, double seconds,
                                               double settling) {
  const double mu = std::tan(radians(friction)), rate = std::sin(radians(dip)) - mu * std::cos(radians(dip));
  const double least = slope_gravity * rate * seconds * seconds / 2;
  const double allowance = crowd_share * std::abs(least) + mu * settling;
  const Vec3 direction = turn * Vec3(1, 0, mu);
  return {"the mean displacement down the bedding, with tan φ of that off it, is " + significant(least) +
              " m at least, less " + significant(allowance) + " m",
          [=](const Trajectory& trajectory) {
            const double mean = mean_displacement(trajectory).dot(direction);
            return mean >= least - allowance ? std::string() : "it is " + significant(mean) + " m";
          }};
}

}  // namespace

HardCase random_voronoi_slope(Draw& draw) {
  SceneNumbers& numbers = draw.numbers;
  const int count = numbers.whole(4, 12), seed = numbers.whole(1, std::numeric_limits<int>::max());
  const double dip = numbers.between(15, 50), apart = numbers.between(2, 15);
  const bool slides = numbers.chance(0.6);
  const double friction = std::clamp(dip + (slides ? -apart : apart), 0.0, 60.0);
  // In the frame of the bedding, whose x dips.
  const Vec3 size = numbers.logarithmic(1, 20) * Vec3(1, numbers.between(0.4, 1), numbers.between(0.3, 0.8));
  const double face = numbers.between(40, 85);  // degrees to the bedding
  const CuttingPlane cutting{{size.x() / 2, 0, 0}, {std::sin(radians(face)), 0, std::cos(radians(face))}};
  CaseScene scene = random_rock_scene(numbers, friction);
  scene.project.solver.sleep_tolerance = 0;
  const double far = 4 * size.x() + 10;
  scene.add_fixed_box("bedrock", {-far, -far, -size.x()}, {far, far, 0});
  const Vec3 corner(size.x() / 2, size.y() / 2, 0);
  int number = 0;
  for (TetMesh& piece :
       voronoi_pieces(-corner, corner + Vec3(0, 0, size.z()), count, static_cast<unsigned>(seed), cutting))
    scene.add_block("piece " + std::to_string(++number), std::move(piece), draw.body());
  const double step = numbers.logarithmic(1e-3, 1e-2), seconds = 60 * step;
  scene.project.stages = {dynamic_stage(step, seconds)};
  const Mat3 turn = turn_about(Vec3::UnitZ(), numbers.between(0, 360)) * turn_about(Vec3::UnitY(), dip);
  place_scene(scene, turn, Vec3::Zero());
  scene.project.gravity = -slope_gravity * Vec3::UnitZ();
  HardCase drawn;
  drawn.title = std::to_string(number) + " Voronoi cells, " + draw.bodies_word() + ", " + significant(size.x()) +
                " m, bedding " + significant(dip) + "°, face " + significant(face) + "° to it, friction " +
                significant(friction) + "°, steps of " + significant(step) + " s";
  drawn.expected = {stays_before(Vec3::Zero(), turn * Vec3::UnitZ()),
                    slides_as_friction_lets_it(turn, dip, friction, seconds, settling_share * size.z())};
  drawn.build = [scene] { return scene; };
  return drawn;
}

}  // namespace talus
