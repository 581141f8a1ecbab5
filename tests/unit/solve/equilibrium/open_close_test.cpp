#include "solve/equilibrium/open_close.hpp"

#include <gmock/gmock.h>

#include "mesh/structured_mesh.hpp"
#include "support/solver_scenes.hpp"
#include "support/spring_chain.hpp"

namespace talus {
namespace {

TEST(OpenClose, FactorsLinearEquationsOnceAndTakesOneIterationAStep) {
  int assembled = 0;
  Composition composition;
  BodySet body = test::chain_body();
  composition.bodies = &body;
  composition.effects.push_back(
      std::make_unique<test::SpringChain>(test::SpringChain::Stays::through_the_stage, assembled));
  composition.effects.push_back(std::make_unique<test::Load>());
  OpenClose open_close;
  open_close.begin_stage(composition);
  open_close.set_pattern(test::chain_nodes, test::no_contacts);
  for (int i = 0; i < 20; ++i) {
    open_close.begin_step(test::step_of(0.01));
    Increment d = Increment::Zero(3 * test::chain_nodes);
    const OpenCloseResult result = open_close.converge(d);
    EXPECT_TRUE(result.converged);
    EXPECT_EQ(result.iterations, 1);
  }
  EXPECT_EQ(open_close.linear_work().factorisations, 1);
  EXPECT_EQ(open_close.linear_work().solves, 20);
  EXPECT_EQ(open_close.linear_work().gmres_iterations, 0);
}

TEST(OpenClose, FactorsBlocksThatFallSideBySideOnceEach) {
  const Project project = test::rock_project(30, {{"fall", StageKind::dynamic, 0.01, 100, {}}});
  std::vector<Block> list;
  for (int b = 0; b < 3; ++b) {
    Block block;
    block.name = "B" + std::to_string(b);
    block.mesh = box_mesh(Vec3(3 * b, 0, 0), Vec3(3 * b + 1, 1, 1), 2, 2, 2);
    block.surface = boundary(block.mesh);
    list.push_back(block);
  }
  const BlockSystem system = test::block_system(list);
  BodySet bodies(project, system);
  const ContactSet contacts;
  const ContactLinks links(bodies, contacts);
  Composition composition = compose(project, system, 0, bodies, links);
  OpenClose open_close;
  open_close.begin_stage(composition);
  open_close.set_pattern(bodies.nodes.movable, test::no_contacts);
  for (int i = 0; i < 30; ++i) {
    const StepContext step = test::step_of(0.01);
    for (const auto& effect : composition.effects) effect->begin_step(step);
    open_close.begin_step(step);
    Increment d = Increment::Zero(bodies.unknowns());
    ASSERT_TRUE(open_close.converge(d).converged);
    for (const auto& effect : composition.effects) effect->accept(d);
    for (std::size_t n = 0; n < bodies.nodes.position.size(); ++n)
      bodies.nodes.position[n] += bodies.node_increment(static_cast<int>(n), d);
  }
  EXPECT_EQ(open_close.linear_work().systems, 3);
  EXPECT_EQ(open_close.linear_work().largest_system, bodies.nodes.movable / 3);
  EXPECT_EQ(open_close.linear_work().factorisations, 3);
}

/// A cube that falls on four springs, 0.1 mm below its corners, with an interior-point method that may not iterate.
OpenCloseResult convergence_of_a_cube_that_lands(int iteration_limit) {
  const Project project = test::rock_project(30, {{"fall", StageKind::dynamic, 0.01, 1, {}}});
  const BlockSystem system = test::cube_on_slab();
  BodySet bodies(project, system);
  ContactSet contacts;
  for (int n = 0; n < static_cast<int>(bodies.nodes.position.size()); ++n) {
    if (bodies.nodes.body[n] != 1 || bodies.nodes.position[n].z() != 0) continue;
    ContactPoint point;
    point.bodies[0] = 1;
    point.normal = Vec3::UnitZ();
    point.gap = 1e-4;
    point.size = 1;
    point.normal_stiffness = point.shear_stiffness = 1e9;
    point.friction = 0.5;
    point.stencil_begin = static_cast<int>(contacts.nodes.size());
    point.stencil_end = point.stencil_begin + 1;
    contacts.points.push_back(point);
    contacts.nodes.push_back(n);
    contacts.weights.push_back(1);
  }
  contacts.sort_out();
  ContactLinks links(bodies, contacts);
  links.connect();
  Composition composition = compose(project, system, 0, bodies, links);
  SolverTolerances tolerances;
  tolerances.convergence.stalled_fraction = 0;  // no iteration gains
  tolerances.convergence.newton_iterations = 2;
  tolerances.convergence.interior_point_limit = 0;
  OpenClose open_close(tolerances, iteration_limit);
  open_close.begin_stage(composition);
  open_close.set_pattern(bodies.nodes.movable, test::no_contacts);
  StepContext step = test::step_of(0.01);
  step.dynamic_factor = 1;
  step.reach = 1;
  for (const auto& effect : composition.effects) effect->begin_step(step);
  open_close.begin_step(step);
  Increment d = Increment::Zero(bodies.unknowns());
  return open_close.converge(d);
}

TEST(OpenClose, GivesUpWithALargeResidualAndMoreContactsThanIterationsLeft) {
  EXPECT_TRUE(convergence_of_a_cube_that_lands(60).converged);
  const OpenCloseResult given_up = convergence_of_a_cube_that_lands(4);
  EXPECT_FALSE(given_up.converged);
  EXPECT_EQ(given_up.iterations, 1);
  EXPECT_GT(given_up.residual, 0.05 * given_up.force_scale);
}

}  // namespace
}  // namespace talus
