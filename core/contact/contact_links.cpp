#include "contact/contact_links.hpp"

namespace talus {

void ContactLinks::connect(Arms arms) {
  moves_.clear();
  for (const ContactPoint& point : contacts_.points) {
    const auto count = static_cast<std::size_t>(point.stencil_end - point.stencil_begin);
    const auto nodes = std::span(contacts_.nodes).subspan(point.stencil_begin, count);
    const auto weights = std::span(contacts_.weights).subspan(point.stencil_begin, count);
    moves_.add(nodes, weights);
    if (arms == Arms::mean && moves_.may_meet()) moves_.let_meet(Meeting::carrier(weights));
  }
}

}  // namespace talus
