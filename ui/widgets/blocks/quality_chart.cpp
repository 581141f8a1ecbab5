#include "widgets/blocks/quality_chart.hpp"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <numeric>

#include "widgets/kit/numbers.hpp"
#include "widgets/kit/theme.hpp"

namespace talus {

namespace {

constexpr double left_margin = 8, right_margin = 8, top_margin = 18, foot = 18;
constexpr int labels_below = 5;

}  // namespace

QualityChart::QualityChart(QWidget* parent) : QWidget(parent) {
  setMinimumSize(180, 90);
  setMouseTracking(true);
  setAccessibleName(tr("How well shaped the tetrahedra are"));
}

void QualityChart::show(const Histogram& histogram, double poor, int decimals, const QString& unit) {
  histogram_ = histogram;
  poor_ = poor;
  decimals_ = decimals;
  unit_ = unit;
  const long poorOnes = std::accumulate(histogram.counts.begin(),
                                        histogram.counts.begin() + static_cast<long>(histogram.bin_of(poor)), 0L);
  setAccessibleDescription(
      tr("%1 tetrahedra, %2 of them below %3").arg(count()).arg(poorOnes).arg(numbers::fixed(poor, decimals)));
  update();
}

void QualityChart::clear() {
  histogram_.counts.clear();
  update();
}

long QualityChart::count() const { return std::accumulate(histogram_.counts.begin(), histogram_.counts.end(), 0L); }

QRectF QualityChart::plot() const { return QRectF(rect()).adjusted(left_margin, top_margin, -right_margin, -foot); }

QRectF QualityChart::barOf(std::size_t bin) const {
  const QRectF area = plot();
  const double width = area.width() / static_cast<double>(histogram_.counts.size());
  const long most = *std::ranges::max_element(histogram_.counts);
  const long count = histogram_.counts[bin];
  const double share = most > 0 ? static_cast<double>(count) / static_cast<double>(most) : 0;
  const double height = count > 0 ? std::max(2.0, share * area.height()) : 0;  // one bad tetrahedron is to be seen
  return {area.left() + width * static_cast<double>(bin) + 1, area.bottom() - height, width - 2, height};
}

void QualityChart::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setFont(theme::font(theme::now().type.small));
  const Colours& colours = theme::colours();
  if (histogram_.counts.empty()) {
    painter.setPen(colours.textMuted);
    painter.drawText(rect(), Qt::AlignCenter, tr("Not meshed yet."));
    return;
  }
  const QRectF area = plot();
  const auto poorBins = histogram_.bin_of(poor_);
  for (std::size_t bin = 0; bin < histogram_.counts.size(); ++bin)
    painter.fillRect(barOf(bin), static_cast<int>(bin) == pointed_ ? colours.accentHover
                                 : bin < poorBins                  ? colours.warn
                                                                   : colours.accent);
  painter.setPen(colours.borderStrong);
  painter.drawLine(area.bottomLeft(), area.bottomRight());
  painter.setPen(colours.textMuted);
  for (int i = 0; i <= labels_below; ++i) {
    const double share = static_cast<double>(i) / labels_below;
    const QString label =
        numbers::fixed(histogram_.low + share * (histogram_.high - histogram_.low), decimals_) + unit_;
    const int alignment = i == 0 ? Qt::AlignLeft : i == labels_below ? Qt::AlignRight : Qt::AlignHCenter;
    const double at = area.left() + share * area.width();
    const double start = i == 0 ? at : i == labels_below ? at - 60 : at - 30;
    painter.drawText(QRectF(start, area.bottom() + 3, 60, foot - 3), alignment | Qt::AlignTop, label);
  }
  if (pointed_ < 0) return;
  const double from = histogram_.low + pointed_ * histogram_.width();
  painter.drawText(QRectF(0, 0, width(), top_margin), Qt::AlignCenter,
                   tr("%1 of %2 between %3 and %4")
                       .arg(numbers::whole(histogram_.counts[static_cast<std::size_t>(pointed_)]),
                            numbers::whole(count()), numbers::fixed(from, decimals_ + 1) + unit_,
                            numbers::fixed(from + histogram_.width(), decimals_ + 1) + unit_));
}

void QualityChart::mouseMoveEvent(QMouseEvent* event) {
  const QRectF area = plot();
  const double share = (event->position().x() - area.left()) / area.width();
  const int bins = static_cast<int>(histogram_.counts.size());
  pointed_ = share < 0 || share >= 1 ? -1 : static_cast<int>(share * bins);
  update();
}

void QualityChart::leaveEvent(QEvent*) {
  pointed_ = -1;
  update();
}

}  // namespace talus
