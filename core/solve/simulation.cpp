#include "solve/simulation.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "contact/contact_detector.hpp"
#include "effects/inertia.hpp"
#include "solve/energy_balance.hpp"
#include "solve/joint_laws.hpp"
#include "solve/open_close.hpp"
#include "solve/stage_clock.hpp"
#include "solve/stopwatch.hpp"

namespace talus {

namespace {

/// A step that does not settle is cut by this factor, and grows back by it …
constexpr double cut_factor = 3;
/// … but is never shorter than this share of the stage's step: then the run has not converged.
constexpr double shortest_share = 0.01;
/// Contacts are sought within this many times the way that a node can make in the step …
constexpr double reach_factor = 2.5;
/// … and this share of the smallest mesh size, so that touching faces are found at rest.
constexpr double reach_share = 1e-3;
/// A bond that has opened by more than this share of the mesh size is broken.
constexpr double opening_tolerance = 2e-4;

std::vector<Surface> surfaces_of(const BlockSystem& system) {
  std::vector<Surface> surfaces;
  for (const Block& block : system.blocks) surfaces.push_back(make_surface(block.mesh.nodes, block.surface));
  return surfaces;
}

std::vector<ContactBody> contact_bodies(const BodySet& set, const std::vector<Surface>& surfaces) {
  std::vector<ContactBody> bodies;
  for (std::size_t b = 0; b < set.bodies.size(); ++b)
    bodies.push_back({&surfaces[b], set.bodies[b].first_node, set.bodies[b].fixed, set.bodies[b].young});
  return bodies;
}

ContactSettings contact_settings(const Project& project) {
  ContactSettings settings;
  settings.stiffness = project.solver.contact_stiffness;
  return settings;
}

OpenCloseSettings open_close_settings(const Project& project) {
  OpenCloseSettings settings;
  settings.iteration_limit = project.solver.open_close_limit;
  return settings;
}

}  // namespace

struct Simulation::State {
  State(const Project& p, const BlockSystem& s)
      : project(p),
        system(s),
        bodies(p, s),
        clock(p.stages),
        surfaces(surfaces_of(s)),
        detector(contact_bodies(bodies, surfaces), joint_laws(p), pair_joints(p, s), contact_settings(p)),
        composition(compose(p, s, bodies, contacts)),
        open_close(composition, open_close_settings(p)),
        energy(p, s),
        increment(Increment::Zero(bodies.unknowns())),
        last_increment(increment) {
    for (const Monitor& monitor : p.monitors) {
      const double tolerance = 1e-6 * std::cbrt(s.solids_volume);
      monitors.push_back(material_point(s, monitor.block, monitor.at, tolerance, "monitor '" + monitor.name + "'"));
    }
    smallest_size = 1e300;
    for (std::size_t b = 0; b < bodies.bodies.size(); ++b)
      if (!bodies.bodies[b].fixed) smallest_size = std::min(smallest_size, surfaces[b].size);
  }

