#pragma once

#include <QTabWidget>

class QPlainTextEdit;
class QStackedWidget;
class QWidget;

namespace talus {

class BlocksPanel;
class EventList;
class MeshPanel;
class PageTable;
class SplinterPanel;
struct Session;
class WindowActions;

/// Under the view: the page's table, histories, problems, log. The tab that a page of the workflow needs comes to the
/// front with it.
class BottomPanel : public QTabWidget {
  Q_OBJECT
 public:
  BottomPanel(Session& session, WindowActions& actions);
  void showProblems();

 private:
  void showPage();
  void showStrip();
  void showTitle();
  void entitle(QWidget& page, const QString& title);
  void countProblems();
  void showSplinters();
  Session& session_;
  QStackedWidget* tables_;  ///< one of these three
  QWidget* page_;           ///< the strip of stages, on their page, and the table
  QWidget* strip_;
  PageTable* table_;
  EventList* events_;  ///< beside the table on pages that tell of a run
  BlocksPanel* blocks_;
  MeshPanel* mesh_;
  SplinterPanel* splinters_;  ///< has no tab while there are none
  QWidget *histories_, *problems_;
  QPlainTextEdit* log_;
};

}  // namespace talus
