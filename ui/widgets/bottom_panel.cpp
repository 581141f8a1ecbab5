#include "widgets/bottom_panel.hpp"

#include <QTabBar>
#include <QTime>

#include "widgets/history_panel.hpp"
#include "widgets/problem_list.hpp"
#include "widgets/step_table.hpp"
#include "widgets/theme.hpp"

namespace talus {

BottomPanel::BottomPanel(Workspace& workspace) : workspace_(workspace) {
  setDocumentMode(true);
  tabBar()->setExpanding(false);
  auto* table = new StepTable(workspace);
  table_ = table;
  histories_ = new HistoryPanel(workspace);
  problems_ = new ProblemList(workspace);
  log_ = new QPlainTextEdit;
  log_->setReadOnly(true);
  log_->setMaximumBlockCount(5000);
  log_->setFrameShape(QFrame::NoFrame);
  log_->setProperty("kind", "log");
  log_->setAccessibleName(tr("Log"));
  addTab(table_, {});
  addTab(histories_, tr("Histories"));
  addTab(problems_, {});
  addTab(log_, tr("Log"));
  auto title = [this](const QString& words) { setTabText(indexOf(table_), words); };
  connect(table, &StepTable::titleChanged, this, title);
  title(rowsOf(workspace_.step(), workspace_.document().project(), nullptr).title);
  connect(&workspace_, &Workspace::stepChanged, this, &BottomPanel::showStep);
  connect(&workspace_, &Workspace::problemsChanged, this, &BottomPanel::countProblems);
  connect(&workspace_, &Workspace::logged, this, [this](const QString& line) {
    log_->appendPlainText(QTime::currentTime().toString(QStringLiteral("HH:mm:ss  ")) + line);
  });
  countProblems();
}

void BottomPanel::showStep() { setCurrentWidget(isSetUp(workspace_.step()) ? table_ : histories_); }

void BottomPanel::countProblems() {
  const int tab = indexOf(problems_);
  const auto count = workspace_.problems().size();
  setTabText(tab, count == 0 ? tr("Problems") : tr("Problems  %1").arg(count));
  setTabIcon(tab, count == 0 ? QIcon() : theme::icon(QStringLiteral("warning"), theme::Tone::warn));
}

}  // namespace talus
