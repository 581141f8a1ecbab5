#include "session/block_histories.hpp"

#include "document/document.hpp"
#include "session/current_project.hpp"

namespace talus {

namespace {
constexpr std::size_t most_histories = 6;  // curves that a plot tells apart
}

BlockHistories::BlockHistories(CurrentProject& project, Playback& playback)
    : ResultsMeasure(playback), project_(project) {
  connect(&project.selection(), &Selection::changed, this, &BlockHistories::takeSelection);
}

void BlockHistories::takeSelection() {
  std::vector<int> blocks = project_.selection().blocks();
  if (blocks.size() > most_histories) blocks.resize(most_histories);
  if (blocks == blocks_) return;
  blocks_ = std::move(blocks);
  askAnew();
}

ResultsMeasure::Work BlockHistories::work() {
  if (blocks_.empty()) return {};
  std::vector<double> densities;
  for (const Material& material : project_.document().project().materials) densities.push_back(material.density);
  return [this, blocks = blocks_, densities](const ResultReader& results, Progress& progress) {
    const auto history = std::make_shared<const BlockHistory>(block_history(results, blocks, densities, progress));
    return [this, history] { history_ = history; };
  };
}

}  // namespace talus
