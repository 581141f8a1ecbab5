#include "solve/company.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/broad/box_tree.hpp"
#include "model/stage_changes.hpp"
#include "model/stage_length.hpp"

namespace talus {

namespace {

double largest(const TimeTable& table) {
  double most = 0;
  for (const TableRow& row : table) most = std::max(most, row.value.norm());
  return most;
}

double largest_force(const PointLoad& load) { return load.table.empty() ? load.force.norm() : largest(load.table); }

double largest_displacement(const Constraint& constraint) {
  if (!constraint.table.empty()) return largest(constraint.table);
  double square = 0;
  for (const std::optional<double>& one : constraint.displacement) square += one.value_or(0) * one.value_or(0);
  return std::sqrt(square);
}

/// How far a body may go before boxes are made anew: its way, with room for others' pushes and for its turning.
double given_for(double way, const Box& box, const StepTolerances& tolerances) {
  return tolerances.foreseen_way * way + (box.upper - box.lower).norm();
}

/// Of each box, whether it meets another one; boxes are those that bodies stay in.
std::vector<char> meets_another(const std::vector<Box>& boxes) {
  BoxTree tree;
  tree.build(boxes);
  std::vector<char> meets;
  std::vector<int> stack;
  for (int b = 0; b < static_cast<int>(boxes.size()); ++b) meets.push_back(tree.any_other_within(b, boxes, stack));
  return meets;
}

Box widened(Box box, double margin) {
  box.widen(margin);
  return box;
}

}  // namespace

std::vector<Pull> pulls_on_blocks(const Project& now, const BlockSystem& system) {
  std::vector<Pull> pulls;
  for (const Block& block : system.blocks) {
    Pull& pull = pulls.emplace_back();
    // From where one displacement has it to where another one does: as far as both are from the start.
    for (const Constraint& constraint : now.constraints)
      if (constraint.block == block.name) pull.way += 2 * largest_displacement(constraint);
    if (block.body == BodyKind::fixed) continue;
    pull.acceleration = now.gravity.norm();
    const double mass = now.materials[block.material].density * block.volume;
    for (const PointLoad& load : now.loads)
      if (load.block == block.name) pull.acceleration += largest_force(load) / mass;
  }
  return pulls;
}

std::size_t blocks_alone_in_run(const Project& project, const BlockSystem& system, const StepTolerances& tolerances) {
  std::vector<Pull> pulls(system.blocks.size());
  double time = 0;
  for (int stage = 0; stage < static_cast<int>(project.stages.size()); ++stage) {
    time += length_of(project.stages[stage]);
    const std::vector<Pull> now = pulls_on_blocks(project_in_stage(project, stage), system);
    for (std::size_t b = 0; b < now.size(); ++b) {
      pulls[b].acceleration = std::max(pulls[b].acceleration, now[b].acceleration);
      pulls[b].way = std::max(pulls[b].way, now[b].way);
    }
  }
  std::vector<Box> boxes;
  for (std::size_t b = 0; b < system.blocks.size(); ++b) {
    Box box;
    for (const Vec3& x : system.blocks[b].mesh.nodes) box.add(x);
    double speed = 0;
    for (const InitialVelocity& given : project.velocities)
      if (given.block == system.blocks[b].name)
        speed = given.linear.norm() + given.angular.norm() * (box.upper - box.lower).norm();
    const bool stays = system.blocks[b].body == BodyKind::fixed && pulls[b].way == 0;
    boxes.push_back(stays ? box : widened(box, given_for(pulls[b].farthest(speed, time), box, tolerances)));
  }
  const std::vector<char> meets = meets_another(boxes);
  std::size_t alone = 0;
  for (std::size_t b = 0; b < meets.size(); ++b) alone += system.blocks[b].body != BodyKind::fixed && !meets[b] ? 1 : 0;
  return alone;
}

Company::Company(std::size_t bodies, const StepTolerances& tolerances, Choice choice)
    : tolerances_(tolerances),
      choice_(choice),
      pulls_(bodies),
      held_(bodies, false),
      alone_(bodies, choice == Choice::never ? 1 : 0),
      met_(bodies, 0),
      given_(bodies, 0.0),
      travelled_(bodies, 0.0),
      at_least_(bodies, 0.0),
      gone_(bodies, 0.0),
      speeds_(bodies, 0.0) {}

void Company::begin_stage(std::vector<Pull> pulls, std::vector<bool> held) {
  pulls_ = std::move(pulls);
  held_ = std::move(held);
  least_left_ = -1;
}

bool Company::is_due(double reach) const {
  return least_left_ < reach || (choice_ == Choice::by_reach && steps_ >= tolerances_.foreseen_steps);
}

void Company::find_speeds(const BodySet& bodies) {
  std::fill(speeds_.begin(), speeds_.end(), 0.0);
  const NodeSet& nodes = bodies.nodes;
  for (const int n : nodes.free) speeds_[nodes.body[n]] = std::max(speeds_[nodes.body[n]], nodes.velocity[n].norm());
  for (const int r : bodies.turning) {
    const RigidBody& one = bodies.rigid[r];
    speeds_[one.body] = nodes.velocity[one.centre].norm() + one.reach * one.spin().norm();
  }
}

std::vector<Box> Company::give_boxes(const BodySet& bodies, double time, double reach) {
  std::vector<Box> boxes;
  least_left_ = std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < bodies.bodies.size(); ++b) {
    const Body& body = bodies.bodies[b];
    Box& box = boxes.emplace_back();
    for (int n = body.first_node; n < body.first_node + body.node_count; ++n) box.add(bodies.nodes.position[n]);
    const bool stays = held_[b] && pulls_[b].way == 0;
    const double way = std::max(pulls_[b].farthest(speeds_[b], time), at_least_[b]);
    // Gaps up to the reach are looked for before bodies touch.
    given_[b] = stays ? 0 : given_for(way, box, tolerances_) + tolerances_.foreseen_way * reach;
    box.widen(given_[b]);
    if (!stays) least_left_ = std::min(least_left_, given_[b]);
  }
  return boxes;
}

