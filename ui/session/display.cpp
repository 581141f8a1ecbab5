#include "session/display.hpp"

#include "document/item_at.hpp"
#include "session/current_project.hpp"
#include "session/playback.hpp"

namespace talus {

Display::Display(CurrentProject& project, Playback& playback)
    : project_(project), playback_(playback), whole_(project, playback) {
  settings_.field = field_named("displacement");
  whole_.follow(settings_.field);
  connect(&playback_, &Playback::frameChanged, this, &Display::takeFrame);
  connect(&project_, &CurrentProject::systemChanged, this, [this] { mark({}); });  // they are places of other blocks
  connect(&project_, &CurrentProject::opened, this, [this] { forgetRanges(); });
  connect(&whole_, &RunRange::changed, this, [this] {
    const auto before = settings_.range;
    takeFrame();
    if (settings_.range != before) emit changed();
  });
}

void Display::goTo(WorkflowPage page) {
  if (page == page_) return;
  page_ = page;
  emit pageChanged();
}

void Display::takeFrame() { settings_.range = legendRange(); }

std::optional<ValueRange> Display::legendRange() const {
  const auto frame = playback_.frame();
  const auto typed = typedRange();
  if (frame && typed) return typed;
  if (!frame || !settings_.field || !project_.system() || !rangeFollowsRun_) return std::nullopt;
  ValueRange range = whole_.known();
  // Until the others are read; and a run shows moments beyond its last frame.
  if (range.empty() || playback_.isLive()) range.include(whole_.rangeOf(*frame));
  return range.empty() ? std::nullopt : std::optional<ValueRange>(legend_range(*settings_.field, range));
}

void Display::set(const SceneSettings& settings) {
  const bool anotherField = settings.field != settings_.field, sameOnly = settings.only == settings_.only;
  settings_ = settings;
  if (anotherField) {
    if (sameOnly) settings_.only = kept(onlyRanges_);  // it was of the other field
    whole_.follow(settings_.field);
    takeFrame();
  }
  keep(onlyRanges_, settings_.only);
  emit changed();
}

void Display::forgetRanges() {
  typedRanges_.clear();
  onlyRanges_.clear();
  settings_.only.reset();
}

std::optional<ValueRange> Display::kept(const RangesOfFields& ranges) const {
  const auto found = settings_.field ? ranges.find(settings_.field->name) : ranges.end();
  return found == ranges.end() ? std::nullopt : std::optional<ValueRange>(found->second);
}

void Display::keep(RangesOfFields& ranges, const std::optional<ValueRange>& range) const {
  if (!settings_.field) return;
  if (range)
    ranges.insert_or_assign(settings_.field->name, *range);
  else
    ranges.erase(settings_.field->name);
}

void Display::setRangeFollowsRun(bool follows) {
  rangeFollowsRun_ = follows;
  takeFrame();
  emit changed();
}

ValueRange Display::spannedRange() const {
  const auto frame = playback_.frame();
  if (settings_.range || !frame || !settings_.field) return settings_.range.value_or(ValueRange{0, 1});
  return legend_range(*settings_.field, whole_.rangeOf(*frame));
}

std::optional<ValueRange> Display::typedRange() const { return kept(typedRanges_); }

void Display::setTypedRange(const std::optional<ValueRange>& range) {
  keep(typedRanges_, range);
  takeFrame();
  emit changed();
}

void Display::show(const SceneSettings& saved) {
  if ((saved.theme == Theme::dark) != isDark()) setDark(saved.theme == Theme::dark);
  SceneSettings settings = saved;
  settings.block_colours = settings_.block_colours;
  settings.places = settings_.places;
  settings.joints = settings_.joints;
  set(settings);
  settings_.only = saved.only;  // and not what the field has kept
  keep(onlyRanges_, saved.only);
  setTypedRange(saved.range);
}

void Display::setDark(bool dark) {
  settings_.theme = dark ? Theme::dark : Theme::light;
  emit themeChanged();
  emit changed();
}

void Display::showField(const QString& place) {
  goTo(pageOf(place));
  project_.selection().select(itemAt(project_.document().project(), place));
  emit fieldWanted(place);
}

void Display::mark(std::vector<MarkedPlace> places) {
  if (places == settings_.places) return;
  settings_.places = std::move(places);
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
