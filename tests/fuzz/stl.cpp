#include "fuzz/given.hpp"
#include "geometry/mesher/surfaces/height_field.hpp"
#include "geometry/mesher/surfaces/mended_surface.hpp"
#include "geometry/mesher/surfaces/triangle_file.hpp"

// Triangles of a file are mended as far as can be; as the surface of a terrain they become rock.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace talus;
  const std::string_view text = fuzz::text_of(bytes, size);
  const bool as_object = text.starts_with("v ") || text.starts_with("#");
  const char* name = as_object ? "rock.obj" : text.starts_with("ply") ? "rock.ply" : "rock.stl";
  const auto file = fuzz::file_of(text, name);
  fuzz::allow_refusal([&] {
    const PolygonSoup soup = read_polygons(file.string(), name);
    fuzz::allow_refusal([&] { mended(soup); });
    fuzz::allow_refusal([&] { solid_below(height_field(welded(soup), 0.5, name), -1e6, "solid rock"); });
  });
  return 0;
}
