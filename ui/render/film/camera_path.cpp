#include "render/film/camera_path.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/units.hpp"
#include "results/text_table.hpp"

namespace talus {

namespace {

/// A cubic through the values at four moments, between the two in the middle (Catmull and Rom, of unequal spacings).
Vec3 between(const std::array<double, 4>& t, const std::array<Vec3, 4>& p, double time) {
  const double h = t[2] - t[1], s = (time - t[1]) / h;
  const auto slope = [&](std::size_t i) -> Vec3 {
    return t[i + 1] > t[i - 1] ? Vec3((p[i + 1] - p[i - 1]) / (t[i + 1] - t[i - 1])) : Vec3::Zero();
  };
  const double s2 = s * s, s3 = s2 * s;
  return (2 * s3 - 3 * s2 + 1) * p[1] + (s3 - 2 * s2 + s) * h * slope(1) + (3 * s2 - 2 * s3) * p[2] +
         (s3 - s2) * h * slope(2);
}

}  // namespace

std::vector<CameraKey> read_camera_keys(const std::filesystem::path& file) {
  constexpr std::size_t columns = 7;
  std::vector<CameraKey> keys;
  for (const std::vector<double>& row : read_text_table(file, columns)) {
    CameraKey key{row[0], {row[1], row[2], row[3]}, {row[4], row[5], row[6]}};
    if (!keys.empty() && !(key.time > keys.back().time))
      throw InputError(file.string(), "the times of camera keys grow", "sort its rows by time, each only once");
    if (!((key.focal_point - key.position).norm() > 0))
      throw InputError(file.string(), "a camera looks to where it stands", "move one of the two points");
    keys.push_back(key);
  }
  if (keys.empty())
    throw InputError(file.string(), "holds no camera keys",
                     "write a line of heads, then rows of time, place (x, y, z) and where it looks to (x, y, z)");
  return keys;
}

std::string camera_keys_csv(const std::vector<CameraKey>& keys) {
  std::string table = "time [s],x [m],y [m],z [m],to x [m],to y [m],to z [m]\n";
  for (const CameraKey& key : keys) {
    const Vec3 &at = key.position, &to = key.focal_point;
    table += csv_line({key.time, at.x(), at.y(), at.z(), to.x(), to.y(), to.z()}) + '\n';
  }
  return table;
}

CameraPath::CameraPath(const CameraMoves& moves, const BlockSystem& system, const CameraPose& held)
    : moves_(moves), held_(held) {
  if (!moves.follow) return;
  const auto followed = static_cast<std::size_t>(*moves.follow);
  for (std::size_t b = 0; b < followed; ++b) first_ += system.blocks[b].mesh.nodes.size();
  const std::vector<Vec3>& nodes = system.blocks.at(followed).mesh.nodes;
  count_ = nodes.size();
  for (const Vec3& node : nodes) middle_ += node / static_cast<double>(count_);
  double radius = 0;
  for (const Vec3& node : nodes) radius = std::max(radius, (node - middle_).norm());
  // The block is this many times smaller than the picture is high; nearer than the whole scene only.
  constexpr double times_smaller = 6;
  const Vec3 back = held.position - held.focal_point;
  const double near = times_smaller * radius / std::tan(radians(held.view_angle / 2));
  held_.focal_point = middle_;
  held_.position = middle_ + std::min(1.0, near / back.norm()) * back;
  held_.parallel_scale = std::min(held.parallel_scale, times_smaller * radius);
}

bool CameraPath::stands_still() const { return moves_.keys.empty() && moves_.turn == 0 && !moves_.follow; }

CameraPose CameraPath::at_key(double time) const {
  const std::vector<CameraKey>& keys = moves_.keys;
  CameraPose pose = held_;
  pose.view_up = Vec3::UnitZ();
  const auto after = std::ranges::upper_bound(keys, time, {}, &CameraKey::time);
  const auto place = [&](std::ptrdiff_t i) -> const CameraKey& {
    return keys[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, std::ssize(keys) - 1))];
  };
  const std::ptrdiff_t next = after - keys.begin();
  if (next == 0 || next == std::ssize(keys)) {
    pose.position = place(next - (next == 0 ? 0 : 1)).position;
    pose.focal_point = place(next - (next == 0 ? 0 : 1)).focal_point;
    return pose;
  }
  std::array<double, 4> times;
  std::array<Vec3, 4> positions, focal_points;
  for (std::size_t i = 0; i < 4; ++i) {
    const CameraKey& key = place(next - 2 + static_cast<std::ptrdiff_t>(i));
    times[i] = key.time;
    positions[i] = key.position;
    focal_points[i] = key.focal_point;
  }
  pose.position = between(times, positions, time);
  pose.focal_point = between(times, focal_points, time);
  return pose;
}

CameraPose CameraPath::pose(const Frame& frame, double share) const {
  CameraPose pose = moves_.keys.empty() ? held_ : at_key(frame.time);
  if (count_ > 0) {
    Vec3 way = Vec3::Zero();
    for (std::size_t n = 0; n < count_; ++n) way += frame.displacement[first_ + n] / static_cast<double>(count_);
    pose.position += way;
    pose.focal_point += way;
  }
  if (moves_.turn != 0) {
    const Mat3 turn = Eigen::AngleAxisd(radians(share * moves_.turn), Vec3::UnitZ()).toRotationMatrix();
    pose.position = pose.focal_point + turn * (pose.position - pose.focal_point);
    pose.view_up = turn * pose.view_up;
  }
  return pose;
}

}  // namespace talus
