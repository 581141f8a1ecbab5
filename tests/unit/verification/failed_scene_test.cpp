#include "verification/failed_scene.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "base/error.hpp"
#include "base/temporary_folder.hpp"
#include "io/project_file.hpp"
#include "model/stages.hpp"
#include "verification/random/random_scene.hpp"

namespace talus {
namespace {

using testing::HasSubstr;

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST(FailedScene, IsAProjectWithItsBlocksAsSolids) {
  for (const RandomFamily& family : random_families()) {
    const CaseScene scene = random_scene({family.name, 1, 1, {}}).build();
    const Project project = project_of(scene);
    EXPECT_EQ(parse_project(write_project(project)), project) << family.name << ": it is sound, and read as written";
    if (!scene.project.solids.empty()) continue;
    ASSERT_EQ(project.solids.size(), scene.system.blocks.size());
    EXPECT_EQ(project.solids.back().body, scene.system.blocks.back().body);
  }
}

TEST(FailedScene, IsWrittenWithWhatFailed) {
  HardCase scene = random_scene({"drops", 1, 1, RandomBodies::rigid});
  scene.expected.push_back({"the impossible", [](const Trajectory&) { return std::string("it did not happen"); }});
  NoProgress progress;
  const Trial trial = run_trial(scene, {}, progress);
  ASSERT_FALSE(trial.passed());
  const TemporaryFolder folder;
  const std::filesystem::path file = write_failed_scene(folder.path() / "new", scene, trial, {}, progress);
  EXPECT_EQ(file.filename(), "drops-1-1-rigid.talus");
  EXPECT_THAT(text_of(file), HasSubstr("// - expected: the impossible; but it did not happen\n"));
  const Project project = read_project(file);
  EXPECT_EQ(project.name, "drops:1:1:rigid");
  EXPECT_EQ(project.stages, scene.build().project.stages);
}

TEST(FailedScene, SaysWhereItCannotBeWritten) {
  const HardCase scene = random_scene({"drops", 1, 1, RandomBodies::rigid});
  NoProgress progress;
  EXPECT_THROW(write_failed_scene("/proc/nowhere", scene, {}, {}, progress), InputError);
}

}  // namespace
}  // namespace talus
