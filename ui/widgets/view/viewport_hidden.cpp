// Which blocks the 3-D view draws.
#include <algorithm>

#include "document/selection.hpp"
#include "widgets/view/viewport.hpp"

namespace talus {

void Viewport::hideSelected() {
  if (!scene_) return;
  const std::vector<int> chosen = selectedInView();
  hidden_.insert(hidden_.end(), chosen.begin(), chosen.end());
  scene_->set_hidden(hidden_);
  selection().clear();
  render();
}

void Viewport::isolateSelected() {
  const std::vector<int> chosen = selectedInView();
  if (!scene_ || chosen.empty()) return;
  hidden_.clear();
  for (int block = 0; block < static_cast<int>(system_->blocks.size()); ++block)
    if (!std::binary_search(chosen.begin(), chosen.end(), block)) hidden_.push_back(block);
  scene_->set_hidden(hidden_);
  render();
}

void Viewport::showAll() {
  if (!scene_) return;
  hidden_.clear();
  scene_->set_hidden({});
  render();
}

}  // namespace talus
