#include "solve/simulation_state.hpp"

#include <algorithm>
#include <cmath>

#include "effects/in_situ_stress.hpp"
#include "solve/joint_laws.hpp"

namespace talus {

namespace {

std::vector<Surface> surfaces_of(const BlockSystem& system) {
  std::vector<Surface> surfaces;
  for (const Block& block : system.blocks) surfaces.push_back(make_surface(block.mesh.nodes, block.surface));
  return surfaces;
}

std::vector<ContactBody> contact_bodies(const BodySet& set, const std::vector<Surface>& surfaces) {
  std::vector<ContactBody> bodies;
  for (std::size_t b = 0; b < set.bodies.size(); ++b)
    bodies.push_back(
        {&surfaces[b], set.bodies[b].first_node, set.bodies[b].fixed, set.bodies[b].young, set.bodies[b].one_piece()});
  return bodies;
}

std::vector<double> sizes_of(const std::vector<Surface>& surfaces) {
  std::vector<double> sizes;
  for (const Surface& surface : surfaces) sizes.push_back(surface.size);
  return sizes;
}

ContactSettings contact_settings(const Project& project) {
  ContactSettings settings;
  settings.model = project.solver.contact;
  settings.stiffness = project.solver.contact_stiffness;
  settings.motion_told = true;
  return settings;
}

OpenCloseSettings open_close_settings(const Project& project) {
  OpenCloseSettings settings;
  settings.iteration_limit = project.solver.open_close_limit;
  return settings;
}

double smallest_mesh_size(const BodySet& bodies, const std::vector<Surface>& surfaces) {
  double size = 1e300;
  for (std::size_t b = 0; b < bodies.bodies.size(); ++b)
    if (!bodies.bodies[b].built_fixed()) size = std::min(size, surfaces[b].size);
  return size;
}

/// Half the height of all blocks [m]; of a flat model half its longest side.
double half_height(const BodySet& bodies) {
  Vec3 low = Vec3::Constant(1e300), high = -low;
  for (const Vec3& x : bodies.nodes.reference) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  const Vec3 sides = high - low;
  return 0.5 * (sides.z() > 0 ? sides.z() : sides.maxCoeff());
}

}  // namespace

Simulation::State::State(const Project& p, const BlockSystem& s)
    : project(p),
      system(s),
      bodies(p, s),
      clock(p.stages),
      surfaces(surfaces_of(s)),
      smallest_size(smallest_mesh_size(bodies, surfaces)),
      detector(contact_bodies(bodies, surfaces), joint_laws(p), pair_joints(p, s), contact_settings(p)),
      open_close(open_close_settings(p)),
      control(p.solver.adaptive, half_height(bodies), smallest_size),
      sleep(sizes_of(surfaces), p.solver.sleep_tolerance) {
  for (const Monitor& monitor : p.monitors) {
    const double tolerance = 1e-6 * std::cbrt(s.solids_volume);
    monitors.push_back(material_point(s, monitor.block, monitor.at, tolerance, "monitor '" + monitor.name + "'"));
  }
  bodies.stress = stress_before(p, s, bodies);
  for (const Vec3& x : bodies.nodes.reference) context.extent = std::max(context.extent, x.cwiseAbs().maxCoeff());
  for (std::size_t b = 0; b < surfaces.size(); ++b)
    if (!bodies.bodies[b].built_fixed()) context.mesh_size = std::max(context.mesh_size, surfaces[b].size);
}

}  // namespace talus
