#include "screenshot.hpp"

#include <QApplication>
#include <QElapsedTimer>
#include <cstdio>

#include "base/error.hpp"
#include "jobs/solver_job.hpp"
#include "widgets/view/viewport.hpp"

namespace talus {

namespace {

constexpr int bad_input = 2, our_fault = 3;
constexpr int rest_ms = 600;  // the fine drawing comes when the camera has rested
constexpr int patience_ms = 600000;

int complain(int code, const QString& sentence) {
  std::fprintf(stderr, "talus: %s\n", qPrintable(sentence));
  return code;
}

template <class Condition>
bool waitFor(Condition condition, int limitMs) {
  QElapsedTimer timer;
  timer.start();
  while (!condition() && timer.elapsed() < limitMs) QApplication::processEvents(QEventLoop::WaitForMoreEvents, 20);
  return condition();
}

void rest(int ms) {
  QElapsedTimer timer;
  timer.start();
  while (timer.elapsed() < ms) QApplication::processEvents(QEventLoop::AllEvents, 20);
}

}  // namespace

QString readSize(const QString& text, QSize& size) {
  const auto parts = text.split(u'x');
  bool goodWidth = false, goodHeight = false;
  if (parts.size() == 2) size = {parts[0].toInt(&goodWidth), parts[1].toInt(&goodHeight)};
  const bool good = goodWidth && goodHeight && size.width() >= 320 && size.height() >= 240 && size.width() <= 8192 &&
                    size.height() <= 8192;
  return good ? QString() : QStringLiteral("--size: \"%1\" is no size; give one such as 1280x800").arg(text);
}

int takeScreenshot(MainWindow& window, const ScreenshotRequest& request) {
  Session& session = window.session();
  window.show();
  if (!request.file.isEmpty()) {
    if (!session.open(request.file.toStdString())) {
      const Problem& problem = session.messages.problems().back();
      return complain(bad_input, QStringLiteral("%1: %2; %3").arg(problem.place, problem.problem, problem.remedy));
    }
    const auto failed = [&] { return !session.messages.problems().empty(); };
    if (session.playback.isLoading()) waitFor([&] { return session.playback.frame() || failed(); }, patience_ms);
    if (!session.project.system() && !failed()) {
      session.run.mesh();
      waitFor([&] { return !session.run.job().isBusy(); }, patience_ms);
    }
  }
  if (!request.field.isEmpty()) {
    try {
      SceneSettings settings = session.display.settings();
      settings.field = field_named(request.field.toStdString());
      session.display.set(settings);
    } catch (const InputError& error) {
      return complain(bad_input, QString::fromUtf8(error.what()));
    }
  }
  if (!request.time.isEmpty() && !session.playback.times().empty()) {
    bool good = false;
    const double time = request.time.toDouble(&good);
    if (!good) return complain(bad_input, QStringLiteral("--time: \"%1\" is no number of seconds").arg(request.time));
    session.playback.showTime(time);
    waitFor([&] { return !session.playback.isWaiting(); }, patience_ms);
  }
  for (const WorkflowPage page : all_pages)
    if (request.page == QLatin1String(pageKey(page))) session.display.goTo(page);
  if (!request.page.isEmpty() && request.page != QLatin1String(pageKey(session.display.page())))
    return complain(bad_input, QStringLiteral("--page: there is no page \"%1\"; see talus --help").arg(request.page));
  window.viewport().fit();
  window.resize(request.size);
  rest(rest_ms);
  if (!window.grab().save(request.out))
    return complain(bad_input, QStringLiteral("%1: cannot be written; choose another place").arg(request.out));
  return session.messages.problems().empty() ? 0 : our_fault;
}

}  // namespace talus
