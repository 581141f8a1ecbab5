// A window is killed with unsaved work; the next one offers it.
#include <QPainter>
#include <QProcess>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <csignal>

#include "driven_window.hpp"
#include "io/project_file.hpp"
#include "widgets/begin/recovery_offer.hpp"

namespace talus {
namespace {

constexpr double typed_friction = 33;

class Recovered : public DrivenWindow {
 protected:
  void SetUp() override {
    before_ = qgetenv("XDG_STATE_HOME");
    if (!qEnvironmentVariableIsSet("TALUS_TEST_STATE")) qputenv("XDG_STATE_HOME", state_.path().toUtf8());
    DrivenWindow::SetUp();
  }
  void TearDown() override {
    DrivenWindow::TearDown();
    qputenv("XDG_STATE_HOME", before_);
  }
  /// Another program of these tests, in which a window edits the file and waits; it is killed.
  void editAndKill(const std::filesystem::path& file) {
    QProcess other;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("TALUS_TEST_STATE"), QStringLiteral("1"));
    environment.insert(QStringLiteral("TALUS_TEST_FILE"), QString::fromStdString(file.string()));
    other.setProcessEnvironment(environment);
    other.start(QApplication::applicationFilePath(),
                {QStringLiteral("--gtest_also_run_disabled_tests"),
                 QStringLiteral("--gtest_filter=Recovered.DISABLED_EditsAndWaits")});
    QByteArray said;
    ASSERT_TRUE(wait([&] {
      other.waitForReadyRead(20);
      said += other.readAllStandardOutput();
      return said.contains("edited");
    })) << said.toStdString();
    EXPECT_TRUE(leftovers().empty()) << "another living window's work is its own";
    ::kill(static_cast<pid_t>(other.processId()), SIGKILL);
    ASSERT_TRUE(other.waitForFinished());
    ASSERT_EQ(other.exitStatus(), QProcess::CrashExit);
  }
  RecoveryOffer* offered() {
    window->offerRecovery();
    rest(50);
    return window->findChild<RecoveryOffer*>();
  }
  static void click(const QWidget& parent, const char* words) {
    for (auto* button : parent.findChildren<QPushButton*>())
      if (button->text() == QString::fromUtf8(words)) return QTest::mouseClick(button, Qt::LeftButton);
    FAIL() << "no button " << words;
  }

 private:
  QTemporaryDir state_;
  QByteArray before_;
};

/// Not a test: what the other program does.
TEST_F(Recovered, DISABLED_EditsAndWaits) {
  window->open(qEnvironmentVariable("TALUS_TEST_FILE").toStdString());
  Project project = session->project.document().project();
  project.joints[0].friction_angle = typed_friction;
  for (int i = 2; i < 12; ++i) {  // a large change is kept at once
    Joint joint = project.joints[0];
    joint.name = "J" + std::to_string(i);
    project.joints.push_back(joint);
  }
  session->project.document().change(project, QStringLiteral("change joint J1"));
  std::printf("edited\n");
  std::fflush(stdout);
  for (;;) rest(100);
}

TEST_F(Recovered, WorkOfAWindowThatWasKilledIsOfferedAndRecovered) {
  const auto file = slidingCube();
  const std::string saved = write_project(read_project(file));
  editAndKill(file);
  auto* offer = offered();
  ASSERT_NE(offer, nullptr);
  const auto buttons = offer->findChildren<QPushButton*>();
  const auto usual = std::ranges::find_if(buttons, [](const QPushButton* one) { return one->isDefault(); });
  ASSERT_NE(usual, buttons.end());
  EXPECT_EQ((*usual)->text(), QStringLiteral("Recover")) << "what Enter does";
  click(*offer, "Recover");
  ASSERT_TRUE(wait([&] { return session->project.document().isOpen(); }));
  EXPECT_EQ(session->project.document().project().joints[0].friction_angle, typed_friction);
  EXPECT_EQ(session->project.document().file(), file);
  EXPECT_FALSE(session->project.document().isSaved());
  EXPECT_EQ(write_project(read_project(file)), saved) << "its file is written by Save alone";
  wait([&] { return !session->run.job().isBusy(); });
  EXPECT_TRUE(leftovers().empty());
  session->project.save();
  EXPECT_EQ(read_project(file).joints[0].friction_angle, typed_friction);
}

TEST_F(Recovered, LaterOffersItAgainAndDiscardForgetsIt) {
  editAndKill(slidingCube());
  auto* offer = offered();
  ASSERT_NE(offer, nullptr);
  click(*offer, "Later");
  ASSERT_TRUE(wait([&] { return window->findChild<RecoveryOffer*>() == nullptr; }));
  offer = offered();
  ASSERT_NE(offer, nullptr);
  click(*offer, "Discard");
  ASSERT_TRUE(wait([&] { return window->findChild<RecoveryOffer*>() == nullptr; }));
  EXPECT_EQ(offered(), nullptr);
  EXPECT_FALSE(session->project.document().isOpen());
}

/// Not a test: draws the offer over the window, into the folder that TALUS_PICTURES names.
TEST_F(Recovered, DISABLED_DrawsTheOffer) {
  editAndKill(slidingCube());
  for (const bool dark : {false, true}) {
    session->display.setDark(dark);
    for (const QSize& size : {QSize(1280, 720), QSize(1600, 1000)}) {
      window->resize(size);
      auto* offer = offered();
      ASSERT_NE(offer, nullptr);
      QPixmap picture = window->grab();
      QPainter(&picture).drawPixmap((size.width() - offer->width()) / 2, (size.height() - offer->height()) / 2,
                                    offer->grab());
      picture.save(
          QStringLiteral("%1/recovery_%2_%3.png")
              .arg(qEnvironmentVariable("TALUS_PICTURES"), dark ? QStringLiteral("dark") : QStringLiteral("light"))
              .arg(size.width()));
      click(*offer, "Later");
      ASSERT_TRUE(wait([&] { return window->findChild<RecoveryOffer*>() == nullptr; }));
    }
  }
}

}  // namespace
}  // namespace talus
