#include "text/orientation_text.hpp"

#include "model/number_text.hpp"
#include "text/table.hpp"

namespace talus::cli {

std::string sets_text(std::span<const SetStatistics> sets) {
  Table table({"Set", "Poles", "Dip [°]", "Dip direction [°]", "Fisher κ", "95 % cone [°]", "68 % within [°]"},
              "lrrrrrr");
  for (const SetStatistics& set : sets) {
    const PlaneAttitude mean = set.mean_plane();
    const auto cone = confidence_cone(set.fisher, 0.95);
    const auto& kappa = set.fisher.kappa;
    table.add({set.name.empty() ? "-" : set.name, std::to_string(set.members.size()), decimals(mean.dip, 1),
               decimals(mean.dip_direction, 1), kappa ? number(*kappa, 4) : "-", cone ? decimals(*cone, 1) : "-",
               kappa ? decimals(spread_cone(*kappa, 0.68), 1) : "-"});
  }
  return table.text();
}

std::string kinematics_text(const KinematicCounts& counts, const KinematicSetting& setting) {
  Table table({"Failure mode", "Critical", "Of", "Share [%]", ""}, "lrrrl");
  const auto add = [&](const char* mode, const KinematicCount& count, const char* what) {
    table.add({mode, std::to_string(count.count), std::to_string(count.total), decimals(count.percent(), 2), what});
  };
  add("planar sliding", counts.planar, "poles");
  add("  no limits at the sides", counts.planar_unlimited, "poles");
  add("wedge sliding", counts.wedge, "intersections");
  add("  of these on one plane", counts.on_one_plane, "intersections");
  add("  line flatter than friction", counts.wedge_flat, "intersections");
  add("flexural toppling", counts.flexural, "poles");
  add("direct toppling", counts.direct, "intersections");
  add("  oblique", counts.direct_oblique, "intersections");
  add("  base planes", counts.base, "poles");
  add("  base planes, oblique", counts.base_oblique, "poles");
  return "Face " + plane_text(setting.face) + ", friction angle " + number(setting.friction_angle, 4) +
         " degrees, lateral limits ±" + number(setting.lateral_limit, 4) + " degrees\n" + table.text();
}

}  // namespace talus::cli
