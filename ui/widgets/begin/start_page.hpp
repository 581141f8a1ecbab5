#pragma once

#include <QFrame>
#include <filesystem>

class QGridLayout;
class QPushButton;
class QVBoxLayout;

namespace talus {

/// Where a project is begun: new, from a template, from a sample, or one of the files that were open before.
class StartPage : public QWidget {
  Q_OBJECT
 public:
  StartPage();
  /// Reads the recent files again. `mayReturn`: a project is open behind the page.
  void refresh(bool mayReturn);

 signals:
  void returnRequested();
  /// By its key; empty: the user has still to choose.
  void templateChosen(const QString& key);
  /// To be opened as a copy.
  void sampleChosen(const std::filesystem::path& file);
  void openRequested();
  void openResultsRequested();
  void fileChosen(const std::filesystem::path& file);

 private:
  QWidget* makeLeft();
  static QPushButton* addButton(QVBoxLayout& column, const QString& words, const QString& icon, const char* kind);
  static QGridLayout* addHeading(QVBoxLayout& column, const QString& title, const QString& note);
  void addTemplates(QVBoxLayout& column);
  void addSamples(QVBoxLayout& column);
  QPushButton* return_;
  QVBoxLayout* recent_;
};

/// A template or a sample with its picture; a click chooses it.
class StartCard : public QFrame {
  Q_OBJECT
 public:
  StartCard(const QString& name, const QString& description, const QString& picture);

 signals:
  void chosen();

 protected:
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
};

}  // namespace talus
