#pragma once

#include <QAbstractButton>
#include <QApplication>
#include <QMessageBox>
#include <QTimer>

namespace talus {

/// Clicks a button of the next question, by its words, as soon as it is there; keeps what was asked.
class Answer : public QObject {
 public:
  explicit Answer(const QString& words) {
    timer_.setInterval(10);
    connect(&timer_, &QTimer::timeout, this, [this, words] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (!box) return;
      asked_ = box->text();
      timer_.stop();
      for (auto* button : box->buttons())
        if (button->text().remove(u'&').startsWith(words)) return button->click();
      box->reject();  // there is no such button: the test sees it by what follows
    });
    timer_.start();
  }
  /// What the question said; empty where none came.
  const QString& asked() const { return asked_; }

 private:
  QTimer timer_;
  QString asked_;
};

}  // namespace talus
