#include <cmath>

#include "base/units.hpp"
#include "templates/shapes.hpp"
#include "templates/structures.hpp"

namespace talus {

namespace {

/// Columns of one height in front of a rock face, on a plane that dips out of it: Goodman & Bray's toppling columns
/// with a base that is not stepped. A column topples where its width over its height is below tan α of the dip, and
/// slides where the dip exceeds the friction angle.
Project make_toppling_face(const TemplateValues& values) {
  const double height = values.at("height"), width = values.at("width"), dip = values.at("dip");
  const int count = static_cast<int>(values.at("count"));
  const double front = count * width, depth = width / 2;
  Project project = rock_with_joints("Toppling face", values.at("friction"));
  const std::vector<SectionPoint> ground{
      {-height, -height / 2}, {front + 1.5 * height, -height / 2}, {front + 1.5 * height, 0}, {0, 0}, {0, height},
      {-height, height}};
  project.solids = {fixed_rock("slope", prism(on_incline(ground, dip), -2 * depth, 2 * depth), height / 2)};
  for (int i = 0; i < count; ++i) {
    const double from = i * width, to = from + width;
    const auto profile = on_incline({{from, 0}, {to, 0}, {to, height}, {from, height}}, dip);
    const std::string number = std::to_string(i + 1);
    project.solids.push_back(free_rock("column " + number, prism(profile, -depth, depth)));
  }
  const SectionPoint head = on_incline({{front - width / 2, height}}, dip)[0];
  add_monitor(project, "column " + std::to_string(count), {head.x, 0, head.z});
  add_stages(project, height, std::sqrt(height));
  return project;
}

}  // namespace

ProjectTemplate toppling_face() {
  return {"toppling-face",
          "Toppling face",
          "Columns between steep joints on a plane that dips out of the face. They topple where width over height is "
          "below the tangent of the dip, and slide where the dip exceeds the friction angle.",
          {{"height", "Column height", "along the joints", "m", 1, 40, 8},
           {"width", "Column width", "spacing of the joints", "m", 0.2, 10, 1.5},
           {"count", "Columns", "in front of the face", "", 1, 20, 6, true},
           {"dip", "Base dip", "of the plane that the columns stand on", "°", 0, 45, 20},
           {"friction", "Friction angle", "of joints and base", "°", 0, 60, 35}},
          make_toppling_face};
}

}  // namespace talus
