#pragma once

#include <QObject>
#include <optional>
#include <utility>
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
  const std::vector<int>& blocks() const { return together(Item::Kind::block); }
  /// Solids, likewise: one selects the ones or the others.
  const std::vector<int>& solids() const { return together(Item::Kind::solid); }
  std::optional<int> hoveredBlock() const { return hovered(Item::Kind::block); }
  std::optional<int> hoveredSolid() const { return hovered(Item::Kind::solid); }

  void select(const Item& item);
  /// These blocks, or solids, together; the last one is the current one.
  void selectBlocks(std::vector<int> blocks) { selectTogether(Item::Kind::block, std::move(blocks)); }
  void selectSolids(std::vector<int> solids) { selectTogether(Item::Kind::solid, std::move(solids)); }
  /// Adds a block, or a solid, or takes it out.
  void toggleBlock(int block) { toggle({Item::Kind::block, block}); }
  void toggleSolid(int solid) { toggle({Item::Kind::solid, solid}); }
  void clear() { select({}); }
  /// What the pointer is over; nothing where it has left.
  void hover(const Item& item = {});
  void hoverBlock(std::optional<int> block) { hover(block ? Item{Item::Kind::block, *block} : Item{}); }

 signals:
  void changed();
  void hoverChanged();

 private:
  const std::vector<int>& together(Item::Kind kind) const;
  std::optional<int> hovered(Item::Kind kind) const;
  void selectTogether(Item::Kind kind, std::vector<int> indices);
  void toggle(const Item& item);

  Item current_, hovered_;
  std::vector<int> together_;  ///< all that are selected with the current one, of its kind
};

}  // namespace talus
