#pragma once

#include <QObject>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "render/fields/field_range.hpp"
#include "results/field.hpp"

namespace talus {

class BackgroundJob;
class CurrentProject;
class Playback;

/// The range of a field over every frame of the run, whichever were looked at: of a run that goes on as its frames
/// come, of results on disk by reading all of them once, on a thread of its own.
class RunRange : public QObject {
  Q_OBJECT
 public:
  RunRange(CurrentProject& project, Playback& playback);
  ~RunRange() override;

  /// Which field; empty: none.
  void follow(const std::optional<Field>& field);
  /// Nothing is left to be read.
  bool isWhole() const;
  /// As far as it is known, SI.
  const ValueRange& known() const { return known_; }
  /// Of the field that is followed in a frame of the project's blocks; empty where there are none.
  ValueRange rangeOf(const Frame& frame) const;

 signals:
  void changed();

 private:
  void takeFrames();
  void readAll();
  void include(const ValueRange& range);

  CurrentProject& project_;
  Playback& playback_;
  std::optional<Field> field_;
  ValueRange known_;
  mutable std::shared_ptr<const BlockSystem> system_;  ///< that fields_ is of
  mutable std::unique_ptr<const FieldValues> fields_;  ///< made once: of some fields that takes a while
  std::optional<double> lastLive_;                     ///< s, of the newest frame of a run that goes on that is in it
  std::filesystem::path folder_;                       ///< whose frames are read; empty while a run goes on
  std::map<std::string, ValueRange> whole_;            ///< of the folder, by the field's name
  std::unique_ptr<BackgroundJob> job_;
};

}  // namespace talus
