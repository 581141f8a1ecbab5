#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "base/error.hpp"
#include "results/checkpoint.hpp"
#include "results/result_folder.hpp"
#include "results/summary.hpp"
#include "run/run.hpp"
#include "support/silent_observer.hpp"
#include "support/small_scenes.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// Lets so many steps be taken.
struct Stopper final : RunObserver {
  explicit Stopper(int steps) : left(steps) {}
  void on_step(const StepReport&, const HistoryRow&, double) override { --left; }
  void on_frame(std::shared_ptr<const Frame>) override {}
  bool go_on() override { return left > 0; }
  int left;
};

/// A block settles on a base and is pushed over its edge; another one falls on to it.
class ResumedRun : public testing::Test {
 protected:
  ResumedRun() : folder_(fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name()) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    project_.name = "over the edge";
    project_.materials = {{"rock", 2600, 25e9, 0.24}};
    project_.joints.emplace_back();
    project_.joints[0].name = "J";
    project_.joints[0].friction_angle = 20;
    project_.stages = {{"settle", StageKind::static_, 0.01, 20, {}}, {"slide", StageKind::dynamic, 0.005, 160, {}}};
    project_.monitors = {{"P", "A", Vec3(0.5, 0.5, 1)}};
    project_.velocities = {{"A", Vec3(2, 0, 0), Vec3::Zero()}};
    project_.output.every = 0.07;
    system_.blocks = {test::box_block("base", Vec3(0, 0, -1), Vec3(2, 1, 0), BodyKind::fixed),
                      test::box_block("A", Vec3(0, 0, 0), Vec3(1, 1, 1)),
                      test::box_block("B", Vec3(0.2, 0.1, 1.5), Vec3(0.8, 0.9, 2), BodyKind::rigid)};
    system_.solids_volume = 3.24;
    system_.joint_names = {"J"};
  }
  ~ResumedRun() override { fs::remove_all(folder_); }

  RunReport run_to_end(const std::string& name, bool resume) {
    SilentObserver observer;
    return run(project_, system_, {folder_ / name, "{}", 1, resume}, observer);
  }
  RunReport run_for(int steps, const std::string& name, bool resume = false) {
    Stopper observer(steps);
    return run(project_, system_, {folder_ / name, "{}", 1, resume}, observer);
  }

  void expect_same(const std::string& a, const std::string& b) const {
    EXPECT_EQ(content(folder_ / a / "history.csv"), content(folder_ / b / "history.csv"));
    const ResultReader first(folder_ / a), second(folder_ / b);
    ASSERT_EQ(first.frame_times(), second.frame_times());
    for (int i = 0; i < static_cast<int>(first.frame_times().size()); ++i) {
      const Frame p = first.frame(i), q = second.frame(i);
      EXPECT_EQ(p.displacement, q.displacement) << i;
      EXPECT_EQ(p.velocity, q.velocity) << i;
      EXPECT_EQ(p.stress, q.stress) << i;
      EXPECT_EQ(p.motions, q.motions) << i;
      ASSERT_EQ(p.contacts.size(), q.contacts.size()) << i;
    }
    const std::vector<StepReport> p = first.steps(), q = second.steps();
    ASSERT_EQ(p.size(), q.size());
    for (std::size_t i = 0; i < p.size(); ++i) {
      EXPECT_EQ(p[i].iterations, q[i].iterations) << i;
      EXPECT_EQ(p[i].energy.contact, q[i].energy.contact) << i;
      EXPECT_EQ(p[i].unbalanced_force, q[i].unbalanced_force) << i;
    }
    EXPECT_EQ(content(folder_ / a / "log.txt"), content(folder_ / b / "log.txt"));
    EXPECT_EQ(content(folder_ / a / "results.xdmf"), content(folder_ / b / "results.xdmf"));
  }

  Project project_;
  BlockSystem system_;
  fs::path folder_;
};

TEST_F(ResumedRun, ComesToTheSameBitsWhereverItWasStopped) {
  const RunReport whole = run_to_end("whole", false);
  ASSERT_EQ(whole.status, RunStatus::completed) << whole.reason;
  ASSERT_FALSE(whole.events.empty());
  for (const int steps : {1, 19, 20, 21, 90, 179}) {
    const std::string name = "stopped_" + std::to_string(steps);
    EXPECT_EQ(run_for(steps, name).status, RunStatus::stopped);
    EXPECT_EQ(run_for(7, name, true).status, steps == 179 ? RunStatus::completed : RunStatus::stopped);
    const RunReport resumed = run_to_end(name, true);
    EXPECT_EQ(resumed.status, RunStatus::completed) << resumed.reason;
    EXPECT_EQ(resumed.steps, whole.steps);
    EXPECT_EQ(resumed.iterations, whole.iterations);
    EXPECT_EQ(resumed.work.factorisations, whole.work.factorisations);
    EXPECT_EQ(resumed.blocks[1].displacement, whole.blocks[1].displacement);
    ASSERT_EQ(resumed.events.size(), whole.events.size());
    for (std::size_t i = 0; i < whole.events.size(); ++i) EXPECT_EQ(resumed.events[i].what, whole.events[i].what);
    expect_same("whole", name);
  }
}

