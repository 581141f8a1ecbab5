#include "document/document.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "base/error.hpp"
#include "io/project_file.hpp"

namespace talus {
namespace {

const char* const slab = R"({
  "talus": 1, "name": "Slab",
  "materials": {"rock": {"density": 2600, "young": 1e9, "poisson": 0.25}},
  "joints": {"J1": {"friction_angle": 30}},
  "default_joint": "J1",
  "solids": [{"name": "base", "box": {"min": [0, 0, 0], "max": [2, 2, 1]}, "material": "rock", "body": "fixed"}],
  "stages": [{"name": "wait", "type": "dynamic", "time_step": 0.01, "steps": 2}]
})";

class DocumentTest : public ::testing::Test {
 protected:
  void SetUp() override {
    folder = std::filesystem::temp_directory_path() / ("talus_document_" + std::to_string(::getpid()) +
                                                       ::testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(folder);
    file = folder / "slab.talus";
    std::ofstream(file) << slab;
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  std::filesystem::path folder, file;
  Document document;
};

TEST_F(DocumentTest, OpensAProjectAndNamesItsPlaces) {
  int opened = 0;
  QObject::connect(&document, &Document::opened, [&] { ++opened; });
  document.open(file);
  EXPECT_EQ(opened, 1);
  EXPECT_EQ(document.name().toStdString(), "Slab");
  EXPECT_EQ(document.folder(), folder);
  EXPECT_EQ(document.resultsFolder(), folder / "slab.results");
  EXPECT_TRUE(document.isSaved());
}

TEST_F(DocumentTest, KeepsWhatWasOpenWhenTheNextFileIsBroken) {
  document.open(file);
  const auto broken = folder / "broken.talus";
  std::ofstream(broken) << "{ \"talus\": 1, ";
  EXPECT_THROW(document.open(broken), InputError);
  EXPECT_EQ(document.name().toStdString(), "Slab");
  EXPECT_EQ(document.file(), file);
}

TEST_F(DocumentTest, ChangesTheWholeProjectAtOnceAndTakesItBack) {
  document.open(file);
  const Project before = document.project();
  Project changed = before;
  changed.solver.integrator = Integrator::generalized_alpha;
  changed.stages[0].time_step = 0.005;
  document.changeProject(changed, QStringLiteral("use Δ/2"));
  EXPECT_EQ(document.project(), changed);
  EXPECT_EQ(document.undoStack().undoText(), QStringLiteral("use Δ/2"));
  document.undoStack().undo();
  EXPECT_EQ(document.project(), before);
  changed.stages[0].time_step = -1;
  EXPECT_THROW(document.changeProject(changed, {}), InputError);
  EXPECT_EQ(document.undoStack().count(), 1);
}

TEST_F(DocumentTest, ChangesAJointAndTakesItBack) {
  document.open(file);
  int changed = 0;
  QObject::connect(&document, &Document::projectChanged, [&] { ++changed; });
  Joint joint = document.project().joints[0];
  joint.friction_angle = 22;
  document.changeJoint(0, joint);
  EXPECT_EQ(document.project().joints[0].friction_angle, 22);
  EXPECT_FALSE(document.isSaved());
  EXPECT_EQ(document.undoStack().undoText().toStdString(), "change joint J1");
  document.undoStack().undo();
  EXPECT_EQ(document.project().joints[0].friction_angle, 30);
  EXPECT_TRUE(document.isSaved());
  EXPECT_EQ(changed, 2);
}

TEST_F(DocumentTest, ChangesTheBodyOfASolidAndTakesItBack) {
  document.open(file);
  int changed = 0;
  QObject::connect(&document, &Document::projectChanged, [&] { ++changed; });
  Solid solid = document.project().solids[0];
  solid.body = BodyKind::automatic;
  document.changeSolid(0, solid);
  EXPECT_EQ(document.project().solids[0].body, BodyKind::automatic);
  EXPECT_EQ(document.undoStack().undoText().toStdString(), "change solid base");
  document.undoStack().undo();
  EXPECT_EQ(document.project().solids[0].body, BodyKind::fixed);
  document.undoStack().redo();
  document.save();
  EXPECT_EQ(read_project(file).solids[0].body, BodyKind::automatic);
  EXPECT_EQ(changed, 3);
  solid.mesh_size = -1;
  EXPECT_THROW(document.changeSolid(0, solid), InputError);
  EXPECT_FALSE(document.project().solids[0].mesh_size);
}

TEST_F(DocumentTest, RefusesWhatAFileMayNotHold) {
  document.open(file);
  Material material = document.project().materials[0];
  material.poisson = 0.5;
  EXPECT_THROW(document.changeMaterial(0, material), InputError);
  EXPECT_EQ(document.project().materials[0].poisson, 0.25);
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(DocumentTest, SavesWhatItChanged) {
  document.open(file);
  Material material = document.project().materials[0];
  material.density = 2710;
  document.changeMaterial(0, material);
  document.save();
  EXPECT_TRUE(document.isSaved());
  Document again;
  again.open(file);
  EXPECT_EQ(again.project().materials[0].density, 2710);
}

TEST(Selection, OneSelectionWithBlocksAddedByControl) {
  Selection selection;
  int changed = 0;
  QObject::connect(&selection, &Selection::changed, [&] { ++changed; });
  selection.select({Item::Kind::block, 3});
  selection.select({Item::Kind::block, 3});
  EXPECT_EQ(changed, 1);
  selection.toggleBlock(1);
  EXPECT_EQ(selection.blocks(), (std::vector<int>{1, 3}));
  EXPECT_EQ(selection.current(), (Item{Item::Kind::block, 1}));
  selection.toggleBlock(1);
  EXPECT_EQ(selection.current(), (Item{Item::Kind::block, 3}));
  selection.select({Item::Kind::stage, 0});
  EXPECT_TRUE(selection.blocks().empty());
}

TEST(Selection, HoverTellsOnlyOfChanges) {
  Selection selection;
  int hover = 0;
  QObject::connect(&selection, &Selection::hoverChanged, [&] { ++hover; });
  selection.hoverBlock(2);
  selection.hoverBlock(2);
  EXPECT_EQ(selection.hoveredBlock(), 2);
  selection.hoverBlock(std::nullopt);
  EXPECT_FALSE(selection.hoveredBlock());
  EXPECT_EQ(hover, 2);
}

}  // namespace
}  // namespace talus
