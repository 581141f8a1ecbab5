#include "render/fields/field_classes.hpp"

#include <stdexcept>

#include "render/paint/picture_words.hpp"
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
    classes.push_back({colour, picture_word(to_string(static_cast<MotionMode>(classes.size())))});
  return classes;
}

}  // namespace

std::vector<FieldClass> classes_of(const Field& field) {
  switch (field.measure) {
    case Field::Measure::state:
      return {{state_colour(ContactState::open), picture_word("open")},
              {state_colour(ContactState::stick), picture_word("sticks")},
              {state_colour(ContactState::slip), picture_word("slides")},
              {held, picture_word("bonded")}};
    case Field::Measure::bond:
      return {{neither, picture_word("never bonded")}, {held, picture_word("bonded")}, {torn, picture_word("broken")}};
    case Field::Measure::body: {
      const auto& palette = block_palette();
      return {{fixed, picture_word("fixed")},
              {palette[0], picture_word("rigid")},
              {palette[2], picture_word("affine")},
              {palette[1], picture_word("tetrahedra")}};
    }
    case Field::Measure::sleep:
      return {{fixed, picture_word("fixed")},
              {rgb(0xee8866), picture_word("awake")},
              {rgb(0x77aadd), picture_word("asleep")}};
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
