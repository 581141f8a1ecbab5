#pragma once

#include <QTabWidget>

class QPlainTextEdit;

namespace talus {

struct Session;

/// Under the view: the page's table, histories, problems, log. The tab that a page of the workflow needs comes to the
/// front with it.
class BottomPanel : public QTabWidget {
  Q_OBJECT
 public:
  explicit BottomPanel(Session& session);
  void showProblems();

 private:
  void showPage();
  void countProblems();
  Session& session_;
  QWidget *table_, *histories_, *problems_;
  QPlainTextEdit* log_;
};

}  // namespace talus