  const Project& project;
  const BlockSystem& system;
  BodySet bodies;
  StageClock clock;
  std::vector<Surface> surfaces;
  ContactDetector detector;
  ContactSet contacts;
  std::vector<ContactForces> forces;
  std::vector<ContactOutcome> outcomes;
  Composition composition;
  OpenClose open_close;
  EnergyBalance energy;
  std::vector<MaterialPoint> monitors;
  Increment increment, last_increment, guess;
  double last_length = 0;       ///< s, of the last accepted step; 0: there is none to go by
  double trial_length = 1e300;  ///< s, what the next step is tried with
  double dynamic_factor = 1;
  double smallest_size = 0;
  std::uint64_t pattern_generation = ~0ull;
  bool velocities_given = false;
  double detect_seconds = 0;
  int step = 0;
};

Simulation::Simulation(const Project& project, const BlockSystem& system)
    : state_(std::make_unique<State>(project, system)) {}
Simulation::~Simulation() = default;

bool Simulation::finished() const { return !converged() || state_->clock.finished(); }
bool Simulation::stage_ended() const { return state_->clock.stage_ended(); }
int Simulation::stage() const {
  const StageClock& clock = state_->clock;
  return clock.stage_ended() ? clock.stage() - 1 : clock.stage();
}
double Simulation::time() const { return state_->clock.time(); }
double Simulation::end_time() const { return state_->clock.end(); }
long Simulation::total_steps() const { return state_->clock.total_steps(); }
const BodySet& Simulation::bodies() const { return state_->bodies; }

void Simulation::give_initial_velocities() {
  State& s = *state_;
  for (const InitialVelocity& given : s.project.velocities)
    for (std::size_t b = 0; b < s.system.blocks.size(); ++b) {
      if (s.system.blocks[b].name != given.block || s.bodies.bodies[b].fixed) continue;
      const Body& body = s.bodies.bodies[b];
      Vec3 centroid = Vec3::Zero();
      double mass = 0;
      for (int e = body.first_element; e < body.first_element + body.element_count; ++e) {
        for (const int node : s.bodies.elements[e].nodes)
          centroid += s.bodies.elements[e].mass / 4 * s.bodies.nodes.position[node];
        mass += s.bodies.elements[e].mass;
      }
      centroid /= mass;
      for (int n = body.first_node; n < body.first_node + body.node_count; ++n)
        s.bodies.nodes.velocity[n] = given.linear + given.angular.cross(s.bodies.nodes.position[n] - centroid);
    }
  s.energy.energy_was_given(Inertia::kinetic_energy(s.bodies));
  s.velocities_given = true;
}

StepReport Simulation::step() {
  State& s = *state_;
  const Stage& stage = s.project.stages[s.clock.stage()];
  s.dynamic_factor = stage.kind == StageKind::dynamic ? 1 : 0;
  if (s.clock.stage_begins()) s.last_length = 0;
  if (s.dynamic_factor > 0 && !s.velocities_given) give_initial_velocities();

  StepReport report;
  report.step = ++s.step;
  report.stage = s.clock.stage();
  report.time_step = s.clock.next_length();
  const SolveTimes before = s.open_close.times();
  const double detect_before = s.detect_seconds;
  double left = report.time_step;
  while (left > 1e-9 * report.time_step) {
    const double trial = std::min(left, s.trial_length);
    if (try_step(trial, report)) {
      left -= trial;
      s.trial_length = std::min(trial * cut_factor, report.time_step);
    } else if (trial / cut_factor < shortest_share * report.time_step) {
      break;
    } else {
      failure_.clear();
      s.trial_length = trial / cut_factor;
      ++report.cuts;
    }
  }
  if (converged()) s.clock.advance();
  report.time = s.clock.time();
  const SolveTimes& now = s.open_close.times();
  report.phases = {s.detect_seconds - detect_before, now.assemble - before.assemble, now.factor - before.factor,
                   now.solve - before.solve,         now.update - before.update,     0};
  summarise(report);
  return report;
}

void Simulation::detect(double length) {
  State& s = *state_;
  const Stopwatch watch(s.detect_seconds);
  double fastest = 0;
  for (const Vec3& v : s.bodies.nodes.velocity) fastest = std::max(fastest, v.norm());
  const double way = s.dynamic_factor * fastest * length + 0.5 * s.project.gravity.norm() * length * length;
  s.detector.detect(s.bodies.nodes.position, reach_factor * way + reach_share * s.smallest_size, s.contacts);
  if (s.pattern_generation == s.detector.coupling_generation()) return;
  s.pattern_generation = s.detector.coupling_generation();
  std::vector<std::pair<int, int>> couplings;
  for (const auto& [i, j] : s.detector.coupled_nodes())
    couplings.emplace_back(s.bodies.nodes.freedom[i], s.bodies.nodes.freedom[j]);
  s.open_close.set_pattern(s.bodies.nodes.movable, std::move(couplings));
}

void Simulation::first_guess(double length) {
  // Where the last step's motion goes on, or where the velocity leads; standing still starts a static step. The paper's
  // integrator turns the velocity of a sticking node round each step, so that the velocity alone is no good guess.
  State& s = *state_;
  s.increment.setZero();
  double best = s.open_close.residual_at(s.increment);
  const auto offer = [&](const Increment& guess) {
    const double residual = s.open_close.residual_at(guess);
    if (!(residual < best)) return;
    best = residual;
    s.increment = guess;
  };
  if (s.last_length > 0) {
    s.guess = length / s.last_length * s.last_increment;
    offer(s.guess);
  }
  if (s.dynamic_factor == 0) return;
  s.guess.resize(s.increment.size());
  for (std::size_t n = 0; n < s.bodies.nodes.velocity.size(); ++n)
    if (const int freedom = s.bodies.nodes.freedom[n]; freedom >= 0)
      s.guess.segment<3>(3 * freedom) = length * s.bodies.nodes.velocity[n];
  offer(s.guess);
}

bool Simulation::inverts_an_element() const {
  const State& s = *state_;
  return std::any_of(s.bodies.elements.begin(), s.bodies.elements.end(), [&](const Element& element) {
    Corners corners = s.bodies.corner_increments(element, s.increment);
    for (int i = 0; i < 4; ++i) corners[i] += s.bodies.nodes.position[element.nodes[i]];
    return !(element_shape(corners).volume > 0);
  });
}

bool Simulation::settle(StepReport& report) {
  State& s = *state_;
  const Settling result = s.open_close.settle(s.increment);
  report.iterations += result.iterations;
  report.unbalanced_force = result.residual;
  if (result.settled && !inverts_an_element()) return true;
  if (result.settled) {
    failure_ = "a tetrahedron turned inside out at t = " + std::to_string(time()) + " s";
    return false;
  }
  failure_ = "the open-close iteration did not settle at t = " + std::to_string(time()) + " s";
  failure_ += where_it_struggles(result.worst_node);
  return false;
}

std::string Simulation::where_it_struggles(int freedom) const {
  const State& s = *state_;
  if (freedom < 0 || s.contacts.points.empty()) return "";
  const auto& freedoms = s.bodies.nodes.freedom;
  const auto node = std::find(freedoms.begin(), freedoms.end(), freedom) - freedoms.begin();
  const auto distance = [&](const ContactPoint& point) {
    return (point.position - s.bodies.nodes.position[node]).squaredNorm();
  };
  const ContactPoint& nearest =
      *std::min_element(s.contacts.points.begin(), s.contacts.points.end(),
                        [&](const ContactPoint& a, const ContactPoint& b) { return distance(a) < distance(b); });
  const auto coordinate = [&](int k) { return std::to_string(nearest.position[k]); };
  std::string where = ": contact " + s.system.blocks[nearest.bodies[0]].name + " - " +
                      s.system.blocks[nearest.bodies[1]].name + " at (" + coordinate(0) + ", " + coordinate(1) + ", " +
                      coordinate(2) + ") m";
  if (!s.project.joints.empty()) where += ", joint " + s.project.joints[nearest.joint].name;
  return where;
}

bool Simulation::try_step(double length, StepReport& report) {
  State& s = *state_;
  failure_.clear();
  if (s.bodies.nodes.movable > 0) {
    detect(length);
    const StepContext context{s.clock.time(), length, s.dynamic_factor};
    for (const auto& effect : s.composition.effects) effect->begin_step(context);
    s.open_close.begin_step();
    first_guess(length);
    if (!settle(report)) return false;
  }
  accept(length, report);
  return true;
}

void Simulation::accept(double length, StepReport& report) {
  State& s = *state_;
  auto& points = s.contacts.points;
  s.forces.resize(points.size());
  s.outcomes.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    ContactPoint& point = points[i];
    const Vec3 u = relative_displacement(s.contacts, point, s.bodies, s.increment);
    ContactForces& force = s.forces[i];
    force.gap = point.gap + point.normal.dot(u);
    force.normal = normal_force(point, force.gap);
    force.shear = s.composition.shear ? s.composition.shear->force(i, s.increment) : Vec3(Vec3::Zero());
    const double spring = s.composition.shear ? s.composition.shear->spring_force(i, s.increment).norm() : 0;
    const double excess = spring - force.shear.norm();
    const bool slips = excess > 1e-12 * spring;
    const bool pulled_off = point.bonded && force.gap > opening_tolerance * point.size;
    const bool yields = point.bonded && point.tension > 0 && force.normal <= -point.tension;
    const bool touches = force.normal > 0 || (point.bonded && !pulled_off);
    force.mode = !touches ? ContactMode::open : slips ? ContactMode::slip : ContactMode::stick;
    point.mode = force.mode;
    force.slip = force.mode == ContactMode::slip ? excess / point.shear_stiffness : 0;
    s.outcomes[i] = {force.normal, force.shear, force.gap, force.slip, point.bonded && (slips || pulled_off || yields)};
  }
  for (const auto& effect : s.composition.effects) effect->accept(s.increment);
  s.detector.accept(s.contacts, s.outcomes);
  for (std::size_t n = 0; n < s.bodies.nodes.position.size(); ++n) {
    const Vec3 d = s.bodies.node_increment(static_cast<int>(n), s.increment);
    s.bodies.nodes.position[n] += d;
    report.max_displacement = std::max(report.max_displacement, d.norm());
  }
  s.bodies.update_shapes();
  report.energy = s.energy.after_step(s.bodies, s.contacts, s.forces);
  s.last_increment = s.increment;
  s.last_length = length;
}

