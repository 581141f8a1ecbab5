#include "results/stored_motion.hpp"

#include <Eigen/Core>

namespace talus {

StoredMotion stored(const MotionClass& motion) {
  StoredMotion row{};
  Eigen::Map<Vec3>(row.direction) = motion.direction;
  Eigen::Map<Vec3>(row.line) = motion.line;
  Eigen::Map<Vec3>(row.axis) = motion.axis;
  row.rotation_share = motion.rotation_share;
  row.mode = static_cast<std::int32_t>(motion.mode);
  row.came_to_rest = motion.came_to_rest;
  for (std::size_t i = 0; i < 2; ++i) {
    row.joints[i] = motion.joints[i];
    row.against[i] = motion.against[i];
  }
  return row;
}

MotionClass restored(const StoredMotion& row) {
  return {.mode = static_cast<MotionMode>(row.mode),
          .came_to_rest = row.came_to_rest != 0,
          .joints = {row.joints[0], row.joints[1]},
          .against = {row.against[0], row.against[1]},
          .direction = Eigen::Map<const Vec3>(row.direction),
          .line = Eigen::Map<const Vec3>(row.line),
          .axis = Eigen::Map<const Vec3>(row.axis),
          .rotation_share = row.rotation_share};
}

hdf5::Handle stored_motion_type() {
  hdf5::Handle type(hdf5::check(H5Tcreate(H5T_COMPOUND, sizeof(StoredMotion)), "cannot describe a motion"));
  const auto add = [&](const char* name, std::size_t offset, hid_t number, hsize_t count) {
    hdf5::insert_field(type, name, offset, number, count);
  };
  add("direction", offsetof(StoredMotion, direction), H5T_NATIVE_DOUBLE, 3);
  add("line", offsetof(StoredMotion, line), H5T_NATIVE_DOUBLE, 3);
  add("axis", offsetof(StoredMotion, axis), H5T_NATIVE_DOUBLE, 3);
  add("rotation share", offsetof(StoredMotion, rotation_share), H5T_NATIVE_DOUBLE, 1);
  add("mode", offsetof(StoredMotion, mode), H5T_NATIVE_INT32, 1);
  add("came to rest", offsetof(StoredMotion, came_to_rest), H5T_NATIVE_INT32, 1);
  add("joints", offsetof(StoredMotion, joints), H5T_NATIVE_INT32, 2);
  add("against", offsetof(StoredMotion, against), H5T_NATIVE_INT32, 2);
  return type;
}

}  // namespace talus
