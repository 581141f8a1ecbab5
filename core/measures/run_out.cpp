#include "measures/run_out.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "base/error.hpp"
#include "base/units.hpp"
#include "measures/block_travel.hpp"
#include "measures/node_places.hpp"

namespace talus {

namespace {

Vec3 level(const Vec3& vector) { return {vector.x(), vector.y(), 0}; }

/// A hundredth of the diagonal of all blocks at rest [m].
double usual_length(const BlockSystem& system) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Block& block : system.blocks)
    for (const Vec3& node : block.mesh.nodes) {
      low = low.cwiseMin(node);
      high = high.cwiseMax(node);
    }
  return (high.array() >= low.array()).all() ? (high - low).norm() / 100 : 0;
}

double length_of(const RunOutSettings& settings, const BlockSystem& system) {
  if (!settings.moved) return usual_length(system);
  if (!(*settings.moved >= 0) || !std::isfinite(*settings.moved))
    throw InputError("moved", "a length that blocks have gone is not negative", "give metres, as 0.5");
  return *settings.moved;
}

/// Of a mean displacement; one that is steeper than this has no direction in plan.
Vec3 forward_of(const Vec3& displacement, const RunOutSettings& settings) {
  constexpr double least_level_part = 1e-6;
  if (settings.azimuth) {
    if (!std::isfinite(*settings.azimuth))
      throw InputError("direction", "this is no azimuth", "give degrees clockwise from north, as 135");
    return {std::sin(radians(*settings.azimuth)), std::cos(radians(*settings.azimuth)), 0};
  }
  const Vec3 part = level(displacement);
  return part.norm() > least_level_part * displacement.norm() ? Vec3(part.normalized()) : Vec3::Zero();
}

MovedRock moved_among(const std::vector<BlockTravel>& travels, const BlockSystem& system,
                      const RunOutSettings& settings) {
  MovedRock rock;
  rock.further_than = length_of(settings, system);
  for (const BlockTravel& travel : travels) {
    const Block& block = system.blocks[static_cast<std::size_t>(travel.block)];
    if (block.body == BodyKind::fixed || travel.displacement.norm() <= rock.further_than) continue;
    rock.blocks.push_back(travel.block);
    rock.volume += block.volume;
    rock.displacement += block.volume * travel.displacement;
  }
  if (rock.volume > 0) rock.displacement /= rock.volume;
  rock.forward = forward_of(rock.displacement, settings);
  return rock;
}

/// Foremost is what lies farther forward, and of two that lie as far the lower one.
bool before(const Vec3& a, const Vec3& b, const Vec3& forward) {
  const double x = a.dot(forward), y = b.dot(forward);
  return x > y || (x == y && a.z() < b.z());
}

/// The foremost point of the rock, in a frame or at rest.
struct Foremost {
  Vec3 at_rest = Vec3::Zero(), now = Vec3::Zero();  ///< m
  std::size_t node = 0;                             ///< that is foremost now
};

/// `first`: node of each block.
Foremost foremost_of(const BlockSystem& system, const std::vector<std::size_t>& first, const Frame& frame,
                     const MovedRock& rock) {
  Foremost foremost;
  bool any = false;
  for (const int number : rock.blocks) {
    const auto b = static_cast<std::size_t>(number);
    const std::vector<Vec3>& nodes = system.blocks[b].mesh.nodes;
    const std::vector<Vec3> moved = places(system.blocks[b], first[b], frame);
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      const Vec3& now = moved[n];
      if (!any || before(nodes[n], foremost.at_rest, rock.forward)) foremost.at_rest = nodes[n];
      if (!any || before(now, foremost.now, rock.forward)) {
        foremost.now = now;
        foremost.node = first[b] + n;
      }
      any = true;
    }
  }
  return foremost;
}

Vec3 highest_at_rest(const BlockSystem& system, const MovedRock& rock) {
  Vec3 highest(0, 0, -std::numeric_limits<double>::infinity());
  for (const int number : rock.blocks)
    for (const Vec3& node : system.blocks[static_cast<std::size_t>(number)].mesh.nodes)
      if (node.z() > highest.z()) highest = node;
  return highest;
}

void take_farther(FarthestBlock& farthest, int block, double length) {
  if (farthest.block < 0 || length > farthest.length) farthest = {block, length};
}

}  // namespace

double Descent::height() const { return from.z() - to.z(); }
double Descent::length() const { return level(to - from).norm(); }
double Descent::angle() const { return degrees(std::atan2(height(), length())); }

MovedRock moved_rock(const BlockSystem& system, const Frame& frame, const RunOutSettings& settings) {
  return moved_among(block_travels(system, frame), system, settings);
}

RunOut run_out(const BlockSystem& system, const Frame& frame, const RunOutSettings& settings) {
  const std::vector<BlockTravel> travels = block_travels(system, frame);
  RunOut result;
  result.rock = moved_among(travels, system, settings);
  const MovedRock& rock = result.rock;
  if (rock.blocks.empty()) return result;
  Vec3 centre = Vec3::Zero();
  for (const int number : rock.blocks) {
    const BlockTravel& travel = travels[static_cast<std::size_t>(number)];
    take_farther(result.in_space, number, travel.displacement.norm());
    take_farther(result.in_plan, number, level(travel.displacement).norm());
    take_farther(result.forward, number, travel.displacement.dot(rock.forward));
    centre += system.blocks[static_cast<std::size_t>(number)].volume / rock.volume * travel.centroid;
  }
  const Foremost foremost = foremost_of(system, first_nodes(system), frame, rock);
  result.front = (foremost.now - foremost.at_rest).dot(rock.forward);
  result.crown_to_toe = {highest_at_rest(system, rock), foremost.now};
  result.of_centre = {centre - rock.displacement, centre};
  return result;
}

FrontHistory::FrontHistory(const BlockSystem& system, MovedRock rock)
    : system_(system), rock_(std::move(rock)), fit_(system), first_(first_nodes(system)) {}

FrontMoment FrontHistory::at(const Frame& frame) const {
  FrontMoment moment{.time = frame.time};
  if (rock_.blocks.empty()) return moment;
  const Foremost foremost = foremost_of(system_, first_, frame, rock_);
  moment.advance = (foremost.now - foremost.at_rest).dot(rock_.forward);
  moment.velocity = frame.velocity[foremost.node].dot(rock_.forward);
  for (const int number : rock_.blocks) {
    const auto b = static_cast<std::size_t>(number);
    if (fit_.mean(number, &frame.displacement[first_[b]]).norm() > rock_.further_than)
      moment.volume += system_.blocks[b].volume;
  }
  return moment;
}

}  // namespace talus
