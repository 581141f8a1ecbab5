#include "widgets/results/history_panel.hpp"

#include <algorithm>
#include <cmath>

#include "session/current_run.hpp"
#include "session/display.hpp"
#include "session/playback.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

double largestOf(const std::vector<Curve>& curves) {
  double largest = 0;
  for (const Curve& curve : curves)
    for (const double value : curve.y)
      if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  return largest;
}

void showIn(Plot& plot, const numbers::Scale& scale, std::vector<Curve> curves) {
  for (Curve& curve : curves)
    for (double& value : curve.y) value /= scale.factor;
  plot.setCurves(std::move(curves), scale.unit);
}

}  // namespace

HistoryPanel::HistoryPanel(CurrentRun& run, Playback& playback, Display& display)
    : run_(run),
      playback_(playback),
      display_(display),
      displacement_(new Plot(tr("Displacement"))),
      speed_(new Plot(tr("Speed"))),
      energy_(new Plot(tr("Energy"))),
      iterations_(new Plot(tr("Open–close iterations"))),
      contacts_(new Plot(tr("Contacts"))) {
  setProperty("plane", "surface");
  auto* row = new QHBoxLayout(this);
  setMargins(row, 0, 1);
  auto* sentence = makeLabel(tr("Curves of monitors and energies appear here as soon as a run makes steps."), "muted");
  sentence->setAlignment(Qt::AlignCenter);
  empty_ = sentence;
  row->addWidget(empty_, 1);
  for (auto* plot : {displacement_, speed_, iterations_, contacts_, energy_}) {
    row->addWidget(plot, 1);
    connect(plot, &Plot::timeChosen, &playback_, &Playback::showTime);
  }
  connect(&run_, &CurrentRun::historyChanged, this, &HistoryPanel::refresh);
  connect(&display_, &Display::pageChanged, this, &HistoryPanel::showPlotsOfPage);
  connect(&playback_, &Playback::frameChanged, this, [this] {
    const auto cursor = playback_.frame() ? std::optional<double>(playback_.time()) : std::nullopt;
    for (auto* plot : {displacement_, speed_, iterations_, contacts_, energy_}) plot->setCursor(cursor);
  });
  refresh();
}

void HistoryPanel::showPlotsOfPage() {
  const bool any = !run_.steps().empty();
  const bool solving = display_.page() == WorkflowPage::solve;
  empty_->setVisible(!any);
  displacement_->setVisible(any && !run_.monitorNames().empty());
  speed_->setVisible(any && !solving && !run_.monitorNames().empty());
  iterations_->setVisible(any && (solving || run_.monitorNames().empty()));
  contacts_->setVisible(any && (solving || run_.monitorNames().empty()));
  energy_->setVisible(any);
}

void HistoryPanel::refresh() {
  showPlotsOfPage();
  if (!isVisible()) return;  // filled when it is looked at
  fillMonitors();
  fillSolver();
  fillEnergy();
}

void HistoryPanel::showEvent(QShowEvent*) { refresh(); }

void HistoryPanel::fillMonitors() {
  std::vector<Curve> displacement, speed;
  const auto& names = run_.monitorNames();
  for (size_t m = 0; m < names.size(); ++m) {
    Curve u{text(names[m]), static_cast<int>(m), {}, {}};
    Curve v = u;
    for (const HistoryRow& row : run_.history()) {
      if (m >= row.monitors.size()) continue;
      u.x.push_back(row.time);
      u.y.push_back(row.monitors[m].displacement.norm());
      v.x.push_back(row.time);
      v.y.push_back(row.monitors[m].velocity.norm());
    }
    displacement.push_back(std::move(u));
    speed.push_back(std::move(v));
  }
  const numbers::Scale length = numbers::scaleOf(largestOf(displacement), "m");
  const numbers::Scale pace = numbers::scaleOf(largestOf(speed), "m/s");
  showIn(*displacement_, length, std::move(displacement));
  showIn(*speed_, pace, std::move(speed));
}

std::vector<double> HistoryPanel::stepTimes() const {
  std::vector<double> times;
  for (const StepReport& step : run_.steps()) times.push_back(step.time);
  return times;
}

void HistoryPanel::fillSolver() {
  const std::vector<double> times = stepTimes();
  Curve iterations{{}, 1, times, {}}, open{tr("open"), 0, times, {}}, stick{tr("stick"), 2, times, {}},
      slip{tr("slip"), 1, times, {}};
  for (const StepReport& step : run_.steps()) {
    iterations.y.push_back(step.iterations);
    open.y.push_back(step.open);
    stick.y.push_back(step.stick);
    slip.y.push_back(step.slip);
  }
  iterations_->setCurves({std::move(iterations)}, tr("a step"));
  contacts_->setCurves({std::move(open), std::move(stick), std::move(slip)}, {});
}

void HistoryPanel::fillEnergy() {
  const std::vector<double> times = stepTimes();
  struct Part {
    QString name;
    double EnergyLedger::*member;
    int colour;
  };
  const Part parts[] = {{tr("kinetic"), &EnergyLedger::kinetic, 0},
                        {tr("elastic"), &EnergyLedger::elastic, 2},
                        {tr("friction"), &EnergyLedger::friction_dissipated, 1},
                        {tr("loss"), &EnergyLedger::integration_loss, 3}};
  std::vector<Curve> curves;
  for (const Part& part : parts) {
    Curve curve{part.name, part.colour, times, {}};
    bool any = false;
    for (const StepReport& step : run_.steps()) {
      curve.y.push_back(step.energy.*part.member);
      any = any || curve.y.back() != 0;
    }
    if (any) curves.push_back(std::move(curve));
  }
  const numbers::Scale scale = numbers::energyScale(largestOf(curves));
  showIn(*energy_, scale, std::move(curves));
}

}  // namespace talus