void Company::look(const BodySet& bodies, double time, double reach) {
  std::fill(travelled_.begin(), travelled_.end(), 0.0);
  steps_ = 0;
  ++looks_;
  in_company_ = movable_ = 0;
  for (std::size_t b = 0; b < held_.size(); ++b) movable_ += held_[b] ? 0 : 1;
  if (choice_ == Choice::by_reach) {
    find_speeds(bodies);
    const std::vector<char> meets = meets_another(give_boxes(bodies, time, reach));
    for (std::size_t b = 0; b < meets.size(); ++b) alone_[b] = held_[b] || meets[b] ? 0 : 1;
  } else {
    least_left_ = std::numeric_limits<double>::infinity();
  }
  for (std::size_t b = 0; b < held_.size(); ++b) {
    if (held_[b] || alone_[b]) continue;
    ++in_company_;
    met_[b] = 1;
  }
}

void Company::moved(int body, double displacement) {
  travelled_[body] += displacement;
  if (choice_ == Choice::by_reach) least_left_ = std::min(least_left_, given_[body] - travelled_[body]);
}

void Company::step_taken() {
  ++steps_;
  std::fill(at_least_.begin(), at_least_.end(), 0.0);
}

bool Company::goes_too_far(const BodySet& bodies, const Increment& d) {
  if (choice_ != Choice::by_reach || in_company_ == movable_) return false;
  std::fill(gone_.begin(), gone_.end(), 0.0);
  const NodeSet& nodes = bodies.nodes;
  for (const int n : nodes.free)
    gone_[nodes.body[n]] = std::max(gone_[nodes.body[n]], d.segment<3>(3 * nodes.dof_block[n]).norm());
  bool any = false;
  for (const int b : bodies.moving) {
    if (!alone_[b] || travelled_[b] + gone_[b] <= given_[b]) continue;
    at_least_[b] = gone_[b];
    any = true;
  }
  if (any) least_left_ = -1;
  return any;
}

std::size_t Company::never_met(const BodySet& bodies) const {
  std::size_t count = 0;
  for (std::size_t b = 0; b < met_.size(); ++b) count += !bodies.bodies[b].built_fixed() && !met_[b] ? 1 : 0;
  return count;
}

}  // namespace talus
