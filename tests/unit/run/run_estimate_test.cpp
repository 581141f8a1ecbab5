#include "run/run_estimate.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "base/error.hpp"
#include "base/memory_limit.hpp"
#include "run/run.hpp"
#include "support/small_scenes.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

struct Silent final : RunObserver {
  void on_step(const StepReport&, const HistoryRow&, double) override {}
  void on_frame(std::shared_ptr<const Frame>) override {}
  bool go_on() override { return true; }
};

class Estimate : public testing::Test {
 protected:
  Estimate() {
    project_.name = "fall";
    project_.materials = {{"rock", 2600, 25e9, 0.24}};
    project_.stages = {{"fall", StageKind::dynamic, 0.01, 100, {}}};
    project_.output.every = 0.25;
    system_.blocks = {test::box_block("B", Vec3(0, 0, 0), Vec3(1, 1, 1))};
    system_.solids_volume = 1;
  }
  void TearDown() override {
    set_memory_limit(HUGE_VAL);
    fs::remove_all(folder_);
  }

  std::string refusal() {
    try {
      require_room(run_estimate(project_, system_), folder_ / "not" / "there");
      return "none";
    } catch (const InputError& error) {
      return error.what();
    }
  }

  Project project_;
  BlockSystem system_;
  fs::path folder_ = fs::path(testing::TempDir()) / "run_estimate";
};

TEST_F(Estimate, KnowsTheFramesAndWhatTheyTake) {
  project_.output.every = 0.01;
  Silent nobody;
  const RunReport report = run(project_, system_, {folder_, "{}", 1}, nobody);
  const RunEstimate estimate = run_estimate(project_, system_);
  EXPECT_EQ(estimate.frames, report.frames);
  const auto written =
      static_cast<double>(fs::file_size(folder_ / "results.h5") + fs::file_size(folder_ / "steps.csv"));
  EXPECT_GT(estimate.results, 0.2 * written) << "small tables take more than is in them";
  EXPECT_LT(estimate.results, 1.2 * written);
}

TEST_F(Estimate, FramesAreNoOftenerThanSteps) {
  project_.output.every = 1e-12;
  EXPECT_EQ(run_estimate(project_, system_).frames, 101);
  project_.output.every = 0.3;
  EXPECT_EQ(run_estimate(project_, system_).frames, 4) << "the last one is at the end";
}

TEST_F(Estimate, AStageThatMayEndAtEquilibriumPromisesItsLastFrameAlone) {
  project_.stages[0].kind = StageKind::static_;
  project_.stages[0].until_equilibrium = true;
  EXPECT_EQ(run_estimate(project_, system_).frames, 2);
}

TEST_F(Estimate, MoreResultsThanTheDiskHoldsAreRefusedWithTheirSize) {
  EXPECT_EQ(refusal(), "none");
  project_.stages[0] = {"fall", StageKind::dynamic, 1e-6, {}, 1e9};
  project_.output.every = 1e-12;
  EXPECT_THAT(refusal(),
              HasSubstr("/output/every: the results would take 1.2e+06 TB in 1e15 frames, and the disk has"));
}

TEST_F(Estimate, MoreMemoryThanThereIsIsRefused) {
  set_memory_limit(1e3);
  EXPECT_THAT(refusal(), HasSubstr("/solids: solving takes about "));
}

}  // namespace
}  // namespace talus
