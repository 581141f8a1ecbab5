#include "widgets/results/block_history_panel.hpp"

#include <QComboBox>
#include <algorithm>
#include <cmath>

#include "session/block_histories.hpp"
#include "session/playback.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"
#include "widgets/results/save_table.hpp"

namespace talus {

namespace {
constexpr int width_of_quantity = 200;  // pixels: the longest title
}

QString titleOf(const BlockQuantity& quantity) {
  // What blocks have: the translators' tool finds it here.
  static const char* const known[] = {QT_TRANSLATE_NOOP("quantity", "Displacement"),
                                      QT_TRANSLATE_NOOP("quantity", "Displacement x"),
                                      QT_TRANSLATE_NOOP("quantity", "Displacement y"),
                                      QT_TRANSLATE_NOOP("quantity", "Displacement z"),
                                      QT_TRANSLATE_NOOP("quantity", "Speed"),
                                      QT_TRANSLATE_NOOP("quantity", "Velocity x"),
                                      QT_TRANSLATE_NOOP("quantity", "Velocity y"),
                                      QT_TRANSLATE_NOOP("quantity", "Velocity z"),
                                      QT_TRANSLATE_NOOP("quantity", "Rotation"),
                                      QT_TRANSLATE_NOOP("quantity", "Kinetic energy"),
                                      QT_TRANSLATE_NOOP("quantity", "Contact force"),
                                      QT_TRANSLATE_NOOP("quantity", "Largest von Mises stress"),
                                      QT_TRANSLATE_NOOP("quantity", "Normal forces, summed"),
                                      QT_TRANSLATE_NOOP("quantity", "Shear forces, summed")};
  static_cast<void>(known);
  return QCoreApplication::translate("quantity", std::string(quantity.title).c_str());
}

BlockHistoryPanel::BlockHistoryPanel(BlockHistories& histories, Playback& playback, Messages& messages)
    : BlockHistoryPanel(histories, playback, messages, new QWidget) {}

BlockHistoryPanel::BlockHistoryPanel(BlockHistories& histories, Playback& playback, Messages& messages, QWidget* charts)
    : ExplainedPanel(charts),
      histories_(histories),
      playback_(playback),
      messages_(messages),
      charts_(charts),
      save_(makeButton(tr("Save as CSV…"), "link")) {
  auto* row = new QHBoxLayout(charts_);
  setMargins(row, 0, 1);
  both_ = {addChart(tr("Quantity of the left plot"), "displacement"),
           addChart(tr("Quantity of the right plot"), "speed")};
  both_[1].head->addWidget(save_);
  connect(save_, &QPushButton::clicked, this, &BlockHistoryPanel::save);
  connect(&histories_, &BlockHistories::changed, this, &BlockHistoryPanel::refresh);
  connect(&playback_, &Playback::frameChanged, this, [this] {
    const auto cursor = playback_.frame() ? std::optional<double>(playback_.time()) : std::nullopt;
    for (const Chart& chart : both_) chart.plot->setCursor(cursor);
  });
  refresh();
}

BlockHistoryPanel::Chart BlockHistoryPanel::addChart(const QString& name, std::string_view quantity) {
  QStringList titles;
  for (const BlockQuantity& one : all_block_quantities()) titles << titleOf(one);
  Chart chart{makeCombo(titles, name), new Plot({}), new QHBoxLayout};
  chart.quantity->setMinimumWidth(width_of_quantity);
  chart.quantity->setToolTip(tr("What of the blocks that are selected is shown over time"));
  const auto all = all_block_quantities();
  chart.quantity->setCurrentIndex(
      static_cast<int>(std::ranges::find(all, quantity, &BlockQuantity::name) - all.begin()));
  auto* column = new QVBoxLayout;
  setMargins(column, 0, 0);
  setMargins(chart.head, 4, 8);
  chart.head->addWidget(chart.quantity);
  chart.head->addStretch(1);
  column->addLayout(chart.head);
  column->addWidget(chart.plot, 1);
  static_cast<QHBoxLayout*>(charts_->layout())->addLayout(column, 1);
  connect(chart.quantity, &QComboBox::activated, this, &BlockHistoryPanel::refresh);
  connect(chart.plot, &Plot::timeChosen, &playback_, &Playback::showTime);
  return chart;
}

void BlockHistoryPanel::showEvent(QShowEvent*) { histories_.setWatched(true); }

void BlockHistoryPanel::hideEvent(QHideEvent*) { histories_.setWatched(false); }

const BlockQuantity& BlockHistoryPanel::quantityOf(const Chart& chart) const {
  return all_block_quantities()[static_cast<std::size_t>(chart.quantity->currentIndex())];
}

void BlockHistoryPanel::refresh() {
  const bool any = histories_.history() != nullptr;
  explain(any                                               ? QString()
          : !histories_.problem().isEmpty()                 ? histories_.problem()
          : playback_.times().empty() || playback_.isLive() ? tr("Histories of blocks are shown when a run has ended.")
          : histories_.blocks().empty()
              ? tr("Click a block in the view or the table to see what became of it; Ctrl and a click adds another.")
              : tr("The frames are being read."));
  if (any)
    for (const Chart& chart : both_) fill(chart);
}

void BlockHistoryPanel::fill(const Chart& chart) {
  const BlockHistory& history = *histories_.history();
  const BlockQuantity& quantity = quantityOf(chart);
  std::vector<Curve> curves;
  double largest = 0;
  for (std::size_t i = 0; i < history.blocks.size(); ++i) {
    curves.push_back({text(history.names[i]), static_cast<int>(i), history.times, history.values(i, quantity)});
    for (const double value : curves.back().y)
      if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  }
  const numbers::Scale scale = numbers::scaleOf(largest, std::string(quantity.unit).c_str());
  for (Curve& curve : curves)
    for (double& value : curve.y) value /= scale.factor;
  chart.plot->setCurves(std::move(curves), scale.unit);
}

void BlockHistoryPanel::save() {
  if (!histories_.history()) return;
  std::vector<BlockQuantity> quantities;
  for (const Chart& chart : both_)
    if (std::ranges::find(quantities, quantityOf(chart)) == quantities.end()) quantities.push_back(quantityOf(chart));
  saveTable(*this, messages_, tr("Save the histories of the selected blocks"), QStringLiteral("blocks.csv"),
            [&] { return history_csv(*histories_.history(), quantities); });
}

}  // namespace talus
