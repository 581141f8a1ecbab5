#include "contact/contact_links.hpp"

namespace talus {

void ContactLinks::connect() {
  moves_.clear();
  for (const ContactPoint& point : contacts_.points) {
    const auto count = static_cast<std::size_t>(point.stencil_end - point.stencil_begin);
    moves_.add(std::span(contacts_.nodes).subspan(point.stencil_begin, count),
               std::span(contacts_.weights).subspan(point.stencil_begin, count));
  }
}

}  // namespace talus