void Simulation::summarise(StepReport& report) const {
  const State& s = *state_;
  report.contacts = static_cast<int>(s.forces.size());
  for (std::size_t i = 0; i < s.forces.size(); ++i) {
    const ContactForces& force = s.forces[i];
    ++(force.mode == ContactMode::open ? report.open : force.mode == ContactMode::stick ? report.stick : report.slip);
    if (force.mode == ContactMode::open) continue;
    const ContactPoint& point = s.contacts.points[i];
    const double penetration = point.overlap - force.gap;
    report.max_penetration = std::max(report.max_penetration, penetration);
    report.max_relative_penetration = std::max(report.max_relative_penetration, penetration / point.size);
  }
}

Frame Simulation::frame(int index) const {
  const State& s = *state_;
  Frame frame;
  frame.index = index;
  frame.time = time();
  frame.stage = stage();
  for (std::size_t n = 0; n < s.bodies.nodes.position.size(); ++n)
    frame.displacement.push_back(s.bodies.nodes.position[n] - s.bodies.nodes.reference[n]);
  frame.velocity = s.bodies.nodes.velocity;
  for (std::size_t b = 0; b < s.bodies.bodies.size(); ++b) {
    const Body& body = s.bodies.bodies[b];
    const std::size_t tetrahedra = s.system.blocks[b].mesh.tetrahedra.size();
    if (body.fixed)
      frame.stress.insert(frame.stress.end(), tetrahedra, Voigt::Zero());
    else
      frame.stress.insert(frame.stress.end(), s.bodies.stress.begin() + body.first_element,
                          s.bodies.stress.begin() + body.first_element + body.element_count);
  }
  frame.contacts = contacts();
  return frame;
}

