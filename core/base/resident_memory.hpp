#pragma once

namespace talus {

/// Bytes of memory that this process has in the machine's, and the most that it had since it began or was told to
/// begin anew; 0 where the system does not tell.
struct ResidentMemory {
  double now = 0, most = 0;
};
ResidentMemory resident_memory();

/// Gives back what was freed, and lets `most` be counted from now on. False where the system does not allow it.
bool count_resident_memory_anew();

}  // namespace talus
