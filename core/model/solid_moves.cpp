#include "model/solid_moves.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/units.hpp"

namespace talus {
namespace {

using Rotation = Eigen::Quaterniond;

Rotation rotation_of(const Turn& turn) {
  return Rotation(Eigen::AngleAxisd(radians(turn.angle), turn.axis.normalized()));
}

/// Of angles that are a few digits long as the user has them: 30, not 29.999999999999996.
double without_noise(double angle) {
  constexpr double digits = 1e10;
  return std::round(angle * digits) / digits;
}

Vec3 away_from(const Vec3& centre, double factor, const Vec3& point) { return centre + factor * (point - centre); }

/// Scales what a shape itself says; gives the point that stays where it is.
struct Scaling {
  double factor;
  Vec3 about, origin;
  const std::string& name;

  Vec3 operator()(BoxShape& box) const {
    box = {away_from(about, factor, box.min), away_from(about, factor, box.max)};
    return about;
  }
  Vec3 operator()(PolyhedronShape& shape) const {
    for (Vec3& vertex : shape.vertices) vertex = away_from(about, factor, vertex);
    return about;
  }
  Vec3 operator()(CylinderShape& cylinder) const {
    cylinder.from = away_from(about, factor, cylinder.from);
    cylinder.to = away_from(about, factor, cylinder.to);
    cylinder.radius *= factor;
    return about;
  }
  Vec3 operator()(SectionShape& section) const {
    for (auto& [distance, height] : section.points) {
      distance *= factor;
      height *= factor;
    }
    section.origin = away_from(about, factor, section.origin);
    section.width *= factor;
    return about;
  }
  Vec3 operator()(FileShape& file) const {
    file.scale *= factor;
    return -origin;  // what the file has is scaled about its own zero, and less the origin then
  }
  Vec3 operator()(TerrainShape&) const { refuse("a terrain has the size of its file"); }
  Vec3 operator()(CombinedShape&) const { refuse("a combined solid has the size of its parts"); }

  [[noreturn]] void refuse(const std::string& why) const { throw InputError("solid " + name, why, "scale these"); }
};

}  // namespace

Solid moved(Solid solid, const Vec3& by) {
  solid.move += by;
  return solid;
}

Solid turned(Solid solid, const Turn& by) {
  const Turn before = solid.turn.value_or(Turn{by.axis, 0, by.about});
  const Rotation second = rotation_of(by);
  if (before.axis.cross(by.axis).isZero()) {  // the usual case keeps its digits
    const double sense = before.axis.dot(by.axis) < 0 ? -1 : 1;
    solid.turn = Turn{before.axis, without_noise(before.angle + sense * by.angle), before.about};
  } else {
    const Eigen::AngleAxisd both(second * rotation_of(before));
    solid.turn = Turn{both.axis(), degrees(both.angle()), before.about};
  }
  // What the point lies at about which the shape turned first: the rotation of the rest does not move it.
  solid.move = by.about + second * (before.about + solid.move - by.about) - before.about;
  return solid;
}

Solid scaled(Solid solid, double factor, const Vec3& about, const Vec3& origin) {
  const Vec3 still = std::visit(Scaling{factor, about, origin, solid.name}, solid.shape);
  if (solid.turn) solid.turn->about = away_from(still, factor, solid.turn->about);
  solid.move = factor * solid.move + (1 - factor) * (about - still);
  return solid;
}

std::string free_name(const Project& project, const std::string& stem) {
  const auto is_taken = [&](const std::string& name) {
    const auto called = [&](const auto& thing) { return thing.name == name; };
    return std::ranges::any_of(project.solids, called) || std::ranges::any_of(project.blocks, called);
  };
  std::string name = stem;
  for (int number = 2; is_taken(name); ++number) name = stem + ' ' + std::to_string(number);
  return name;
}

Project with_copies(Project project, int solid, int count, const Vec3& step) {
  const Solid original = project.solids.at(static_cast<std::size_t>(solid));
  for (int i = 1; i <= count; ++i) {
    Solid copy = moved(original, i * step);
    copy.name = free_name(project, original.name);
    project.solids.insert(project.solids.begin() + solid + i, copy);
  }
  return project;
}

Project with_combined(Project project, CombineOperation operation, const std::vector<int>& solids) {
  if (solids.size() < 2) throw InputError("solids", "there is nothing to combine", "select two solids or more");
  CombinedShape shape{operation, {}};
  for (const int solid : solids) shape.solids.push_back(project.solids.at(static_cast<std::size_t>(solid)).name);
  for (const Solid& other : project.solids)
    if (const auto* combined = std::get_if<CombinedShape>(&other.shape))
      for (const std::string& name : shape.solids)
        if (std::ranges::count(combined->solids, name) > 0)
          throw InputError("solid " + name, "is a part of " + other.name + " already", "combine a copy of it");
  Solid made = project.solids.at(static_cast<std::size_t>(solids.front()));
  const std::string between = operation == CombineOperation::subtract ? " less " : " and ";
  made.name = free_name(project, shape.solids[0] + between + shape.solids[1]);
  made.shape = shape;
  made.turn.reset();
  made.move.setZero();
  project.solids.push_back(made);
  return project;
}

}  // namespace talus
