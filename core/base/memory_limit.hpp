#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace talus {

/// What the program may come to hold beyond what it holds now, its mesher included.
struct MemoryLimit {
  double bytes = 0;
  bool told = false;  ///< by the user; otherwise it is what this machine has to spare
};

/// As set_memory_limit() told last, or what is free on the machine at this moment; less where the process is in a group
/// (cgroup, as in a container or a batch job) that is bounded. Infinite where the system does not tell.
MemoryLimit memory_limit();
void set_memory_limit(double bytes);

/// Throws InputError at `place` where `work` ("meshing") takes more `bytes` than that.
void require_memory(double bytes, const std::string& place, const std::string& work, const std::string& remedy);

/// "12 GB", "350 MB": two digits, units of a thousand.
std::string bytes_text(double bytes);
/// Reads that, and "1.5TB", "800M", "2000000"; nothing where it is no size above zero.
std::optional<double> bytes_from(std::string_view text);

}  // namespace talus
