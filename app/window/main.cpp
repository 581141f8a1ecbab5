// talus [PROJECT|RESULTS]: the window.
// talus --screenshot OUT.png [--size WxH] [--theme light|dark] [--language en|de] [--page PAGE] [--field FIELD] [--time
// SECONDS]
// [--select PLACE] [--new TEMPLATE] [PROJECT|RESULTS]: a picture of the window and out, for regression tests; with
// QT_QPA_PLATFORM=offscreen it needs no display.
#include <QApplication>
#include <QCommandLineParser>
#include <QSettings>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string_view>

#include "base/memory_limit.hpp"
#include "screenshot.hpp"
#include "version/version.hpp"
#include "widgets/kit/language.hpp"
#include "widgets/kit/theme.hpp"
#include "widgets/view/render_surface.hpp"
#include "widgets/window/main_window.hpp"

namespace {

constexpr int bad_usage = 2;

int complain(const QString& sentence) {
  std::fprintf(stderr, "talus: %s\n", qPrintable(sentence));
  return bad_usage;
}

/// Whether only words are asked for: they need no display, which a QApplication does not start without.
bool asksForWords(int argc, char** argv) {
  constexpr std::string_view words[] = {"-h", "--help", "--help-all", "-v", "--version"};
  return std::any_of(argv + 1, argv + argc, [&](const char* argument) {
    return std::find(std::begin(words), std::end(words), argument) != std::end(words);
  });
}

/// Whether Qt would find nothing to draw on, which it ends by a crash.
bool lacksDisplay(int argc, char** argv) {
  const bool told = std::any_of(argv + 1, argv + argc, [](std::string_view argument) {
    return argument.starts_with("-platform") || argument.starts_with("--platform");
  });
  return !told && !std::getenv("DISPLAY") && !std::getenv("WAYLAND_DISPLAY") && !std::getenv("QT_QPA_PLATFORM");
}

}  // namespace

int main(int argc, char** argv) {
  if (!asksForWords(argc, argv) && lacksDisplay(argc, argv))
    return complain(
        QStringLiteral("there is no display; talus-cli needs none, and with QT_QPA_PLATFORM=offscreen "
                       "talus --screenshot neither"));
  talus::setDefaultSurfaceFormat();
  const std::unique_ptr<QCoreApplication> app(asksForWords(argc, argv) ? new QCoreApplication(argc, argv)
                                                                       : new QApplication(argc, argv));
  talus::language::keepDecimalPoint();
  QApplication::setApplicationName(QStringLiteral("talus"));
  QApplication::setOrganizationName(QStringLiteral("talus"));
  QGuiApplication::setDesktopFileName(QStringLiteral("talus"));  // by which a desktop finds name and icon
  QSettings::setDefaultFormat(QSettings::IniFormat);

  QCommandLineParser parser;
  parser.setApplicationDescription(QStringLiteral("Rock slopes that come apart along joints."));
  parser.addHelpOption();
  const QCommandLineOption versionOption({QStringLiteral("v"), QStringLiteral("version")},
                                         QStringLiteral("Prints the version, what it was built from, and leaves"));
  parser.addPositionalArgument(QStringLiteral("file"), QStringLiteral("A .talus project or a results folder."));
  const QCommandLineOption themeOption(QStringLiteral("theme"), QStringLiteral("light or dark"),
                                       QStringLiteral("name"));
  const QCommandLineOption pageOption(
      {QStringLiteral("page"), QStringLiteral("step")},  // "step" is what it was called before
      QStringLiteral("geometry, joints, blocks, mesh, materials, loads, stages, solve or results"),
      QStringLiteral("name"));
  const QCommandLineOption sizeOption(QStringLiteral("size"), QStringLiteral("Size of the window, pixels"),
                                      QStringLiteral("WxH"), QStringLiteral("1280x800"));
  const QCommandLineOption fieldOption(QStringLiteral("field"), QStringLiteral("Colours the blocks of results"),
                                       QStringLiteral("name"));
  const QCommandLineOption timeOption(QStringLiteral("time"), QStringLiteral("Shows the frame nearest to this moment"),
                                      QStringLiteral("seconds"));
  const QCommandLineOption selectOption(QStringLiteral("select"),
                                        QStringLiteral("Selects a thing by its place: /materials/rock, /stages/0"),
                                        QStringLiteral("place"));
  const QCommandLineOption screenshotOption(
      QStringLiteral("screenshot"), QStringLiteral("Write a picture of the window and leave"), QStringLiteral("PNG"));
  const QCommandLineOption newOption(
      QStringLiteral("new"), QStringLiteral("Begins a project from this template; talus-cli new --list names them"),
      QStringLiteral("template"));
  const QCommandLineOption languageOption(QStringLiteral("language"),
                                          QStringLiteral("en or de; without it, as chosen or as the system has it"),
                                          QStringLiteral("code"));
  const QCommandLineOption memoryOption(
      QStringLiteral("max-memory"),
      QStringLiteral("What cutting, meshing and solving may hold; without it, what the machine has free"),
      QStringLiteral("16GB"));
  parser.addOptions({memoryOption, versionOption, newOption, languageOption, themeOption, pageOption, sizeOption,
                     fieldOption, timeOption, selectOption, screenshotOption});
  parser.process(*app);
  if (parser.isSet(versionOption)) return std::puts(talus::version_text("talus").c_str()) < 0 ? bad_usage : 0;

  QSettings settings;
  QString themeName = settings.value(QStringLiteral("theme"), QStringLiteral("light")).toString();
  if (parser.isSet(themeOption)) themeName = parser.value(themeOption);
  if (themeName != QLatin1String("light") && themeName != QLatin1String("dark"))
    return complain(QStringLiteral("--theme: there is no theme \"%1\"; give light or dark").arg(themeName));
  if (const QString code = parser.value(languageOption); !talus::language::install(code) && !code.isEmpty())
    return complain(QStringLiteral("--language: \"%1\" is not spoken; give en or de").arg(code));
  if (parser.isSet(memoryOption)) {
    const auto bytes = talus::bytes_from(parser.value(memoryOption).toStdString());
    if (!bytes) return complain(QStringLiteral("--max-memory is no size; give it as 16GB"));
    talus::set_memory_limit(*bytes);
  }
  if (parser.positionalArguments().size() > 1) return complain(QStringLiteral("one file at a time; see talus --help"));
  talus::theme::install(themeName == QLatin1String("dark"));

  talus::ScreenshotRequest request;
  request.out = parser.value(screenshotOption);
  request.file = parser.positionalArguments().value(0);
  request.page = parser.value(pageOption);
  request.field = parser.value(fieldOption);
  request.time = parser.value(timeOption);
  request.select = parser.value(selectOption);
  request.begin = parser.value(newOption);
  if (const QString wrong = talus::checkTemplate(request.begin); !wrong.isEmpty()) return complain(wrong);
  if (const QString wrong = talus::readSize(parser.value(sizeOption), request.size); !wrong.isEmpty())
    return complain(wrong);

  talus::MainWindow window;
  window.resize(request.size);
  if (parser.isSet(screenshotOption)) return talus::takeScreenshot(window, request);
  window.present(parser.isSet(sizeOption) ? std::optional(request.size) : std::nullopt);
  if (!request.file.isEmpty()) window.open(request.file.toStdString());
  if (!request.begin.isEmpty()) window.newProject(request.begin.toStdString());
  window.offerRecovery();
  const int status = QApplication::exec();
  settings.setValue(QStringLiteral("theme"),
                    talus::theme::now().dark ? QStringLiteral("dark") : QStringLiteral("light"));
  return status;
}
