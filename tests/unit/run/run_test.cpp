#include "run/run.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "results/result_folder.hpp"
#include "results/summary.hpp"
#include "support/small_scenes.hpp"

namespace talus {
namespace {

struct Recorder final : RunObserver {
  int steps = 0, frames = 0, stop_after = 1 << 30;
  double last_fraction = 0;
  std::vector<EffectOutcome> effects;
  int iterations = 0;
  void on_iteration(double unbalanced) override {
    ++iterations;
    EXPECT_TRUE(std::isfinite(unbalanced));
  }
  bool looks_on = false;
  std::vector<std::shared_ptr<const Frame>> moments;
  bool wants_moment() override { return looks_on; }
  void on_moment(std::shared_ptr<const Frame> moment) override { moments.push_back(std::move(moment)); }
  void on_step(const StepReport&, const HistoryRow&, double fraction) override {
    ++steps;
    EXPECT_GT(fraction, last_fraction);
    last_fraction = fraction;
  }
  void on_frame(std::shared_ptr<const Frame> frame) override { EXPECT_EQ(frame->index, frames++); }
  void on_effects(const std::vector<EffectOutcome>& of_now) override { effects = of_now; }
  bool go_on() override { return steps < stop_after; }
};

class Run : public testing::Test {
 protected:
  Run()
      : folder_(std::filesystem::path(testing::TempDir()) /
                testing::UnitTest::GetInstance()->current_test_info()->name()) {
    std::filesystem::remove_all(folder_);
    project_.name = "fall";
    project_.materials = {{"rock", 2600, 25e9, 0.24}};
    project_.stages = {{"fall", StageKind::dynamic, 0.01, 100, {}}};
    project_.monitors = {{"P", "B", Vec3(0.5, 0.5, 0.5)}};
    project_.output.every = 0.25;
    system_.blocks = {test::box_block("B", Vec3(0, 0, 0), Vec3(1, 1, 1))};
    system_.solids_volume = 1;
  }
  ~Run() override { std::filesystem::remove_all(folder_); }

  RunReport run_it() { return run(project_, system_, {folder_, "{}", 1}, recorder_); }

