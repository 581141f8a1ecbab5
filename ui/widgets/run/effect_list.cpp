#include "widgets/run/effect_list.hpp"

#include <QCoreApplication>
#include <QGridLayout>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>

#include "jobs/solver_job.hpp"
#include "session/current_run.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

constexpr int cost_width = 72;

double dearest(const auto& effects) {
  double most = 0;
  for (const auto& effect : effects) most = std::max(most, effect.seconds);
  return most;
}

/// In the user's language.
QString effectName(const std::string& name) {
  static const char* const known[] = {
      QT_TRANSLATE_NOOP("effects", "elasticity"),
      QT_TRANSLATE_NOOP("effects", "neo-Hookean elasticity"),
      QT_TRANSLATE_NOOP("effects", "initial stress"),
      QT_TRANSLATE_NOOP("effects", "inertia"),
      QT_TRANSLATE_NOOP("effects", "displacement constraint"),
      QT_TRANSLATE_NOOP("effects", "point load"),
      QT_TRANSLATE_NOOP("effects", "body force"),
      QT_TRANSLATE_NOOP("effects", "normal contact"),
      QT_TRANSLATE_NOOP("effects", "shear contact"),
      QT_TRANSLATE_NOOP("effects", "cohesion and tension"),
      QT_TRANSLATE_NOOP("effects", "rebound"),
      QT_TRANSLATE_NOOP("effects", "damping"),
      QT_TRANSLATE_NOOP("effects", "restitution"),
      QT_TRANSLATE_NOOP("effects", "missed contacts"),
      QT_TRANSLATE_NOOP("effects", "updated normals"),
      QT_TRANSLATE_NOOP("effects", "penalty scaling"),
      QT_TRANSLATE_NOOP("effects", "followed springs"),
      QT_TRANSLATE_NOOP("effects", "acceleration reset"),
      QT_TRANSLATE_NOOP("effects", "sleep"),
      QT_TRANSLATE_NOOP("effects", "nonlinear elimination")};  // where translators find them
  static_cast<void>(known);
  return sentenceCase(QCoreApplication::translate("effects", name.c_str()));
}

double share(double part, double whole) { return whole > 0 ? part / whole : 0; }

}  // namespace

EffectList::EffectList(CurrentRun& run) : run_(run), column_(new QVBoxLayout(this)) {
  setMargins(column_, 0, 4);
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // what it says does not make the panel wider
  connect(&run_, &CurrentRun::effectsChanged, this, &EffectList::refresh);
  connect(&run_.job(), &SolverJob::stateChanged, this, &EffectList::refresh);
  refresh();
}

std::vector<EffectList::Row> EffectList::expected() const {
  const std::vector<EffectCost> costs = run_.effectCosts();
  const double most = dearest(costs);
  std::vector<Row> rows;
  for (const EffectCost& cost : costs)
    rows.push_back({effectName(std::string(to_string(cost.kind))), text(cost.reason), text(cost.items),
                    cost.active ? tr("%1 ms").arg(numbers::significant(1e3 * cost.seconds, 2)) : tr("off"), cost.active,
                    share(cost.seconds, most)});
  return rows;
}

std::vector<EffectList::Row> EffectList::spent() const {
  const double most = dearest(run_.effects());
  std::vector<Row> rows;
  for (const EffectOutcome& effect : run_.effects())
    rows.push_back({effectName(effect.name),
                    text(effect.reason),
                    {},
                    effect.active ? tr("%1 s").arg(numbers::significant(effect.seconds, 2)) : tr("off"),
                    effect.active,
                    share(effect.seconds, most)});
  return rows;
}

void EffectList::refresh() {
  const bool ran = !run_.effects().empty();
  std::vector<Row> rows = ran ? spent() : expected();
  const bool staysAsItIs =
      column_->count() > 0 && ran == showsSpent_ && std::ranges::equal(rows, rows_, {}, &Row::words, &Row::words);
  rows_ = std::move(rows);
  if (staysAsItIs) return showCosts();
  showsSpent_ = ran;
  clearLayout(*column_);
  costs_.clear();
  if (rows_.empty()) {
    auto* sentence =
        makeWrappedLabel(tr("Which effects the scene calls for, and what each will cost, is listed here when its "
                            "blocks are cut and meshed."),
                         "small");
    column_->addWidget(sentence);
    return;
  }
  addHeading(ran ? tr("time spent") : tr("iteration, estimated"));
  for (const Row& row : rows_) addRow(row);
  showCosts();
}

void EffectList::showCosts() {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    costs_[i].words->setText(rows_[i].cost);
    if (costs_[i].bar) costs_[i].bar->setShare(rows_[i].share);
  }
}

void EffectList::addHeading(const QString& unit) {
  const auto active = std::count_if(rows_.begin(), rows_.end(), [](const Row& row) { return row.active; });
  auto* heading = new QWidget;
  auto* row = new QHBoxLayout(heading);
  setMargins(row, 0, 6);
  row->addWidget(makeLabel(tr("Effects: %1 of %2 on").arg(active).arg(rows_.size()), "section"));
  row->addStretch();
  row->addWidget(makeLabel(unit, "faint"));
  column_->addWidget(heading);
}

void EffectList::addRow(const Row& row) {
  auto* widget = new QWidget;
  auto* grid = new QGridLayout(widget);
  grid->setContentsMargins(0, 1, 0, 1);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(0);
  grid->setColumnStretch(1, 1);
  grid->addWidget(new Glyph(row.active ? QStringLiteral("check") : QStringLiteral("dash"),
                            row.active ? theme::Tone::ok : theme::Tone::muted, 14),
                  0, 0);
  grid->addWidget(makeWrappedLabel(row.name, row.active ? nullptr : "muted"), 0, 1);
  auto* bar = row.active ? new ShareBar : nullptr;
  if (bar) grid->addWidget(bar, 0, 2);
  auto* cost = makeLabel({}, row.active ? nullptr : "faint");
  cost->setFixedWidth(cost_width);
  cost->setAlignment(Qt::AlignRight);
  grid->addWidget(cost, 0, 3);
  grid->addWidget(makeWrappedLabel(row.reason, "small"), 1, 1, 1, 3);
  if (!row.items.isEmpty()) grid->addWidget(makeWrappedLabel(row.items, "small"), 2, 1, 1, 3);
  column_->addWidget(widget);
  costs_.push_back({cost, bar});
}

ShareBar::ShareBar() { setFixedSize(44, 4); }

void ShareBar::setShare(double share) {
  if (share == share_) return;
  share_ = share;
  update();
}

void ShareBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme::colours().pressed);
  painter.drawRoundedRect(rect(), 2, 2);
  if (share_ <= 0) return;
  painter.setBrush(theme::colours().accent);
  painter.drawRoundedRect(QRectF(0, 0, std::max(2.0, width() * share_), height()), 2, 2);
}

}  // namespace talus
