#include "widgets/view/timeline.hpp"

#include <QComboBox>
#include <QHelpEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QToolButton>
#include <QToolTip>
#include <algorithm>

#include "document/document.hpp"
#include "model/stage_length.hpp"
#include "session/current_run.hpp"
#include "session/playback.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"
#include "widgets/view/field_chooser.hpp"

namespace talus {

namespace {

constexpr int tick_ms = 40;
constexpr double speeds[] = {0.1, 0.25, 0.5, 1, 2, 4, 8};
constexpr int real_time = 3;  // index into speeds
constexpr double inset = 8, track_y = 19;
constexpr int name_size = 10;
constexpr double band_name_height = 12, beside_name = 2;  // pixels

int frameAt(const std::vector<double>& times, double time) {
  const auto after = std::upper_bound(times.begin(), times.end(), time + 1e-9);
  return std::max(0, static_cast<int>(after - times.begin()) - 1);
}

}  // namespace

TimelineTrack::TimelineTrack(Document& document, CurrentRun& run, Playback& playback)
    : document_(document), run_(run), playback_(playback) {
  setMinimumWidth(140);
  setAccessibleName(tr("Timeline"));
  connect(&playback_, &Playback::framesChanged, this, qOverload<>(&QWidget::update));
  connect(&playback_, &Playback::frameChanged, this, qOverload<>(&QWidget::update));
  connect(&run_, &CurrentRun::reportChanged, this, qOverload<>(&QWidget::update));
}

double TimelineTrack::end() const {
  const auto& times = playback_.times();
  double last = times.empty() ? 1 : times.back();
  if (!playback_.isLive()) return std::max(last, 1e-9);
  double planned = 0;  // a run that goes on will get there
  for (const Stage& stage : document_.project().stages) planned += length_of(stage);
  return std::max(last, planned);
}

double TimelineTrack::xAt(double time) const { return inset + (width() - 2 * inset) * time / end(); }

std::vector<TimelineTrack::Band> TimelineTrack::bands() const {
  std::vector<Band> made;
  const auto& steps = run_.steps();
  for (auto first = steps.begin(), after = first; first != steps.end(); first = after) {
    after = std::upper_bound(first, steps.end(), first->stage,
                             [](int stage, const StepReport& step) { return stage < step.stage; });
    const auto stage = static_cast<size_t>(first->stage);
    const QString name = stage < run_.stageNames().size() ? text(run_.stageNames()[stage]) : QString();
    const double end = std::prev(after)->time;
    if (made.empty() || made.back().name != name) made.push_back({made.empty() ? 0 : made.back().end, end, name});
    made.back().end = end;
  }
  if (made.empty()) made.push_back({0, end(), {}});
  return made;
}

std::vector<TimelineTrack::StageName> TimelineTrack::stageNames() const {
  const QFontMetrics metrics(theme::font(name_size, QFont::Medium), this);
  const auto all = bands();
  std::vector<StageName> made;
  for (const Band& band : all) {
    const double left = xAt(band.begin) + beside_name, wide = metrics.horizontalAdvance(band.name);
    const double limit = &band == &all.back() ? width() : xAt(band.end) - beside_name;
    if (!band.name.isEmpty() && left + wide <= limit)
      made.push_back({{left, 0, wide + 1, band_name_height}, band.name});
  }
  return made;
}

void TimelineTrack::paintEvent(QPaintEvent*) {
  const Colours& c = theme::colours();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(c.pressed);
  painter.drawRoundedRect(QRectF(xAt(0), track_y - 2, xAt(end()) - xAt(0), 4), 2, 2);
  painter.setFont(theme::font(name_size, QFont::Medium));
  const double now = playback_.time();
  for (const Band& band : bands()) {
    const QRectF whole(xAt(band.begin) + 1, track_y - 2, std::max(1.0, xAt(band.end) - xAt(band.begin) - 2), 4);
    painter.setPen(Qt::NoPen);
    painter.setBrush(c.borderStrong);
    painter.drawRoundedRect(whole, 2, 2);
    if (now > band.begin) {
      painter.setBrush(c.accent);
      painter.drawRoundedRect(QRectF(whole.left(), whole.top(), std::min(whole.right(), xAt(now)) - whole.left(), 4), 2,
                              2);
    }
  }
  painter.setPen(c.textMuted);
  for (const StageName& name : stageNames()) painter.drawText(name.place, Qt::AlignLeft | Qt::AlignVCenter, name.words);
  painter.setFont(theme::font(10));
  const auto& events = run_.events();
  for (size_t i = 0; i < events.size(); ++i) {
    const QPointF tip(xAt(events[i].time), track_y + 9);
    painter.setPen(Qt::NoPen);
    painter.setBrush(c.textMuted);
    painter.drawPolygon(QPolygonF{tip, tip + QPointF(-3.5, 5), tip + QPointF(3.5, 5)});
    // A crowded mark keeps its triangle and tells in its tooltip.
    const QString what = text(events[i].what);
    const double wide = painter.fontMetrics().horizontalAdvance(what) + 10;
    const double limit = i + 1 < events.size() ? xAt(events[i + 1].time) - 6 : width();
    if (tip.x() + wide > limit) continue;
    painter.setPen(c.textMuted);
    painter.drawText(QRectF(tip.x() + 6, track_y + 8, wide, 13), Qt::AlignVCenter, what);
  }
  if (!playback_.frame()) return;
  painter.setPen(QPen(c.accent, 2));
  painter.setBrush(c.surface);
  painter.drawEllipse(QPointF(xAt(now), track_y), 7, 7);
}

void TimelineTrack::scrubTo(double x) {
  const auto& times = playback_.times();
  if (times.empty()) return;
  const double time = std::clamp((x - inset) / std::max(1.0, width() - 2 * inset), 0.0, 1.0) * end();
  playback_.showTime(time);
}

void TimelineTrack::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) scrubTo(event->position().x());
}

