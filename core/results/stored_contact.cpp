#include "results/stored_contact.hpp"

#include <Eigen/Core>

namespace talus {

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
          .area = row.area};
}

hdf5::Handle stored_contact_type() {
  hdf5::Handle type(hdf5::check(H5Tcreate(H5T_COMPOUND, sizeof(StoredContact)), "cannot describe a contact"));
  const auto add = [&](const char* name, std::size_t offset, hid_t number, hsize_t count) {
    hdf5::insert_field(type, name, offset, number, count);
  };
  add("position [m]", offsetof(StoredContact, position), H5T_NATIVE_DOUBLE, 3);
  add("normal", offsetof(StoredContact, normal), H5T_NATIVE_DOUBLE, 3);
  add("shear force [N]", offsetof(StoredContact, shear_force), H5T_NATIVE_DOUBLE, 3);
  add("normal force [N]", offsetof(StoredContact, normal_force), H5T_NATIVE_DOUBLE, 1);
  add("area [m2]", offsetof(StoredContact, area), H5T_NATIVE_DOUBLE, 1);
  add("blocks", offsetof(StoredContact, blocks), H5T_NATIVE_INT32, 2);
  add("joint", offsetof(StoredContact, joint), H5T_NATIVE_INT32, 1);
  add("state", offsetof(StoredContact, state), H5T_NATIVE_INT32, 1);
  return type;
}

}  // namespace talus
