#pragma once

#include <QSize>
#include <QString>

#include "widgets/window/main_window.hpp"

namespace talus {

/// What `talus --screenshot` was asked for; empty strings where nothing was said.
struct ScreenshotRequest {
  QString out, file, page, field, time;  ///< time: s
  QSize size;
};

/// Reads "1280x800"; returns what is wrong with it, or nothing.
QString readSize(const QString& text, QSize& size);

/// Opens the file, meshes the project where there are no results, goes to the page, and writes a picture of the
/// window when all of it is drawn. Returns the program's exit code.
int takeScreenshot(MainWindow& window, const ScreenshotRequest& request);

}  // namespace talus
