#include "session/block_colouring.hpp"

#include <algorithm>

#include "render/paint/theme.hpp"
#include "session/block_survey.hpp"
#include "session/current_project.hpp"
#include "session/display.hpp"

namespace talus {

namespace {

/// Blocks by the class that each is in; classes that no block is in have no place in the key.
BlockColours coloursOf(const QString& title, const std::vector<int>& classes, const std::vector<KeyEntry>& meanings) {
  BlockColours colours{title.toStdString(), {}, {}};
  std::vector<bool> met(meanings.size());
  for (const int which : classes) {
    colours.colours.push_back(meanings[static_cast<std::size_t>(which)].colour);
    met[static_cast<std::size_t>(which)] = true;
  }
  for (std::size_t i = 0; i < meanings.size(); ++i)
    if (met[i]) colours.key.push_back(meanings[i]);
  return colours;
}

/// A colour for each of some named things.
template <class Named>
std::vector<KeyEntry> meaningsOf(const std::vector<Named>& things) {
  std::vector<KeyEntry> meanings;
  for (const Named& thing : things)
    meanings.push_back({block_palette()[meanings.size() % block_palette().size()], thing.name});
  return meanings;
}

template <class Class>
std::vector<int> classesOf(const BlockSystem& system, const Class& classOf) {
  std::vector<int> classes;
  for (const Block& block : system.blocks) classes.push_back(classOf(block));
  return classes;
}

KeyEntry entry(Rgb colour, const QString& meaning) { return {colour, meaning.toStdString()}; }

std::vector<KeyEntry> bodies() {
  const auto& palette = block_palette();
  return {entry(colours(Theme::light).rock, QObject::tr("fixed")), entry(palette[0], QObject::tr("rigid")),
          entry(palette[2], QObject::tr("affine")), entry(palette[1], QObject::tr("tetrahedra"))};
}

/// From what stays to what goes.
std::vector<KeyEntry> waysToLeave() {
  const auto& palette = caution_palette();
  return {entry(colours(Theme::light).rock, QObject::tr("fixed")), entry(palette[0], QObject::tr("cannot leave")),
          entry(palette[1], QObject::tr("removable, stable")),     entry(palette[2], QObject::tr("slides, F above 1")),
          entry(palette[3], QObject::tr("slides, F below 1")),     entry(palette[4], QObject::tr("falls"))};
}

int wayToLeave(const BlockFacts& facts) {
  enum { fixed, stays, stable, slides_safely, slides, falls };
  if (facts.fixed) return fixed;
  switch (facts.leaving.leaving) {
    case Leaving::enclosed:
    case Leaving::tapered:
      return stays;
    case Leaving::stable:
      return stable;
    case Leaving::falls:
      return falls;
    case Leaving::slides_on_one:
    case Leaving::slides_on_two:
      break;
  }
  return facts.leaving.factor && *facts.leaving.factor < 1 ? slides : slides_safely;
}

}  // namespace

QString titleOf(ColourBy by) {
  switch (by) {
    case ColourBy::solid:
      return QObject::tr("Solid");
    case ColourBy::body:
      return QObject::tr("Body");
    case ColourBy::material:
      return QObject::tr("Material");
    case ColourBy::removability:
      return QObject::tr("Removability");
    case ColourBy::block:
      break;
  }
  return QObject::tr("Block");
}

BlockColouring::BlockColouring(CurrentProject& project, BlockSurvey& survey, Display& display)
    : project_(project), survey_(survey), display_(display) {
  connect(&survey_, &BlockSurvey::changed, this, &BlockColouring::refresh);  // comes with other blocks, too
}

void BlockColouring::colourBy(ColourBy by) {
  if (by == by_) return;
  by_ = by;
  if (by == ColourBy::removability) survey_.want();
  refresh();
  emit changed();
}

void BlockColouring::refresh() {
  std::shared_ptr<const BlockColours> chosen;
  const auto take = [&](const std::vector<int>& classes, const std::vector<KeyEntry>& meanings) {
    chosen = std::make_shared<const BlockColours>(coloursOf(titleOf(by_), classes, meanings));
  };
  if (const auto system = project_.system()) {
    switch (by_) {
      case ColourBy::block:
        break;
      case ColourBy::solid:
        take(classesOf(*system, [](const Block& block) { return block.solid; }),
             meaningsOf(project_.builtFrom().solids));
        break;
      case ColourBy::material:
        take(classesOf(*system, [](const Block& block) { return block.material; }),
             meaningsOf(project_.builtFrom().materials));
        break;
      case ColourBy::body:
        take(classesOf(*system, [](const Block& block) { return static_cast<int>(block.body); }), bodies());
        break;
      case ColourBy::removability: {
        if (!survey_.facts()) break;
        std::vector<int> ways;
        std::ranges::transform(*survey_.facts(), std::back_inserter(ways), wayToLeave);
        take(ways, waysToLeave());
        break;
      }
    }
  }
  if (!chosen && !display_.settings().block_colours) return;
  SceneSettings settings = display_.settings();
  settings.block_colours = std::move(chosen);
  display_.set(settings);
}

}  // namespace talus
