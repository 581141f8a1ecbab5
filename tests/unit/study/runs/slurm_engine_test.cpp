// How runs are handed to Slurm, by programs that stand in for it; tests/cli/slurm_test.sh has a cluster of its own.
#include "study/runs/slurm_engine.hpp"

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "base/temporary_folder.hpp"

namespace talus {
namespace {

class SlurmStandIn : public testing::Test {
 protected:
  void SetUp() override {
    path_ = std::getenv("PATH");
    setenv("PATH", (folder_.path().string() + ":" + path_).c_str(), 1);
    write("squeue", "exit 0");  // nothing is in the queue any more
    std::ofstream(folder_.path() / "p.talus") << R"({"talus": 1, "materials": {"rock": {"density": 2600, "young": 1e9,
      "poisson": 0.2}}, "joints": {"J": {"friction_angle": 30}}, "default_joint": "J", "solids": [{"name": "cube",
      "box": {"min": [0, 0, 0], "max": [1, 1, 1]}, "material": "rock", "mesh_size": 1}],
      "stages": [{"name": "fall", "type": "dynamic", "time_step": 0.01, "steps": 2}]})";
  }
  void TearDown() override { setenv("PATH", path_.c_str(), 1); }

  void write(const std::string& program, const std::string& script) {
    const auto file = folder_.path() / program;
    std::ofstream(file) << "#!/bin/sh\n" << script << '\n';
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  }
  StudyFolder study() {
    StudyRequest request;
    request.project_file = folder_.path() / "p.talus";
    request.wish = parse_ladder_wish({}, {"time_step=1,2"});
    return StudyFolder(folder_.path() / "study", make_plan(request), false);
  }
  /// What sbatch was told to run, a line a call.
  std::string asked() const {
    std::ifstream stream(folder_.path() / "asked");
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  const TemporaryFolder folder_;
  std::string path_;
  NoProgress nobody_;
};

TEST_F(SlurmStandIn, RunsThatALostNodeHadAreHandedOverAgain) {
  const StudyFolder runs = study();
  ASSERT_EQ(runs.missing_runs().size(), 2u);
  // The first call ends run 0 alone, the next one ends all that it is asked for.
  write("sbatch", "echo \"$2\" >> '" + (folder_.path() / "asked").string() + "'\n" + "case $2 in *=0,1) touch '" +
                      runs.run_file(0).string() + "';; *) touch '" + runs.run_file(1).string() + "';; esac\necho 12");
  run_by_slurm(runs, {.program = "talus-cli", .grace = std::chrono::milliseconds(0)}, nobody_);
  EXPECT_TRUE(runs.missing_runs().empty());
  EXPECT_EQ(asked(), "--array=0,1\n--array=1\n");
}

TEST_F(SlurmStandIn, RunsThatNeverComeAreGivenUp) {
  const StudyFolder runs = study();
  write("sbatch", "echo \"$2\" >> '" + (folder_.path() / "asked").string() + "'\necho 12");
  run_by_slurm(runs, {.program = "talus-cli", .submissions = 2, .grace = std::chrono::milliseconds(0)}, nobody_);
  EXPECT_EQ(runs.missing_runs().size(), 2u);
  EXPECT_EQ(asked(), "--array=0,1\n--array=0,1\n");
}

}  // namespace
}  // namespace talus
