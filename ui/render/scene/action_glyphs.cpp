#include "render/scene/action_glyphs.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "mesh/moments.hpp"
#include "model/project.hpp"
#include "render/paint/numbers.hpp"
#include "render/scene/block_surface.hpp"

namespace talus {

namespace {

using Kind = ActionGlyph::Kind;

int block_named(const BlockSystem& system, const std::string& name) {
  const auto found = std::ranges::find(system.blocks, name, &Block::name);
  return found == system.blocks.end() ? -1 : static_cast<int>(found - system.blocks.begin());
}

Vec3 centroid_of(const BlockSystem& system, int block) {
  return volume_moments(system.blocks[static_cast<std::size_t>(block)].mesh).centroid;
}

/// Of a block that is not cut yet, the place by which the project names it; nothing where neither is known.
std::optional<Vec3> middle_of(const std::string& block, const Project& project, const BlockSystem& system) {
  if (const int found = block_named(system, block); found >= 0) return centroid_of(system, found);
  const auto named = std::ranges::find(project.blocks, block, &BlockOverride::name);
  return named == project.blocks.end() ? std::nullopt : std::optional(named->at);
}

const Vec3& largest_row(const TimeTable& table) {
  return std::ranges::max_element(table, {}, [](const TableRow& row) { return row.value.squaredNorm(); })->value;
}

ActionGlyph glyph_of(const PointLoad& load, const BlockSystem& system) {
  ActionGlyph glyph{.kind = Kind::load, .block = block_named(system, load.block), .label = {}};
  glyph.arrow = load.table.empty() ? load.force : largest_row(load.table);
  glyph.pushes = glyph.block >= 0 && glyph.arrow.dot(centroid_of(system, glyph.block) - load.at) > 0;
  glyph.label = amount_text(glyph.arrow.norm(), "N");
  return glyph;
}

ActionGlyph glyph_of(const Constraint& support, const BlockSystem& system) {
  ActionGlyph glyph{.kind = Kind::support, .block = block_named(system, support.block), .label = {}};
  for (int i = 0; i < 3; ++i) {
    glyph.held[static_cast<std::size_t>(i)] = support.displacement[static_cast<std::size_t>(i)].has_value();
    glyph.arrow[i] = support.displacement[static_cast<std::size_t>(i)].value_or(0);
  }
  if (!support.table.empty()) glyph.arrow = largest_row(support.table);
  if (!glyph.arrow.isZero()) glyph.label = amount_text(glyph.arrow.norm(), "m");
  return glyph;
}

ActionGlyph glyph_of(const InitialVelocity& velocity, const BlockSystem& system) {
  ActionGlyph glyph{.kind = Kind::velocity, .block = block_named(system, velocity.block), .label = {}};
  glyph.arrow = velocity.linear;
  glyph.spin = velocity.angular;
  glyph.label = velocity.linear.isZero() ? amount_text(velocity.angular.norm(), "rad/s")
                                         : amount_text(velocity.linear.norm(), "m/s");
  return glyph;
}

ActionGlyph glyph_of(const Monitor& monitor, const BlockSystem& system) {
  return {.kind = Kind::monitor, .block = block_named(system, monitor.block), .label = monitor.name};
}

std::array<ActionGlyph::Principal, 3> principal_stresses(const Voigt& stress) {
  Mat3 tensor;
  tensor << stress[0], stress[3], stress[5], stress[3], stress[1], stress[4], stress[5], stress[4], stress[2];
  const Eigen::SelfAdjointEigenSolver<Mat3> solved(tensor);
  std::array<ActionGlyph::Principal, 3> cross;
  for (int i = 0; i < 3; ++i)
    cross[static_cast<std::size_t>(i)] = {solved.eigenvectors().col(i), solved.eigenvalues()[i]};
  return cross;
}

void add_crosses(const InSituStress& stress, int index, const BlockSystem& system, std::vector<ActionGlyph>& glyphs) {
  Eigen::AlignedBox3d box;
  for (const Block& block : system.blocks)
    if (stress.blocks.empty() || std::ranges::find(stress.blocks, block.name) != stress.blocks.end())
      for (const Vec3& node : block.mesh.nodes) box.extend(node);
  if (box.isEmpty()) return;
  for (const double share : {1.0 / 6, 0.5, 5.0 / 6}) {
    ActionGlyph glyph{.kind = Kind::stress, .index = index, .at = box.center(), .label = {}};
    glyph.at.z() = box.min().z() + share * box.sizes().z();
    glyph.cross = principal_stresses(stress.stress + stress.gradient * (glyph.at.z() - stress.level));
    const auto largest = std::ranges::max(glyph.cross, {}, [](const auto& one) { return std::abs(one.value); });
    glyph.label = amount_text(largest.value, "Pa");
    glyphs.push_back(glyph);
  }
}

std::optional<Vec3> place_of(const PointLoad& load, const Project&, const BlockSystem&) { return load.at; }
std::optional<Vec3> place_of(const Monitor& monitor, const Project&, const BlockSystem&) { return monitor.at; }
std::optional<Vec3> place_of(const Constraint& support, const Project& project, const BlockSystem& system) {
  return support.at ? support.at : middle_of(support.block, project, system);
}
std::optional<Vec3> place_of(const InitialVelocity& velocity, const Project& project, const BlockSystem& system) {
  return middle_of(velocity.block, project, system);
}

/// All that have a place.
void add_each(const auto& things, const Project& project, const BlockSystem& system, std::vector<ActionGlyph>& glyphs) {
  int index = -1;
  for (const auto& thing : things) {
    ++index;
    const auto place = place_of(thing, project, system);
    if (!place) continue;
    glyphs.push_back(glyph_of(thing, system));
    glyphs.back().index = index;
    glyphs.back().at = *place;
  }
}

double size_of(const ActionGlyph& glyph) {
  double size = glyph.arrow.norm();
  for (const auto& one : glyph.cross) size = std::max(size, std::abs(one.value));
  return size;
}

}  // namespace

std::vector<ActionGlyph> action_glyphs(const Project& project, const BlockSystem& system) {
  std::vector<ActionGlyph> glyphs;
  add_each(project.loads, project, system, glyphs);
  add_each(project.constraints, project, system, glyphs);
  add_each(project.velocities, project, system, glyphs);
  add_each(project.monitors, project, system, glyphs);
  for (std::size_t i = 0; i < project.in_situ.size(); ++i)
    add_crosses(project.in_situ[i], static_cast<int>(i), system, glyphs);
  return glyphs;
}

double largest_of(const std::vector<ActionGlyph>& glyphs, Kind kind) {
  double largest = 0;
  for (const ActionGlyph& glyph : glyphs)
    if (glyph.kind == kind) largest = std::max(largest, size_of(glyph));
  return largest;
}

std::string amount_text(double value, const std::string& unit) {
  const DisplayUnit shown = display_unit(unit, std::abs(value));
  std::string figures = format_number(value * shown.factor);
  if (figures.find('.') != std::string::npos) {
    figures.erase(figures.find_last_not_of('0') + 1);
    if (figures.ends_with('.')) figures.pop_back();
  }
  return figures + " " + shown.name;
}

}  // namespace talus
