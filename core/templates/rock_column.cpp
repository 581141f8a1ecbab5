#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "templates/shapes.hpp"
#include "templates/structures.hpp"

namespace talus {

namespace {

/// A column on an inclined plane: it stays, slides, topples or does both (the chart of Ashby, 1971).
Project make_rock_column(const TemplateValues& values) {
  const double height = values.at("height"), width = values.at("width"), half = values.at("depth") / 2;
  const double dip = values.at("dip"), margin = std::max(height, width);
  Project project = rock_with_joints("Column on a plane", values.at("friction"));
  const auto ground = on_incline(
      {{-width - margin / 2, -margin / 2}, {2 * margin, -margin / 2}, {2 * margin, 0}, {-width - margin / 2, 0}}, dip);
  const auto column = on_incline({{-width, 0}, {0, 0}, {0, height}, {-width, height}}, dip);
  const double side = 1.5 * half + margin / 4;
  project.solids = {fixed_rock("plane", prism(ground, -side, side), margin / 2),
                    free_rock("column", prism(column, -half, half))};
  const SectionPoint head = on_incline({{-width / 2, height}}, dip)[0];
  add_monitor(project, "column", {head.x, 0, head.z});
  add_stages(project, height, std::sqrt(height));
  return project;
}

}  // namespace

ProjectTemplate rock_column() {
  return {"column",
          "Column",
          "A column on an inclined plane. It slides where the dip exceeds the friction angle, and topples where width "
          "over height is below the tangent of the dip.",
          {{"height", "Height", "normal to the plane", "m", 0.2, 40, 4},
           {"width", "Width", "along the dip", "m", 0.1, 20, 1},
           {"depth", "Depth", "along the strike", "m", 0.1, 20, 1},
           {"dip", "Plane dip", "from the horizontal", "°", 0, 60, 20},
           {"friction", "Friction angle", "between column and plane", "°", 0, 60, 35}},
          make_rock_column};
}

}  // namespace talus
