#include "solve/motion_record.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace talus {

namespace {

/// More spans than this are halved in number: a hundredth of a stage is resolved at a few hundred bytes a block and
/// span.
constexpr std::size_t most_spans = 128;
/// Normals within this angle belong to one face: cosine of 5°, more than the facets of a meshed plane differ by.
const double cos_same_face = std::cos(M_PI / 36);
/// A block that bears on its contacts by less than this share of its weight is free.
constexpr double bearing_share = 1e-3;

}  // namespace

void CarriedLoad::add(const Face& face) {
  for (Face& known : faces) {
    if (known.block != face.block || known.joint != face.joint) continue;
    if (known.normal.dot(face.normal) < cos_same_face * known.normal.norm() * face.normal.norm()) continue;
    known.normal += face.normal;
    known.moment += face.moment;
    known.impulse += face.impulse;
    return;
  }
  faces.push_back(face);
}

void CarriedLoad::add(const CarriedLoad& later) {
  for (const Face& face : later.faces) add(face);
  loaded_time += later.loaded_time;
}

SmallMotion motion_between(const BlockPose& from, const BlockPose& to) {
  const Eigen::AngleAxisd turn(Mat3(to.rotation * from.rotation.transpose()));
  return {to.centroid - from.centroid, turn.angle() * turn.axis(), (to.centroid + from.centroid) / 2};
}

MotionRecord::MotionRecord(const Project& project, const BlockSystem& system, const BodySet& bodies)
    : fit_(system), start_(fit_.poses(bodies)), last_(start_), force_(system.blocks.size()) {
  if (!project.gravity.isZero()) up_ = -project.gravity.normalized();
  for (std::size_t b = 0; b < system.blocks.size(); ++b) {
    weight_.push_back(bodies.bodies[b].density * fit_.volume(static_cast<int>(b)) * project.gravity.norm());
    yields_.push_back(system.blocks[b].body != BodyKind::fixed);
  }
}

void MotionRecord::begin_stage(double time) {
  start_ = last_;
  done_.clear();
  length_ = time - time_;
  growing_ = {time_, time_, {}, std::vector<CarriedLoad>(weight_.size())};
  stage_begins_ = false;
}

void MotionRecord::add_contacts(double length, const std::vector<ContactSample>& contacts, const BodySet& bodies) {
  std::fill(force_.begin(), force_.end(), 0);
  for (const ContactSample& contact : contacts) {
    if (contact.normal_force <= 0) continue;
    const double impulse = contact.normal_force * length;
    for (int side = 0; side < 2; ++side) {
      const int block = contact.blocks[side];
      if (bodies.bodies[block].fixed) continue;
      force_[block] += contact.normal_force;
      const double sign = side == 0 ? 1 : -1;
      growing_.loads[block].add({contact.blocks[1 - side], contact.joint, sign * impulse * contact.normal,
                                 impulse * contact.position, impulse});
    }
  }
  for (std::size_t b = 0; b < force_.size(); ++b)
    if (force_[b] > bearing_share * weight_[b]) growing_.loads[b].loaded_time += length;
}

bool MotionRecord::take(double time, bool stage_ended, const BodySet& bodies,
                        const std::vector<ContactSample>& contacts) {
  if (time <= time_) return false;  // the step failed
  if (stage_begins_) begin_stage(time);
  add_contacts(time - time_, contacts, bodies);
  growing_.end = time_ = time;
  stage_begins_ = stage_ended;
  if (!stage_ended && growing_.end - growing_.begin < (1 - 1e-9) * length_) return false;
  complete(bodies);
  if (done_.size() > most_spans) thin();
  return true;
}

void MotionRecord::complete(const BodySet& bodies) {
  growing_.poses = last_ = fit_.poses(bodies);
  done_.push_back(std::move(growing_));
  growing_ = {time_, time_, {}, std::vector<CarriedLoad>(weight_.size())};
}

void MotionRecord::thin() {
  length_ *= 2;
  std::vector<MotionSpan> thinner;
  for (MotionSpan& span : done_) {
    if (thinner.empty() || span.end - thinner.back().begin > (1 + 1e-9) * length_) {
      thinner.push_back(std::move(span));
      continue;
    }
    MotionSpan& before = thinner.back();
    before.end = span.end;
    before.poses = std::move(span.poses);
    for (std::size_t b = 0; b < before.loads.size(); ++b) before.loads[b].add(span.loads[b]);
  }
  done_ = std::move(thinner);
}

std::vector<const MotionSpan*> MotionRecord::spans(const BodySet& bodies) {
  std::vector<const MotionSpan*> all;
  for (const MotionSpan& span : done_) all.push_back(&span);
  if (growing_.end > growing_.begin) {
    growing_.poses = fit_.poses(bodies);
    all.push_back(&growing_);
  }
  return all;
}

MotionWindow MotionRecord::window(const std::vector<const MotionSpan*>& spans, int b, int from, int to) const {
  const auto block = static_cast<std::size_t>(b);
  const std::vector<BlockPose>& before = from < 0 ? start_ : spans[static_cast<std::size_t>(from)]->poses;
  const std::vector<BlockPose>& after = spans[static_cast<std::size_t>(to)]->poses;
  CarriedLoad load;
  for (int i = from + 1; i <= to; ++i) load.add(spans[static_cast<std::size_t>(i)]->loads[block]);

  MotionWindow window;
  window.motion = motion_between(before[block], after[block]);
  window.spread = after[block].rotation * fit_.spread(b) * after[block].rotation.transpose();
  window.up = up_;
  const double time = spans[static_cast<std::size_t>(to)]->end - spans[static_cast<std::size_t>(from + 1)]->begin;
  window.loaded_share = load.loaded_time / time;
  for (const CarriedLoad::Face& face : load.faces) {
    const auto other = static_cast<std::size_t>(face.block);
    window.faces.push_back({face.block, face.joint, face.normal.normalized(), face.moment / face.impulse, face.impulse,
                            motion_between(before[other], after[other]), yields_[other]});
  }
  return window;
}

}  // namespace talus
