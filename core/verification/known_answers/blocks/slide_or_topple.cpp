#include "verification/known_answers/blocks/slide_or_topple.hpp"

#include <cmath>

#include "base/units.hpp"
#include "model/number_text.hpp"
#include "model/stages.hpp"
#include "verification/known_answers/support/bracket.hpp"
#include "verification/known_answers/support/recorded_run.hpp"

namespace talus {

namespace {

/// A run ends when the column has slipped by this share of its height, or turned by as many radians …
constexpr double clearly_moved = 0.02;
/// … and has slipped, or turned, if it did so by more than this: a thousand times its elastic settlement.
constexpr double block_moved = 5e-4;
/// What no elastic toe yields by, of the height.
constexpr double just_slipped = 2e-5;

/// How a column has moved, in the plane of the slope's dip.
struct ColumnMotion {
  double slip = 0;  ///< of its toe, of its height
  double turn = 0;  ///< rad
};

ColumnMotion column_motion(const BlockMotion& block, double width, double height) {
  // What turns by θ about its toe moves its centroid by this much down the slope; the rest is slip.
  const double by_turning = width / 2 * (1 - std::cos(block.rotation)) + height / 2 * std::sin(block.rotation);
  return {(block.displacement.x() - by_turning) / height, block.rotation};
}

ColumnMode mode_of(const ColumnMotion& motion) {
  const bool slips = motion.slip > block_moved, turns = motion.turn > block_moved;
  return slips   ? turns ? ColumnMode::slides_and_topples : ColumnMode::slides
         : turns ? ColumnMode::topples
                 : ColumnMode::stable;
}

ColumnMotion run_column(const ColumnPoint& point, const CaseOptions& options, Progress& progress) {
  const double height = 1, width = point.slenderness * height;
  CaseScene scene = rock_scene(point.friction_angle);
  tilt(scene, point.dip);
  scene.add_fixed_box("slab", Vec3(-2, -1, -1), Vec3(3, 1, 0));
  scene.add_box("column", Vec3(0, -0.25, 0), Vec3(width, 0.25, height));
  scene.project.stages = {static_stage(0.005, 20), dynamic_stage(0.005, 1)};
  ColumnMotion result;
  record(scene, options, progress, [&](const Snapshot& snapshot) {
    result = column_motion(snapshot.blocks[1], width, height);
    return result.slip < clearly_moved && result.turn < clearly_moved;
  });
  return result;
}

/// Runs the points into a table, a row each; how many have another mode than expected.
int compare_modes(const std::vector<ColumnPoint>& points, CaseTable& table, const CaseOptions& options,
                  Progress& progress) {
  table.columns = {"width/height", "dip [°]", "φ [°]", "expected", "computed", "slip of the toe/height", "turn [rad]"};
  int wrong = 0;
  for (const ColumnPoint& point : points) {
    progress.report(static_cast<double>(table.rows.size()) / static_cast<double>(points.size()), table.title);
    const ColumnMotion motion = run_column(point, options, progress);
    const ColumnMode expected = expected_mode(point), computed = mode_of(motion);
    wrong += expected != computed;
    table.rows.push_back({decimals(point.slenderness, 2), decimals(point.dip, 2), decimals(point.friction_angle, 2),
                          std::string(to_string(expected)), std::string(to_string(computed)), decimals(motion.slip, 6),
                          decimals(motion.turn, 6)});
  }
  return wrong;
}

CaseOutcome modes(const std::string& title, const std::vector<ColumnPoint>& points, const CaseOptions& options,
                  Progress& progress) {
  CaseOutcome outcome;
  outcome.tables.push_back({title, {}, {}});
  const int wrong = compare_modes(points, outcome.tables.back(), options, progress);
  outcome.findings.push_back({.quantity = "points of another mode, of " + std::to_string(points.size()),
                              .unit = "",
                              .computed = static_cast<double>(wrong),
                              .tolerance = 0,
                              .absolute = true});
  return outcome;
}

CaseOutcome chart(const CaseOptions& options, Progress& progress) {
  const std::vector<double> all{0.25, 0.4, 0.5, 0.75, 1, 1.5}, few{0.25, 1};
  CaseOutcome outcome = modes("Columns 1° beside the lines of the chart",
                              points_beside_the_lines(options.thorough ? all : few), options, progress);
  const double slenderness = 0.25, dip = 30, expected = friction_angle_of_pure_toppling(slenderness, dip);
  const Bracket toe_slips = narrowed({expected - 2, expected + 2}, 7, [&](double friction_angle) {
    return run_column({slenderness, dip, friction_angle}, options, progress).slip > just_slipped;
  });
  outcome.findings.push_back({.quantity = "friction angle of toppling without slip, width/height 0.25 on 30°",
                              .unit = "°",
                              .expected = expected,
                              .computed = toe_slips.middle(),
                              .tolerance = 0.1,
                              .absolute = true});
  return outcome;
}

CaseOutcome examples(const CaseOptions& options, Progress& progress) {
  return modes("Columns 10 m wide on 40°", {{1, 40, 40.1}, {2, 40, 20}, {0.4, 40, 40}}, options, progress);
}

}  // namespace

double friction_angle_of_pure_toppling(double slenderness, double dip) {
  const double k = slenderness, t = std::tan(radians(dip));
  return degrees(std::atan(((4 * k * k + 1) * t + 3 * k) / (k * k + 4 + 3 * k * t)));
}

ColumnMode expected_mode(const ColumnPoint& point) {
  const double delta = degrees(std::atan(point.slenderness));
  if (point.dip > delta && point.friction_angle > delta)
    return point.friction_angle < friction_angle_of_pure_toppling(point.slenderness, point.dip)
               ? ColumnMode::slides_and_topples
               : ColumnMode::topples;
  return point.dip > point.friction_angle ? ColumnMode::slides : ColumnMode::stable;
}

std::vector<ColumnPoint> points_beside_the_lines(const std::vector<double>& slendernesses) {
  std::vector<ColumnPoint> points;
  for (const double k : slendernesses) {
    const double delta = degrees(std::atan(k));
    for (const double side : {-1.0, 1.0}) {
      points.push_back({k, delta - 6, delta - 6 + side});  // stable | slides: α = φ
      points.push_back({k, delta + side, delta + 10});     // stable | topples: α = δ
      for (const double steeper : {8.0, 20.0}) {
        const double dip = delta + steeper;
        points.push_back({k, dip, delta + side});                                    // slides | both: φ = δ
        points.push_back({k, dip, friction_angle_of_pure_toppling(k, dip) + side});  // both | topples
      }
    }
  }
  return points;
}

std::vector<KnownCase> slide_or_topple_cases() {
  return {{.name = "toppling_chart",
           .title = "Columns slide, topple or both as the chart says",
           .source = "Ashby 1971, Sagaseta 1986",
           .thinned = true,
           .of_any_body = true,
           .run = chart},
          {.name = "toppling_examples",
           .title = "Three columns of Wyllie and Mah on 40°",
           .source = "Wyllie & Mah 2004, figure 1.10; 3DEC verification problem 'Sliding and toppling blocks'",
           .of_any_body = true,
           .run = examples}};
}

}  // namespace talus
