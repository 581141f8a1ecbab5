#include "widgets/known_answers.hpp"

#include <QFileDialog>
#include <QHeaderView>
#include <QSplitter>
#include <algorithm>
#include <fstream>

#include "study/verify_json.hpp"
#include "widgets/case_page.hpp"
#include "widgets/numbers.hpp"

namespace talus {

namespace {

constexpr int list_width = 440;
const QSize usual_size(1180, 700);

QString text(const std::string& s) { return QString::fromStdString(s); }

}  // namespace

KnownAnswers::KnownAnswers(std::vector<KnownCase> cases, QWidget* parent)
    : QDialog(parent), cases_(std::move(cases)), list_(new PlainTable), page_(new CasePage) {
  setWindowTitle(tr("Known answers"));
  resize(usual_size);
  auto* column = new QVBoxLayout(this);
  setMargins(column, 0, 0);
  auto* split = new QSplitter(Qt::Horizontal);
  split->setChildrenCollapsible(false);
  split->setHandleWidth(1);
  split->addWidget(makeList());
  split->addWidget(page_);
  split->setStretchFactor(1, 1);
  split->setSizes({list_width, usual_size.width() - list_width});
  column->addWidget(split, 1);
  column->addWidget(makeFoot());

  connect(&job_, &VerifyJob::progressed, this, &KnownAnswers::showProgress);
  connect(&job_, &VerifyJob::caseEnded, this, &KnownAnswers::take);
  connect(&job_, &VerifyJob::ended, this, [this] {
    for (const std::size_t index : std::exchange(waiting_, {})) showRow(index);
    refresh();
  });
  for (std::size_t i = 0; i < cases_.size(); ++i) showRow(i);
  list_->setCurrentCell(0, 0);
  refresh();
}

QWidget* KnownAnswers::makeList() {
  auto* plane = makePlane("surface");
  auto* column = new QVBoxLayout(plane);
  setMargins(column, 0, 0);
  std::vector<QStringList> rows;
  for (const KnownCase& known : cases_) rows.push_back({text(known.title), {}, {}});
  list_->setContent({tr("Case"), tr("Result"), tr("Time")}, rows, {true, true, false});
  list_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  list_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  list_->setAccessibleName(tr("Cases with a known answer"));
  for (int row = 0; row < list_->rowCount(); ++row)
    list_->item(row, 0)->setToolTip(text(cases_[static_cast<std::size_t>(row)].name));
  connect(list_, &QTableWidget::currentCellChanged, this, &KnownAnswers::showCurrent);
  connect(list_, &QTableWidget::itemSelectionChanged, this, &KnownAnswers::refresh);
  column->addWidget(list_);
  return plane;
}

QWidget* KnownAnswers::makeFoot() {
  auto* foot = makePlane("bottom");
  auto* row = new QHBoxLayout(foot);
  setMargins(row, 12, 8);
  repeat_ = new QCheckBox(tr("Also on two threads and at 1/10 scale"));
  repeat_->setToolTip(
      tr("Each case is run twice more: on two threads it must give the same bits, at a tenth of the scale the same "
         "relative numbers"));
  row->addWidget(repeat_);
  what_ = new ElidedLabel({}, "small");
  what_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  row->addWidget(what_, 1);
  bar_ = new QProgressBar;
  bar_->setRange(0, 1000);
  bar_->setTextVisible(false);
  bar_->setFixedWidth(140);
  bar_->setAccessibleName(tr("Share of the cases that is done"));
  row->addWidget(bar_);
  left_ = makeLabel({}, "small");
  row->addWidget(left_);
  cancel_ = makeButton(tr("Cancel"));
  export_ = makeButton(tr("Export as JSON…"));
  runSelected_ = makeButton(tr("Run selected"));
  runQuick_ = makeButton(tr("Run all quick ones"), "primary");
  runQuick_->setDefault(true);
  for (auto* button : {cancel_, export_, runSelected_, runQuick_}) row->addWidget(button);
  connect(cancel_, &QPushButton::clicked, &job_, &VerifyJob::cancel);
  connect(export_, &QPushButton::clicked, this, &KnownAnswers::askForExport);
  connect(runSelected_, &QPushButton::clicked, this, &KnownAnswers::runSelected);
  connect(runQuick_, &QPushButton::clicked, this, &KnownAnswers::runQuick);
  return foot;
}

void KnownAnswers::runQuick() {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < cases_.size(); ++i)
    if (!cases_[i].takes_long) indices.push_back(i);
  run(std::move(indices));
}

void KnownAnswers::runSelected() {
  std::vector<std::size_t> indices;
  for (const QModelIndex& row : list_->selectionModel()->selectedRows())
    indices.push_back(static_cast<std::size_t>(row.row()));
  std::sort(indices.begin(), indices.end());
  run(std::move(indices));
}

