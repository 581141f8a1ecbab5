#pragma once

#include <QWidget>

#include "widgets/results/export_job.hpp"

class QLabel;
class QProgressBar;

namespace talus {

/// In the status bar while a picture, a film, a report or data are written: how far it is, and a way to cancel.
class ExportStrip : public QWidget {
  Q_OBJECT
 public:
  explicit ExportStrip(ExportJob& job);

 private:
  QString name_;
  QLabel* what_;
  QProgressBar* bar_;
};

}  // namespace talus
