#include <gmock/gmock.h>

#include "support/solver_scenes.hpp"

namespace talus {
namespace {

constexpr double time_step = 0.01;  // s

struct Motion {
  std::vector<StepReport> reports;
  Vec3 displacement = Vec3::Zero();  ///< m, of the block's first node
  std::vector<ContactSample> contacts;
  bool converged = true;
};

Motion run(Project project, const BlockSystem& system, int limit = settings_of(Preset::paper).open_close_limit) {
  project.solver = settings_of(Preset::paper);
  project.solver.open_close_limit = limit;
  Simulation simulation(project, system);
  Motion result;
  while (!simulation.finished()) result.reports.push_back(simulation.step());
  result.converged = simulation.converged();
  const BodySet& bodies = simulation.bodies();
  const int node = bodies.bodies.back().first_node;
  result.displacement = bodies.nodes.position[node] - bodies.nodes.reference[node];
  result.contacts = simulation.contacts();
  return result;
}

Project incline(double dip, double friction_angle) {
  Project project = test::rock_project(friction_angle, {{"rest", StageKind::static_, time_step, 10, {}},
                                                        {"slide", StageKind::dynamic, time_step, 50, {}}});
  project.gravity = test::tilted_gravity(dip);
  return project;
}

/// By how much of the way a block slides another way down 30° at φ = 20° than it should, in 0.1 s of static steps, each
/// of which begins at rest, and 0.5 s of dynamic ones.
double sliding_error(double step) {
  Project project = incline(30, 20);
  project.stages = {{"rest", StageKind::static_, step, static_cast<int>(std::lround(0.1 / step)), {}},
                    {"slide", StageKind::dynamic, step, static_cast<int>(std::lround(0.5 / step)), {}}};
  const Motion slid = run(project, test::cube_on_slab());
  EXPECT_TRUE(slid.converged);
  const double acceleration = 9.81 * (std::sin(M_PI / 6) - std::tan(20 * M_PI / 180) * std::cos(M_PI / 6));
  const double at_rest = 0.1 / step * 0.5 * acceleration * step * step, sliding = 0.5 * acceleration * 0.5 * 0.5;
  return slid.displacement.x() / (at_rest + sliding) - 1;
}

TEST(PaperScheme, ABlockSlidesDownAnInclineByTheClosedForm) {
  const double error = sliding_error(time_step), with_tenth = sliding_error(time_step / 10);
  EXPECT_LT(std::abs(error), 1e-3);
  EXPECT_LT(std::abs(with_tenth), 1e-3);
}

TEST(PaperScheme, FrictionPointsUpTheInclineInEveryStep) {
  Project project = incline(30, 20);
  project.solver = settings_of(Preset::paper);
  const BlockSystem system = test::cube_on_slab();
  Simulation simulation(project, system);
  while (!simulation.finished()) {
    const StepReport report = simulation.step();
    double normal = 0;
    Vec3 friction = Vec3::Zero();
    for (const ContactSample& contact : simulation.contacts()) {
      normal += contact.normal_force;
      friction += contact.shear_force;
    }
    EXPECT_NEAR(friction.norm(), std::tan(20 * M_PI / 180) * normal, 1e-2 * friction.norm()) << "step " << report.step;
  }
}

TEST(PaperScheme, ABlockSticksBelowItsFrictionAngle) {
  const Motion stuck = run(incline(30, 35), test::cube_on_slab());
  ASSERT_TRUE(stuck.converged);
  EXPECT_LT(stuck.displacement.norm(), 1e-4) << "springs alone give";
  double shear = 0, normal = 0;
  for (const ContactSample& contact : stuck.contacts) {
    shear += contact.shear_force.norm();
    normal += contact.normal_force;
  }
  EXPECT_LE(shear, std::tan(35 * M_PI / 180) * normal);
}

TEST(PaperScheme, NoStepTakesMoreThanSixRoundsBeforeItIsCut) {
  const Motion slid = run(incline(30, 20), test::cube_on_slab());
  for (const StepReport& report : slid.reports)
    EXPECT_LE(report.iterations, 6 * (1 + report.cuts) + 6 * 3 * report.cuts) << "step " << report.step;
}

TEST(PaperScheme, OneRoundIsTooFewWhereStatesChange) {
  Project project = incline(30, 20);
  project.stages = {{"slide", StageKind::dynamic, time_step, 1, {}}};
  const Motion one = run(project, test::cube_on_slab(), 1);
  EXPECT_TRUE(!one.converged || one.reports[0].cuts > 0) << "the block is set down: it sticks before it slides";
}

/// A round in which a contact was open bore no normal force, so the first round in which it is closed bears no friction
/// (36). With friction of the force that a spring would have had, a block that meets an edge of the plane's mesh is
/// thrown back and forth until the step is as short as it may be.
TEST(PaperScheme, ABlockSlidesOnWhereItMeetsAnEdgeOfTheMesh) {
  BlockSystem system = test::block_system({test::box_block("ground", Vec3(-2, -2, -1), Vec3(5, 2, 0), BodyKind::fixed),
                                           test::box_block("B", Vec3(0.1, -0.4, 0), Vec3(1.1, 0.6, 1))});
  system.blocks[0].mesh = box_mesh(Vec3(-2, -2, -1), Vec3(5, 2, 0), 8, 7, 1);
  system.blocks[1].mesh = box_mesh(Vec3(0.1, -0.4, 0), Vec3(1.1, 0.6, 1), 3, 3, 3, true);
  for (Block& block : system.blocks) block.surface = boundary(block.mesh);
  Project project = incline(30, 15);
  project.stages[1].steps = 100;
  EXPECT_TRUE(run(project, system).converged);
}

TEST(PaperScheme, AStaticStepBeginsAtRestWithAllItsInertia) {
  Project project = test::rock_project(30, {{"fall", StageKind::static_, time_step, 7, {}}});
  const Motion fallen = run(project, test::block_system({test::box_block("B", Vec3(0, 0, 0), Vec3(1, 1, 1))}));
  const double expected = 7 * 0.5 * 9.81 * time_step * time_step;
  EXPECT_NEAR(fallen.displacement.z(), -expected, 1e-9 * expected);
}

}  // namespace
}  // namespace talus
