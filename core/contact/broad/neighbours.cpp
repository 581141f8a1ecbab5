#include "contact/broad/neighbours.hpp"

#include <algorithm>

namespace talus {
namespace {

constexpr double steps_in_box = 32;       // at its pace a body stays in its box for so many steps …
constexpr double least_box_margin = 0.1;  // … and at least for this fraction of its mesh size
constexpr double spared = 0.999;          // of the margin; what is left is for rounding
constexpr double reach_allowance = 2;     // the reach planned for, of the one that asks for it
constexpr double reach_forgotten = 16;    // a plan for so many times the reach is too wide

}  // namespace

void Neighbours::make_due(int body) {
  if (!bodies_[body].is_due) due_.push_back(body);
  bodies_[body].is_due = true;
}

void Neighbours::set(int body, const Stance& stance) {
  bodies_[body].stance = stance;
  make_due(body);
}

void Neighbours::plan_for(int body, double reach) {
  Body& b = bodies_[body];
  const bool too_wide = !b.stance.rests && reach_forgotten * reach < b.planned_reach;
  if (reach <= b.planned_reach && !too_wide) return;
  b.planned_reach = reach_allowance * reach;
  b.leaves_at = -1;
  make_due(body);
}

void Neighbours::give_box(int body, std::span<const Vec3> x, const Odometers& odometers, FaceBoxes& faces) {
  Body& b = bodies_[body];
  if (odometers.travelled(body) <= b.leaves_at) return;
  faces.refit(body, x);
  const double margin = std::max(least_box_margin * b.stance.size, steps_in_box * odometers.pace(body));
  boxes_[body] = faces.box_of(body);
  boxes_[body].widen(margin + b.planned_reach);
  b.leaves_at = odometers.travelled(body) + spared * margin;
  reboxed_.push_back(body);
}

void Neighbours::rebuild_or_refit() {
  refitted_ += reboxed_.size();
  if (refitted_ >= bodies_.size()) {  // so that a tree whose bodies have gone apart costs no more than to build it
    tree_.build(boxes_);
    refitted_ = 0;
  } else {
    for (int b : reboxed_) tree_.refit(b, boxes_);
  }
}

void Neighbours::find_pairs() {
  fresh_.clear();
  for (int b : due_) {
    found_.clear();
    const Stance& own = bodies_[b].stance;
    tree_.within(boxes_[b], own.least_distance, boxes_, stack_, found_);
    for (int other : found_) {
      if (other != b && !(own.rests && bodies_[other].stance.rests)) fresh_.push_back(std::minmax(b, other));
    }
  }
  std::sort(fresh_.begin(), fresh_.end());
  fresh_.erase(std::unique(fresh_.begin(), fresh_.end()), fresh_.end());
  std::erase_if(pairs_, [&](const auto& pair) { return bodies_[pair.first].is_due || bodies_[pair.second].is_due; });
  pairs_.insert(pairs_.end(), fresh_.begin(), fresh_.end());
  std::sort(pairs_.begin(), pairs_.end());
}

bool Neighbours::follow(std::span<const Vec3> x, const Reach& reach, const Odometers& odometers, FaceBoxes& faces) {
  boxes_.resize(bodies_.size());
  for (int b = 0; b < static_cast<int>(bodies_.size()); ++b) plan_for(b, reach.part(b));
  for (int b : odometers.moved()) {
    if (!(odometers.travelled(b) <= bodies_[b].leaves_at)) make_due(b);
  }
  if (due_.empty()) return false;
  reboxed_.clear();
  for (int b : due_) give_box(b, x, odometers, faces);
  rebuild_or_refit();
  find_pairs();
  for (int b : due_) bodies_[b].is_due = false;
  due_.clear();
  return true;
}

}  // namespace talus
