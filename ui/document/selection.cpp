#include "document/selection.hpp"

#include <algorithm>

namespace talus {

namespace {

bool isSelectedTogether(Item::Kind kind) { return kind == Item::Kind::block || kind == Item::Kind::solid; }

}  // namespace

const std::vector<int>& Selection::together(Item::Kind kind) const {
  static const std::vector<int> none;
  return current_.kind == kind ? together_ : none;
}

std::optional<int> Selection::hovered(Item::Kind kind) const {
  return hovered_.kind == kind ? std::optional(hovered_.index) : std::nullopt;
}

void Selection::select(const Item& item) {
  std::vector<int> indices;
  if (isSelectedTogether(item.kind)) indices.push_back(item.index);
  if (item == current_ && indices == together_) return;
  current_ = item;
  together_ = std::move(indices);
  emit changed();
}

void Selection::selectTogether(Item::Kind kind, std::vector<int> indices) {
  std::sort(indices.begin(), indices.end());
  current_ = indices.empty() ? Item{} : Item{kind, indices.back()};
  together_ = std::move(indices);
  emit changed();
}

void Selection::toggle(const Item& item) {
  if (current_.kind != item.kind) together_.clear();
  const auto place = std::lower_bound(together_.begin(), together_.end(), item.index);
  if (place != together_.end() && *place == item.index) {
    together_.erase(place);
    current_ = together_.empty() ? Item{} : Item{item.kind, together_.back()};
  } else {
    together_.insert(place, item.index);
    current_ = item;
  }
  emit changed();
}

void Selection::hover(const Item& item) {
  if (item == hovered_) return;
  hovered_ = item;
  emit hoverChanged();
}

}  // namespace talus
