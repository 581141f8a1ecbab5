#include "export/gltf_file.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace talus {

namespace {

static_assert(std::endian::native == std::endian::little);

// Numbers that glTF 2.0 has from OpenGL.
constexpr int of_floats = 5126, of_unsigned_integers = 5125;
constexpr int for_vertices = 34962, for_indices = 34963;

void append(std::string& bytes, std::uint32_t number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

/// Chunks are multiples of four bytes.
std::string padded(std::string bytes, char by) {
  bytes.resize((bytes.size() + 3) / 4 * 4, by);
  return bytes;
}

}  // namespace

int GltfFile::add(const void* data, std::size_t size, Json accessor, int target) {
  accessor["bufferView"] = json["bufferViews"].size();
  Json view = {{"buffer", 0}, {"byteOffset", numbers_.size()}, {"byteLength", size}};
  if (target != 0) view["target"] = target;
  json["bufferViews"].push_back(view);
  numbers_.append(static_cast<const char*>(data), size);
  json["accessors"].push_back(std::move(accessor));
  return static_cast<int>(json["accessors"].size()) - 1;
}

int GltfFile::add_floats(const std::vector<float>& numbers, int components, bool bounded, int target) {
  const auto width = static_cast<std::size_t>(components);
  Json accessor = {{"componentType", of_floats},
                   {"count", numbers.size() / width},
                   {"type", components == 1 ? "SCALAR" : "VEC" + std::to_string(components)}};
  if (bounded) {
    std::vector<float> least(numbers.begin(), numbers.begin() + components), most = least;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      least[i % width] = std::min(least[i % width], numbers[i]);
      most[i % width] = std::max(most[i % width], numbers[i]);
    }
    accessor["min"] = least;
    accessor["max"] = most;
  }
  return add(numbers.data(), numbers.size() * sizeof(float), std::move(accessor), target);
}

int GltfFile::add_positions(const std::vector<float>& positions) {
  return add_floats(positions, 3, true, for_vertices);
}

int GltfFile::add_times(const std::vector<float>& seconds) { return add_floats(seconds, 1, true); }

int GltfFile::add_rows(const std::vector<float>& rows, int components) { return add_floats(rows, components, false); }

int GltfFile::add_indices(const std::vector<std::uint32_t>& vertices) {
  return add(vertices.data(), vertices.size() * sizeof(std::uint32_t),
             {{"componentType", of_unsigned_integers}, {"count", vertices.size()}, {"type", "SCALAR"}}, for_indices);
}

std::string GltfFile::bytes() const {
  Json whole = json;
  whole["buffers"][0]["byteLength"] = numbers_.size();
  const std::string text = padded(whole.dump(-1, ' ', false, Json::error_handler_t::replace), ' ');
  const std::string numbers = padded(numbers_, '\0');
  std::string file = "glTF";
  constexpr std::uint32_t header = 12, chunk_header = 8, version = 2;
  append(file, version);
  append(file, static_cast<std::uint32_t>(header + 2 * chunk_header + text.size() + numbers.size()));
  append(file, static_cast<std::uint32_t>(text.size()));
  file += "JSON" + text;
  append(file, static_cast<std::uint32_t>(numbers.size()));
  file += std::string("BIN\0", 4) + numbers;
  return file;
}

}  // namespace talus
