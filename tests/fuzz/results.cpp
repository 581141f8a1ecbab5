#include "fuzz/given.hpp"
#include "results/checkpoint.hpp"
#include "results/result_file.hpp"

// results.h5 with all its frames, and the same bytes as a checkpoint.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace talus;
  const auto file = fuzz::file_of(fuzz::text_of(bytes, size), "results.h5");
  fuzz::allow_refusal([&] {
    const ResultFileReader results(file);
    for (int frame = 0; frame < static_cast<int>(results.frame_times.size()) && frame < 8; ++frame)
      fuzz::allow_refusal([&] { results.frame(frame); });
  });
  fuzz::allow_refusal([&] { read_checkpoint(file); });
  return 0;
}
