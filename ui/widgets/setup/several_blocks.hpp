#pragma once

#include <QWidget>
#include <vector>

namespace talus {

struct BlockSystem;
struct Project;

/// What several selected blocks are together: how many, their volume and mass, their bodies and materials.
class SeveralBlocks : public QWidget {
  Q_OBJECT
 public:
  /// `project` is the one that the blocks were built from.
  SeveralBlocks(const BlockSystem& system, const Project& project, const std::vector<int>& blocks);
};

}  // namespace talus