void TimelineTrack::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons().testFlag(Qt::LeftButton)) scrubTo(event->position().x());
}

bool TimelineTrack::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  for (const Event& mark : run_.events()) {
    if (std::abs(xAt(mark.time) - help->pos().x()) > 6) continue;
    QToolTip::showText(help->globalPos(), QStringLiteral("%1 s: %2").arg(numbers::fixed(mark.time, 2), text(mark.what)),
                       this);
    return true;
  }
  for (const Band& band : bands()) {
    if (band.name.isEmpty() || help->pos().x() < xAt(band.begin) || help->pos().x() > xAt(band.end)) continue;
    QToolTip::showText(help->globalPos(), band.name, this);
    return true;
  }
  QToolTip::hideText();
  return true;
}

Timeline::Timeline(Document& document, CurrentRun& run, Playback& playback) : playback_(playback) {
  setProperty("plane", "bottom");
  setFixedHeight(44);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 0, 10, 0);
  row->setSpacing(1);
  back_ = makeTool(QStringLiteral("step-back"), tr("Previous frame (Left)"));
  play_ = makeTool(QStringLiteral("play"), tr("Play (Space)"));
  forward_ = makeTool(QStringLiteral("step"), tr("Next frame (Right)"));
  loop_ = makeTool(QStringLiteral("loop"), tr("Loop (L)"), true);
  for (auto* tool : {back_, play_, forward_, loop_}) row->addWidget(tool);
  row->addSpacing(6);
  track_ = new TimelineTrack(document, run, playback);
  row->addWidget(track_, 1);
  row->addSpacing(8);
  time_ = makeLabel({}, "strong");
  total_ = makeLabel({}, "small");
  row->addWidget(time_);
  row->addSpacing(4);
  row->addWidget(total_);
  row->addSpacing(8);
  QStringList names;
  for (double speed : speeds) names << tr("%1×").arg(speed);
  names[real_time] = tr("1× real");
  speed_ = makeCombo(names, tr("Speed of play"));
  speed_->setToolTip(tr("Model time a second of watching"));
  speed_->setCurrentIndex(real_time);
  speed_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  row->addWidget(speed_);

  timer_.setInterval(tick_ms);
  connect(&timer_, &QTimer::timeout, this, &Timeline::tick);
  connect(play_, &QToolButton::clicked, this, &Timeline::togglePlay);
  connect(back_, &QToolButton::clicked, this, [this] { stepBy(-1); });
  connect(forward_, &QToolButton::clicked, this, [this] { stepBy(1); });
  connect(speed_, &QComboBox::currentIndexChanged, this, [this] {
    playedFrom_ = playback_.time();
    clock_.restart();
    emit speedChanged();
  });
  connect(&playback_, &Playback::framesChanged, this, &Timeline::refresh);
  connect(&playback_, &Playback::frameChanged, this, &Timeline::refresh);
  refresh();
}

void Timeline::setPlaying(bool plays) {
  if (plays == isPlaying()) return;
  if (plays)
    timer_.start();
  else
    timer_.stop();
  play_->setIcon(theme::icon(plays ? QStringLiteral("pause") : QStringLiteral("play")));
  play_->setToolTip(plays ? tr("Pause (Space)") : tr("Play (Space)"));
}

void Timeline::togglePlay() {
  const auto& times = playback_.times();
  if (isPlaying() || times.size() < 2) {
    setPlaying(false);
    return;
  }
  if (playback_.number() == static_cast<int>(times.size()) - 1) playback_.showFrame(0);
  playedFrom_ = times[static_cast<size_t>(std::max(0, playback_.number()))];
  clock_.start();
  setPlaying(true);
}

void Timeline::tick() {
  const auto& times = playback_.times();
  if (times.empty()) {
    setPlaying(false);
    return;
  }
  if (playback_.isWaiting()) return;  // a slow disk plays with fewer pictures, not late
  const double time = playedFrom_ + speed() * static_cast<double>(clock_.elapsed()) / 1000;
  const int number = frameAt(times, time);
  if (number != playback_.number()) playback_.showFrame(number);
  if (time < times.back()) return;
  if (loop_->isChecked()) {
    playedFrom_ = times.front();
    clock_.restart();
  } else {
    setPlaying(false);
  }
}

void Timeline::stepBy(int frames) {
  setPlaying(false);
  playback_.showFrame(playback_.number() + frames);
}

void Timeline::goToFirst() {
  setPlaying(false);
  playback_.showFrame(0);
}

void Timeline::goToLast() {
  setPlaying(false);
  playback_.showFrame(static_cast<int>(playback_.times().size()) - 1);
}

void Timeline::refresh() {
  const auto& times = playback_.times();
  const bool any = !times.empty();
  for (auto* tool : {back_, play_, forward_, loop_}) tool->setEnabled(any);
  speed_->setEnabled(any);
  if (!any) setPlaying(false);
  time_->setText(any ? tr("%1 s").arg(numbers::fixed(playback_.time(), 2)) : QStringLiteral("–"));
  total_->setText(any ? tr("of %1 s").arg(numbers::figure(std::max(times.back(), playback_.time()), 4))
                      : tr("no frames yet"));
  track_->update();
}

double Timeline::speed() const { return speeds[std::max(0, speed_->currentIndex())]; }

}  // namespace talus
