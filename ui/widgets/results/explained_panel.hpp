#pragma once

#include <QWidget>

class QLabel;

namespace talus {

/// A panel with something that is measured, or in its place a sentence that says why there is nothing.
class ExplainedPanel : public QWidget {
  Q_OBJECT
 protected:
  explicit ExplainedPanel(QWidget* content);
  /// Empty: the content is shown.
  void explain(const QString& why);

 private:
  QWidget* content_;
  QLabel* sentence_;
};

}  // namespace talus
