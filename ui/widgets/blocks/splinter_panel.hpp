#pragma once

#include <QWidget>
#include <functional>

class QLabel;
class QPushButton;

namespace talus {

class PlainTable;
struct Session;

/// The splinters that cuts leave: each is marked in the view, and the buttons say what can be done about them.
class SplinterPanel : public QWidget {
  Q_OBJECT
 public:
  explicit SplinterPanel(Session& session);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QPushButton* addButton(const QString& words, const QString& tip, std::function<void()> act);
  void refresh();
  void mark();
  void showChosen();
  void moveJoint();
  /// The row of the table that is chosen, else the first.
  std::size_t chosen() const;

  Session& session_;
  QLabel* words_;
  PlainTable* table_;
  QWidget* buttons_;
  QPushButton *drop_, *merge_;
};

}  // namespace talus
