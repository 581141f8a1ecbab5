#include "verification/hard_cases/trial.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "model/stages.hpp"
#include "verification/hard_cases/expectations.hpp"
#include "verification/known_answers/support/scene.hpp"

// Every figure of a trial must be able to fail: a scene, or a state of the bodies, that breaks it is reported.
namespace talus {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A cube of 1 m at rest on a slab, for two stages. No corner lies on an edge of the slab's mesh.
CaseScene cube_at_rest() {
  CaseScene scene = rock_scene(30);
  scene.add_fixed_box("slab", Vec3(-4, -3, -1), Vec3(8, 3, 0));
  scene.add_box("cube", Vec3(-0.5, -0.5, 0), Vec3(0.5, 0.5, 1));
  scene.project.stages = {static_stage(1e-3, 10), dynamic_stage(0.01, 0.2)};
  return scene;
}

HardCase named(std::function<CaseScene()> build, const HardCaseExpectation& expectation = rests("cube", 0, 1e-6)) {
  return {.name = "scene", .group = "group", .title = "Title", .expected = {expectation}, .build = std::move(build)};
}

HardCase changed(const std::function<void(CaseScene&)>& change) {
  return named([change] {
    CaseScene scene = cube_at_rest();
    change(scene);
    return scene;
  });
}

Trial trial_of(const HardCase& scene, const TrialOptions& options = {}) {
  NoProgress progress;
  return run_trial(scene, options, progress);
}

TEST(Trial, ComesToTheSameAtAnotherPlace) {
  HardCase scene = named(cube_at_rest);
  scene.elsewhere = Elsewhere{33, {4e6, -3e6, 0}};
  EXPECT_FALSE(trial_of(scene).elsewhere.has_value()) << "it was not asked for";
  EXPECT_FALSE(trial_of(named(cube_at_rest), {.elsewhere = true}).elsewhere.has_value()) << "it names no place";
  const Trial trial = trial_of(scene, {.elsewhere = true});
  ASSERT_TRUE(trial.elsewhere.has_value());
  EXPECT_THAT(faults(trial), IsEmpty());
  EXPECT_LT(trial.elsewhere->apart, 1e-12);
}

/// A base that moves to the east whichever way the scene is turned.
TEST(Trial, WhatKnowsNorthIsNotTheSameAtAnotherPlace) {
  HardCase scene = changed([](CaseScene& built) {
    built.project.constraints = {{.block = "slab", .at = {}, .displacement = {1e-4, 0, 0}}};
  });
  scene.elsewhere = Elsewhere{33, {4e6, -3e6, 0}};
  const Trial trial = trial_of(scene, {.elsewhere = true});
  EXPECT_THAT(faults(trial), Contains(HasSubstr("not the same at another place: displacements differ by")));
  EXPECT_GT(trial.elsewhere.value().apart, 100 * most_apart_elsewhere);
}

TEST(Trial, OfABlockAtRestHasNoFaultsAndItsFigures) {
  const Trial trial = trial_of(named(cube_at_rest), {.repeat_on = {1, 2}});
  EXPECT_THAT(faults(trial), IsEmpty());
  EXPECT_TRUE(trial.passed());
  EXPECT_EQ(trial.ending, TrialEnding::completed);
  EXPECT_EQ(trial.steps, 30);
  EXPECT_EQ(trial.cuts, 0);
  EXPECT_GE(trial.iterations, trial.most_iterations);
  EXPECT_GT(trial.penetration, 0);
  EXPECT_NEAR(trial.least_volume, 1, 1e-5);
  EXPECT_LT(trial.least_volume, 1) << "its own weight presses it together";
  EXPECT_EQ(trial.prints.size(), 31U) << "the start and every step";
  ASSERT_EQ(trial.repetitions.size(), 2U);
  EXPECT_EQ(trial.repetitions[0].threads, 1);
  EXPECT_EQ(trial.repetitions[1].threads, 2);
}

TEST(Trial, SoftContactIsTooDeep) {
  const Trial trial = trial_of(changed([](CaseScene& scene) { scene.project.joints[0].normal_stiffness = 1e6; }));
  EXPECT_GT(trial.penetration, most_penetration);
  EXPECT_THAT(faults(trial), Contains(HasSubstr("of the mesh size deep")));
}

TEST(Trial, BlocksThatStartInEachOtherAreFoundWhereContactIsNot) {
  // Half a metre deep there is no contact by the search's own rules.
  const Trial trial = trial_of(
      changed([](CaseScene& scene) { scene.add_box("stowaway", Vec3(-0.3, -0.3, 0.2), Vec3(0.3, 0.3, 0.8)); }));
  EXPECT_EQ(trial.interpenetrating, "stowaway in cube");
  EXPECT_THAT(faults(trial), Contains(HasSubstr("stowaway in cube is")));
}

TEST(Trial, ContactThatIsLoadedFromNothingIsEnergyThatGrows) {
  const Trial trial = trial_of(changed([](CaseScene& scene) {
    scene.project.stages = {dynamic_stage(1e-3, 0.01)};
    for (Vec3& node : scene.system.blocks[1].mesh.nodes) node.z() -= 1e-4;
  }));
  EXPECT_THAT(faults(trial), Contains(HasSubstr("energy grows by")));
}

TEST(Trial, ARunThatDoesNotConvergeGivesTheSolversWords) {
  const Trial trial = trial_of(changed([](CaseScene& scene) {
    scene.project.velocities = {{.block = "cube", .linear = {3, 0, -2}, .angular = {0, 2, 0}}};
    scene.project.solver.open_close_limit = 1;
  }));
  EXPECT_EQ(trial.ending, TrialEnding::not_converged);
  EXPECT_THAT(faults(trial), Contains(HasSubstr("did not converge: the open-close iteration did not converge")));
}

TEST(Trial, WhatIsThrownBreaksItOff) {
  const Trial thrown = trial_of(named([]() -> CaseScene { throw std::runtime_error("no mesh"); }));
  EXPECT_EQ(thrown.ending, TrialEnding::broken_off);
  EXPECT_THAT(faults(thrown), ElementsAre("broke off: no mesh"));
  EXPECT_THAT(faults(trial_of(named(cube_at_rest, rests("brick", 0, 1)))),
              ElementsAre(HasSubstr("the scene has no block 'brick'")));
}

TEST(Trial, WhatIsNoNumberIsFound) {
  const Trial trial = trial_of(changed([](CaseScene& scene) {
    scene.project.velocities = {{"cube", Vec3::Constant(std::numeric_limits<double>::quiet_NaN()), Vec3::Zero()}};
  }));
  EXPECT_FALSE(trial.passed());

  const Trial fast = trial_of(changed([](CaseScene& scene) {
    scene.project.stages = {dynamic_stage(0.01, 0.02)};
    scene.system.blocks[1].body = BodyKind::rigid;
    scene.project.velocities = {{"cube", Vec3(0, 0, 1e200), Vec3::Zero()}};
  }));
  EXPECT_FALSE(fast.finite) << "its kinetic energy is beyond what a number can be";
  EXPECT_EQ(fast.ending, TrialEnding::broken_off);

  const CaseScene scene = cube_at_rest();
  BodySet bodies(scene.project, scene.system);
  EXPECT_TRUE(all_finite(bodies));
  bodies.nodes.velocity.back().y() = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(all_finite(bodies));
  Trial figures;
  figures.finite = false;
  EXPECT_THAT(faults(figures), ElementsAre(HasSubstr("is not a number")));
}

TEST(Trial, ATetrahedronThatIsInsideOutHasANegativeVolume) {
  const CaseScene scene = cube_at_rest();
  BodySet bodies(scene.project, scene.system);
  EXPECT_EQ(least_volume_ratio(bodies), 1);
  const std::array<int, 4> nodes = bodies.elements[0].nodes;
  auto& at = bodies.nodes.position;
  at[nodes[0]] += 2 * ((at[nodes[1]] + at[nodes[2]] + at[nodes[3]]) / 3 - at[nodes[0]]);
  EXPECT_NEAR(least_volume_ratio(bodies), -1, 1e-12);
  Trial figures;
  figures.least_volume = -0.1;
  EXPECT_THAT(faults(figures), ElementsAre(HasSubstr("inverted: -0.1 of its volume")));
}

TEST(Trial, ExpectationsThatAreNotMetAreSaidWithTheirFigures) {
  EXPECT_THAT(faults(trial_of(named(cube_at_rest, travels_at_least("cube", Vec3(1, 0, 0), 1)))),
              ElementsAre(HasSubstr("expected: cube goes at least 1 m; but cube goes")));
}

TEST(Trial, ALedgerThatDoesNotCloseIsAFault) {
  Trial figures;
  figures.closes = false;
  figures.remainder = 1e-5;
  EXPECT_THAT(faults(figures), ElementsAre("the energy ledger misses 1e-05 of what moved"));
}

TEST(Trial, OtherBitsOnOtherThreadsAreFound) {
  const HardCase scene = changed([](CaseScene& one) {
    if (ThreadLimit::current() > 1) one.project.gravity.x() = 1e-12;
  });
  const Trial trial = trial_of(scene, {.repeat_on = {1, 2}});
  EXPECT_EQ(trial.repetitions[0].difference, "");
  EXPECT_THAT(faults(trial),
              ElementsAre(HasSubstr(
                  "not the same bits on 2 threads, taken up anew in between: positions or iterations differ")));
}

TEST(Trial, FingerprintsOfRunsAreTheSameWhereAllTheirSnapshotsAre) {
  const Trial trial = trial_of(named(cube_at_rest));
  EXPECT_EQ(fingerprint(trial_of(named(cube_at_rest), {.threads = 2})), fingerprint(trial));
  const auto of_changed = [&trial](const std::function<void(std::vector<SnapshotHash>&)>& change) {
    Trial other = trial;
    change(other.prints);
    return fingerprint(other);
  };
  using Prints = std::vector<SnapshotHash>;
  const std::set<std::uint64_t> others{fingerprint(trial),
                                       of_changed([](Prints& prints) { prints[20].positions ^= 1; }),
                                       of_changed([](Prints& prints) { ++prints[20].iterations; }),
                                       of_changed([](Prints& prints) { prints[20].time += 1e-15; }),
                                       of_changed([](Prints& prints) { std::swap(prints[20], prints[21]); }),
                                       of_changed([](Prints& prints) { prints.pop_back(); })};
  EXPECT_EQ(others.size(), 6U) << "each must be told from all others";
}

TEST(Trial, ARunThatIsSaidToStopGoesNoFurther) {
  class Stopping final : public Progress {
   public:
    void report(double, std::string_view) override { ++reports; }
    bool cancelled() const override { return reports >= 3; }
    int reports = 0;
  } progress;
  EXPECT_THROW(run_trial(named(cube_at_rest), {}, progress), Cancelled);
  EXPECT_EQ(progress.reports, 3);
}

}  // namespace
}  // namespace talus
