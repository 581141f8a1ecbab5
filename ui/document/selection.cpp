#include "document/selection.hpp"

#include <algorithm>

namespace talus {

void Selection::select(const Item& item) {
  std::vector<int> blocks;
  if (item.kind == Item::Kind::block) blocks.push_back(item.index);
  if (item == current_ && blocks == blocks_) return;
  current_ = item;
  blocks_ = std::move(blocks);
  emit changed();
}

void Selection::selectBlocks(std::vector<int> blocks) {
  std::sort(blocks.begin(), blocks.end());
  current_ = blocks.empty() ? Item{} : Item{Item::Kind::block, blocks.back()};
  blocks_ = std::move(blocks);
  emit changed();
}

void Selection::toggleBlock(int block) {
  const auto place = std::lower_bound(blocks_.begin(), blocks_.end(), block);
  if (place != blocks_.end() && *place == block) {
    blocks_.erase(place);
    current_ = blocks_.empty() ? Item{} : Item{Item::Kind::block, blocks_.back()};
  } else {
    blocks_.insert(place, block);
    current_ = {Item::Kind::block, block};
  }
  emit changed();
}

void Selection::hoverBlock(std::optional<int> block) {
  if (block == hovered_) return;
  hovered_ = block;
  emit hoverChanged();
}

}  // namespace talus
