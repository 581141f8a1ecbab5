#include "results/frame_tables.hpp"

namespace talus {

void FrameTables::open_in(const hdf5::Handle& file) {
  using hdf5::Table;
  displacement = Table(file, "/VTKHDF/PointData/displacement", H5T_NATIVE_DOUBLE, 3);
  velocity = Table(file, "/VTKHDF/PointData/velocity", H5T_NATIVE_DOUBLE, 3);
  stress = Table(file, "/VTKHDF/CellData/stress", H5T_NATIVE_DOUBLE, 6);
  contact_type = stored_contact_type();
  contacts = Table(file, "/Talus/contacts", contact_type);
  contact_ends = Table(file, "/Talus/contact_end", H5T_NATIVE_INT64);
  has_motions = hdf5::check(H5Lexists(file, "/Talus/motions", H5P_DEFAULT), "cannot be read") > 0;
  if (has_motions) {
    motion_type = stored_motion_type();
    motions = Table(file, "/Talus/motions", motion_type);
    motion_ends = Table(file, "/Talus/motion_end", H5T_NATIVE_INT64);
  }
  has_sleep = hdf5::check(H5Lexists(file, "/Talus/asleep", H5P_DEFAULT), "cannot be read") > 0;
  if (has_sleep) asleep = Table(file, "/Talus/asleep", H5T_NATIVE_INT8);
  index = Table(file, "/Talus/frame_index", H5T_NATIVE_INT32);
  stage = Table(file, "/Talus/frame_stage", H5T_NATIVE_INT32);
}

void FrameTables::refresh() {
  for (hdf5::Table* table : {&displacement, &velocity, &stress, &contacts, &contact_ends, &index, &stage})
    table->refresh();
  if (has_sleep) asleep.refresh();
  if (has_motions)
    for (hdf5::Table* table : {&motions, &motion_ends}) table->refresh();
}

}  // namespace talus
