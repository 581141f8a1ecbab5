#pragma once

#include <memory>

#include "measures/block_history.hpp"
#include "session/results_measure.hpp"

namespace talus {

class CurrentProject;

/// What became of the blocks that are selected, of the first six of them.
class BlockHistories : public ResultsMeasure {
  Q_OBJECT
 public:
  BlockHistories(CurrentProject& project, Playback& playback);

  /// Null where nothing is measured yet, or no block is selected.
  const std::shared_ptr<const BlockHistory>& history() const { return history_; }
  const std::vector<int>& blocks() const { return blocks_; }

 private:
  Work work() override;
  void forget() override { history_.reset(); }
  void takeSelection();

  CurrentProject& project_;
  std::vector<int> blocks_;
  std::shared_ptr<const BlockHistory> history_;
};

}  // namespace talus
