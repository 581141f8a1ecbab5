#include "render/fields/field_classes.hpp"

#include <stdexcept>

#include "render/paint/theme.hpp"

namespace talus {

namespace {

constexpr Rgb held = rgb(0x00806f), torn = rgb(0xc0208c), neither = rgb(0x868e89);

const Rgb fixed = colours(Theme::light).rock;

std::vector<FieldClass> motions() {
  const Rgb of_modes[] = {fixed,         rgb(0xbbcc33), rgb(0xcc4125), rgb(0x77aadd), rgb(0x0068a8),
                          rgb(0xeedd88), rgb(0x44bb99), rgb(0xee8866), rgb(0xaa7ab8)};
  std::vector<FieldClass> classes;
  for (const Rgb colour : of_modes)
    classes.push_back({colour, std::string(to_string(static_cast<MotionMode>(classes.size())))});
  return classes;
}

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
    case Field::Measure::body: {
      const auto& palette = block_palette();
      return {{fixed, "fixed"}, {palette[0], "rigid"}, {palette[2], "affine"}, {palette[1], "tetrahedra"}};
    }
    case Field::Measure::sleep:
      return {{fixed, "fixed"}, {rgb(0xee8866), "awake"}, {rgb(0x77aadd), "asleep"}};
    case Field::Measure::motion:
      return motions();
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
