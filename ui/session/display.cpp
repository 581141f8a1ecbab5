#include "session/display.hpp"

#include "session/current_project.hpp"
#include "session/playback.hpp"

namespace talus {

Display::Display(CurrentProject& project, Playback& playback) : project_(project), playback_(playback) {
  connect(&playback_, &Playback::frameChanged, this, &Display::takeFrame);
}

void Display::goTo(WorkflowPage page) {
  if (page == page_) return;
  page_ = page;
  emit pageChanged();
}

void Display::takeFrame() {
  const auto frame = playback_.frame();
  if (!frame) {
    seen_ = {};
    settings_.range.reset();
  } else if (settings_.field && project_.system()) {
    seen_.include(field_range(*project_.system(), *frame, *settings_.field));
    settings_.range = rangeFollowsRun_ && !seen_.empty()
                          ? std::optional<ValueRange>(legend_range(*settings_.field, seen_))
                          : std::nullopt;
  }
}

void Display::set(const SceneSettings& settings) {
  const bool anotherField = settings.field != settings_.field;
  settings_ = settings;
  if (anotherField) {
    seen_ = {};
    settings_.range.reset();
    takeFrame();
  }
  emit changed();
}

void Display::setRangeFollowsRun(bool follows) {
  rangeFollowsRun_ = follows;
  takeFrame();
  emit changed();
}

void Display::setDark(bool dark) {
  settings_.theme = dark ? Theme::dark : Theme::light;
  emit themeChanged();
  emit changed();
}

void Display::showTrouble(const ConvergenceTrouble& trouble) {
  std::vector<int> blocks;
  const auto system = project_.system();
  for (std::size_t b = 0; system && b < system->blocks.size(); ++b)
    for (const std::string& name : trouble.blocks)
      if (system->blocks[b].name == name) blocks.push_back(static_cast<int>(b));
  project_.selection().selectBlocks(std::move(blocks));
  emit troubleWanted(trouble);
}

}  // namespace talus
