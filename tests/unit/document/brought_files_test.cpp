#include "document/brought_files.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <fstream>

#include "base/error.hpp"
#include "document/document.hpp"
#include "io/project_file.hpp"
#include "io/whole_file.hpp"

namespace talus {
namespace {

class BroughtFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    folder = std::filesystem::temp_directory_path() / ("talus_brought_" + std::to_string(::getpid()));
    for (const char* name : {"from/shapes", "to"}) std::filesystem::create_directories(folder / name);
    std::ofstream(folder / "from/shapes/hill.step") << "a hill";
    Solid solid;
    solid.name = "hill";
    solid.material = "rock";
    solid.shape = FileShape{"shapes/hill.step"};
    project.solids = {solid};
    project.materials = {{.name = "rock", .density = 2600, .young = 1e9, .poisson = 0.2}};
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  std::filesystem::path folder;
  Project project;
};

TEST_F(BroughtFiles, ACopyThatIsSavedElsewhereTakesItsFilesAlong) {
  Document document;
  document.begin({.text = write_project(project), .folder = folder / "from", .isWork = false});
  EXPECT_EQ(document.folder(), folder / "from");
  document.saveAs(folder / "to/copy.talus");
  EXPECT_EQ(read_whole_file(folder / "to/shapes/hill.step"), "a hill");
  EXPECT_EQ(document.folder(), folder / "to");
}

TEST_F(BroughtFiles, AnotherFileOfTheNameIsNotOverwritten) {
  std::filesystem::create_directories(folder / "to/shapes");
  std::ofstream(folder / "to/shapes/hill.step") << "another hill";
  EXPECT_THROW(bring_files(project, folder / "from", folder / "to"), InputError);
  EXPECT_EQ(read_whole_file(folder / "to/shapes/hill.step"), "another hill");
  std::ofstream(folder / "to/shapes/hill.step") << "a hill";
  EXPECT_NO_THROW(bring_files(project, folder / "from", folder / "to"));
}

}  // namespace
}  // namespace talus
