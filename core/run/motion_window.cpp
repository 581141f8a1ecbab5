#include "run/motion_window.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace talus {

namespace {

/// A block falls when it was free for more of the time than this: contacts that rattle are closed about half of it.
constexpr double free_fraction = 0.75;
/// Sliding and turning together explain less than this of a block's travel: it is carried along, or falls.
constexpr double explained_fraction = 0.5;
/// A part of the motion that makes less of the travel than this is not named: settling and the waviness of a meshed
/// face make a few per cent.
constexpr double named_fraction = 0.1;
/// A face that slips by less than this of the one that slips most goes along with the block.
constexpr double slipping_fraction = 0.1;
/// A face that carries less than this of the load is brushed against, not slid on.
constexpr double carrying_fraction = 0.05;
/// Normals within this angle belong to one plane, a motion within it of a line follows that line: cosine of 10°, twice
/// the angle by which facets of one meshed, worn or bent face may differ.
const double cos_same = std::cos(M_PI / 18);
/// Turning is torsional when its axis lies nearer to the plane's normal than to the plane: cosine of 45°.
const double cos_torsional = std::sqrt(0.5);
/// A block that this one carries presses on it from above: its normal points down by more than this.
constexpr double pressing_down = 0.1;

/// Slip of the block over a face [m].
Vec3 slip(const LoadedFace& face, const SmallMotion& motion) {
  const Vec3 relative = motion.at(face.centre) - face.other.at(face.centre);
  return relative - relative.dot(face.normal) * face.normal;
}

/// Faces that hold the block up, strongest first: without those of movable blocks that weigh on it.
std::vector<LoadedFace> supports(const MotionWindow& window) {
  std::vector<LoadedFace> held;
  for (const LoadedFace& face : window.faces)
    if (!face.other_can_yield || face.normal.dot(window.up) >= -pressing_down) held.push_back(face);
  if (held.empty()) held = window.faces;
  std::stable_sort(held.begin(), held.end(),
                   [](const LoadedFace& a, const LoadedFace& b) { return a.impulse > b.impulse; });
  return held;
}

/// Root mean square displacement that turning about the centroid makes [m].
double turned(const Vec3& w, const MotionWindow& window) {
  return std::sqrt(std::max(0., window.spread.trace() * w.squaredNorm() - w.dot(window.spread * w)));
}

/// Root mean square displacement of the block [m].
double own_travel(const MotionWindow& window) {
  return std::hypot(window.motion.translation.norm(), turned(window.motion.rotation, window));
}

/// How far the block slid over its supports and turned against them.
struct Travel {
  double sliding = 0;            ///< m, slip weighted by load
  double turning = 0;            ///< m, root mean square over the volume, about an axis through the load's centre
  Vec3 rotation = Vec3::Zero();  ///< rad, against the support that turns along least
};

double load_on(const std::vector<LoadedFace>& held) {
  double load = 0;
  for (const LoadedFace& face : held) load += face.impulse;
  return load;
}

Vec3 rotation_against(const LoadedFace& face, const MotionWindow& window) {
  return window.motion.rotation - face.other.rotation;
}

/// The supports that sliding is measured on: of columns that topple together, slip between them is part of their
/// turning, and only what does not turn along counts.
std::vector<LoadedFace> standing(const std::vector<LoadedFace>& held, const MotionWindow& window,
                                 const Vec3& rotation) {
  if (turned(rotation, window) < named_fraction * own_travel(window)) return held;
  std::vector<LoadedFace> firm;
  for (const LoadedFace& face : held)
    if (2 * rotation_against(face, window).norm() >= rotation.norm()) firm.push_back(face);
  return firm;
}

Travel travel_over(const std::vector<LoadedFace>& held, const MotionWindow& window) {
  Travel travel;
  for (const LoadedFace& face : held)
    if (const Vec3 relative = rotation_against(face, window); relative.norm() > travel.rotation.norm())
      travel.rotation = relative;
  const std::vector<LoadedFace> firm = standing(held, window, travel.rotation);
  const double load = load_on(firm);
  Vec3 centre = Vec3::Zero();
  for (const LoadedFace& face : firm) {
    travel.sliding += face.impulse / load * slip(face, window.motion).norm();
    centre += face.impulse / load * face.centre;
  }
  const Vec3 arm = travel.rotation.cross(window.motion.centroid - centre);
  travel.turning = std::hypot(turned(travel.rotation, window), arm.norm());
  return travel;
}

/// The block that takes this one along for the greater part of its displacement, −1 if none does.
int carrying_block(const std::vector<LoadedFace>& held, const MotionWindow& window) {
  for (const LoadedFace& face : held)
    if (face.other.at(window.motion.centroid).norm() > explained_fraction * own_travel(window)) return face.block;
  return -1;
}

void name_plane(MotionClass& motion, std::size_t plane, const LoadedFace& face) {
  motion.joints[plane] = face.joint;
  motion.against[plane] = face.block;
}

/// Which plane, or which two and their line.
void name_planes(MotionClass& motion, const std::vector<LoadedFace>& held, const MotionWindow& window) {
  const double load = load_on(held);
  double most = 0;
  for (const LoadedFace& face : held)
    if (face.impulse >= carrying_fraction * load) most = std::max(most, slip(face, window.motion).norm());
  std::vector<LoadedFace> slid;
  for (const LoadedFace& face : held)
    if (face.impulse >= carrying_fraction * load && slip(face, window.motion).norm() > slipping_fraction * most)
      slid.push_back(face);
  if (slid.empty()) slid.push_back(held.front());
  const LoadedFace& first = slid.front();
  name_plane(motion, 0, first);
  const Vec3 direction = slip(first, window.motion).normalized();
  for (const LoadedFace& second : slid) {
    if (std::abs(first.normal.dot(second.normal)) > cos_same) continue;
    const Vec3 line = first.normal.cross(second.normal).normalized();
    if (std::abs(line.dot(direction)) < cos_same) continue;
    motion.mode = MotionMode::sliding_on_two;
    motion.line = line.dot(direction) < 0 ? Vec3(-line) : line;
    // In the order of the project, so that it does not change with the load.
    const bool swapped = std::pair(second.joint, second.block) < std::pair(first.joint, first.block);
    name_plane(motion, swapped ? 0 : 1, second);
    name_plane(motion, swapped ? 1 : 0, first);
    return;
  }
}

/// Whether the axis stands on the plane of a support, or on what several make together.
bool is_torsional(const Vec3& axis, const std::vector<LoadedFace>& held) {
  const double load = load_on(held);
  Vec3 resultant = Vec3::Zero();
  for (const LoadedFace& face : held) {
    resultant += face.impulse * face.normal;
    if (face.impulse >= carrying_fraction * load && std::abs(axis.dot(face.normal)) > cos_torsional) return true;
  }
  return std::abs(axis.dot(resultant)) > cos_torsional * resultant.norm();
}

void name_turning(MotionClass& motion, const std::vector<LoadedFace>& held, const Travel& travel) {
  motion.axis = travel.rotation.normalized();
  const bool torsional = is_torsional(motion.axis, held);
  if (motion.rotation_share > 1 - named_fraction) {
    motion.mode = torsional ? MotionMode::torsional : MotionMode::toppling;
    name_plane(motion, 0, held.front());
  } else {
    motion.mode = torsional ? MotionMode::sliding_and_torsional : MotionMode::sliding_and_toppling;
  }
}

MotionClass unsupported(const MotionWindow& window, int carried_by) {
  MotionClass motion;
  motion.mode = carried_by < 0 ? MotionMode::falling : MotionMode::carried;
  motion.against[0] = carried_by;
  motion.direction = window.motion.translation.normalized();
  return motion;
}

}  // namespace

Vec3 SmallMotion::at(const Vec3& x) const { return translation + rotation.cross(x - centroid); }

MotionClass classify(const MotionWindow& window) {
  if (window.faces.empty() || window.loaded_fraction < 1 - free_fraction) return unsupported(window, -1);
  const std::vector<LoadedFace> held = supports(window);
  const Travel travel = travel_over(held, window);
  const double explained = travel.sliding + travel.turning, own = own_travel(window);
  if (explained <= explained_fraction * own) return unsupported(window, carrying_block(held, window));

  MotionClass motion;
  motion.mode = MotionMode::sliding_on_one;
  motion.rotation_share = travel.turning / explained;
  // A block that turns on the spot goes nowhere.
  if (window.motion.translation.norm() > named_fraction * own)
    motion.direction = window.motion.translation.normalized();
  if (motion.rotation_share <= 1 - named_fraction) name_planes(motion, held, window);
  if (motion.rotation_share >= named_fraction) name_turning(motion, held, travel);
  return motion;
}

}  // namespace talus
