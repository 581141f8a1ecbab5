#include <gtest/gtest.h>

#include <QApplication>
#include <QSettings>
#include <QTemporaryDir>

#include "widgets/kit/language.hpp"
#include "widgets/kit/theme.hpp"
#include "widgets/view/render_surface.hpp"

namespace {

/// Each test begins as after a first start, whatever was tested before in the same process.
class FirstStart : public testing::EmptyTestEventListener {
  void OnTestStart(const testing::TestInfo&) override {
    QSettings().clear();
    if (talus::theme::now().dark) talus::theme::install(false);
  }
};

}  // namespace

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  // Also when ctest only lists the tests, for which no environment is set.
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  talus::setDefaultSurfaceFormat();
  QApplication app(argc, argv);
  talus::language::keepDecimalPoint();
  QApplication::setApplicationName(QStringLiteral("talus-test"));
  QApplication::setOrganizationName(QStringLiteral("talus-test"));
  QTemporaryDir settings;  // the user's own recent files are no part of a test
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
  // … nor is their unsaved work; a test that plays a second start says where both keep it.
  if (!qEnvironmentVariableIsSet("TALUS_TEST_STATE")) qputenv("XDG_STATE_HOME", settings.path().toUtf8());
  talus::theme::install(false);
  testing::UnitTest::GetInstance()->listeners().Append(new FirstStart);
  return RUN_ALL_TESTS();
}
