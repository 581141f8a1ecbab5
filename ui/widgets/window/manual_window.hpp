#pragma once

#include <QDialog>

#include "document/selection.hpp"
#include "session/workflow_page.hpp"

class QTextBrowser;

namespace talus {

/// The heading of the manual that tells of a page of the workflow, or of the thing that is selected on it.
QString manualHeading(WorkflowPage page, Item::Kind selected);

/// The manual, beside the window.
class ManualWindow : public QDialog {
  Q_OBJECT
 public:
  explicit ManualWindow(QWidget* parent);
  /// With this heading at the top; false where the manual has none.
  bool present(const QString& heading);

 private:
  QTextBrowser* pages_;
};

}  // namespace talus
