#pragma once

#include <QSize>
#include <QString>

#include "widgets/window/main_window.hpp"

namespace talus {

/// What `talus --screenshot` was asked for; empty strings where nothing was said.
struct ScreenshotRequest {
  QString out, file, page, field, time, select, begin;  ///< time: s; select: a place of the project; begin: a template
  QSize size;
};

/// Reads "1280x800"; returns what is wrong with it, or nothing.
QString readSize(const QString& text, QSize& size);

/// What is wrong with the name of a template, or nothing; empty names none.
QString checkTemplate(const QString& key);

/// Opens the file, meshes the project where there are no results, goes to the page, and writes a picture of the
/// window when all of it is drawn. Returns the program's exit code.
int takeScreenshot(MainWindow& window, const ScreenshotRequest& request);

}  // namespace talus
