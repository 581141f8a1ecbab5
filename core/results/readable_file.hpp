#pragma once

#include "results/hdf5.hpp"

namespace talus::hdf5 {

/// A way for HDF5 to write a file that others may open at every moment, and after a kill at any moment, whether they
/// know of a single writer and many readers or not: h5py as it is usually called, ParaView, another machine.
///
/// HDF5 begins its files with a superblock (File Format Specification 3.0, II.A). Where it writes itself, that says
/// while a writer is at work that the file is open, and others refuse it; and that it ends where HDF5 has given room
/// away up to now, before it is as long. Here it always says that the file is closed. The file is kept longer than what
/// is in it, by room that takes nothing on the disk (a hole), and the superblock names that end: what is written after
/// a reader has looked lies within it, too. Nothing is locked: who reads keeps nobody from going on with a run, and a
/// FolderLock keeps a second writer away.
///
/// Sets that way for files that are created or opened to write with `access`. Throws Error.
void write_readably(hid_t access);

}  // namespace talus::hdf5
