#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <string>

#include "document/recovery.hpp"

namespace talus {

class InputError;

/// Keeps the document's unsaved work where a crash does not reach it: at most `interval` after a change, and at once
/// after a large one. What has been saved is kept no longer.
class Autosave : public QObject {
  Q_OBJECT
 public:
  explicit Autosave(Document& document, int interval_ms = 30000);

 signals:
  /// It cannot be kept. Said once until it can be again.
  void failed(const talus::InputError& error);

 private:
  void follow();
  void keep();

  Document& document_;
  RecoverySlot slot_;
  QTimer timer_;
  std::string safe_;  ///< the text that is in the slot or in the project's file
  bool failing_ = false;
};

}  // namespace talus
