#include "solve/motion_watch.hpp"

#include <algorithm>
#include <cmath>

namespace talus {

namespace {

// Lengths are shares of a block's size, the cube root of its volume; travel is the root mean square over its volume.

/// A block that has gone less than this in the last quarter of the stage stands still. Blocks of stiff rock settle
/// under their weight by 1e-6 to 1e-5 of their size, and no contact creeps.
constexpr double still = 1e-4;
/// A block that stands still and has gone less than this since the stage began has settled and not moved: soft model
/// material under its weight, and gaps that close, make a few thousandths.
constexpr double settled = 0.01;
/// A class is read from the last piece of travel of this length: by then a direction owes nothing to the settling of
/// contacts, and a block does not yet go into its next motion.
constexpr double read_over = 0.05;
/// A new class is told once the block has gone this far in it.
constexpr double lasting = 0.01;
/// A block at rest before the stage that gathers way goes farther in each quarter of the time, 1 : 3 : 5 : 7 under
/// constant force. Less than this ratio of one to the one before is creeping, settling or swinging.
constexpr double gathering = 1.1;
/// Travel of this share of the size is rounding.
constexpr double rounding = 1e-9;

}  // namespace

MotionWatch::MotionWatch(const Project& project, const BlockSystem& system, const BodySet& bodies)
    : names_(motion_names(system)), record_(project, system, bodies), news_(system.blocks.size()) {}

double MotionWatch::travel(int block, const BlockPose& from, const BlockPose& to) const {
  const SmallMotion motion = motion_between(from, to);
  const double radius = std::sqrt(record_.fit().spread(block).trace());
  return std::hypot(motion.translation.norm(), radius * motion.rotation.norm()) /
         std::cbrt(record_.fit().volume(block));
}

bool MotionWatch::gathers_way(int block, const Spans& spans) const {
  const auto b = static_cast<std::size_t>(block);
  const double begin = spans.front()->begin, length = spans.back()->end - begin;
  const BlockPose* poses[5] = {&record_.start()[b], nullptr, nullptr, nullptr, &spans.back()->poses[b]};
  for (int quarter = 1; quarter < 4; ++quarter) {
    const double until = begin + length * quarter / 4;
    const auto nearest = std::min_element(spans.begin(), spans.end(), [&](const auto* x, const auto* y) {
      return std::abs(x->end - until) < std::abs(y->end - until);
    });
    poses[quarter] = &(*nearest)->poses[b];
  }
  const auto part = [&](int quarter) { return travel(block, *poses[quarter], *poses[quarter + 1]); };
  const auto onwards = [&](int quarter) {
    const SmallMotion now = motion_between(*poses[quarter], *poses[quarter + 1]);
    const SmallMotion all = motion_between(*poses[0], *poses[4]);
    const double radius = record_.fit().spread(block).trace();
    return now.translation.dot(all.translation) + radius * now.rotation.dot(all.rotation) > 0;
  };
  return part(1) > rounding && part(2) > gathering * part(1) && part(3) > gathering * part(2) && onwards(1) &&
         onwards(2) && onwards(3);
}

int MotionWatch::last_moving(int block, const Spans& spans) const {
  const auto b = static_cast<std::size_t>(block);
  int last = static_cast<int>(spans.size()) - 1;
  while (last > 0 && travel(block, spans[static_cast<std::size_t>(last) - 1]->poses[b], spans.back()->poses[b]) < still)
    --last;
  return last;
}

MotionClass MotionWatch::class_of(int block, const Spans& spans) const {
  const auto b = static_cast<std::size_t>(block);
  const BlockPose &start = record_.start()[b], &now = spans.back()->poses[b];
  const double last_quarter = spans.back()->end - (spans.back()->end - spans.front()->begin) / 4;
  double lately = travel(block, start, now), ever = lately;
  for (const MotionSpan* span : spans) {
    const double to_now = travel(block, span->poses[b], now);
    ever = std::max(ever, travel(block, start, span->poses[b]));
    lately = span->end <= last_quarter ? to_now : std::max(lately, to_now);
  }
  const bool rests = lately < still && !gathers_way(block, spans);
  if (rests && ever < settled) return {};

  const int last = rests ? last_moving(block, spans) : static_cast<int>(spans.size()) - 1;
  const BlockPose& end = spans[static_cast<std::size_t>(last)]->poses[b];
  int from = last - 1;
  while (from >= 0 && travel(block, spans[static_cast<std::size_t>(from)]->poses[b], end) < read_over) {
    // What a block has hardly begun is read from the later half of the time: settling lies in the first.
    if (!rests && 2 * spans[static_cast<std::size_t>(from)]->end < spans.front()->begin + spans.back()->end) break;
    --from;
  }
  MotionClass motion = classify(record_.window(spans, block, from, last));
  motion.came_to_rest = rests;
  return motion;
}

void MotionWatch::look(double time, bool stage_ended, const BodySet& bodies,
                       const std::vector<ContactSample>& contacts) {
  if (record_.take(time, stage_ended, bodies, contacts)) tell(record_.spans(bodies), classes(bodies));
}

std::vector<MotionClass> MotionWatch::classes(const BodySet& bodies) {
  std::vector<MotionClass> classes(names_.blocks.size());
  const Spans spans = record_.spans(bodies);
  if (spans.empty()) return classes;
  for (std::size_t b = 0; b < classes.size(); ++b)
    if (!bodies.bodies[b].fixed) classes[b] = class_of(static_cast<int>(b), spans);
  return classes;
}

void MotionWatch::tell(const Spans& spans, const std::vector<MotionClass>& classes) {
  for (std::size_t b = 0; b < classes.size(); ++b) {
    const MotionClass& now = classes[b];
    News& news = news_[b];
    if (now.mode == MotionMode::stable || same_kind(now, news.known)) {
      news.next = news.known;
      continue;
    }
    const BlockPose& pose = spans.back()->poses[b];
    if (!same_kind(now, news.next)) news = {news.known, news.told, now, spans.back()->end, pose};
    // A block at rest goes no farther, and was looked at for a quarter of the stage.
    if (!now.came_to_rest && travel(static_cast<int>(b), news.from, pose) < lasting) continue;
    news.known = now;
    if (now.mode == MotionMode::falling || same_kind(now, news.told)) continue;  // a bounce is no news
    news.told = now;
    const double since =
        now.came_to_rest ? spans[static_cast<std::size_t>(last_moving(static_cast<int>(b), spans))]->end : news.since;
    events_.push_back({since, names_.blocks[b] + ": " + motion_text(now, names_)});
  }
}

}  // namespace talus
