#pragma once

#include <QFrame>
#include <filesystem>

#include "widgets/project/samples.hpp"

class QVBoxLayout;

namespace talus {

/// What the window shows before a file is open: recent files and the shipped samples.
class StartPage : public QWidget {
  Q_OBJECT
 public:
  StartPage();
  /// Reads the recent files again.
  void refresh();

 signals:
  void openRequested();
  void openResultsRequested();
  void fileChosen(const std::filesystem::path& file);

 private:
  QWidget* makeLeft();
  QWidget* makeSamples();
  QVBoxLayout* recent_;
};

/// A sample with its picture; a click opens it.
class SampleCard : public QFrame {
  Q_OBJECT
 public:
  explicit SampleCard(const Sample& sample);

 signals:
  void chosen();

 protected:
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
};

}  // namespace talus
