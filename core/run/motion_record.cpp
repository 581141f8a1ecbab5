#include "run/motion_record.hpp"

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
/// A block that bears on its contacts by less than this fraction of its weight is free.
constexpr double bearing_fraction = 1e-3;

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
  free_time += later.free_time;
}

SmallMotion motion_between(const BlockPose& from, const BlockPose& to) {
  const Eigen::AngleAxisd turn(Mat3(to.rotation * from.rotation.transpose()));
  return {to.centroid - from.centroid, turn.angle() * turn.axis(), (to.centroid + from.centroid) / 2};
}

MotionRecord::MotionRecord(const Project& project, const BlockSystem& system, const BodySet& bodies)
    : fit_(system), start_(fit_.poses(bodies)), tracks_(system.blocks.size()), force_(system.blocks.size()) {
  if (!project.gravity.isZero()) up_ = -project.gravity.normalized();
  for (std::size_t b = 0; b < system.blocks.size(); ++b) {
    weight_.push_back(bodies.bodies[b].density * fit_.volume(static_cast<int>(b)) * project.gravity.norm());
    yields_.push_back(system.blocks[b].body != BodyKind::fixed);
  }
}

void MotionRecord::begin_stage(double time) {
  for (std::size_t b = 0; b < tracks_.size(); ++b) {
    if (!tracks_[b].empty()) start_[b] = tracks_[b].back().pose;
    tracks_[b].clear();
  }
  ends_.clear();
  begin_ = time_;
  length_ = time - time_;
  stage_begins_ = false;
}

void MotionRecord::begin_span() {
  ends_.push_back(time_);
  passing_.clear();
  grows_ = true;
}

MotionRecord::Passage& MotionRecord::growing(int block) {
  Track& track = tracks_[block];
  if (track.empty() || track.back().span != spans() - 1) {
    track.push_back({spans() - 1, {}, {}});
    passing_.push_back(block);
  }
  return track.back();
}

void MotionRecord::add_contacts(double length, const std::vector<ContactSample>& contacts, const BodySet& bodies) {
  for (const int b : bodies.driven) growing(b);
  for (const int b : bodies.moving) force_[b] = 0;
  for (const ContactSample& contact : contacts) {
    if (contact.normal_force <= 0) continue;
    const double impulse = contact.normal_force * length;
    for (int side = 0; side < 2; ++side) {
      const int block = contact.blocks[side];
      if (bodies.bodies[block].fixed) continue;
      force_[block] += contact.normal_force;
      const double sign = side == 0 ? 1 : -1;
      growing(block).load.add({contact.blocks[1 - side], contact.joint, sign * impulse * contact.normal,
                               impulse * contact.position, impulse});
    }
  }
  for (const int b : bodies.moving)
    if (Passage& passage = growing(b); !(force_[b] > bearing_fraction * weight_[b])) passage.load.free_time += length;
}

bool MotionRecord::take(double time, bool stage_ended, const BodySet& bodies,
                        const std::vector<ContactSample>& contacts) {
  if (time <= time_) return false;  // the step failed
  if (stage_begins_) begin_stage(time);
  if (!grows_) begin_span();
  add_contacts(time - time_, contacts, bodies);
  ends_.back() = time_ = time;
  stage_begins_ = stage_ended;
  const double span_began = spans() > 1 ? end(spans() - 2) : begin_;
  if (!stage_ended && time - span_began < (1 - 1e-9) * length_) return false;
  catch_up(bodies);
  grows_ = false;
  if (ends_.size() > most_spans) thin();
  return true;
}

void MotionRecord::catch_up(const BodySet& bodies) {
  if (!grows_) return;
  for (const int b : passing_) tracks_[b].back().pose = fit_.pose(bodies, b);
}

void MotionRecord::thin() {
  length_ *= 2;
  std::vector<double> thinner;
  std::vector<int> becomes;
  double began = begin_;
  for (const double end : ends_) {
    if (thinner.empty() || end - began > (1 + 1e-9) * length_) {
      if (!thinner.empty()) began = thinner.back();
      thinner.push_back(end);
    }
    thinner.back() = end;
    becomes.push_back(static_cast<int>(thinner.size()) - 1);
  }
  ends_ = std::move(thinner);
  for (Track& track : tracks_) {
    std::size_t kept = 0;
    for (Passage& passage : track) {
      passage.span = becomes[passage.span];
      if (kept > 0 && track[kept - 1].span == passage.span) {
        track[kept - 1].pose = passage.pose;
        track[kept - 1].load.add(passage.load);
      } else if (&track[kept++] != &passage) {
        track[kept - 1] = std::move(passage);
      }
    }
    track.erase(track.begin() + static_cast<long>(kept), track.end());
  }
}

const BlockPose& MotionRecord::pose(int block, int span) const {
  const Track& track = tracks_[block];
  const auto later = std::partition_point(track.begin(), track.end(), [&](const Passage& p) { return p.span <= span; });
  return later == track.begin() ? start_[block] : std::prev(later)->pose;
}

MotionWindow MotionRecord::window(int block, int from, int to) const {
  const BlockPose &before = pose(block, from), &after = pose(block, to);
  CarriedLoad load;
  for (const Passage& passage : tracks_[block])
    if (passage.span > from && passage.span <= to) load.add(passage.load);

  MotionWindow window;
  window.motion = motion_between(before, after);
  window.spread = after.rotation * fit_.spread(block) * after.rotation.transpose();
  window.up = up_;
  window.loaded_fraction = 1 - load.free_time / (end(to) - (from < 0 ? begin_ : end(from)));
  for (const CarriedLoad::Face& face : load.faces)
    window.faces.push_back({face.block, face.joint, face.normal.normalized(), face.moment / face.impulse, face.impulse,
                            motion_between(pose(face.block, from), pose(face.block, to)), yields_[face.block]});
  return window;
}

}  // namespace talus
