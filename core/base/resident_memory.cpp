#include "base/resident_memory.hpp"

#include <malloc.h>

#include <fstream>
#include <string>

namespace talus {

ResidentMemory resident_memory() {
  constexpr double kilobyte = 1024;
  ResidentMemory memory;
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (word != "VmRSS:" && word != "VmHWM:") continue;
    double count = 0;
    status >> count;
    (word == "VmRSS:" ? memory.now : memory.most) = kilobyte * count;
  }
  return memory;
}

bool count_resident_memory_anew() {
  malloc_trim(0);
  std::ofstream order("/proc/self/clear_refs");
  order << "5" << std::flush;
  return order.good();
}

}  // namespace talus
