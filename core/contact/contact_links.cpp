#include "contact/contact_links.hpp"

namespace talus {

void ContactLinks::connect(Arms arms) {
  moves_.clear();
  for (const ContactPoint& point : contacts_.points) {
    const auto [nodes, weights] = contacts_.stencil(point);
    moves_.add(nodes, weights);
    if (arms == Arms::mean && moves_.may_meet()) moves_.let_meet(Meeting::carrier(weights));
  }
}

const std::vector<int>* ContactLinks::points_of(const PickedBodies* bodies, const std::vector<int>& all,
                                                std::vector<int>& picked) const {
  if (!bodies) return &all;
  picked.clear();
  for (const int i : all)
    if (bodies->has[point(i).bodies[0]] || bodies->has[point(i).bodies[1]]) picked.push_back(i);
  return &picked;
}

}  // namespace talus
