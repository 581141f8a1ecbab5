#pragma once

#include <QDateTime>
#include <QLockFile>
#include <QString>
#include <filesystem>
#include <memory>
#include <vector>

#include "document/document.hpp"

namespace talus {

/// Where unsaved work is kept: the user's folder for the state of programs (XDG_STATE_HOME, ~/.local/state).
std::filesystem::path recoveryFolder();

/// The place of one window's unsaved work. A lock beside it tells other windows that this one is alive; the system
/// takes it away from a process that has gone.
class RecoverySlot {
 public:
  explicit RecoverySlot(const std::filesystem::path& folder = recoveryFolder());
  /// Empties it: a window that ends in order has nothing to recover.
  ~RecoverySlot();

  /// Writes all or nothing. Throws InputError where it cannot be written.
  void keep(const Draft& draft, const QString& name);
  void clear();
  bool isEmpty() const;

 private:
  QString file_;
  std::unique_ptr<QLockFile> lock_;
};

/// Work that a window left behind that has gone without closing. While this lives, no other window is offered it.
struct Leftover {
  Draft draft;
  QString name;
  QDateTime when;  ///< of the last writing
  /// It has been recovered, or is not wanted.
  void discard() const;

  QString path;  ///< where it is kept
  std::shared_ptr<QLockFile> lock;
};

/// All of it, the newest first.
std::vector<Leftover> leftovers(const std::filesystem::path& folder = recoveryFolder());

}  // namespace talus
