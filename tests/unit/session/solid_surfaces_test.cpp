#include "session/solid_surfaces.hpp"

#include <gmock/gmock.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <fstream>

#include "geometry/solid_surface.hpp"
#include "session/session.hpp"

namespace talus {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

const char* const two_boxes = R"({
  "talus": 1, "materials": {"rock": {"density": 2600, "young": 1e9, "poisson": 0.25}},
  "solids": [{"name": "base", "box": {"min": [0, 0, 0], "max": [2, 2, 1]}, "material": "rock", "body": "fixed"},
             {"name": "roof", "box": {"min": [0, 0, 1], "max": [2, 2, 4]}, "material": "rock"}]
})";

class SolidSurfacesTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    static int argc = 1;
    static char name[] = "test_session";
    static char* argv[] = {name, nullptr};
    if (!QCoreApplication::instance()) new QCoreApplication(argc, argv);
  }
  void SetUp() override {
    ASSERT_TRUE(session.begin({.text = two_boxes}, QStringLiteral("boxes")));
    ASSERT_TRUE(rest());
  }
  /// Until nothing is being made any more.
  bool rest() {
    QElapsedTimer timer;
    timer.start();
    while (session.surfaces.isBusy() && timer.elapsed() < 20000)
      QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 10);
    return !session.surfaces.isBusy();
  }
  std::vector<std::string> names() {
    std::vector<std::string> all;
    for (const SolidSurface& surface : *session.surfaces.current()) all.push_back(surface.name);
    return all;
  }
  Session session;
};

TEST_F(SolidSurfacesTest, AreThereBeforeAnythingIsCut) {
  ASSERT_NE(session.surfaces.current(), nullptr);
  EXPECT_THAT(names(), ElementsAre("base", "roof"));
  EXPECT_DOUBLE_EQ(session.surfaces.current()->at(1).volume, 12);
  const auto blocks = session.surfaces.asBlocks();
  ASSERT_THAT(blocks->blocks, SizeIs(2));
  EXPECT_EQ(blocks->blocks[0].body, BodyKind::fixed);
  EXPECT_EQ(blocks->blocks[1].solid, 1);
  EXPECT_THAT(blocks->blocks[1].surface, SizeIs(12));
}

TEST_F(SolidSurfacesTest, FollowTheSolidsAndNothingElse) {
  Project project = session.project.document().project();
  project.materials[0].density = 2700;
  session.project.document().change(project, QStringLiteral("denser"));
  EXPECT_FALSE(session.surfaces.isBusy());
  std::get<BoxShape>(project.solids[1].shape).max.z() = 5;
  session.project.document().change(project, QStringLiteral("higher"));
  EXPECT_TRUE(session.surfaces.isBusy());
  ASSERT_TRUE(rest());
  EXPECT_DOUBLE_EQ(session.surfaces.current()->at(1).volume, 16);
  session.project.document().undoStack().undo();
  ASSERT_TRUE(rest());
  EXPECT_DOUBLE_EQ(session.surfaces.current()->at(1).volume, 12);
}

TEST_F(SolidSurfacesTest, OneThatCannotBeMadeLeavesTheOthersThere) {
  Project project = session.project.document().project();
  project.solids[0].shape = FileShape{"not_there.step"};
  session.project.document().change(project, QStringLiteral("another"));
  ASSERT_TRUE(rest());
  EXPECT_THAT(names(), ElementsAre("roof"));
  ASSERT_THAT(session.surfaces.problems(), SizeIs(1));
  EXPECT_EQ(session.surfaces.problems()[0].place(), "/solids/0");
  EXPECT_EQ(session.surfaces.asBlocks()->blocks[0].solid, 1);
}

TEST_F(SolidSurfacesTest, AProposalIsShownUntilItIsTakenBack) {
  Project project = session.project.document().project();
  project.solids[1].move = {0, 0, 3};
  session.surfaces.propose(project);
  ASSERT_TRUE(rest());
  EXPECT_DOUBLE_EQ(session.surfaces.current()->at(1).max.z(), 7);
  EXPECT_TRUE(session.project.document().project().solids[1].move.isZero());
  session.surfaces.propose({});
  ASSERT_TRUE(rest());
  EXPECT_DOUBLE_EQ(session.surfaces.current()->at(1).max.z(), 4);
}

TEST_F(SolidSurfacesTest, SeveralSolidsAreSelectedTogetherAndGoTogether) {
  Selection& selection = session.project.selection();
  selection.toggleSolid(1);
  selection.toggleSolid(0);
  EXPECT_THAT(selection.solids(), ElementsAre(0, 1));
  EXPECT_TRUE(selection.blocks().empty());
  Project project = session.project.document().project();
  project.solids.pop_back();
  session.project.document().change(project, QStringLiteral("one less"));
  EXPECT_TRUE(selection.solids().empty()) << "one of them is gone";
}

}  // namespace
}  // namespace talus
