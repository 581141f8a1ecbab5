#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "mesh/mesh_survey.hpp"
#include "removability/block_facts.hpp"

namespace talus {

class BackgroundJob;
class CurrentProject;

/// What is found out about the blocks once they are cut, on a thread of its own: which can leave their place and how,
/// by the strengths that the project has now, and how well they are meshed.
class BlockSurvey : public QObject {
  Q_OBJECT
 public:
  using Facts = std::vector<BlockFacts>;
  explicit BlockSurvey(CurrentProject& project);
  ~BlockSurvey() override;

  /// Somebody wants to know; nothing is looked for before. It comes with `changed`.
  void want();
  /// Of all blocks, in their order; null until they are known.
  std::shared_ptr<const Facts> facts() const { return facts_; }
  std::shared_ptr<const MeshSurvey> mesh() const { return mesh_; }
  bool isBusy() const;

 signals:
  void changed();

 private:
  void takeSystem();
  void takeProject();
  void start();
  Project projectOfBlocks() const;

  CurrentProject& project_;
  bool wanted_ = false;
  bool isLate_ = false;  ///< blocks or strengths have changed since the survey began that goes on
  std::shared_ptr<const Facts> facts_;
  std::shared_ptr<const MeshSurvey> mesh_;
  Project surveyed_;  ///< what `facts_` hold for
  std::unique_ptr<BackgroundJob> job_;
};

}  // namespace talus
