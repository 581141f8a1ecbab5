#pragma once

#include <QLabel>
#include <QProgressBar>
#include <QWidget>

#include "widgets/export_job.hpp"

namespace talus {

/// In the status bar while a picture or film is written: how far it is, and a way to cancel.
class ExportStrip : public QWidget {
  Q_OBJECT
 public:
  explicit ExportStrip(ExportJob& job);
  void begin(const QString& what);

 private:
  QLabel* what_;
  QProgressBar* bar_;
};

}  // namespace talus
