#include "fuzz/given.hpp"
#include "orientation/dxf_joints.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace talus;
  fuzz::allow_refusal([&] { read_dxf_joints(fuzz::text_of(bytes, size)).joints(); });
  return 0;
}
