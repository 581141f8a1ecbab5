#include "widgets/window/bottom_panel.hpp"

#include <QBoxLayout>
#include <QPlainTextEdit>
#include <QStackedWidget>
#include <QTabBar>
#include <QTime>
#include <algorithm>

#include "session/session.hpp"
#include "widgets/actions/stage_strip.hpp"
#include "widgets/blocks/block_actions.hpp"
#include "widgets/blocks/blocks_panel.hpp"
#include "widgets/blocks/mesh_panel.hpp"
#include "widgets/blocks/splinter_panel.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/theme.hpp"
#include "widgets/project/page_table.hpp"
#include "widgets/project/problem_list.hpp"
#include "widgets/results/block_history_panel.hpp"
#include "widgets/results/event_list.hpp"
#include "widgets/results/history_panel.hpp"
#include "widgets/results/line_panel.hpp"
#include "widgets/results/slide_panel.hpp"
#include "widgets/results/slipped_joints_panel.hpp"
#include "widgets/window/top_bar.hpp"

namespace talus {

BottomPanel::BottomPanel(Session& session, WindowActions& actions) : session_(session), tables_(new QStackedWidget) {
  setDocumentMode(true);
  tabBar()->setExpanding(false);
  table_ = new PageTable(session.project, session.playback, session.display);
  strip_ = new StageStrip(session.project, session.messages, session.display);
  page_ = new QWidget;
  auto* column = new QVBoxLayout(page_);
  setMargins(column, 0, 0);
  column->addWidget(strip_);
  auto* row = new QHBoxLayout;
  setMargins(row, 0, 0);
  row->addWidget(table_, 3);
  events_ = new EventList(session.run, session.playback);
  row->addWidget(events_, 2);
  column->addLayout(row, 1);
  QList<QToolButton*> tools{makeActionButton(actions.blocks->byRule, true)};
  for (auto* action :
       {actions.blocks->everyOne, actions.blocks->others, actions.blocks->neighbours, actions.blocks->lasso})
    tools << makeActionButton(action, false);
  blocks_ = new BlocksPanel(session, tools,
                            {actions.hide, actions.isolate, actions.showAll, actions.blocks->neighbours,
                             actions.blocks->excavate, actions.blocks->merge});
  mesh_ = new MeshPanel(session);
  for (QWidget* table : std::initializer_list<QWidget*>{page_, blocks_, mesh_}) tables_->addWidget(table);
  splinters_ = new SplinterPanel(session);
  splinters_->setParent(this);
  splinters_->hide();
  histories_ = new HistoryPanel(session.run, session.playback, session.display);
  auto* histories = new BlockHistoryPanel(session.histories, session.playback, session.messages);
  auto* slide = new SlidePanel(session.slide, session.playback, session.display);
  auto* slips = new SlippedJointsPanel(session.slips);
  auto* alongLine = new LinePanel(session.line, session.messages);
  problems_ = new ProblemList(session.project.problems(), session.messages, session.display);
  log_ = new QPlainTextEdit;
  log_->setReadOnly(true);
  log_->setMaximumBlockCount(5000);
  log_->setFrameShape(QFrame::NoFrame);
  log_->setProperty("kind", "log");
  log_->setAccessibleName(tr("Log"));
  addTab(tables_, {});
  addTab(histories_, tr("Histories"));
  addTab(histories, tr("Blocks' histories"));
  addTab(slide, tr("Run-out"));
  addTab(slips, tr("Joints that slipped"));
  addTab(alongLine, tr("Along a line"));
  addTab(problems_, {});
  addTab(log_, tr("Log"));
  connect(table_, &PageTable::titleChanged, this, &BottomPanel::showTitle);
  connect(blocks_, &BlocksPanel::titleChanged, this, &BottomPanel::showTitle);
  connect(mesh_, &MeshPanel::titleChanged, this, &BottomPanel::showTitle);
  connect(&session_.display, &Display::pageChanged, this, &BottomPanel::showPage);
  connect(&session_.project, &CurrentProject::opened, this, &BottomPanel::showStrip);
  connect(&session_.project.document(), &Document::projectChanged, this, &BottomPanel::showStrip);
  connect(&session_.messages, &Messages::problemsChanged, this, &BottomPanel::countProblems);
  connect(&session_.project.problems(), &ProjectProblems::changed, this, &BottomPanel::countProblems);
  connect(&session_.messages, &Messages::logged, this, [this](const QString& line) {
    log_->appendPlainText(QTime::currentTime().toString(QStringLiteral("HH:mm:ss  ")) + line);
  });
  connect(&session_.splinters, &SplinterList::changed, this, &BottomPanel::showSplinters);
  countProblems();
  showPage();
}

/// They have a tab while there are some, which comes to the front where they keep the rock from being cut.
void BottomPanel::showSplinters() {
  const int tab = indexOf(splinters_);
  const auto count = session_.splinters.all().size();
  if (count == 0) {
    const bool isShown = tab >= 0 && currentIndex() == tab;
    if (tab >= 0) removeTab(tab);
    if (isShown) setCurrentWidget(tables_);
    return;
  }
  const QString title = tr("Splinters  %1").arg(count);
  if (tab < 0)
    insertTab(1, splinters_, title);
  else
    setTabText(tab, title);
  if (session_.splinters.areRefused()) setCurrentWidget(splinters_);
}

void BottomPanel::showStrip() {
  const bool hasStages = !session_.project.document().project().stages.empty();
  strip_->setVisible(hasStages && session_.display.page() == WorkflowPage::stages);
}

void BottomPanel::showPage() {
  const WorkflowPage page = session_.display.page();
  showStrip();
  events_->setWanted(page == WorkflowPage::solve || page == WorkflowPage::results);
  if (page == WorkflowPage::blocks)
    tables_->setCurrentWidget(blocks_);
  else if (page == WorkflowPage::mesh)
    tables_->setCurrentWidget(mesh_);
  else
    tables_->setCurrentWidget(page_);
  showTitle();
  setCurrentWidget(isSetUp(page) ? static_cast<QWidget*>(tables_) : histories_);
}

void BottomPanel::showTitle() {
  const QWidget* shown = tables_->currentWidget();
  entitle(*tables_, shown == blocks_ ? blocks_->title() : shown == mesh_ ? mesh_->title() : table_->title());
}

void BottomPanel::entitle(QWidget& page, const QString& title) {
  const int tab = indexOf(&page);
  if (tabText(tab) != title) setTabText(tab, title);  // Qt lays all tabs out anew, for the same words too
}

void BottomPanel::showProblems() { setCurrentWidget(problems_); }

void BottomPanel::countProblems() {
  std::vector<Problem> problems = session_.messages.problems();
  problems.insert(problems.end(), session_.project.problems().all().begin(), session_.project.problems().all().end());
  entitle(*problems_, problems.empty() ? tr("Problems") : tr("Problems  %1").arg(problems.size()));
  const auto worst = std::ranges::max_element(problems, {}, &Problem::severity);
  setTabIcon(indexOf(problems_), problems.empty() ? QIcon() : iconOfProblems(worst->severity));
}

}  // namespace talus