std::vector<ContactSample> Simulation::contacts() const {
  const State& s = *state_;
  std::vector<ContactSample> samples;
  for (std::size_t i = 0; i < s.forces.size(); ++i) {
    const ContactPoint& point = s.contacts.points[i];
    const ContactForces& force = s.forces[i];
    samples.push_back({point.position,
                       point.normal,
                       {point.bodies[0], point.bodies[1]},
                       point.joint,
                       static_cast<ContactState>(force.mode),
                       force.normal,
                       force.shear,
                       point.area});
  }
  return samples;
}

HistoryRow Simulation::history() const {
  const State& s = *state_;
  HistoryRow row;
  row.time = time();
  row.stage = stage();
  for (const MaterialPoint& point : s.monitors)
    row.monitors.push_back(
        {point.at(s.bodies.nodes.position) - point.at(s.bodies.nodes.reference), point.at(s.bodies.nodes.velocity)});
  return row;
}

std::vector<EffectOutcome> Simulation::effects() const {
  const State& s = *state_;
  std::vector<EffectOutcome> outcomes;
  for (const EffectStatus& status : called_effects(s.project, s.system)) {
    EffectOutcome outcome{status.name, status.active, status.reason, 0};
    for (std::size_t i = 0; i < s.composition.effects.size(); ++i)
      if (s.composition.effects[i]->name() == status.name) outcome.seconds = s.open_close.times().effects[i];
    outcomes.push_back(outcome);
  }
  return outcomes;
}

}  // namespace talus
