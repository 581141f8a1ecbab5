#include "widgets/geometry/new_solids.hpp"

#include "model/solid_moves.hpp"
#include "session/solid_file.hpp"

namespace talus {

namespace {

/// A cube beside the rock, half as large: where a new shape goes.
struct Room {
  Vec3 corner;
  double side;
};

Room beside(const std::optional<BoxShape>& extent) {
  if (!extent) return {Vec3::Zero(), 10};
  return {{extent->max.x(), extent->min.y(), extent->min.z()}, (extent->max - extent->min).maxCoeff() / 2};
}

SolidShape boxIn(const Room& room) { return BoxShape{room.corner, room.corner + Vec3::Constant(room.side)}; }

/// Two benches that look east, their faces as steep as is usual.
SolidShape benchIn(const Room& room) {
  SectionShape bench;
  for (const auto& [distance, height] :
       {std::pair(0.0, 0.0), {1.0, 0.0}, {1.0, 0.2}, {0.72, 0.2}, {0.6, 0.6}, {0.42, 0.6}, {0.3, 1.0}, {0.0, 1.0}})
    bench.points.push_back({distance * room.side, height * room.side});
  bench.origin = room.corner + Vec3(0, room.side / 2, 0);
  bench.width = room.side;
  return bench;
}

SolidShape wedgeIn(const Room& room) {
  PolyhedronShape wedge;
  for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 0), Vec3(0, 0, 1), Vec3(0, 1, 1)})
    wedge.vertices.push_back(room.corner + room.side * corner);
  wedge.faces = {{0, 2, 3, 1}, {0, 1, 4}, {2, 5, 3}, {0, 4, 5, 2}, {1, 3, 5, 4}};
  return wedge;
}

SolidShape tunnelThrough(const std::optional<BoxShape>& extent) {
  if (!extent) return CylinderShape{Vec3::Zero(), {0, 10, 0}, 2};
  const Vec3 middle = (extent->min + extent->max) / 2, size = extent->max - extent->min;
  const double over = 0.05 * size.y();  // faces that coincide would be hard to subtract
  CylinderShape tunnel{middle, middle, std::min(size.x(), size.z()) / 8};
  tunnel.from.y() = extent->min.y() - over;
  tunnel.to.y() = extent->max.y() + over;
  return tunnel;
}

}  // namespace

Project with_new_solid(Project project, NewShape shape, const std::optional<BoxShape>& extent) {
  project = with_rock(std::move(project));
  Solid solid;
  solid.material = project.materials.front().name;
  switch (shape) {
    case NewShape::box:
      solid.name = free_name(project, "box");
      solid.shape = boxIn(beside(extent));
      break;
    case NewShape::bench:
      solid.name = free_name(project, "bench");
      solid.shape = benchIn(beside(extent));
      break;
    case NewShape::polyhedron:
      solid.name = free_name(project, "polyhedron");
      solid.shape = wedgeIn(beside(extent));
      break;
    case NewShape::tunnel:
      solid.name = free_name(project, "tunnel");
      solid.shape = tunnelThrough(extent);
      break;
  }
  project.solids.push_back(solid);
  return project;
}

}  // namespace talus
