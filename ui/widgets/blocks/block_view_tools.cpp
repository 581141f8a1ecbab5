#include "widgets/blocks/block_view_tools.hpp"

#include <QComboBox>
#include <QSlider>

#include "session/block_colouring.hpp"
#include "session/display.hpp"
#include "widgets/kit/parts.hpp"

namespace talus {

namespace {

constexpr int steps = 40;
constexpr double farthest = 2;  // of the way from the middle of all blocks
constexpr int combo_width = 116, slider_width = 100;

}  // namespace

BlockViewTools::BlockViewTools(BlockColouring& colouring, Display& display)
    : colouring_(colouring),
      display_(display),
      colours_(makeCombo({}, tr("Colour by"))),
      apart_(new QSlider(Qt::Horizontal)) {
  auto* row = new QHBoxLayout(this);
  setMargins(row, 0, 6);
  for (const ColourBy by : all_colourings) colours_->addItem(titleOf(by));
  colours_->setObjectName(QStringLiteral("colour by"));
  colours_->setFixedWidth(combo_width);
  colours_->setToolTip(tr("What the blocks are coloured by"));
  apart_->setObjectName(QStringLiteral("apart"));
  apart_->setAccessibleName(tr("How far blocks are drawn apart"));
  apart_->setToolTip(tr("How far blocks are drawn apart (E)"));
  apart_->setRange(0, steps);
  apart_->setFixedWidth(slider_width);
  row->addWidget(makeLabel(tr("Colour by"), "muted"));
  row->addWidget(colours_);
  row->addSpacing(8);
  row->addWidget(makeLabel(tr("Apart"), "muted"));
  row->addWidget(apart_);
  connect(colours_, &QComboBox::activated, this,
          [this](int index) { colouring_.colourBy(all_colourings[static_cast<std::size_t>(index)]); });
  connect(apart_, &QSlider::valueChanged, this, [this](int value) {
    SceneSettings settings = display_.settings();
    settings.explosion = farthest * value / steps;
    display_.set(settings);
  });
  connect(&display_, &Display::changed, this, &BlockViewTools::refresh);
  connect(&colouring_, &BlockColouring::changed, this, &BlockViewTools::refresh);
  refresh();
}

void BlockViewTools::refresh() {
  colours_->setCurrentIndex(static_cast<int>(colouring_.by()));
  const QSignalBlocker silent(apart_);  // the value may lie between its steps
  apart_->setValue(static_cast<int>(display_.settings().explosion / farthest * steps + 0.5));
}

}  // namespace talus
