#include "widgets/begin/project_preview.hpp"

#include <QPainter>
#include <cstring>

#include "base/error.hpp"
#include "geometry/block_builder.hpp"
#include "render/scene/offscreen.hpp"
#include "render/scene/slope_view.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/text.hpp"
#include "widgets/kit/theme.hpp"

namespace talus {

namespace {

constexpr int pause_ms = 250;  // after the last key, so that a number is drawn once

QImage imageOf(const Image& image) {
  QImage made(image.width, image.height, QImage::Format_RGB888);
  const auto row = static_cast<std::size_t>(image.width) * 3;
  for (int y = 0; y < image.height; ++y)
    std::memcpy(made.scanLine(y), image.rgb.data() + static_cast<std::size_t>(y) * row, row);
  return made;
}

/// Size and height of the writing in pixels of the screen.
ProjectPreview::Drawn drawing(const Project& project, QSize size, double text_height, Theme theme, Progress& progress) {
  ProjectPreview::Drawn drawn;
  try {
    const BlockSystem system = build_blocks(project, ".", progress);
    SceneSettings settings;
    settings.theme = theme;
    settings.text_height = text_height;
    settings.legend = settings.time_stamp = false;
    Scene scene(system, settings);
    look_at_slope(scene, system, nullptr);
    drawn.picture = imageOf(draw_image(scene, size.width(), size.height()));
    drawn.blocks = static_cast<int>(system.blocks.size());
  } catch (const InputError& error) {
    drawn.problem = text(error.problem());
  } catch (const std::exception& error) {
    drawn.problem = text(error.what());
  }
  return drawn;
}

}  // namespace

ProjectPreview::ProjectPreview() {
  setMinimumSize(320, 240);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setAccessibleName(tr("Preview of the project"));
  pause_.setSingleShot(true);
  pause_.setInterval(pause_ms);
  connect(&pause_, &QTimer::timeout, this, &ProjectPreview::draw);
  connect(&job_, &BackgroundJob::ended, this, [this] {
    if (stale_ && !pause_.isActive()) draw();
    update();
  });
}

void ProjectPreview::setProject(std::optional<Project> project) {
  project_ = std::move(project);
  if (!project_) drawn_ = {};
  askAgain();
}

void ProjectPreview::askAgain() {
  stale_ = project_.has_value();
  if (!stale_) return update();
  job_.cancel();
  pause_.start();
  update();
}

void ProjectPreview::draw() {
  if (job_.isBusy() || !project_) return;  // it is drawn when the one before has ended
  stale_ = false;
  const QSize pixels = size() * devicePixelRatioF();
  const double writing = theme::now().type.small * devicePixelRatioF();
  const Theme theme = theme::now().dark ? Theme::dark : Theme::light;
  job_.start<Drawn>(
      [project = *project_, pixels, writing, theme](Progress& progress, const auto& ended) {
        ended(drawing(project, pixels, writing, theme, progress));
      },
      [this](const Drawn& drawn) {
        if (!stale_ && project_) drawn_ = drawn;
        update();
        emit this->drawn();
      });
}

void ProjectPreview::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  askAgain();
}

void ProjectPreview::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.fillRect(rect(), theme::colours().viewBottom);
  if (!drawn_.picture.isNull()) painter.drawImage(rect(), drawn_.picture);
  QString words;
  if (!project_)
    words = tr("Nothing in it yet: materials, joints and solids are added in the window.");
  else if (!drawn_.problem.isEmpty())
    words = drawn_.problem;
  else if (drawn_.picture.isNull())
    words = tr("Cutting …");
  painter.setPen(theme::colours().textMuted);
  painter.setFont(theme::font(theme::now().type.body));
  painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap, words);
  if (words.isEmpty())
    painter.drawText(rect().adjusted(12, 8, -12, -8), Qt::AlignRight | Qt::AlignTop,
                     numbers::counted(drawn_.blocks, "block"));
}

}  // namespace talus
