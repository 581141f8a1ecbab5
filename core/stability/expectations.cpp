#include "stability/expectations.hpp"

#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "cases/case_text.hpp"
#include "mesh/moments.hpp"

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
std::string unrest(const Course& course, int block, int stage, double distance, double angle) {
  const Moment& from = course.end_of_stage(stage);
  const BlockMotion& stood = from.blocks[block];
  double way = 0, turn = 0;
  for (const Moment& moment : course.moments) {
    if (moment.time < from.time) continue;
    way = larger(way, (moment.blocks[block].displacement - stood.displacement).norm());
    turn = larger(turn, degrees(std::abs(moment.blocks[block].rotation - stood.rotation)));
  }
  if (way < distance && turn < angle) return {};
  return course.system.blocks[block].name + " moves by " + with_unit(way, "m") + " and turns by " + in_degrees(turn);
}

double way_along(const Course& course, const std::string& block, const Vec3& direction) {
  return course.last().blocks[course.block(block)].displacement.dot(direction);
}

std::string travel_fault(const std::string& block, double way) { return block + " goes " + significant(way, 6) + " m"; }

bool movable(const Block& block) { return block.body != BodyKind::fixed; }

}  // namespace

Demand rests(const std::string& block, int stage, double distance, double angle) {
  return {block + " rests " + since_words(stage) + ": moves by less than " + with_unit(distance, "m") +
              ", turns by less than " + in_degrees(angle),
          [=](const Course& course) { return unrest(course, course.block(block), stage, distance, angle); }};
}

Demand all_rest(int stage, double distance, double angle) {
  return {"all blocks rest " + since_words(stage) + ": move by less than " + with_unit(distance, "m") +
              ", turn by less than " + in_degrees(angle),
          [=](const Course& course) {
            for (std::size_t b = 0; b < course.system.blocks.size(); ++b)
              if (const auto fault = unrest(course, static_cast<int>(b), stage, distance, angle); !fault.empty())
                return fault;
            return std::string();
          }};
}

Demand travels(const std::string& block, const Vec3& direction, double distance, double tolerance) {
  return {block + " goes " + significant(distance, 6) + " m within " + with_unit(100 * tolerance, "%"),
          [=](const Course& course) {
            const double way = way_along(course, block, direction);
            const bool there = std::abs(way - distance) <= tolerance * std::abs(distance);
            return there ? std::string() : travel_fault(block, way);
          }};
}

Demand travels_at_least(const std::string& block, const Vec3& direction, double least) {
  return {block + " goes at least " + with_unit(least, "m"), [=](const Course& course) {
            const double way = way_along(course, block, direction);
            return way >= least ? std::string() : travel_fault(block, way);
          }};
}

Demand topples(const std::string& block, double angle) {
  return {block + " turns by at least " + in_degrees(angle), [=](const Course& course) {
            double turn = 0;
            for (const Moment& moment : course.moments)
              turn = std::max(turn, degrees(moment.blocks[course.block(block)].rotation));
            return turn >= angle ? std::string() : block + " turns by " + in_degrees(turn);
          }};
}

Demand stops(const std::string& block, double speed) {
  return {block + " ends slower than " + with_unit(speed, "m/s"), [=](const Course& course) {
            const double end = course.last().blocks[course.block(block)].velocity.norm();
            return end < speed ? std::string() : block + " ends with " + with_unit(end, "m/s");
          }};
}

Demand gains_no_speed(const std::string& block, double since, double gain) {
  return {block + " gains less than " + with_unit(gain, "m/s") + " after " + with_unit(since, "s"),
          [=](const Course& course) {
            const int b = course.block(block);
            double first = -1;
            for (const Moment& moment : course.moments) {
              if (moment.time < since) continue;
              const double speed = moment.blocks[b].velocity.norm();
              if (first < 0) first = speed;
              if (!(speed - first < gain)) return block + " gains " + with_unit(speed - first, "m/s");
            }
            return std::string();
          }};
}

Demand stays_before(const Vec3& point, const Vec3& normal) {
  return {"nothing passes through the plane at (" + significant(point.x()) + ", " + significant(point.y()) + ", " +
              significant(point.z()) + ") m",
          [=](const Course& course) {
            for (std::size_t b = 0; b < course.system.blocks.size(); ++b) {
              if (!movable(course.system.blocks[b])) continue;
              const Vec3 start = volume_moments(course.system.blocks[b].mesh).centroid;
              for (const Moment& moment : course.moments) {
                const double before = (start + moment.blocks[b].displacement - point).dot(normal);
                if (!(before > 0))
                  return course.system.blocks[b].name + " is " + with_unit(-before, "m") + " behind it at " +
                         with_unit(moment.time, "s");
              }
            }
            return std::string();
          }};
}

}  // namespace talus
