#include "session/session.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <QCoreApplication>
#include <fstream>

#include "base/error.hpp"
#include "jobs/solver_job.hpp"

namespace talus {
namespace {

const char* const slab = R"({
  "talus": 1, "name": "Slab",
  "materials": {"rock": {"density": 2600, "young": 1e9, "poisson": 0.25}},
  "joints": {"J1": {"friction_angle": 30}}, "default_joint": "J1",
  "solids": [{"name": "base", "box": {"min": [0, 0, 0], "max": [2, 2, 1]}, "material": "rock"}],
  "monitors": [{"name": "P1", "block": "base", "at": [1, 1, 1]}],
  "stages": [{"name": "wait", "type": "dynamic", "time_step": 0.01, "steps": 2}]
})";

/// A tetrahedron of one block.
BlockSystem one_block() {
  Block block;
  block.name = "base";
  block.mesh = {{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}, {{0, 1, 2, 3}}};
  block.surface = {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{0, 3, 2}}};
  return {.blocks = {block}, .joint_names = {}};
}

/// All nodes moved by this, m.
std::shared_ptr<const Frame> frame(double time, double moved) {
  Frame made;
  made.time = time;
  made.displacement.assign(4, Vec3(moved, 0, 0));
  made.velocity.assign(4, Vec3::Zero());
  return std::make_shared<const Frame>(std::move(made));
}

class SessionTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    static int argc = 1;
    static char name[] = "test_session";
    static char* argv[] = {name, nullptr};
    if (!QCoreApplication::instance()) new QCoreApplication(argc, argv);
  }
  void SetUp() override {
    folder = std::filesystem::temp_directory_path() / ("talus_session_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "slab.talus") << slab;
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  /// As a run that goes on brings them.
  void bring(std::initializer_list<std::shared_ptr<const Frame>> frames) { session.playback.add(frames); }

  std::filesystem::path folder;
  Session session;
};

TEST_F(SessionTest, OpensAProjectAndForgetsTheOneBefore) {
  session.messages.add({Problem::Severity::error, QStringLiteral("here"), QStringLiteral("wrong"), {}, {}});
  session.display.goTo(WorkflowPage::stages);
  int opened = 0;
  QObject::connect(&session.project, &CurrentProject::opened, [&] {
    ++opened;
    EXPECT_EQ(session.project.system(), nullptr) << "all of the one before is gone by now";
    EXPECT_TRUE(session.messages.problems().empty());
    EXPECT_EQ(session.run.monitorNames(), std::vector<std::string>{"P1"});
  });
  session.project.setSystem(std::make_shared<const BlockSystem>(one_block()));
  ASSERT_TRUE(session.open(folder / "slab.talus"));
  EXPECT_EQ(opened, 1);
  EXPECT_EQ(session.display.page(), WorkflowPage::geometry);
  EXPECT_EQ(session.run.stageNames(), std::vector<std::string>{"wait"});
  EXPECT_TRUE(session.run.whyNotSolve().isEmpty());
}

TEST_F(SessionTest, KeepsWhatIsOpenWhenAFileCannotBeRead) {
  ASSERT_TRUE(session.open(folder / "slab.talus"));
  EXPECT_FALSE(session.open(folder / "nothing.talus"));
  EXPECT_FALSE(session.open(folder));
  ASSERT_EQ(session.messages.problems().size(), 2u);
  EXPECT_TRUE(session.messages.problems()[0].place.startsWith(QStringLiteral("nothing.talus: ")));
  EXPECT_EQ(session.project.document().name(), QStringLiteral("Slab"));
}

TEST_F(SessionTest, FollowsALiveRunUntilAnEarlierFrameIsChosen) {
  session.playback.beginRun();
  bring({frame(0, 0), frame(1, 0.5)});
  EXPECT_EQ(session.playback.number(), 1);
  EXPECT_DOUBLE_EQ(session.playback.time(), 1);
  session.playback.showTime(0.4);
  EXPECT_EQ(session.playback.number(), 0);
  bring({frame(2, 1)});
  EXPECT_EQ(session.playback.number(), 0) << "it is looked at";
  session.playback.showFrame(99);
  bring({frame(3, 2)});
  EXPECT_EQ(session.playback.number(), 3) << "the newest is followed again";
  EXPECT_EQ(session.playback.times(), (std::vector<double>{0, 1, 2, 3}));
}

TEST_F(SessionTest, FramesAreOutdatedByAnEdit) {
  ASSERT_TRUE(session.open(folder / "slab.talus"));
  session.playback.beginRun();
  EXPECT_TRUE(session.playback.isCurrent());
  int told = 0;
  QObject::connect(&session.playback, &Playback::framesChanged, [&] { ++told; });
  Project changed = session.project.document().project();
  changed.joints[0].friction_angle = 20;
  session.project.document().change(changed, {});
  EXPECT_FALSE(session.playback.isCurrent());
  EXPECT_EQ(told, 1);
}

TEST_F(SessionTest, TheLegendSpansTheFramesSeenSoFarOrTheOneInView) {
  session.project.setSystem(std::make_shared<const BlockSystem>(one_block()));
  SceneSettings settings = session.display.settings();
  settings.field = field_named("displacement");
  session.display.set(settings);
  session.playback.beginRun();
  std::optional<ValueRange> told;
  QObject::connect(&session.playback, &Playback::frameChanged, [&] { told = session.display.settings().range; });
  bring({frame(0, 0), frame(1, 5)});
  EXPECT_EQ(told, (ValueRange{0, 5})) << "known before widgets are told of the frame";
  session.playback.showFrame(0);
  EXPECT_EQ(session.display.settings().range, (ValueRange{0, 5}));
  session.display.setRangeFollowsRun(false);
  EXPECT_FALSE(session.display.settings().range);
  session.display.setRangeFollowsRun(true);
  settings = session.display.settings();
  settings.field = field_named("velocity");
  session.display.set(settings);
  EXPECT_EQ(session.display.settings().range, (ValueRange{0, 1})) << "of another field";
  session.playback.clear();
  EXPECT_FALSE(session.display.settings().range);
}

TEST_F(SessionTest, ATroubleIsShownWithItsBlocks) {
  session.project.setSystem(std::make_shared<const BlockSystem>(one_block()));
  int wanted = 0;
  QObject::connect(&session.display, &Display::troubleWanted, [&] { ++wanted; });
  ConvergenceTrouble trouble;
  trouble.blocks = {"base", "none of that name"};
  session.display.showTrouble(trouble);
  EXPECT_EQ(session.project.selection().blocks(), std::vector<int>{0});
  EXPECT_EQ(wanted, 1);
}

TEST_F(SessionTest, NoRunMayReplaceFramesThatAreBeingWritten) {
  ASSERT_TRUE(session.open(folder / "slab.talus"));
  session.playback.setExporting(true);
  EXPECT_EQ(session.run.whyNotSolve(), QStringLiteral("The results are being exported"));
  session.solve();
  EXPECT_FALSE(session.run.job().isBusy());
  EXPECT_EQ(session.display.page(), WorkflowPage::geometry);
  session.playback.setExporting(false);
  EXPECT_TRUE(session.run.whyNotSolve().isEmpty());
}

TEST(Messages, ProblemsOfARunGoWithIt) {
  Messages messages;
  int added = 0;
  QString line;
  QObject::connect(&messages, &Messages::problemAdded, [&] { ++added; });
  QObject::connect(&messages, &Messages::logged, [&](const QString& words) { line = words; });
  messages.add(problemOf(InputError("joint J1", "is steep", "turn it")));
  EXPECT_EQ(line, QStringLiteral("joint J1: is steep; turn it"));
  messages.add(problemOf(InputError("run", "did not converge", "take shorter steps"), Problem::Of::run));
  EXPECT_EQ(added, 2);
  messages.settle(Problem::Of::run);
  ASSERT_EQ(messages.problems().size(), 1u);
  EXPECT_EQ(messages.problems()[0].place, QStringLiteral("joint J1"));
}

}  // namespace
}  // namespace talus
