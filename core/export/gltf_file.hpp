#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace talus {

/// A glTF file that grows: its JSON, and the numbers that it points to. Seen by this folder's .cpp files alone.
class GltfFile {
 public:
  using Json = nlohmann::ordered_json;

  Json json;

  // Each adds an accessor and returns its index.
  int add_positions(const std::vector<float>& positions);        ///< of vertices, x y z
  int add_indices(const std::vector<std::uint32_t>& vertices);   ///< of triangles
  int add_times(const std::vector<float>& seconds);              ///< of an animation
  int add_rows(const std::vector<float>& rows, int components);  ///< that an animation goes through
  /// The bytes of the .glb file.
  std::string bytes() const;

 private:
  int add(const void* data, std::size_t size, Json accessor, int target = 0);
  int add_floats(const std::vector<float>& numbers, int components, bool bounded, int target = 0);

  std::string numbers_;
};

}  // namespace talus
