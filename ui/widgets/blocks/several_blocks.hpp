#pragma once

#include <QWidget>
#include <functional>
#include <vector>

#include "session/block_edits.hpp"

namespace talus {

class BlockSurvey;
class CurrentProject;
class Messages;
class Section;

/// Several selected blocks: what they are together, and what can be given to all of them at once, each as one step that
/// can be undone.
class SeveralBlocks : public QWidget {
  Q_OBJECT
 public:
  SeveralBlocks(CurrentProject& project, const BlockSurvey& survey, Messages& messages, std::vector<int> blocks);

 private:
  void addEdits(Section& section);
  void addName(Section& section);
  void addBody(Section& section);
  void addMaterial(Section& section);
  void addMeshSize(Section& section);
  void addFacts();
  Section* add(const QString& title, const QString& note = {});
  /// Says a problem where the project would be impossible.
  void tryTo(const std::function<void()>& act);

  CurrentProject& project_;
  const BlockSurvey& survey_;
  Messages& messages_;
  std::vector<int> blocks_;
  std::vector<BlockOverride> said_;  ///< of each, body and material as the project has them now
};

}  // namespace talus
