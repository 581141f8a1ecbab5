#include "screenshot.hpp"

#include <QApplication>
#include <QElapsedTimer>
#include <QPainter>
#include <cstdio>

#include "base/error.hpp"
#include "document/item_place.hpp"
#include "templates/templates.hpp"
#include "widgets/begin/new_dialog.hpp"
#include "widgets/begin/project_preview.hpp"
#include "widgets/view/viewport.hpp"

namespace talus {

namespace {

constexpr int bad_input = 2, our_fault = 3;
constexpr int rest_ms = 600;  // the fine drawing comes when the camera has rested
constexpr int patience_ms = 600000;
constexpr int smallest_file = 0;  // of a PNG's "quality"

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

/// The window, and over it the dialog that is open.
QPixmap pictureOf(QWidget& window) {
  QPixmap picture = window.grab();
  if (QWidget* dialog = QApplication::activeModalWidget()) {
    const QPixmap over = dialog->grab();
    QPainter painter(&picture);
    painter.fillRect(picture.rect(), QColor(0, 0, 0, 70));
    painter.drawPixmap((window.width() - dialog->width()) / 2, (window.height() - dialog->height()) / 2, over);
  }
  return picture;
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

QString checkTemplate(const QString& key) {
  try {
    if (!key.isEmpty() && key != QLatin1String(empty_key)) template_named(key.toStdString());
    return {};
  } catch (const InputError& error) {
    return QStringLiteral("--new: ") + QString::fromUtf8(error.what());
  }
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
    waitFor([&] { return !session.isOpening(); }, patience_ms);
    if (session.playback.isLoading()) waitFor([&] { return session.playback.frame() || failed(); }, patience_ms);
    if (!session.project.system() && !failed()) {
      session.run.mesh();
      waitFor([&] { return !session.run.isBusy(); }, patience_ms);
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
  if (!request.select.isEmpty()) {
    const auto& project = session.project.document().json();
    const Item item = itemAt(nlohmann::ordered_json::json_pointer(request.select.toStdString()), project);
    if (item == Item{})
      return complain(bad_input, QStringLiteral("--select: the project has nothing at \"%1\"").arg(request.select));
    session.project.selection().select(item);
  }
  window.viewport().fit();
  window.resize(request.size);
  if (!request.begin.isEmpty()) {
    window.newProject(request.begin.toStdString());
    rest(rest_ms);
    waitFor([&] { return window.findChild<ProjectPreview*>()->isUpToDate(); }, patience_ms);
  }
  rest(rest_ms);
  if (!pictureOf(window).save(request.out, nullptr, smallest_file))
    return complain(bad_input, QStringLiteral("%1: cannot be written; choose another place").arg(request.out));
  return session.messages.problems().empty() ? 0 : our_fault;
}

}  // namespace talus
