#include "widgets/verification/run_list.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QHeaderView>
#include <QProgressBar>
#include <QSplitter>
#include <algorithm>
#include <fstream>

#include "widgets/kit/numbers.hpp"

namespace talus {

namespace {

constexpr int result_column = 1, first_fact = 2;
constexpr int runs_width = 540, list_height = 400, page_width = 680, page_height = 260;

}  // namespace

RunList::RunList(RunListWords words, std::vector<RunItem> items, QWidget* page, Qt::Orientation orientation)
    : words_(std::move(words)), items_(std::move(items)), table_(new PlainTable) {
  auto* column = new QVBoxLayout(this);
  setMargins(column, 0, 0);
  auto* split = new QSplitter(orientation);
  split->setChildrenCollapsible(false);
  split->setHandleWidth(1);
  split->addWidget(makeTable());
  split->addWidget(page);
  split->setStretchFactor(1, 1);
  split->setSizes(orientation == Qt::Horizontal ? QList{runs_width, page_width} : QList{list_height, page_height});
  column->addWidget(split, 1);
  column->addWidget(makeFoot());
  connect(&job_, &BackgroundJob::progressed, this, &RunList::showProgress);
  connect(&job_, &BackgroundJob::ended, this, [this] {
    for (const std::size_t index : std::exchange(waiting_, {})) showRow(index);
    refresh();
  });
}

void RunList::begin() {
  for (std::size_t i = 0; i < items_.size(); ++i) showRow(i);
  table_->setCurrentCell(0, 0);
  refresh();
}

QWidget* RunList::makeTable() {
  auto* plane = makePlane("surface");
  auto* column = new QVBoxLayout(plane);
  setMargins(column, 0, 0);
  QStringList heads{words_.what, tr("Result")};
  heads << words_.facts << words_.figures << tr("Time");
  std::vector<bool> wordy(static_cast<std::size_t>(first_fact + words_.facts.size()), true);
  wordy.resize(static_cast<std::size_t>(heads.size()), false);
  std::vector<QStringList> rows;
  for (const RunItem& item : items_) rows.push_back(QStringList{item.title, {}} << item.facts);
  table_->setContent(heads, rows, wordy);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  for (int fact = 0; fact < words_.facts.size(); ++fact)
    table_->horizontalHeader()->setSectionResizeMode(first_fact + fact, QHeaderView::Stretch);
  table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  table_->setAccessibleName(words_.list);
  for (int row = 0; row < table_->rowCount(); ++row) {
    const RunItem& item = items_[static_cast<std::size_t>(row)];
    table_->item(row, 0)->setToolTip(item.tip);
    for (int fact = 0; fact < item.facts.size(); ++fact)
      table_->item(row, first_fact + fact)->setToolTip(item.facts[fact]);
  }
  connect(table_, &QTableWidget::currentCellChanged, this, &RunList::showCurrent);
  connect(table_, &QTableWidget::itemSelectionChanged, this, &RunList::refresh);
  column->addWidget(table_);
  return plane;
}

QWidget* RunList::makeFoot() {
  auto* foot = makePlane("bottom");
  auto* row = new QHBoxLayout(foot);
  setMargins(row, 12, 8);
  makeGroups(*row);
  repeat_ = new QCheckBox(words_.repeat);
  repeat_->setToolTip(words_.repeatTip);
  row->addWidget(repeat_);
  what_ = new ElidedLabel({}, "small");
  what_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  row->addWidget(what_, 1);
  bar_ = makeProgressBar();
  bar_->setFixedWidth(140);
  bar_->setAccessibleName(tr("Share of the runs that is done"));
  row->addWidget(bar_);
  left_ = makeLabel({}, "small");
  row->addWidget(left_);
  cancel_ = makeButton(tr("Cancel"));
  export_ = makeButton(tr("Export as JSON…"));
  runSelected_ = makeButton(tr("Run selected"));
  runQuick_ = makeButton(tr("Run all quick ones"), "primary");
  runQuick_->setDefault(true);
  for (auto* button : {cancel_, export_, runSelected_, runQuick_}) row->addWidget(button);
  connect(cancel_, &QPushButton::clicked, &job_, &BackgroundJob::cancel);
  connect(export_, &QPushButton::clicked, this, &RunList::askForExport);
  connect(runSelected_, &QPushButton::clicked, this, &RunList::runSelected);
  connect(runQuick_, &QPushButton::clicked, this, &RunList::runQuick);
  return foot;
}

void RunList::makeGroups(QBoxLayout& row) {
  QStringList names{tr("All groups")};
  for (const RunItem& item : items_)
    if (!item.group.isEmpty() && !names.contains(item.group)) names << item.group;
  groups_ = makeCombo(names, tr("Group"));
  groups_->setMinimumWidth(170);
  groups_->setToolTip(tr("Lists this group alone, and runs it alone"));
  connect(groups_, &QComboBox::currentIndexChanged, this, &RunList::showGroup);
  groups_->setVisible(names.size() > 1);
  if (names.size() > 1) row.addWidget(groups_);
}

void RunList::showGroup() {
  for (std::size_t i = 0; i < items_.size(); ++i)
    table_->setRowHidden(static_cast<int>(i), groups_->currentIndex() > 0 && items_[i].group != groups_->currentText());
  table_->clearSelection();
}

void RunList::runQuick() {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < items_.size(); ++i)
    if (!items_[i].takesLong && !table_->isRowHidden(static_cast<int>(i))) indices.push_back(i);
  run(std::move(indices));
}

