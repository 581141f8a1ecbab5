#include "document/document.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "io/project_file.hpp"
#include "io/whole_file.hpp"

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

/// The slab with another friction of its joint.
Project withFriction(const Document& document, double angle) {
  Project changed = document.project();
  changed.joints[0].friction_angle = angle;
  return changed;
}

TEST_F(DocumentTest, ChangesTheProjectAndTakesItBack) {
  document.open(file);
  const Project before = document.project();
  int told = 0;
  QObject::connect(&document, &Document::projectChanged, [&] { ++told; });
  Project changed = before;
  changed.solver.integrator = Integrator::generalized_alpha;
  changed.stages[0].time_step = 0.005;
  document.change(changed, QStringLiteral("use Δ/2"));
  EXPECT_EQ(document.project(), changed);
  EXPECT_EQ(document.undoStack().undoText(), QStringLiteral("use Δ/2"));
  EXPECT_FALSE(document.isSaved());
  document.undoStack().undo();
  EXPECT_EQ(document.project(), before);
  EXPECT_TRUE(document.isSaved());
  document.undoStack().redo();
  EXPECT_EQ(document.project(), changed);
  EXPECT_EQ(told, 3);
}

TEST_F(DocumentTest, RefusesWhatAFileMayNotHoldAndLosesNothing) {
  document.open(file);
  const Project before = document.project();
  Project changed = before;
  changed.stages[0].time_step = -1;
  EXPECT_THROW(document.change(changed, {}), InputError);
  changed = before;
  changed.materials[0].poisson = 0.5;
  EXPECT_THROW(document.change(changed, {}), InputError);
  EXPECT_EQ(document.project(), before);
  EXPECT_EQ(document.text(), slab);
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(DocumentTest, ChangesWhatTheFileSaysKeyByKey) {
  document.open(file);
  auto json = document.json();
  EXPECT_FALSE(json["materials"]["rock"].contains("damping"));
  json["materials"]["rock"]["damping"] = 0;  // what it is without being said
  document.change(json, QStringLiteral("say it"));
  EXPECT_TRUE(document.json()["materials"]["rock"].contains("damping"));
  EXPECT_EQ(document.undoStack().count(), 1);
  document.change(json, QStringLiteral("say it again"));
  EXPECT_EQ(document.undoStack().count(), 1) << "nothing has changed";
  json["materials"]["rock"]["dampng"] = 1;
  EXPECT_THROW(document.change(json, {}), InputError);
}

TEST_F(DocumentTest, ChangesOfOneGestureAreOneStep) {
  document.open(file);
  document.change(withFriction(document, 31), QStringLiteral("before"));
  const int gesture = document.newGesture();
  for (const double angle : {32.5, 33.0, 34.25})
    document.change(withFriction(document, angle), QStringLiteral("turn"), gesture);
  EXPECT_EQ(document.undoStack().count(), 2);
  document.change(withFriction(document, 35), QStringLiteral("turn"), document.newGesture());
  EXPECT_EQ(document.undoStack().count(), 3);
  document.undoStack().undo();
  EXPECT_EQ(document.project().joints[0].friction_angle, 34.25);
  document.undoStack().undo();
  EXPECT_EQ(document.project().joints[0].friction_angle, 31);
  document.undoStack().redo();
  EXPECT_EQ(document.project().joints[0].friction_angle, 34.25);
}

TEST_F(DocumentTest, CommentsSurviveChangesAndSaving) {
  const std::string text = std::string("// a slab\n") + slab + "// its end\n";
  std::ofstream(file) << text;
  document.open(file);
  document.change(withFriction(document, 33.5), {});
  document.save();
  std::string expected = text;
  expected.replace(expected.find("\"friction_angle\": 30"), 20, "\"friction_angle\": 33.5");
  EXPECT_EQ(read_whole_file(file), expected);
  document.undoStack().undo();
  EXPECT_EQ(document.text(), text);
  document.saveAs(folder / "copy.talus");
  EXPECT_EQ(read_whole_file(folder / "copy.talus"), text);
}

TEST_F(DocumentTest, AProjectThatIsBeingSetUpMayLackWhatARunNeeds) {
  document.show(Project{});
  EXPECT_TRUE(document.isOpen());
  Project changed = document.project();
  changed.joints.emplace_back().name = "J1";
  document.change(changed, QStringLiteral("add joint J1"));
  changed.materials.push_back({.name = "rock", .density = 2600, .young = 1e9, .poisson = 0.2});
  document.change(changed, QStringLiteral("add material rock"));
  document.saveAs(folder / "new.talus");
  EXPECT_THROW(read_project(folder / "new.talus"), InputError) << "a run needs more";
  Document again;
  again.open(folder / "new.talus");
  EXPECT_EQ(again.project(), changed);
}

TEST_F(DocumentTest, WhatWasSelectedAndIsGoneIsSelectedNoMore) {
  document.open(file);
  Project changed = document.project();
  changed.stages.push_back(changed.stages[0]);
  changed.stages[1].name = "more";
  document.change(changed, {});
  document.selection().select({Item::Kind::stage, 1});
  document.undoStack().undo();
  EXPECT_EQ(document.selection().current(), Item{});
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
