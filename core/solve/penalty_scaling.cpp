#include "solve/penalty_scaling.hpp"

#include <algorithm>

namespace talus {

bool PenaltyScaling::scale(ContactSet& contacts, const ContactLinks& links, const Increment& d, const Depths& allowed,
                           std::span<const Joint> as_given) {
  pairs_.clear();
  for (int i = 0; i < links.moves().size(); ++i) {
    const ContactPoint& point = contacts.points[i];
    if (may_stiffen(point, as_given) && is_too_deep(point, links.gap(i, d), allowed))
      pairs_.push_back(bodies_of(point));
  }
  if (pairs_.empty()) return false;
  std::sort(pairs_.begin(), pairs_.end());
  pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
  for (ContactPoint& point : contacts.points)
    if (may_stiffen(point, as_given) && std::binary_search(pairs_.begin(), pairs_.end(), bodies_of(point)))
      stiffen(point);
  return true;
}

bool PenaltyScaling::may_stiffen(const ContactPoint& point, std::span<const Joint> as_given) const {
  const bool is_given = !as_given.empty() && as_given[point.joint].normal_stiffness;
  return !point.bonded && !is_given && point.penalty_scaling < tolerances_.largest;
}

bool PenaltyScaling::is_too_deep(const ContactPoint& point, double gap, const Depths& allowed) const {
  const double by_spring = allowed.spring * point.size;
  const bool may_be_deeper = point.area > 0 && !bodies_.any_moves_by_elements(point.bodies);
  const double in_all = may_be_deeper ? allowed.in_all * point.size : by_spring;
  const bool is_deep = -gap > by_spring || point.initial_interference - gap > in_all;
  return is_deep && gap < point.gap && -gap > tolerances_.least_compression * by_spring;
}

void PenaltyScaling::stiffen(ContactPoint& point) const {
  const double factor = point.stiffened ? tolerances_.repeated_factor : tolerances_.factor;
  point.stiffened = true;
  if (point.gap < 0) {
    const double left = point.gap / factor;  // at which the stiffer spring pushes as much
    point.initial_interference += left - point.gap;
    point.gap = left;
  }
  point.penalty_scaling *= factor;
  point.normal_stiffness *= factor;
  point.shear_stiffness *= factor;
}

}  // namespace talus
