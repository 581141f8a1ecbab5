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
  for (std::size_t b = 0; b < set.bodies.size(); ++b) {
    const Body& body = set.bodies[b];
    bodies.push_back({.surface = &surfaces[b],
                      .first_node = body.first_node,
                      .fixed = body.fixed,
                      .young = body.young,
                      .single_body = body.single_body(),
                      .deforms = !body.fixed && body.kind != BodyKind::rigid});
  }
  return bodies;
}

std::vector<double> sizes_of(const std::vector<Surface>& surfaces) {
  std::vector<double> sizes;
  for (const Surface& surface : surfaces) sizes.push_back(surface.size);
  return sizes;
}

ContactSettings contact_settings(const Project& project, const ContactTolerances& tolerances) {
  ContactSettings settings;
  settings.tolerances = tolerances;
  settings.model = project.solver.contact;
  settings.stiffness = project.solver.contact_stiffness;
  settings.motion_told = true;
  return settings;
}

double smallest_mesh_size(const BodySet& bodies, const std::vector<Surface>& surfaces) {
  double size = 1e300;
  for (std::size_t b = 0; b < bodies.bodies.size(); ++b)
    if (!bodies.bodies[b].built_fixed()) size = std::min(size, surfaces[b].size);
  return size;
}

/// Where contact is off all are alone; with one block as well.
Company::Choice company_choice(const SimulationState& s) {
  if (!s.is_on(EffectKind::normal_contact)) return Company::Choice::never;
  return s.project.solver.effects.contact == Switch::on ? Company::Choice::always : Company::Choice::by_reach;
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

SimulationState::SimulationState(const Project& given, const BlockSystem& blocks, const Tolerances& t)
    : model(given, blocks),
      project(model.project()),
      system(model.system()),
      tolerances(t.solver.at(project.solver.tolerance)),
      called(called_effects(project, system)),
      bodies(project, system),
      surfaces(surfaces_of(system)),
      smallest_size(smallest_mesh_size(bodies, surfaces)),
      detector(contact_bodies(bodies, surfaces), joint_laws(project), pair_joints(project, system),
               contact_settings(project, t.contact)),
      outcomes(tolerances.contact_outcome),
      penalty_scaling(bodies, tolerances.penalty_scaling),
      company(system.blocks.size(), tolerances.step, company_choice(*this)),
      clock(project.stages, tolerances.step.time_rounding),
      control(project.solver.adaptive, half_height(bodies), smallest_size, tolerances.step_control),
      open_close(tolerances, project.solver.open_close_limit, project.solver.open_close,
                 project.solver.effects.elimination != Switch::off),
      first_guess(tolerances.first_guess),
      pseudo_transient(tolerances.pseudo_transient),
      acceleration_reset(bodies, tolerances.acceleration_reset),
      reserve(bodies),
      followed_springs(bodies, tolerances.followed_spring),
      sleep(sizes_of(surfaces),
            is_on(EffectKind::sleep) ? project.solver.sleep_tolerance.value_or(tolerances.sleep.speed) : 0,
            tolerances.sleep),
      sleeper_loads(sizes_of(surfaces), tolerances.sleep.load_change),
      stress(bodies, composition),
      troubles(project, system, bodies, contacts, model.origin()) {
  for (const Monitor& monitor : project.monitors) {
    const double tolerance = tolerances.effects.point_outside_block * std::cbrt(system.solids_volume);
    monitors.push_back(material_point(system, monitor.block, monitor.at, tolerance, "monitor '" + monitor.name + "'"));
  }
  bodies.stress = stress_before(project, system, bodies);
  if (is_on(EffectKind::missed_contacts)) passage.emplace(system, bodies, surfaces);
  for (const Vec3& x : bodies.nodes.reference) context.extent = std::max(context.extent, x.cwiseAbs().maxCoeff());
  for (std::size_t b = 0; b < surfaces.size(); ++b)
    if (!bodies.bodies[b].built_fixed()) context.mesh_size = std::max(context.mesh_size, surfaces[b].size);
}

double SimulationState::penetration() const {
  return project.solver.penetration_tolerance.value_or(tolerances.step.penetration);
}

}  // namespace talus
