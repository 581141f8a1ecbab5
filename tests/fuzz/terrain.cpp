#include <cmath>
#include <stdexcept>

#include "fuzz/given.hpp"
#include "geometry/mesher/surfaces/height_field.hpp"
#include "geometry/mesher/surfaces/height_points.hpp"

// Points of a terrain become rock, with all of them and thinned; its volume is a number.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace talus;
  const auto file = fuzz::file_of(fuzz::text_of(bytes, size), "points.xyz");
  fuzz::allow_refusal([&] {
    const HeightPoints read = read_points(file.string(), "points.xyz", Vec3::Zero());
    for (const double tolerance : {0.0, 0.5})
      fuzz::allow_refusal([&] {
        const TriangleSolid rock = solid_below(height_field(read.points, tolerance, "points.xyz"), -1e6, "solid rock");
        if (std::isnan(volume_of(rock))) throw std::logic_error("the rock has no volume");
      });
  });
  return 0;
}