void RunList::runSelected() {
  std::vector<std::size_t> indices;
  for (const QModelIndex& row : table_->selectionModel()->selectedRows())
    if (!table_->isRowHidden(row.row())) indices.push_back(static_cast<std::size_t>(row.row()));
  std::sort(indices.begin(), indices.end());
  run(std::move(indices));
}

void RunList::run(std::vector<std::size_t> indices) {
  if (indices.empty() || job_.isBusy()) return;
  waiting_ = std::move(indices);
  start(waiting_, repeat_->isChecked());
  for (const std::size_t index : waiting_) showRow(index);
  showProgress(0, {});
  refresh();
}

void RunList::takeEnded() {
  const std::size_t index = waiting_.front();
  waiting_.erase(waiting_.begin());
  showRow(index);
  if (!waiting_.empty()) showRow(waiting_.front());
  if (static_cast<int>(index) == table_->currentRow()) showCurrent();
}

void RunList::showRow(std::size_t index) {
  const auto waits = std::find(waiting_.begin(), waiting_.end(), index);
  std::optional<RunVerdict> shown = verdict(index);
  if (waits != waiting_.end()) {
    shown = RunVerdict{.words = tr("waits"), .icon = {}, .tone = theme::Tone::accent, .figures = {}};
    if (waits == waiting_.begin()) shown->words = tr("running"), shown->icon = QStringLiteral("play");
  }
  const int row = static_cast<int>(index), first_figure = first_fact + static_cast<int>(words_.facts.size());
  QTableWidgetItem& result = *table_->item(row, result_column);
  result.setText(shown ? shown->words : items_[index].takesLong ? tr("long; not run") : tr("not run"));
  const QString& caution = items_[index].caution;
  result.setToolTip(caution);
  if (shown)
    result.setIcon(shown->icon.isEmpty() ? QIcon() : theme::icon(shown->icon, shown->tone));
  else
    result.setIcon(caution.isEmpty() ? QIcon() : theme::icon(QStringLiteral("warning"), theme::Tone::muted));
  for (int i = 0; i < words_.figures.size(); ++i)
    table_->item(row, first_figure + i)->setText(shown ? shown->figures.value(i) : QString());
  table_->item(row, table_->columnCount() - 1)
      ->setText(shown && shown->seconds > 0 ? numbers::duration(shown->seconds) : QString());
}

void RunList::showCurrent() {
  if (table_->currentRow() >= 0) showPage(static_cast<std::size_t>(table_->currentRow()));
}

void RunList::showProgress(double fraction, const QString& what) {
  showShare(*bar_, fraction);
  what_->setText(what);
  const auto seconds = job_.timeLeft().seconds();
  left_->setText(seconds ? tr("%1 left").arg(numbers::duration(*seconds)) : QString());
}

void RunList::refresh() {
  const bool busy = job_.isBusy();
  for (QWidget* widget : {static_cast<QWidget*>(bar_), static_cast<QWidget*>(left_), static_cast<QWidget*>(cancel_)})
    widget->setVisible(busy);
  int ran = 0, passed = 0;
  for (std::size_t i = 0; i < items_.size(); ++i)
    if (const auto came = verdict(i)) ++ran, passed += came->passed ? 1 : 0;
  if (!busy) what_->setText(ran == 0 ? QString() : words_.passed.arg(passed).arg(ran));
  const QString goesOn = busy ? words_.goesOn : QString();
  const QString nothing = table_->selectionModel()->hasSelection() ? QString() : tr("Select a line first");
  const auto allow = [](QWidget* button, const QString& whyNot) {
    button->setEnabled(whyNot.isEmpty());
    button->setToolTip(whyNot);
  };
  allow(runQuick_, goesOn);
  allow(runSelected_, busy ? goesOn : nothing);
  allow(export_, ran == 0 ? words_.none : QString());
  repeat_->setEnabled(!busy);
}

bool RunList::exportJson(const std::filesystem::path& file) const {
  std::ofstream stream(file);
  stream << json();
  stream.close();
  return static_cast<bool>(stream);
}

void RunList::askForExport() {
  const QString name = QFileDialog::getSaveFileName(this, tr("Export the results"), words_.file, tr("JSON (*.json)"));
  if (name.isEmpty() || exportJson(name.toStdString())) return;
  what_->setText(tr("%1 cannot be written; choose another place").arg(name));
}

}  // namespace talus
