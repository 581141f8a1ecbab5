#include "verification/hard_cases/expectations.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ranges>

#include "base/units.hpp"
#include "mesh/moments.hpp"
#include "model/number_text.hpp"

namespace talus {

namespace {

std::string with_unit(double value, const std::string& unit) { return significant(value) + ' ' + unit; }

std::string in_degrees(double value) { return significant(value) + "°"; }

std::string since_words(int stage) {
  return stage < 0 ? "from the start on" : "after stage " + std::to_string(stage + 1);
}

/// As std::max, but what is no number stays none.
double larger(double a, double b) { return a >= b || std::isnan(a) ? a : b; }

/// The farthest that a block ever was from where it stood at the end of the stage; empty: within both bounds.
std::string unrest(const Trajectory& trajectory, int block, int stage, double distance, double angle) {
  const Snapshot& from = trajectory.end_of_stage(stage);
  const BlockMotion& stood = from.blocks[block];
  double distance_moved = 0, turn = 0;
  for (const Snapshot& snapshot : trajectory.snapshots) {
    if (snapshot.time < from.time) continue;
    distance_moved = larger(distance_moved, (snapshot.blocks[block].displacement - stood.displacement).norm());
    turn = larger(turn, degrees(std::abs(snapshot.blocks[block].rotation - stood.rotation)));
  }
  if (distance_moved < distance && turn < angle) return {};
  return trajectory.system.blocks[block].name + " moves by " + with_unit(distance_moved, "m") + " and turns by " +
         in_degrees(turn);
}

/// Since the end of the stage.
double displacement_along(const Trajectory& trajectory, const std::string& block, const Vec3& direction, int stage) {
  const int b = trajectory.block(block);
  const auto displacement = [&](const Snapshot& snapshot) { return snapshot.blocks[b].displacement; };
  return direction.dot(displacement(trajectory.last()) - displacement(trajectory.end_of_stage(stage)));
}

/// Of the parabola that fits a block's displacements in the second half of the last stage best [m/s²]: what springs on
/// contacts swing, by a good part of the speed near the threshold, but by next to nothing of the way.
double mean_acceleration(const Trajectory& trajectory, int block, const Vec3& direction) {
  const Snapshot &end = trajectory.last(), &start = trajectory.end_of_stage(end.stage - 1);
  const double middle = (start.time + end.time) / 2, duration = end.time - middle;
  const auto second_half = std::ranges::subrange(
      std::ranges::lower_bound(trajectory.snapshots, middle, {}, &Snapshot::time), trajectory.snapshots.end());
  Eigen::MatrixX3d powers(std::ssize(second_half), 3);  // of the time since the middle, of what is left of the stage
  Eigen::VectorXd displacements(std::ssize(second_half));
  int row = 0;
  for (const Snapshot& snapshot : second_half) {
    const double t = (snapshot.time - middle) / duration;
    powers.row(row) << 1, t, t * t;
    displacements[row++] = direction.dot(snapshot.blocks[block].displacement);
  }
  const Eigen::Vector3d parabola = powers.colPivHouseholderQr().solve(displacements);
  return 2 * parabola[2] / (duration * duration);
}

std::string travel_fault(const std::string& block, double distance_moved) {
  return block + " goes " + significant(distance_moved, 6) + " m";
}

bool movable(const Block& block) { return block.body != BodyKind::fixed; }

}  // namespace

HardCaseExpectation rests(const std::string& block, int stage, double distance, double angle) {
  return {block + " rests " + since_words(stage) + ": moves by less than " + with_unit(distance, "m") +
              ", turns by less than " + in_degrees(angle),
          [=](const Trajectory& trajectory) {
            return unrest(trajectory, trajectory.block(block), stage, distance, angle);
          }};
}

HardCaseExpectation all_rest(int stage, double distance, double angle) {
  return {"all blocks rest " + since_words(stage) + ": move by less than " + with_unit(distance, "m") +
              ", turn by less than " + in_degrees(angle),
          [=](const Trajectory& trajectory) {
            for (std::size_t b = 0; b < trajectory.system.blocks.size(); ++b)
              if (const auto fault = unrest(trajectory, static_cast<int>(b), stage, distance, angle); !fault.empty())
                return fault;
            return std::string();
          }};
}

HardCaseExpectation travels(const std::string& block, const Vec3& direction, double distance, double tolerance,
                            int stage) {
  const std::string since = stage < 0 ? "" : " " + since_words(stage);
  return {block + " goes " + significant(distance, 6) + " m" + since + " within " + with_unit(100 * tolerance, "%"),
          [=](const Trajectory& trajectory) {
            const double distance_moved = displacement_along(trajectory, block, direction, stage);
            const bool there = std::abs(distance_moved - distance) <= tolerance * std::abs(distance);
            return there ? std::string() : travel_fault(block, distance_moved);
          }};
}

HardCaseExpectation travels_at_least(const std::string& block, const Vec3& direction, double least) {
  return {block + " goes at least " + with_unit(least, "m"), [=](const Trajectory& trajectory) {
            const double distance_moved = displacement_along(trajectory, block, direction, -1);
            return distance_moved >= least ? std::string() : travel_fault(block, distance_moved);
          }};
}

HardCaseExpectation accelerates(const std::string& block, const Vec3& direction, double acceleration,
                                double tolerance) {
  return {
      block + " is accelerated by " + significant(acceleration, 6) + " m/s² within " + with_unit(100 * tolerance, "%"),
      [=](const Trajectory& trajectory) {
        const double found = mean_acceleration(trajectory, trajectory.block(block), direction);
        const bool so = std::abs(found - acceleration) <= tolerance * std::abs(acceleration);
        return so ? std::string() : block + " is accelerated by " + significant(found, 6) + " m/s²";
      }};
}

HardCaseExpectation topples(const std::string& block, double angle) {
  return {block + " turns by at least " + in_degrees(angle), [=](const Trajectory& trajectory) {
            double turn = 0;
            for (const Snapshot& snapshot : trajectory.snapshots)
              turn = std::max(turn, degrees(snapshot.blocks[trajectory.block(block)].rotation));
            return turn >= angle ? std::string() : block + " turns by " + in_degrees(turn);
          }};
}

HardCaseExpectation stops(const std::string& block, double speed) {
  return {block + " ends slower than " + with_unit(speed, "m/s"), [=](const Trajectory& trajectory) {
            const double end = trajectory.last().blocks[trajectory.block(block)].velocity.norm();
            return end < speed ? std::string() : block + " ends with " + with_unit(end, "m/s");
          }};
}

HardCaseExpectation gains_no_speed(const std::string& block, double since, double gain) {
  return {block + " gains less than " + with_unit(gain, "m/s") + " after " + with_unit(since, "s"),
          [=](const Trajectory& trajectory) {
            const int b = trajectory.block(block);
            double first = -1;
            for (const Snapshot& snapshot : trajectory.snapshots) {
              if (snapshot.time < since) continue;
              const double speed = snapshot.blocks[b].velocity.norm();
              if (first < 0) first = speed;
              if (!(speed - first < gain)) return block + " gains " + with_unit(speed - first, "m/s");
            }
            return std::string();
          }};
}

HardCaseExpectation stays_before(const Vec3& point, const Vec3& normal) {
  return {"nothing passes through the plane at (" + significant(point.x()) + ", " + significant(point.y()) + ", " +
              significant(point.z()) + ") m",
          [=](const Trajectory& trajectory) {
            for (std::size_t b = 0; b < trajectory.system.blocks.size(); ++b) {
              if (!movable(trajectory.system.blocks[b])) continue;
              const Vec3 start = volume_moments(trajectory.system.blocks[b].mesh).centroid;
              for (const Snapshot& snapshot : trajectory.snapshots) {
                const double before = (start + snapshot.blocks[b].displacement - point).dot(normal);
                if (!(before > 0))
                  return trajectory.system.blocks[b].name + " is " + with_unit(-before, "m") + " behind it at " +
                         with_unit(snapshot.time, "s");
              }
            }
            return std::string();
          }};
}

HardCaseExpectation comes_down_aside(const std::string& block, const Vec3& up, double allowance) {
  constexpr double slope = 0.05, turn = 5;  // degrees
  const auto fault = [=](const Trajectory& trajectory) -> std::string {
    const int index = trajectory.block(block);
    for (const Snapshot& snapshot : trajectory.snapshots) {
      const BlockMotion& motion = snapshot.blocks[index];
      const double sunk = -motion.displacement.dot(up) - allowance;
      const double aside = (motion.displacement - motion.displacement.dot(up) * up).norm();
      if (sunk <= 0 || aside >= slope * sunk || motion.rotation >= radians(turn)) continue;
      char text[160];
      std::snprintf(text, sizeof text, "%s sank by %.3g m more than it may at %.4g s, %.3g m aside", block.c_str(),
                    sunk, snapshot.time, aside);
      return text;
    }
    return {};
  };
  return {block + " comes down only aside or turning over", fault};
}

Vec3 mean_displacement(const Trajectory& trajectory) {
  Vec3 sum = Vec3::Zero();
  double volume = 0;
  for (std::size_t b = 0; b < trajectory.system.blocks.size(); ++b) {
    const Block& block = trajectory.system.blocks[b];
    if (!movable(block)) continue;
    sum += block.volume * trajectory.last().blocks[b].displacement;
    volume += block.volume;
  }
  return sum / volume;
}

}  // namespace talus
