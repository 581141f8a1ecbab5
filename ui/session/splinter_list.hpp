#pragma once

#include <QObject>
#include <optional>
#include <vector>

#include "mesh/cutting_report.hpp"
#include "model/rock/blocks.hpp"

namespace talus {

class CurrentProject;
class CurrentRun;
struct JobEnd;

/// The splinters that cuts leave: those for which the last cutting was refused, or else those of the blocks that there
/// are, which were left out or made part of a neighbour.
class SplinterList : public QObject {
  Q_OBJECT
 public:
  SplinterList(CurrentProject& project, CurrentRun& run);

  const std::vector<Splinter>& all() const { return all_; }
  /// There are no blocks because of them.
  bool areRefused() const { return !all_.empty() && all_.front().fate == Splinter::Fate::refused; }

  /// What becomes of splinters from now on; one step that can be undone. Throws InputError.
  void decide(SplinterRule rule);
  /// The cut that leaves a splinter, by its nearest plane; none where the project has no cuts.
  std::optional<int> cutBeside(const Splinter& splinter) const;

 signals:
  void changed();

 private:
  void takeEnd(const JobEnd& end);
  void takeSystem();

  CurrentProject& project_;
  std::vector<Splinter> all_;
};

}  // namespace talus
