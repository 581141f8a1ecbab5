#pragma once

#include "widgets/kit/plain_table.hpp"

namespace talus {

class CurrentRun;
class Playback;

/// What happened in the run, in order: a row that is chosen, by a click or the arrow keys, leads to its moment, and the
/// last one that has happened by the moment in view is chosen. Hidden where there is nothing to list, and on pages that
/// tell of no run.
class EventList : public PlainTable {
  Q_OBJECT
 public:
  EventList(CurrentRun& run, Playback& playback);
  /// The page tells of a run.
  void setWanted(bool wanted);

 private:
  void refresh();
  void markMoment();
  int frameOf(int row) const;

  CurrentRun& run_;
  Playback& playback_;
  bool wanted_ = false;
};

}  // namespace talus
