#include "widgets/results/line_panel.hpp"

#include <QLabel>
#include <QPushButton>

#include "render/charts/line_plot.hpp"
#include "session/field_line.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/results/save_table.hpp"

namespace talus {

LinePanel::LinePanel(FieldLine& line, Messages& messages)
    : line_(line),
      messages_(messages),
      words_(makeWrappedLabel({}, "muted")),
      save_(makeButton(tr("Save as CSV…"), "link")),
      remove_(makeButton(tr("Take the line away"), "link")),
      chart_(new PaintingView(tr("The field along the line"))) {
  setProperty("plane", "surface");
  setAttribute(Qt::WA_StyledBackground);
  auto* row = new QHBoxLayout(this);
  setMargins(row, 0, 8);
  auto* left = new QVBoxLayout;
  setMargins(left, 8, 8);
  auto* choose = makeButton(tr("Choose two points"));
  choose->setToolTip(tr("Click two points of the rock in the view: the field that is shown is followed between them"));
  left->addWidget(choose);
  left->addWidget(words_);
  left->addWidget(save_);
  left->addWidget(remove_);
  left->addStretch(1);
  row->addLayout(left, 1);
  row->addWidget(chart_, 3);
  connect(choose, &QPushButton::clicked, this, [this] { line_.ask(tr("Click both ends of the line")); });
  connect(save_, &QPushButton::clicked, this, [this] {
    saveTable(*this, messages_, tr("Save the field along the line"), QStringLiteral("line.csv"),
              [this] { return line_.table(); });
  });
  connect(remove_, &QPushButton::clicked, &line_, &FieldLine::remove);
  connect(&line_, &FieldLine::changed, this, &LinePanel::refresh);
  refresh();
}

void LinePanel::showEvent(QShowEvent*) { refresh(); }

void LinePanel::refresh() {
  if (!isVisible()) return;
  const LineProbe probe = line_.probe();
  const auto& ends = line_.ends();
  remove_->setVisible(ends.has_value());
  save_->setVisible(!probe.pieces.empty());
  words_->setText(!line_.isPossible()    ? tr("Fields are followed along lines when there are results.")
                  : !ends                ? tr("Two points of the rock make a line, along which the field is shown.")
                  : probe.pieces.empty() ? tr("The line meets no rock in this frame.")
                                         : tr("%1 long").arg(numbers::quantity(((*ends)[1] - (*ends)[0]).norm(), "m")));
  if (probe.pieces.empty()) return chart_->setPainting({});
  HistoryPlot plot = line_plot(probe, line_.field(), {});
  plot.theme = line_.theme();
  chart_->setPainting(chart_painting(plot));
}

}  // namespace talus
