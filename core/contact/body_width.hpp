#pragma once

#include <span>

#include "base/vector.hpp"
#include "contact/contact_body.hpp"

namespace talus {

/// How wide a body is where it is thinnest [m]: along the principal axis about which its nodes at x (all bodies')
/// spread least. Exact for plates and boxes; of a body with thin parts it is that of the whole.
double least_width(const ContactBody& body, std::span<const Vec3> x);

}  // namespace talus