void KnownAnswers::run(std::vector<std::size_t> indices) {
  if (indices.empty() || job_.isBusy()) return;
  std::vector<KnownCase> chosen;
  for (const std::size_t index : indices) chosen.push_back(cases_[index]);
  waiting_ = std::move(indices);
  VerifyOptions options;
  options.repeat = repeat_->isChecked();
  job_.start(std::move(chosen), options);
  for (const std::size_t index : waiting_) showRow(index);
  showProgress(0, {});
  refresh();
}

void KnownAnswers::take(const CaseResult& result) {
  results_.insert_or_assign(result.name, result);
  const std::size_t index = waiting_.front();
  waiting_.erase(waiting_.begin());
  showRow(index);
  if (!waiting_.empty()) showRow(waiting_.front());
  if (static_cast<int>(index) == list_->currentRow()) showCurrent();
}

void KnownAnswers::showRow(std::size_t index) {
  const auto waits = std::find(waiting_.begin(), waiting_.end(), index);
  const auto found = results_.find(cases_[index].name);
  QString result = cases_[index].takes_long ? tr("long; not run") : tr("not run"), seconds, icon;
  theme::Tone tone = theme::Tone::muted;
  if (waits != waiting_.end()) {
    const bool first = waits == waiting_.begin();
    result = first ? tr("running") : tr("waits");
    icon = first ? QStringLiteral("play") : QString();
    tone = theme::Tone::accent;
  } else if (found != results_.end()) {
    const bool passed = found->second.passed();
    result = passed ? tr("passed") : tr("failed");
    icon = passed ? QStringLiteral("ok") : QStringLiteral("error");
    tone = passed ? theme::Tone::ok : theme::Tone::error;
    seconds = numbers::duration(found->second.seconds);
  }
  const int row = static_cast<int>(index);
  list_->item(row, 1)->setText(result);
  list_->item(row, 1)->setIcon(icon.isEmpty() ? QIcon() : theme::icon(icon, tone));
  list_->item(row, 2)->setText(seconds);
}

void KnownAnswers::showCurrent() {
  const int row = list_->currentRow();
  if (row < 0) return;
  const KnownCase& known = cases_[static_cast<std::size_t>(row)];
  const auto found = results_.find(known.name);
  page_->show(known, found == results_.end() ? nullptr : &found->second);
}

void KnownAnswers::showProgress(double fraction, const QString& what) {
  bar_->setValue(static_cast<int>(1000 * fraction));
  what_->setText(what);
  const auto seconds = job_.timeLeft().seconds();
  left_->setText(seconds ? tr("%1 left").arg(numbers::duration(*seconds)) : QString());
}

void KnownAnswers::refresh() {
  const bool busy = job_.isBusy();
  for (QWidget* widget : {static_cast<QWidget*>(bar_), static_cast<QWidget*>(left_), static_cast<QWidget*>(cancel_)})
    widget->setVisible(busy);
  if (!busy) {
    const auto passed =
        std::count_if(results_.begin(), results_.end(), [](const auto& r) { return r.second.passed(); });
    what_->setText(results_.empty() ? QString() : tr("%1 of %2 passed").arg(passed).arg(results_.size()));
  }
  const QString goesOn = busy ? tr("Cases are being run") : QString();
  const QString nothing = list_->selectionModel()->hasSelection() ? QString() : tr("Select a case first");
  const auto allow = [](QWidget* button, const QString& whyNot) {
    button->setEnabled(whyNot.isEmpty());
    button->setToolTip(whyNot);
  };
  allow(runQuick_, goesOn);
  allow(runSelected_, busy ? goesOn : nothing);
  allow(export_, results_.empty() ? tr("No case has been run yet") : QString());
  repeat_->setEnabled(!busy);
}

std::vector<CaseResult> KnownAnswers::results() const {
  std::vector<CaseResult> ordered;
  for (const KnownCase& known : cases_)
    if (const auto found = results_.find(known.name); found != results_.end()) ordered.push_back(found->second);
  return ordered;
}

bool KnownAnswers::exportJson(const std::filesystem::path& file) const {
  std::ofstream stream(file);
  stream << json_text(results());
  stream.close();
  return static_cast<bool>(stream);
}

void KnownAnswers::askForExport() {
  const QString name = QFileDialog::getSaveFileName(this, tr("Export the results"),
                                                    QStringLiteral("known_answers.json"), tr("JSON (*.json)"));
  if (name.isEmpty() || exportJson(name.toStdString())) return;
  what_->setText(tr("%1 cannot be written; choose another place").arg(name));
}

}  // namespace talus