TEST_F(ResumedRun, WritesWhatTheRunLostBehindItsLastCheckpointAgain) {
  run_to_end("whole", false);
  run_for(60, "killed");
  fs::copy(folder_ / "killed" / "checkpoint.h5", folder_ / "earlier.h5");
  run_for(50, "killed", true);  // frames and rows that the checkpoint knows nothing of
  fs::rename(folder_ / "earlier.h5", folder_ / "killed" / "checkpoint.h5");
  run_to_end("killed", true);
  expect_same("whole", "killed");
}

TEST_F(ResumedRun, GoesOnWhereTheLastStageBecameLonger) {
  project_.output.every = 0.05;
  project_.stages[1].steps = 150;
  run_to_end("longer", false);
  project_.stages[1].steps = 160;
  run_to_end("whole", false);
  run_to_end("longer", true);
  expect_same("whole", "longer");
}

TEST_F(ResumedRun, GoesOnInStagesThatFollow) {
  run_to_end("longer", false);
  project_.stages.push_back({"rest", StageKind::dynamic, 0.01, 20, {}});
  run_to_end("whole", false);
  run_to_end("longer", true);
  expect_same("whole", "longer");
}

TEST_F(ResumedRun, BeginsAtTheStartWhereThereIsNoCheckpoint) {
  EXPECT_EQ(run_to_end("new", true).status, RunStatus::completed);
}

TEST_F(ResumedRun, IsTheReportAgainWhereTheRunWasOver) {
  const RunReport whole = run_to_end("whole", false), again = run_to_end("whole", true);
  EXPECT_EQ(again.status, RunStatus::completed);
  EXPECT_EQ(again.steps, whole.steps);
  EXPECT_EQ(again.last_step.energy.kinetic, whole.last_step.energy.kinetic);
}

TEST_F(ResumedRun, RefusesOtherBlocks) {
  run_for(30, "run");
  system_.blocks[2].mesh.nodes[3].x() += 1e-9;
  EXPECT_THROW(run_to_end("run", true), InputError);
}

TEST_F(ResumedRun, RefusesACheckpointThatIsDamaged) {
  run_for(30, "run");
  const fs::path file = folder_ / "run" / "checkpoint.h5";
  const auto size = fs::file_size(file);
  for (const auto at : {size / 3, size / 2, size - 100}) {
    std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekp(static_cast<std::streamoff>(at));
    stream.write("damaged damaged damaged", 23);
  }
  EXPECT_THROW(run_to_end("run", true), InputError);
}

/// Each list of where a table's pieces lie has a checksum. One that is wrong was waited for without end: who writes
/// takes it for one that is being written.
TEST_F(ResumedRun, RefusesResultsWhoseTablesAreDamaged) {
  run_for(30, "run");
  const fs::path file = folder_ / "run" / "results.h5";
  const std::string sound = content(file);
  int damaged = 0;
  for (std::size_t at = sound.find("EAHD"); at != std::string::npos; at = sound.find("EAHD", at + 1)) {
    std::string bytes = sound;
    bytes[at + 20] = static_cast<char>(bytes[at + 20] ^ 0x40);
    std::ofstream(file, std::ios::binary) << bytes;
    EXPECT_THROW(run_to_end("run", true), InputError) << "at " << at;
    ++damaged;
  }
  EXPECT_GE(damaged, 20);
  std::ofstream(file, std::ios::binary) << sound;
  EXPECT_EQ(run_to_end("run", true).status, RunStatus::completed);
}

TEST_F(ResumedRun, RefusesTheCheckpointOfAnotherVersion) {
  run_for(30, "run");
  const fs::path file = folder_ / "run" / "checkpoint.h5";
  Checkpoint checkpoint = read_checkpoint(file).value();
  checkpoint.label.version = "0.0.1, state 1";
  write_checkpoint(file, checkpoint.label, [&](const auto& sink) { sink(checkpoint.state); });
  try {
    run_to_end("run", true);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("another version of Talus: 0.0.1"));
  }
}

}  // namespace
}  // namespace talus
