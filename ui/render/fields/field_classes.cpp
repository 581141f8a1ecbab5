#include "render/fields/field_classes.hpp"

#include <stdexcept>

namespace talus {

namespace {

constexpr Rgb held = rgb(0x00806f), torn = rgb(0xc0208c), neither = rgb(0x868e89);

}  // namespace

std::vector<FieldClass> classes_of(const Field& field) {
  switch (field.measure) {
    case Field::Measure::state:
      return {{state_colour(ContactState::open), "open"},
              {state_colour(ContactState::stick), "sticks"},
              {state_colour(ContactState::slip), "slides"},
              {held, "bonded"}};
    case Field::Measure::bond:
      return {{neither, "never bonded"}, {held, "bonded"}, {torn, "broken"}};
    default:
      throw std::invalid_argument(std::string(field.name) + " has no classes");
  }
}

Rgb state_colour(ContactState state) {
  switch (state) {
    case ContactState::stick:
      return rgb(0x0068a8);
    case ContactState::slip:
      return rgb(0xd2580a);
    case ContactState::open:
      break;
  }
  return neither;
}

}  // namespace talus
