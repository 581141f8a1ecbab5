#include "measures/slide.hpp"

#include <algorithm>

namespace talus {

const FrontMoment* Slide::fastest() const {
  const auto found = std::ranges::max_element(front, {}, &FrontMoment::velocity);
  return found == front.end() ? nullptr : &*found;
}

Slide measure_slide(const ResultReader& results, int frame, const SlideSettings& settings, Progress& progress) {
  const BlockSystem& system = results.system();
  Slide slide;
  {
    const Frame last = results.frame(frame);
    slide.time = last.time;
    slide.run_out = run_out(system, last, settings.run_out);
    slide.deposit = deposit_of(system, last, slide.run_out.rock, settings.cell);
    Frame at_rest;
    at_rest.displacement.assign(last.displacement.size(), Vec3::Zero());
    slide.source = deposit_of(system, at_rest, slide.run_out.rock, slide.deposit.grid.cell).outline;
  }
  for (const Block& block : system.blocks) {
    if (block.body == BodyKind::fixed) continue;
    ++slide.movable;
    slide.movable_volume += block.volume;
  }
  const FrontHistory front(system, slide.run_out.rock);
  for (int number = 0; number <= frame; ++number) {
    if (progress.cancelled()) throw Cancelled{};
    progress.report(static_cast<double>(number) / (frame + 1),
                    "frame " + std::to_string(number + 1) + " of " + std::to_string(frame + 1));
    slide.front.push_back(front.at(results.frame(number)));
  }
  return slide;
}

}  // namespace talus
