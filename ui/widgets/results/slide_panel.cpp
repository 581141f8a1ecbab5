#include "widgets/results/slide_panel.hpp"

#include <QHeaderView>

#include "render/charts/slide_charts.hpp"
#include "session/display.hpp"
#include "session/measured_slide.hpp"
#include "session/playback.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

QString degreesText(double angle) { return numbers::fixed(angle, 1) + QChar(0xb0); }

}  // namespace

SlidePanel::SlidePanel(MeasuredSlide& slide, Playback& playback, Display& display)
    : slide_(slide),
      playback_(playback),
      display_(display),
      moved_(new NumberField({}, {QStringLiteral("m"), QStringLiteral("m")})),
      sentence_(makeWrappedLabel({}, "muted")),
      facts_(new PlainTable),
      map_(new PaintingView(tr("Map of the deposit"))),
      front_(new Plot(tr("Velocity of the front"))) {
  setProperty("plane", "surface");
  setAttribute(Qt::WA_StyledBackground);
  auto* row = new QHBoxLayout(this);
  setMargins(row, 0, 8);
  auto* left = new QVBoxLayout;
  setMargins(left, 0, 4);
  auto* rule = new QHBoxLayout;
  setMargins(rule, 4, 8);
  auto* words = makeLabel(tr("Moved further than"), "small");
  words->setBuddy(moved_);
  rule->addWidget(words);
  moved_->allowNone(tr("1 % of the model"));
  moved_->setAccessibleName(tr("Moved further than"));
  moved_->setMeaning(
      tr("Blocks whose centroid has gone further count as moved; empty: a hundredth of the diagonal of "
         "all blocks"));
  rule->addWidget(moved_, 1);
  left->addLayout(rule);
  facts_->horizontalHeader()->hide();
  facts_->setAccessibleName(tr("Run-out and deposit"));
  left->addWidget(facts_, 1);
  sentence_->setAlignment(Qt::AlignCenter);
  left->addWidget(sentence_, 1);
  facts_->setMinimumWidth(220);
  row->addLayout(left, 4);
  row->addWidget(map_, 5);
  row->addWidget(front_, 4);
  const auto setMoved = [this](std::optional<double> length) {
    SlideSettings settings = slide_.settings();
    settings.run_out.moved = length;
    slide_.set(settings);
  };
  connect(moved_, &NumberField::committed, this, setMoved);
  connect(moved_, &NumberField::cleared, this, [setMoved] { setMoved({}); });
  connect(front_, &Plot::timeChosen, &playback_, &Playback::showTime);
  connect(&slide_, &MeasuredSlide::changed, this, &SlidePanel::refresh);
  connect(&display_, &Display::themeChanged, this, &SlidePanel::refresh);
  connect(&playback_, &Playback::frameChanged, this,
          [this] { front_->setCursor(playback_.frame() ? std::optional<double>(playback_.time()) : std::nullopt); });
  refresh();
}

void SlidePanel::showEvent(QShowEvent*) { slide_.setWatched(true); }

void SlidePanel::hideEvent(QHideEvent*) { slide_.setWatched(false); }

std::vector<QStringList> SlidePanel::facts() const {
  const Slide& slide = *slide_.slide();
  const RunOut& out = slide.run_out;
  const Deposit& deposit = slide.deposit;
  const auto length = [](double metres) { return numbers::quantity(metres, "m"); };
  std::vector<QStringList> rows{
      {tr("Blocks that moved"), tr("%1 of %2").arg(out.rock.blocks.size()).arg(slide.movable)},
      {tr("Volume that moved"), numbers::significant(out.rock.volume, 4) + QStringLiteral(" m³")}};
  if (out.rock.blocks.empty()) return rows;
  rows.push_back({tr("Forward"), out.rock.forward.isZero()
                                     ? tr("straight down")
                                     : text(attitude_text(out.rock.forward)).left(3) + QChar(0xb0)});
  rows.push_back({tr("Run-out of the front"), length(out.front)});
  rows.push_back({tr("Farthest block"), length(out.in_space.length)});
  rows.push_back({tr("… in plan"), length(out.in_plan.length)});
  rows.push_back({tr("… forward"), length(out.forward.length)});
  rows.push_back({tr("Travel angle, crown to toe"), degreesText(out.crown_to_toe.angle())});
  rows.push_back({tr("Fall, length in plan"),
                  length(out.crown_to_toe.height()) + QStringLiteral(", ") + length(out.crown_to_toe.length())});
  rows.push_back({tr("Angle of the centre's travel"), degreesText(out.of_centre.angle())});
  rows.push_back({tr("Area of the deposit"), numbers::significant(deposit.area, 4) + QStringLiteral(" m²")});
  rows.push_back({tr("Volume with voids"), numbers::significant(deposit.bulk, 4) + QStringLiteral(" m³")});
  rows.push_back({tr("Depth, at most"), length(deposit.max_depth)});
  rows.push_back({tr("… on average"), length(deposit.mean_depth)});
  if (const FrontMoment* fastest = slide.fastest())
    rows.push_back(
        {tr("Front at its fastest"),
         tr("%1 at %2 s").arg(numbers::quantity(fastest->velocity, "m/s"), numbers::significant(fastest->time, 4))});
  return rows;
}

void SlidePanel::refresh() {
  const std::shared_ptr<const Slide>& slide = slide_.slide();
  const bool moved = slide && !slide->run_out.rock.blocks.empty();
  facts_->setVisible(slide != nullptr);
  sentence_->setVisible(!slide);
  sentence_->setText(!slide_.problem().isEmpty() ? slide_.problem()
                     : playback_.times().empty() || playback_.isLive()
                         ? tr("Run-out and deposit are measured when a run has ended.")
                         : tr("Run-out and deposit are being measured."));
  if (slide) {
    facts_->setContent({{}, {}}, facts(), {true, false});
    facts_->horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  }
  map_->setVisible(moved);
  front_->setVisible(moved);
  if (!moved) {
    map_->setPainting({});
    return;
  }
  map_->setPainting([slide, theme = display_.settings().theme](Painter& painter, double width, double height) {
    deposit_map(*slide, theme)(painter, width, height);
  });
  showFront();
}

void SlidePanel::showFront() {
  Curve velocity{{}, 0, {}, {}};
  double largest = 0;
  for (const FrontMoment& moment : slide_.slide()->front) {
    velocity.x.push_back(moment.time);
    velocity.y.push_back(moment.velocity);
    largest = std::max(largest, std::abs(moment.velocity));
  }
  const numbers::Scale scale = numbers::scaleOf(largest, "m/s");
  for (double& value : velocity.y) value /= scale.factor;
  front_->setCurves({std::move(velocity)}, scale.unit);
}

}  // namespace talus
