#include "results/stored_rows.hpp"

#include <Eigen/Core>

#include <initializer_list>
#include <limits>
#include <string>

namespace talus {

namespace {

/// So many numbers at a place of the row.
struct RowField {
  const char* name;
  std::size_t offset;
  hid_t number;
  hsize_t count;
};

hdf5::Handle row_type(const std::string& what, std::size_t size, std::initializer_list<RowField> fields) {
  hdf5::Handle type(hdf5::check(H5Tcreate(H5T_COMPOUND, size), "cannot describe " + what));
  for (const RowField& field : fields) hdf5::insert_field(type, field.name, field.offset, field.number, field.count);
  return type;
}

}  // namespace

StoredContact unknown_contact() {
  StoredContact row{};
  row.friction = row.cohesion = std::numeric_limits<double>::quiet_NaN();
  return row;
}

StoredContact stored(const ContactSample& sample) {
  StoredContact row{};
  Eigen::Map<Vec3>(row.position) = sample.position;
  Eigen::Map<Vec3>(row.normal) = sample.normal;
  Eigen::Map<Vec3>(row.shear_force) = sample.shear_force;
  row.normal_force = sample.normal_force;
  row.area = sample.area;
  row.blocks[0] = sample.blocks[0];
  row.blocks[1] = sample.blocks[1];
  row.joint = sample.joint;
  row.state = static_cast<std::int32_t>(sample.state);
  row.friction = sample.friction;
  row.cohesion = sample.cohesion;
  row.bond = static_cast<std::int32_t>(sample.bond);
  return row;
}

ContactSample restored(const StoredContact& row) {
  return {.position = Eigen::Map<const Vec3>(row.position),
          .normal = Eigen::Map<const Vec3>(row.normal),
          .blocks = {row.blocks[0], row.blocks[1]},
          .joint = row.joint,
          .state = static_cast<ContactState>(row.state),
          .normal_force = row.normal_force,
          .shear_force = Eigen::Map<const Vec3>(row.shear_force),
          .area = row.area,
          .friction = row.friction,
          .cohesion = row.cohesion,
          .bond = static_cast<Bond>(row.bond)};
}

hdf5::Handle stored_contact_type() {
  return row_type("a contact", sizeof(StoredContact),
                  {{"position [m]", offsetof(StoredContact, position), H5T_NATIVE_DOUBLE, 3},
                   {"normal", offsetof(StoredContact, normal), H5T_NATIVE_DOUBLE, 3},
                   {"shear force [N]", offsetof(StoredContact, shear_force), H5T_NATIVE_DOUBLE, 3},
                   {"normal force [N]", offsetof(StoredContact, normal_force), H5T_NATIVE_DOUBLE, 1},
                   {"area [m2]", offsetof(StoredContact, area), H5T_NATIVE_DOUBLE, 1},
                   {"blocks", offsetof(StoredContact, blocks), H5T_NATIVE_INT32, 2},
                   {"joint", offsetof(StoredContact, joint), H5T_NATIVE_INT32, 1},
                   {"state", offsetof(StoredContact, state), H5T_NATIVE_INT32, 1},
                   {"friction", offsetof(StoredContact, friction), H5T_NATIVE_DOUBLE, 1},
                   {"cohesion [Pa]", offsetof(StoredContact, cohesion), H5T_NATIVE_DOUBLE, 1},
                   {"bond", offsetof(StoredContact, bond), H5T_NATIVE_INT32, 1}});
}

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
  return row_type("a motion", sizeof(StoredMotion),
                  {{"direction", offsetof(StoredMotion, direction), H5T_NATIVE_DOUBLE, 3},
                   {"line", offsetof(StoredMotion, line), H5T_NATIVE_DOUBLE, 3},
                   {"axis", offsetof(StoredMotion, axis), H5T_NATIVE_DOUBLE, 3},
                   {"rotation share", offsetof(StoredMotion, rotation_share), H5T_NATIVE_DOUBLE, 1},
                   {"mode", offsetof(StoredMotion, mode), H5T_NATIVE_INT32, 1},
                   {"came to rest", offsetof(StoredMotion, came_to_rest), H5T_NATIVE_INT32, 1},
                   {"joints", offsetof(StoredMotion, joints), H5T_NATIVE_INT32, 2},
                   {"against", offsetof(StoredMotion, against), H5T_NATIVE_INT32, 2}});
}

}  // namespace talus
