#pragma once

#include <QAbstractButton>
#include <QApplication>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QTest>
#include <QTimer>
#include <filesystem>

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

/// Types the name of a file into the next dialog that asks for one, as soon as it is there, and presses Enter.
class FileAnswer : public QObject {
 public:
  explicit FileAnswer(const std::filesystem::path& file) {
    timer_.setInterval(10);
    connect(&timer_, &QTimer::timeout, this, [this, file] {
      auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      auto* name = dialog ? dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit")) : nullptr;
      if (!name || !dialog->isActiveWindow()) return;
      asked_ = dialog->windowTitle();
      proposed_ = name->text();
      timer_.stop();
      name->selectAll();
      QTest::keyClicks(name, QString::fromStdString(file.string()));
      QTest::keyClick(name, Qt::Key_Return);
      if (dialog->isVisible()) dialog->reject();  // it was refused: the test sees it by what follows
    });
    timer_.start();
  }
  /// The title of the dialog; empty where none came.
  const QString& asked() const { return asked_; }
  const QString& proposed() const { return proposed_; }  ///< the name that it began with

 private:
  QTimer timer_;
  QString asked_, proposed_;
};

}  // namespace talus
