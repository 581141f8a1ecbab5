// Unsaved work outlives the program: also one that is killed.
#include "document/recovery.hpp"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <csignal>
#include <fstream>

#include "base/error.hpp"
#include "document/autosave.hpp"
#include "io/project_file.hpp"

namespace talus {
namespace {

Project withName(const std::string& name) {
  Project project;
  project.name = name;
  return project;
}

class RecoveryTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    static int argc = 1;
    static char name[] = "test_document";
    static char* argv[] = {name, nullptr};
    if (!QCoreApplication::instance()) new QCoreApplication(argc, argv);
  }
  void SetUp() override {
    state = std::filesystem::temp_directory_path() / ("talus_state_" + std::to_string(::getpid()));
    std::filesystem::create_directories(state);
    qputenv("XDG_STATE_HOME", QByteArray::fromStdString(state.string()));
  }
  void TearDown() override { std::filesystem::remove_all(state); }

  /// Works off events until the condition holds.
  template <class Condition>
  static bool wait(Condition condition) {
    QElapsedTimer timer;
    timer.start();
    while (!condition() && timer.elapsed() < 5000) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 10);
    return condition();
  }
  /// How many projects are kept, by living windows or by none.
  std::size_t kept() const {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(recoveryFolder()))
      count += entry.path().extension() == ".json";
    return count;
  }

  std::filesystem::path state;
};

TEST_F(RecoveryTest, AProcessThatIsKilledLeavesItsUnsavedWork) {
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    Document document;
    Autosave autosave(document);
    document.begin({.text = write_project(withName("Killed")), .file = "/home/slope.talus"});
    const char done = 1;
    if (::write(ready[1], &done, 1) != 1) ::_exit(1);
    for (;;) ::pause();
  }
  char done = 0;
  ASSERT_EQ(::read(ready[0], &done, 1), 1);
  EXPECT_EQ(kept(), 1U);
  EXPECT_TRUE(leftovers().empty()) << "its window is alive";
  ::kill(child, SIGKILL);
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));

  const auto found = leftovers();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].name.toStdString(), "Killed");
  EXPECT_EQ(found[0].draft.file, "/home/slope.talus");
  EXPECT_LT(std::abs(found[0].when.secsTo(QDateTime::currentDateTime())), 60);
  EXPECT_TRUE(leftovers().empty()) << "it has been offered to one window already";

  Document document;
  document.begin(found[0].draft);
  EXPECT_EQ(document.project(), withName("Killed"));
  EXPECT_FALSE(document.isSaved());
  found[0].discard();
  EXPECT_EQ(kept(), 0U);
}

TEST_F(RecoveryTest, WhatIsPutOffIsOfferedAgain) {
  const auto file = recoveryFolder() / "gone.json";
  std::filesystem::create_directories(recoveryFolder());
  std::ofstream(file) << R"({"text": "{}", "name": "Slope", "when": "2026-01-02T03:04:05"})";
  std::ofstream(recoveryFolder() / "broken.json") << "{\"te";
  { EXPECT_EQ(leftovers().size(), 1U); }
  EXPECT_EQ(leftovers().size(), 1U);
}

TEST_F(RecoveryTest, AWindowThatEndsInOrderLeavesNothing) {
  {
    Document document;
    Autosave autosave(document);
    document.begin({.text = write_project(withName("Slope"))});
    EXPECT_EQ(kept(), 1U) << "a project that is in no file is kept at once";
  }
  EXPECT_EQ(kept(), 0U);
}

TEST_F(RecoveryTest, ASmallChangeIsKeptAfterAWhileALargeOneAtOnce) {
  Document document;
  Autosave autosave(document, 100);
  document.begin({.text = write_project(withName("Slope")), .isWork = false});
  EXPECT_EQ(kept(), 0U) << "nothing would be lost";
  document.change(withName("Slope 2"), QStringLiteral("rename"));
  EXPECT_EQ(kept(), 0U);
  EXPECT_TRUE(wait([&] { return kept() == 1; }));
  document.undoStack().undo();
  EXPECT_EQ(kept(), 0U) << "it is as it was begun";
  document.change(withName(std::string(300, 'x')), QStringLiteral("rename"));
  EXPECT_EQ(kept(), 1U);
}

TEST_F(RecoveryTest, WhatIsSavedIsKeptNoLonger) {
  Document document;
  Autosave autosave(document);
  document.begin({.text = write_project(withName("Slope"))});
  ASSERT_EQ(kept(), 1U);
  document.saveAs(state / "slope.talus");
  EXPECT_EQ(kept(), 0U);
  EXPECT_TRUE(document.isSaved());
}

TEST_F(RecoveryTest, AFolderThatCannotBeWrittenIsToldOnce) {
  std::ofstream(state / "file") << "in the way";
  qputenv("XDG_STATE_HOME", QByteArray::fromStdString((state / "file").string()));
  Document document;
  Autosave autosave(document, 1);
  int told = 0;
  QObject::connect(&autosave, &Autosave::failed, [&](const InputError&) { ++told; });
  document.begin({.text = write_project(withName("Slope"))});
  EXPECT_EQ(told, 1);
  document.change(withName(std::string(300, 'x')), QStringLiteral("rename"));
  EXPECT_EQ(told, 1);
}

}  // namespace
}  // namespace talus
