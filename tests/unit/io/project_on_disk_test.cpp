#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "io/project_file.hpp"
#include "unit/io/sample_project.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class ProjectOnDisk : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder); }
  void TearDown() override { fs::remove_all(folder); }

  static std::string content(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  std::size_t files() const { return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {})); }

  const fs::path folder = fs::temp_directory_path() / ("talus-io-" + std::to_string(::getpid()));
  const Project project = parse_project(test::full_project);
};

TEST_F(ProjectOnDisk, IsReadAsItWasSaved) {
  save_project(project, folder / "a.talus");
  EXPECT_EQ(read_project(folder / "a.talus"), project);
  EXPECT_EQ(files(), 1u);
}

TEST_F(ProjectOnDisk, SavingKeepsCommentsAndPermissions) {
  std::ofstream(folder / "a.talus") << test::full_project;
  fs::permissions(folder / "a.talus", fs::perms::owner_read | fs::perms::owner_write);
  save_project(project, folder / "a.talus");
  EXPECT_EQ(content(folder / "a.talus"), test::full_project);
  EXPECT_EQ(fs::status(folder / "a.talus").permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(ProjectOnDisk, SavingFollowsALink) {
  save_project(project, folder / "a.talus");
  fs::create_symlink("a.talus", folder / "link.talus");
  Project changed = project;
  changed.name = "changed";
  save_project(changed, folder / "link.talus");
  EXPECT_TRUE(fs::is_symlink(folder / "link.talus"));
  EXPECT_EQ(read_project(folder / "a.talus"), changed);
}

TEST_F(ProjectOnDisk, AFailedSaveLeavesTheOldFileAndNothingElse) {
  save_project(project, folder / "a.talus");
  const std::string before = content(folder / "a.talus");
  Project bad = project;
  bad.gravity[0] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(save_project(bad, folder / "a.talus"), InputError);
  EXPECT_EQ(content(folder / "a.talus"), before);
  EXPECT_EQ(files(), 1u);

  fs::create_directory(folder / "b.talus");  // a folder is in the way
  EXPECT_THROW(save_project(project, folder / "b.talus"), InputError);
  EXPECT_EQ(files(), 2u);
  EXPECT_THROW(save_project(project, folder / "none" / "a.talus"), InputError);
}

TEST_F(ProjectOnDisk, AMissingFileAndAFolderAreSaidToBeSo) {
  try {
    read_project(folder / "none.talus");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()), "cannot be read: no such file; check the name and the folder");
  }
  try {
    read_project(folder);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("it is a folder"));
  }
}

TEST_F(ProjectOnDisk, ALinkMayNotLeadOutOfTheFolder) {
  const fs::path inner = folder / "inner";
  fs::create_directories(inner);
  fs::create_symlink(folder, inner / "shapes");
  std::ofstream(folder / "hill.step") << "x";
  std::ofstream(inner / "a.talus") << test::full_project;
  try {
    read_project(inner / "a.talus");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.place(), "line 31, /solids/2/file");
    EXPECT_THAT(error.problem(), HasSubstr("outside"));
  }
  EXPECT_EQ(read_project(inner / "a.talus", {.allow_outside = true}), project);
}

TEST_F(ProjectOnDisk, TerrainMayNotComeFromOutsideTheFolderEither) {
  const auto refused = [](const auto& read) {
    try {
      read();
    } catch (const InputError& error) {
      EXPECT_THAT(error.place(), testing::EndsWith("/solids/3/terrain/file"));
      EXPECT_THAT(error.problem(), HasSubstr("outside"));
      return true;
    }
    return false;
  };
  const std::string text = test::replaced(test::full_project, "land.asc", "../land.asc");
  EXPECT_TRUE(refused([&] { parse_project(text); }));
  EXPECT_NO_THROW(parse_project(text, {.allow_outside = true}));
  const fs::path inner = folder / "inner";
  fs::create_directories(inner);
  std::ofstream(folder / "land.asc") << "x";
  fs::create_symlink(folder / "land.asc", inner / "land.asc");
  std::ofstream(inner / "a.talus") << test::full_project;
  EXPECT_TRUE(refused([&] { read_project(inner / "a.talus"); }));
}

}  // namespace
}  // namespace talus
