#include "run/motion_watch.hpp"

#include <algorithm>
#include <cmath>

namespace talus {

namespace {

// Lengths are fractions of a block's size, the cube root of its volume; travel is the root mean square over its volume.

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
/// A block at rest before the stage that accelerates goes farther in each quarter of the time, 1 : 3 : 5 : 7 under
/// constant force. Less than this ratio of one to the one before is creeping, settling or swinging.
constexpr double accelerating = 1.1;
/// Travel of this fraction of the size is rounding.
constexpr double rounding = 1e-9;

}  // namespace

MotionWatch::MotionWatch(const Project& project, const BlockSystem& system, const BodySet& bodies)
    : names_(motion_names(system)),
      record_(project, system, bodies),
      classes_(system.blocks.size()),
      news_(system.blocks.size()) {}

double MotionWatch::travel(int block, const BlockPose& from, const BlockPose& to) const {
  const SmallMotion motion = motion_between(from, to);
  const double radius = std::sqrt(record_.fit().spread(block).trace());
  return std::hypot(motion.translation.norm(), radius * motion.rotation.norm()) /
         std::cbrt(record_.fit().volume(block));
}

double MotionWatch::travel_since(int block, int span) const {
  return travel(block, record_.pose(block, span), record_.last_pose(block));
}

int MotionWatch::span_nearest_to(double time) const {
  int nearest = 0;
  for (int span = 1; span < record_.spans(); ++span)
    if (std::abs(record_.end(span) - time) < std::abs(record_.end(nearest) - time)) nearest = span;
  return nearest;
}

bool MotionWatch::accelerates(int block) const {
  const double begin = record_.begin(), length = record_.end() - begin;
  const BlockPose* poses[5] = {&record_.pose(block, -1), nullptr, nullptr, nullptr, &record_.last_pose(block)};
  for (int quarter = 1; quarter < 4; ++quarter)
    poses[quarter] = &record_.pose(block, span_nearest_to(begin + length * quarter / 4));
  const auto part = [&](int quarter) { return travel(block, *poses[quarter], *poses[quarter + 1]); };
  const auto onwards = [&](int quarter) {
    const SmallMotion now = motion_between(*poses[quarter], *poses[quarter + 1]);
    const SmallMotion all = motion_between(*poses[0], *poses[4]);
    const double radius = record_.fit().spread(block).trace();
    return now.translation.dot(all.translation) + radius * now.rotation.dot(all.rotation) > 0;
  };
  return part(1) > rounding && part(2) > accelerating * part(1) && part(3) > accelerating * part(2) && onwards(1) &&
         onwards(2) && onwards(3);
}

int MotionWatch::last_moving(int block) const {
  int last = record_.spans() - 1;
  while (last > 0 && travel_since(block, last - 1) < still) --last;
  return last;
}

MotionClass MotionWatch::class_of(int block) const {
  const double end = record_.end(), last_quarter = end - (end - record_.begin()) / 4;
  double lately = travel_since(block, -1), ever = lately;
  for (int span = 0; span < record_.spans(); ++span) {
    const double to_now = travel_since(block, span);
    ever = std::max(ever, travel(block, record_.pose(block, -1), record_.pose(block, span)));
    lately = record_.end(span) <= last_quarter ? to_now : std::max(lately, to_now);
  }
  const bool rests = lately < still && !accelerates(block);
  if (rests && ever < settled) return {};

  const int last = rests ? last_moving(block) : record_.spans() - 1;
  const BlockPose& there = record_.pose(block, last);
  int from = last - 1;
  while (from >= 0 && travel(block, record_.pose(block, from), there) < read_over) {
    // What a block has hardly begun is read from the later half of the time: settling lies in the first.
    if (!rests && 2 * record_.end(from) < record_.begin() + end) break;
    --from;
  }
  MotionClass motion = classify(record_.window(block, from, last));
  motion.came_to_rest = rests;
  return motion;
}

void MotionWatch::look(double time, bool stage_ended, const BodySet& bodies,
                       const std::vector<ContactSample>& contacts) {
  if (stage_begins_) {
    std::fill(classes_.begin(), classes_.end(), MotionClass{});
    followed_.clear();
  }
  stage_begins_ = stage_ended;
  if (!record_.take(time, stage_ended, bodies, contacts)) return;
  classes(bodies);
  for (const int b : followed_) tell(b);
  std::erase_if(followed_, [&](int b) {  // what sleeps, and rests by its class too, goes on doing so
    return bodies.bodies[b].fixed && (classes_[b].came_to_rest || classes_[b].mode == MotionMode::stable);
  });
}

const std::vector<MotionClass>& MotionWatch::classes(const BodySet& bodies) {
  if (record_.spans() == 0) return classes_;
  record_.catch_up(bodies);
  followed_.insert(followed_.end(), bodies.moving.begin(), bodies.moving.end());
  std::sort(followed_.begin(), followed_.end());
  followed_.erase(std::unique(followed_.begin(), followed_.end()), followed_.end());
  for (const int b : followed_) classes_[b] = class_of(b);
  return classes_;
}

void MotionWatch::tell(int block) {
  const MotionClass& now = classes_[block];
  News& news = news_[block];
  if (now.mode == MotionMode::stable || same_kind(now, news.known)) {
    news.next = news.known;
    return;
  }
  const BlockPose& pose = record_.last_pose(block);
  if (!same_kind(now, news.next)) news = {news.known, news.told, now, record_.end(), pose};
  // A block at rest goes no farther, and was looked at for a quarter of the stage.
  if (!now.came_to_rest && travel(block, news.from, pose) < lasting) return;
  news.known = now;
  if (now.mode == MotionMode::falling || same_kind(now, news.told)) return;  // a bounce is no news
  news.told = now;
  events_.push_back({now.came_to_rest ? record_.end(last_moving(block)) : news.since,
                     names_.blocks[block] + ": " + motion_text(now, names_)});
}

}  // namespace talus
