#include "stability/balance.hpp"

#include <cstdio>

#include "base/units.hpp"

namespace talus {

Demand comes_down_aside(const std::string& block, const Vec3& up, double allowance) {
  constexpr double slope = 0.05, turn = 5;  // degrees
  const auto fault = [=](const Course& course) -> std::string {
    const int index = course.block(block);
    for (const Moment& moment : course.moments) {
      const BlockMotion& motion = moment.blocks[index];
      const double sunk = -motion.displacement.dot(up) - allowance;
      const double aside = (motion.displacement - motion.displacement.dot(up) * up).norm();
      if (sunk <= 0 || aside >= slope * sunk || motion.rotation >= radians(turn)) continue;
      char text[160];
      std::snprintf(text, sizeof text, "%s sank by %.3g m more than it may at %.4g s, %.3g m aside", block.c_str(),
                    sunk, moment.time, aside);
      return text;
    }
    return {};
  };
  return {block + " comes down only aside or turning over", fault};
}

}  // namespace talus
