#pragma once

#include "results/stored_rows.hpp"

namespace talus {

/// The tables of results.h5 that a frame's values lie in, the same for who writes and who reads them.
struct FrameTables {
  hdf5::Handle contact_type, motion_type;
  hdf5::Table displacement, velocity, stress, contacts, contact_ends, motions, motion_ends, asleep, index, stage;
  bool has_motions = false, has_sleep = false;  ///< results of earlier versions have none

  /// Opens them in a file that has them.
  void open_in(const hdf5::Handle& file);
  /// Those that are open learn what has been written since.
  void refresh();
};

/// A file that is open, and its tables.
struct OpenResultFile {
  hdf5::Handle file;
  FrameTables tables;
  bool has_tables = false;

  /// After the moments of the frames were read: of those that they announce all is there.
  void look_again() {
    if (has_tables)
      tables.refresh();
    else
      tables.open_in(file);
    has_tables = true;
  }
};

}  // namespace talus
