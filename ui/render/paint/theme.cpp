#include "render/paint/theme.hpp"

namespace talus {

const ThemeColours& colours(Theme theme) {
  static constexpr ThemeColours light{.view_top = rgb(0xdde3e6),
                                      .view_bottom = rgb(0xf7f8f8),
                                      .edge = rgb(0x3a4340),
                                      .rock = rgb(0xc9c6bd),
                                      .pick = rgb(0xd2580a),
                                      .warn = rgb(0x8a5a00),
                                      .text = rgb(0x1b211f),
                                      .muted = rgb(0x535d59),
                                      .line = rgb(0x868e89),
                                      .surface = rgb(0xffffff),
                                      .frame = rgb(0xd3d8d6),
                                      .grid = rgb(0xe6e8e5)};
  static constexpr ThemeColours dark{.view_top = rgb(0x2c3335),
                                     .view_bottom = rgb(0x454d50),
                                     .edge = rgb(0x0e1212),
                                     .rock = rgb(0xa3a198),
                                     .pick = rgb(0xff9a4d),
                                     .warn = rgb(0xe0b050),
                                     .text = rgb(0xe7eae9),
                                     .muted = rgb(0xadb6b3),
                                     .line = rgb(0x9aa3a0),
                                     .surface = rgb(0x1e2223),
                                     .frame = rgb(0x41494a),
                                     .grid = rgb(0x343a3b)};
  return theme == Theme::dark ? dark : light;
}

const std::array<Rgb, 7>& block_palette() {
  static constexpr std::array<Rgb, 7> palette{rgb(0x77aadd), rgb(0xeedd88), rgb(0x44bb99), rgb(0xffaabb),
                                              rgb(0xbbcc33), rgb(0x99ddff), rgb(0xaaaa00)};
  return palette;
}

const std::array<Rgb, 5>& caution_palette() {
  static constexpr std::array<Rgb, 5> palette{rgb(0x7d93a6), rgb(0x99ddff), rgb(0xeedd88), rgb(0xee8866),
                                              rgb(0xcc4125)};
  return palette;
}

const std::array<Rgb, 6>& curve_palette(Theme theme) {
  static constexpr std::array<Rgb, 6> light{rgb(0x0068a8), rgb(0xc0208c), rgb(0x00806f),
                                            rgb(0x7a5048), rgb(0x7a3fa0), rgb(0x6f6a00)};
  static constexpr std::array<Rgb, 6> dark{rgb(0x5db3ea), rgb(0xf86ab8), rgb(0x3fc7b3),
                                           rgb(0xdcc0b0), rgb(0xc79be6), rgb(0xcfc84a)};
  return theme == Theme::dark ? dark : light;
}

}  // namespace talus