  Project project_;
  BlockSystem system_;
  std::filesystem::path folder_;
  Recorder recorder_;
};

TEST_F(Run, WritesAFrameAtTheStartAndAfterEveryInterval) {
  const RunReport report = run_it();
  EXPECT_EQ(report.status, RunStatus::completed);
  EXPECT_EQ(report.steps, 100);
  EXPECT_EQ(recorder_.steps, 100);
  EXPECT_EQ(recorder_.last_fraction, 1);
  ASSERT_EQ(recorder_.effects.size(), report.effects.size());
  for (std::size_t i = 0; i < report.effects.size(); ++i)
    EXPECT_EQ(recorder_.effects[i].evaluations, report.effects[i].evaluations) << "told with the last frame";
  const ResultReader results(folder_);
  EXPECT_THAT(results.frame_times(), testing::ElementsAre(0, testing::DoubleEq(0.25), testing::DoubleEq(0.5),
                                                          testing::DoubleEq(0.75), testing::DoubleEq(1.0)));
  EXPECT_NEAR(results.frame(2).displacement[3].z(), -0.5 * 9.81 * 0.25, 1e-9);
  EXPECT_EQ(results.history().size(), 101u);
}

TEST_F(Run, TellsOfEachIterationOfAStep) {
  const RunReport report = run_it();
  EXPECT_GT(report.iterations, 0);
  EXPECT_EQ(recorder_.iterations, report.iterations);
}

TEST_F(Run, ShowsMomentsBetweenFramesToWhoLooksOn) {
  recorder_.looks_on = true;
  const RunReport report = run_it();
  EXPECT_EQ(report.frames, 5) << "moments are not written";
  ASSERT_EQ(recorder_.moments.size(), 96u) << "of steps without a frame";
  const Frame& first = *recorder_.moments.front();
  EXPECT_EQ(first.index, 0);
  EXPECT_NEAR(first.time, 0.01, 1e-12);
  EXPECT_NEAR(first.displacement[3].z(), -0.5 * 9.81 * 0.01 * 0.01, 1e-12);
  EXPECT_NEAR(first.velocity[3].z(), -9.81 * 0.01, 1e-9);
  EXPECT_EQ(first.stress.size(), system_.blocks[0].mesh.tetrahedra.size());
  EXPECT_EQ(recorder_.moments.back()->index, 3);
}

TEST_F(Run, SaysHowBlocksMoveInFramesAndReport) {
  const RunReport report = run_it();
  EXPECT_EQ(report.blocks[0].motion.mode, MotionMode::falling);
  EXPECT_EQ(report.names.blocks, std::vector<std::string>{"B"});
  const ResultReader results(folder_);
  EXPECT_EQ(results.frame(0).motions, std::vector<MotionClass>(1));
  EXPECT_EQ(results.frame(4).motions, std::vector<MotionClass>{report.blocks[0].motion});
}

TEST_F(Run, ComparesExpectationsBetweenStepsAndSinceAMoment) {
  project_.expect = {{"P.displacement.z", 0.505, -0.5 * 9.81 * 0.505 * 0.505, 1e-3, {}, "½gt²"},
                     {"B.velocity.magnitude", 1.0, 9.81, 1e-10, {}, "gt"},
                     {"P.displacement.z", 1.0, -0.5 * 9.81 * 0.75, 1e-9, 0.5, "½g(t²−s²)"},
                     {"P.displacement.x", 1.0, 0.25, 1e-3, {}, "wrong on purpose"},
                     {"P.displacement.x", 7.0, 0, 1e-3, {}, "after the end"}};
  const RunReport report = run_it();
  ASSERT_EQ(report.expect.size(), 5u);
  EXPECT_TRUE(report.expect[0].passed) << report.expect[0].error;
  EXPECT_TRUE(report.expect[1].passed) << report.expect[1].error;
  EXPECT_TRUE(report.expect[2].passed) << report.expect[2].error;
  EXPECT_FALSE(report.expect[3].passed);
  EXPECT_NEAR(report.expect[3].error, 1, 1e-9);
  EXPECT_FALSE(report.expect[4].reached);
  EXPECT_FALSE(report.expect[4].passed);
}

TEST_F(Run, StopsAfterTheStepWhenItIsToldAndLeavesReadableResults) {
  recorder_.stop_after = 30;
  const RunReport report = run_it();
  EXPECT_EQ(report.status, RunStatus::stopped);
  EXPECT_EQ(report.steps, 30);
  EXPECT_EQ(ResultReader(folder_).history().size(), 31u);
}

TEST_F(Run, EnergyOfAFallIsConserved) {
  const RunReport report = run_it();
  const EnergyLedger& energy = report.last_step.energy;
  EXPECT_NEAR(energy.kinetic, 0.5 * 2600 * 9.81 * 9.81, 1e-3);
  EXPECT_NEAR(energy.potential, -energy.kinetic, 1e-3);
  EXPECT_LT(std::abs(energy.integration_loss), 1e-8 * energy.kinetic);
}

TEST_F(Run, EndsWhereBlocksLieInEachOther) {
  system_ = {};
  system_.blocks = {test::box_block("wall", {0, -3, -3}, {1, 3, 3}, BodyKind::fixed),
                    test::box_block("plate", {-0.5, -0.5, -0.5}, {-0.48, 0.5, 0.5}, BodyKind::rigid)};
  project_.joints = {{"J", 30, 0, 0, {}, {}, {}, {}}};
  project_.default_joint = "J";
  system_.joint_names = {"J"};
  project_.monitors.clear();
  project_.gravity.setZero();
  project_.velocities = {{"plate", {30, 0, 0}, {}}};
  project_.output.every = 0.01;
  const RunReport stopped = run_it();
  EXPECT_EQ(stopped.status, RunStatus::completed) << stopped.reason;
  EXPECT_LT(stopped.blocks[1].displacement.x(), 0.5);

  std::filesystem::remove_all(folder_);
  recorder_ = {};
  project_.solver.effects.missed_contacts = Switch::off;  // nothing sees the plate until it is in the wall
  project_.solver.effects.contact = Switch::off;
  const RunReport report = run_it();
  EXPECT_EQ(report.status, RunStatus::interpenetrating);
  EXPECT_NEAR(report.time, 0.02, 1e-12);
  EXPECT_THAT(report.reason, testing::HasSubstr("wall – plate at ("));
  ASSERT_FALSE(report.troubles.empty());
  EXPECT_EQ(report.troubles[0].cause, TroubleCause::interpenetrating);
  EXPECT_TRUE(report.troubles[0].ended_run);
  const auto read = read_summary(folder_ / "summary.json");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->status, RunStatus::interpenetrating);
  EXPECT_EQ(read->troubles[0].cause, TroubleCause::interpenetrating);
}

}  // namespace
}  // namespace talus
