#pragma once

#include <QObject>
#include <QTimer>
#include <filesystem>
#include <optional>
#include <string>

#include "results/folder.hpp"

namespace talus {

/// A run that talus-cli can take over from its checkpoint, by value.
struct OutsideTask {
  std::string project_text;
  std::filesystem::path folder;   ///< paths in the project are relative to it
  std::filesystem::path results;  ///< with the checkpoint
};

/// Goes on with a run in a process that outlives this one, to the same bits. What it says goes into background.txt
/// among the results. Throws InputError where talus-cli (command_line_program) does not start.
void goOnOutside(const OutsideTask& task);

/// A run that another process makes: looks once a second whether one writes into a results folder, and how far it is.
class OutsideRun : public QObject {
  Q_OBJECT
 public:
  explicit OutsideRun(QObject* parent = nullptr);

  /// From now on this folder is looked at; none where it is empty.
  void watch(const std::filesystem::path& folder);

  const std::filesystem::path& folder() const { return folder_; }
  bool isOn() const { return writer_.has_value(); }
  /// Model time that it has come to, s.
  double time() const { return time_; }
  /// A window's run is that window's affair.
  bool canStop() const { return isOn() && writer_->program == "talus-cli"; }
  /// After its step, with a checkpoint.
  void stop();

 signals:
  void changed();  ///< one has begun, or has come further
  void ended();

 private:
  void look();

  std::filesystem::path folder_;
  std::optional<FolderWriter> writer_;
  double time_ = 0;
  QTimer timer_;
};

}  // namespace talus
