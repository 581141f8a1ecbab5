#pragma once

#include "results/hdf5.hpp"

namespace talus::hdf5 {

/// The `count` texts of a dataset lie in heaps of the file, which HDF5 keeps no checksums of and reads without looking
/// (1.10). They are read past it. Throws Error unless each text points at a piece of its length in a heap whose pieces
/// lie within it.
std::vector<std::string> strings_in_heap(hid_t dataset, const std::string& path, std::size_t count);

}  // namespace talus::hdf5
