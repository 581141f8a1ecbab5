#pragma once

#include <QObject>
#include <optional>
#include <vector>

namespace talus {

/// A thing that the window can point at: its kind and its place in the project's (or the block system's) list.
struct Item {
  enum class Kind {
    none,
    solid,
    cut,
    joint,
    block,      ///< as it was cut
    blockWish,  ///< name and overrides that the project has for a block
    merge,      ///< of two blocks
    splinters,
    mesh,  ///< how finely blocks are meshed
    interface,
    material,
    load,
    constraint,
    velocity,
    inSitu,
    stage,
    monitor,
    expectation,
    solver,
    output
  };
  Kind kind = Kind::none;
  int index = -1;
  bool operator==(const Item&) const = default;
};

/// What is selected and what the pointer is over: shared by tree, tables and view. Widgets ask for a change here and
/// repaint when told; none keeps a selection of its own.
class Selection : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  /// The last one that was selected: whose properties are shown.
  const Item& current() const { return current_; }
  /// Blocks that are selected, ascending; more than one after Ctrl and a click.
  const std::vector<int>& blocks() const { return blocks_; }
  std::optional<int> hoveredBlock() const { return hovered_; }

  void select(const Item& item);
  /// These blocks together; the last one is the current one.
  void selectBlocks(std::vector<int> blocks);
  /// Adds a block or takes it out.
  void toggleBlock(int block);
  void clear() { select({}); }
  void hoverBlock(std::optional<int> block);

 signals:
  void changed();
  void hoverChanged();

 private:
  Item current_;
  std::vector<int> blocks_;
  std::optional<int> hovered_;
};

}  // namespace talus
