#include "widgets/window/bottom_panel.hpp"

#include <QPlainTextEdit>
#include <QTabBar>
#include <QTime>

#include "session/session.hpp"
#include "widgets/kit/theme.hpp"
#include "widgets/project/page_table.hpp"
#include "widgets/project/problem_list.hpp"
#include "widgets/results/history_panel.hpp"

namespace talus {

BottomPanel::BottomPanel(Session& session) : session_(session) {
  setDocumentMode(true);
  tabBar()->setExpanding(false);
  auto* table = new PageTable(session.project, session.playback, session.display);
  table_ = table;
  histories_ = new HistoryPanel(session.run, session.playback, session.display);
  problems_ = new ProblemList(session.project, session.messages, session.display);
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
  connect(table, &PageTable::titleChanged, this, title);
  title(rowsOf(session_.display.page(), session_.project.document().project(), nullptr).title);
  connect(&session_.display, &Display::pageChanged, this, &BottomPanel::showPage);
  connect(&session_.messages, &Messages::problemsChanged, this, &BottomPanel::countProblems);
  connect(&session_.project.problems(), &ProjectProblems::changed, this, &BottomPanel::countProblems);
  connect(&session_.messages, &Messages::logged, this, [this](const QString& line) {
    log_->appendPlainText(QTime::currentTime().toString(QStringLiteral("HH:mm:ss  ")) + line);
  });
  countProblems();
}

void BottomPanel::showPage() { setCurrentWidget(isSetUp(session_.display.page()) ? table_ : histories_); }

void BottomPanel::showProblems() { setCurrentWidget(problems_); }

void BottomPanel::countProblems() {
  const int tab = indexOf(problems_);
  const auto count = session_.messages.problems().size() + session_.project.problems().all().size();
  setTabText(tab, count == 0 ? tr("Problems") : tr("Problems  %1").arg(count));
  setTabIcon(tab, count == 0 ? QIcon() : theme::icon(QStringLiteral("warning"), theme::Tone::warn));
}

}  // namespace talus
