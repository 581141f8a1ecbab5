#include "render/stereonet/slope_key.hpp"

#include "model/number_text.hpp"
#include "render/paint/picture_words.hpp"

namespace talus {

std::vector<SlopeKeyRow> slope_key(const Stereonet& net) {
  using Sample = SlopeKeyRow::Sample;
  if (!net.slope) return {};
  const KinematicSetting& slope = *net.slope;
  const Rgb face = face_colour(net.theme), friction_line = friction_colour(net.theme);
  const std::string friction = number_text(slope.friction_angle) + "°";
  std::vector<SlopeKeyRow> rows{{Sample::line, face, 2, picture_word("face"), plane_text(slope.face)}};
  if (net.mode == FailureMode::planar)
    rows.push_back({Sample::line, face, 1.2, picture_word("daylight envelope of its poles"), {}});
  if (net.mode == FailureMode::planar || net.mode == FailureMode::wedge)
    rows.push_back({Sample::dashes, friction_line, 1.4, picture_word("friction cone φ"), friction});
  if (net.mode == FailureMode::flexural)
    rows.push_back({Sample::dashes, friction_line, 1.4, picture_word("slip limit, face dip − φ"), friction});
  if (net.mode != FailureMode::wedge)
    rows.push_back(
        {Sample::dashes, face, 0.8, picture_word("lateral limits"), "±" + number_text(slope.lateral_limit) + "°"});
  const std::string critical =
      judges_lines(net.mode) ? picture_word("critical intersections") : picture_word("critical poles");
  rows.push_back({Sample::area, zone_colour(net.theme), 1, critical, {}});
  if (judges_lines(net.mode)) {
    rows.push_back({Sample::cross, colours(net.theme).muted, 1, picture_word("intersections of mean planes"), {}});
    rows.push_back({Sample::dot, colours(net.theme).muted, 1, picture_word("intersections of joints"), {}});
  }
  return rows;
}

}  // namespace talus
