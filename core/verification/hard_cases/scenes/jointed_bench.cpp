#include "verification/hard_cases/scenes/jointed_bench.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>

#include "base/units.hpp"
#include "orientation/attitude.hpp"

namespace talus {

namespace {

constexpr double bench_length = 40, bench_height = 12, bedrock_depth = 5;  // m

/// How the authors of the Mersenne Twister begin it from a key of one number (their init_by_array, Matsumoto &
/// Nishimura 2002), as many languages do: a slope has the same seed there.
class KeyOfOne {
 public:
  using result_type = std::uint32_t;
  explicit KeyOfOne(std::uint32_t key) : key_(key) {}

  template <class Iterator>
  void generate(Iterator begin, Iterator end) const {
    const auto count = static_cast<std::uint32_t>(end - begin);
    begin[0] = 19650218u;
    for (std::uint32_t i = 1; i < count; ++i) begin[i] = 1812433253u * mixed(begin[i - 1]) + i;
    std::uint32_t i = 1;
    const auto next = [&] {
      if (++i < count) return;
      begin[0] = begin[count - 1];
      i = 1;
    };
    for (std::uint32_t k = 0; k < count; ++k, next()) begin[i] = (begin[i] ^ (mixed(begin[i - 1]) * 1664525u)) + key_;
    for (std::uint32_t k = 1; k < count; ++k, next()) begin[i] = (begin[i] ^ (mixed(begin[i - 1]) * 1566083941u)) - i;
    begin[0] = 0x80000000u;
  }

 private:
  static std::uint32_t mixed(std::uint32_t word) { return word ^ (word >> 30); }
  std::uint32_t key_;
};

class Chance {
 public:
  explicit Chance(unsigned seed) {
    KeyOfOne key(seed);
    engine_.seed(key);
  }
  /// Drawn evenly, of 53 bits (their genrand_res53).
  double between(double low, double high) {
    const double upper = engine_() >> 5, lower = engine_() >> 6;
    return low + (high - low) * ((upper * 67108864 + lower) / 9007199254740992);
  }

 private:
  std::mt19937 engine_;
};

/// What chance says of a steep set.
struct SteepSet {
  double dip_direction, dip;  ///< degrees
  double spacing;             ///< of bench_length / planes
  double first;               ///< of the spacing: where the first plane lies beyond the bench's end
};

struct Draw {
  explicit Draw(unsigned seed) : chance(seed) {
    bedding_dip = chance.between(25, 45);
    sets[0].dip_direction = chance.between(150, 210);
    sets[1].dip_direction = chance.between(60, 120);
    for (SteepSet& set : sets) {
      set.dip = chance.between(60, 88);
      set.spacing = chance.between(0.9, 1.2);
      set.first = chance.between(0.3, 0.7);
    }
    steeper_than_friction = chance.between(5, 15);
  }

  Chance chance;
  double bedding_dip, steeper_than_friction;  // degrees
  std::array<SteepSet, 2> sets;
};

/// What stands between two parallelograms, each counter-clockwise seen from above.
PolyhedronShape between(const std::array<Vec3, 4>& bottom, const std::array<Vec3, 4>& top) {
  PolyhedronShape shape;
  shape.vertices.assign(bottom.begin(), bottom.end());
  shape.vertices.insert(shape.vertices.end(), top.begin(), top.end());
  shape.faces = {{0, 3, 2, 1}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}};
  return shape;
}

/// Over the whole bench, at z = 0 in the west and `rise` in the east.
std::array<Vec3, 4> level(double z, double rise) {
  return {Vec3(0, 0, z), Vec3(bench_length, 0, z + rise), Vec3(bench_length, bench_length, z + rise),
          Vec3(0, bench_length, z)};
}

Cut joint_set(const PlaneAttitude& attitude, const Vec3& through, double spacing, int count) {
  Cut cut;
  cut.joint = "joint";
  cut.dip = attitude.dip;
  cut.dip_direction = attitude.dip_direction;
  cut.through = through;
  cut.spacing = spacing;
  cut.count = std::max(1, count);
  cut.solids = {"bench"};
  return cut;
}

/// Evenly through the bench's height.
Cut bedding_set(double dip, int planes) {
  const int count = static_cast<int>(std::lround(planes / 3.0));
  const double rise = bench_height / (std::max(1, count) + 1);
  return joint_set({dip, 270}, {0, 0, rise}, rise * std::cos(radians(dip)), count);
}

/// From one end of the bench to the other.
Cut steep_set(const SteepSet& set, int planes, const std::vector<Vec3>& corners) {
  const PlaneAttitude attitude{set.dip, set.dip_direction};
  const Vec3 normal = -pole_of(attitude);
  const auto [low, high] = std::ranges::minmax(corners, {}, [&](const Vec3& corner) { return normal.dot(corner); });
  const double spacing = set.spacing * bench_length / planes, first = normal.dot(low) + set.first * spacing;
  return joint_set(attitude, first * normal, spacing, static_cast<int>((normal.dot(high) - first) / spacing));
}

}  // namespace

double JointedBench::dip() const { return Draw(seed).bedding_dip; }

double JointedBench::friction_angle() const {
  const Draw draw(seed);
  return draw.bedding_dip + (end == BenchEnd::stands ? 10 : -draw.steeper_than_friction);
}

Project JointedBench::project() const {
  const Draw draw(seed);
  const double rise = bench_length * std::tan(radians(draw.bedding_dip));
  const PolyhedronShape bench = between(level(0, rise), level(bench_height, rise));
  Project project;
  project.materials = {{.name = "rock", .density = 2600, .young = 2e10, .poisson = 0.25}};
  project.joints.emplace_back().name = project.default_joint = "joint";
  project.joints[0].friction_angle = friction_angle();
  project.solids = {{"bedrock", between(level(-bedrock_depth, 0), level(0, rise)), "rock", BodyKind::fixed, {}},
                    {"bench", bench, "rock", body, {}}};
  project.cuts = {bedding_set(draw.bedding_dip, planes)};
  for (const SteepSet& set : draw.sets) project.cuts.push_back(steep_set(set, planes, bench.vertices));
  return project;
}

}  // namespace talus
