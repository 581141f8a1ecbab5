#include "verification/known_answers/blocks/column_row.hpp"

#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "model/number_text.hpp"
#include "model/stages.hpp"
#include "verification/known_answers/support/bracket.hpp"
#include "verification/known_answers/support/recorded_run.hpp"

namespace talus {

namespace {

/// A row whose farthest column has gone this share of a width within the run has failed.
constexpr double column_moved = 1e-3;

/// In the axes of the base's steps: x down their dip, z their normal. The toe column stands on x = −width … 0.
CaseScene row_scene(const ColumnRow& row, double friction_angle) {
  const double depth = row.width;
  CaseScene scene = rock_scene(friction_angle);
  tilt(scene, row.base_dip);
  const std::vector<double> height = heights(row);
  scene.add_fixed_box("apron", Vec3(0, -depth, -2 * row.width), Vec3(2 * row.width, depth, 0));
  for (int i = 0; i < row.count; ++i) {
    const double back = -(i + 1) * row.width, base = i * row.base_rise;
    const std::string number = std::to_string(i + 1);
    scene.add_fixed_box("step " + number, Vec3(back, -depth, -2 * row.width), Vec3(back + row.width, depth, base));
    scene.add_box("column " + number, Vec3(back, -depth / 2, base),
                  Vec3(back + row.width, depth / 2, base + height[i]));
  }
  scene.project.stages = {static_stage(0.02, 100), dynamic_stage(0.02, 6)};
  return scene;
}

/// The bracket of friction angles that runs close in on, each run a row of the table.
Bracket limit_by_runs(const ColumnRow& row, double young, CaseTable& table, const CaseOptions& options,
                      Progress& progress) {
  const double expected = limiting_friction_angle(row);
  return narrowed({expected - 4, expected + 4}, options.thorough ? 10 : 7, [&](double angle) {
    CaseScene scene = row_scene(row, angle);
    scene.project.materials[0].young = young;
    const bool falls = sets_off(scene, column_moved * row.width, options, progress);
    table.rows.push_back({decimals(young / 1e9, 0), decimals(angle, 3), falls ? "falls" : "stands"});
    return falls;
  });
}

CaseOutcome limit(const CaseOptions& options, Progress& progress) {
  const ColumnRow row;
  CaseOutcome outcome;
  outcome.tables.push_back({"Rows of columns", {"E [GPa]", "φ [°]", "row"}, {}});
  // Limit equilibrium knows no elasticity: columns push on their neighbours' very edges. The stiffer the rock, the
  // nearer runs come to that.
  for (const double young : options.thorough ? std::vector{5e9, 50e9, 500e9} : std::vector{50e9})
    outcome.findings.push_back(
        {.quantity = "limiting friction angle, E " + decimals(young / 1e9, 0) + " GPa",
         .unit = "°",
         .expected = limiting_friction_angle(row),
         .computed = limit_by_runs(row, young, outcome.tables.back(), options, progress).middle(),
         .tolerance = 0.1,
         .absolute = true});
  return outcome;
}

}  // namespace

std::vector<double> heights(const ColumnRow& row) {
  std::vector<double> height;
  for (int i = 1; i <= row.count; ++i)
    height.push_back(i <= row.crest ? i * (row.face_rise - row.base_rise)
                                    : height.back() - row.crest_drop - row.base_rise);
  return height;
}

double toe_force(const ColumnRow& row, double friction_angle) {
  const double t = std::tan(radians(friction_angle));
  const double s = std::sin(radians(row.base_dip)), c = std::cos(radians(row.base_dip));
  const std::vector<double> height = heights(row);
  double from_above = 0, needed = 0;
  for (int i = row.count; i >= 1; --i) {
    const double y = height[i - 1], weight = y;
    const double upper = i < row.crest ? y : y - row.crest_drop;  // where the upper neighbour pushes
    const double lower = i <= row.crest ? y - row.face_rise : y;  // where it pushes the lower one
    const double tops = (from_above * (upper - row.width * t) + weight / 2 * (y * s - row.width * c)) / lower;
    const double slides = from_above - weight * (c * t - s) / (1 - t * t);
    const bool may_topple = lower > 0 && (from_above > 0 || y * s > row.width * c);
    needed = may_topple ? std::max(tops, slides) : slides;
    from_above = std::max(needed, 0.0);
  }
  return needed;
}

double limiting_friction_angle(const ColumnRow& row) {
  double falls = row.base_dip, stands = 44.9;
  for (int i = 0; i < 60; ++i) {
    const double middle = (falls + stands) / 2;
    (toe_force(row, middle) > 0 ? falls : stands) = middle;
  }
  return stands;
}

std::vector<KnownCase> column_row_cases() {
  return {{.name = "goodman_bray",
           .title = "16 columns topple over each other",
           .source = "limit equilibrium of Goodman & Bray 1976",
           .thinned = true,
           .of_any_body = true,
           .run = limit}};
}

}  // namespace talus
