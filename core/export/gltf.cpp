#include <Eigen/Geometry>
#include <cmath>
#include <map>

#include "base/error.hpp"
#include "export/export.hpp"
#include "export/export_folder.hpp"
#include "export/gltf_file.hpp"
#include "measures/block_travel.hpp"

namespace talus {

namespace {

using Json = GltfFile::Json;
using Node = Eigen::Vector3f;

/// The root's rotation: z up becomes y up.
const std::vector<double> y_up = {-std::sqrt(0.5), 0, 0, std::sqrt(0.5)};

/// The middle of the blocks as they were cut, from which nodes are counted: single precision is fine near it.
Vec3 middle_of(const BlockSystem& system) {
  Eigen::AlignedBox3d box;
  for (const Block& block : system.blocks)
    for (const Vec3& node : block.mesh.nodes) box.extend(node);
  if (box.isEmpty()) return Vec3::Zero();
  return box.center();
}

double linear(double srgb) { return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4); }

std::vector<double> numbers_of(const Vec3& vector) { return {vector.x(), vector.y(), vector.z()}; }

/// A file with the root, and for each block a node, named as it is, with mesh and material.
class BlocksFile {
 public:
  BlocksFile(const BlockSystem& system, std::span<const BlockColour> colours)
      : system_(system), origin_(middle_of(system)) {
    const Json root = {{"name", "Talus, z up"}, {"rotation", y_up}, {"children", Json::array()}};
    const Json scene = {{"nodes", Json::array({0})}};
    file_.json["asset"] = {{"version", "2.0"}, {"generator", "Talus"}};
    file_.json["asset"]["extras"]["origin"] = numbers_of(origin_);
    file_.json["scene"] = 0;
    file_.json["scenes"] = Json::array({scene});
    file_.json["nodes"] = Json::array({root});
    for (const BlockColour& colour : colours) material_of_.push_back(material_in(colour));
  }

  /// `positions`: of the block's own nodes [m]; the node stands at `centroid`.
  void add_block(std::size_t number, std::span<const Vec3> positions, const Vec3& centroid) {
    const Block& block = system_.blocks[number];
    std::map<int, std::uint32_t> vertices;  // of a node; what lies inside the block has none
    std::vector<float> places;
    std::vector<std::uint32_t> corners;
    for (const SurfaceTriangle& triangle : block.surface)
      for (const int node : triangle.nodes) {
        const auto [entry, is_new] = vertices.try_emplace(node, static_cast<std::uint32_t>(vertices.size()));
        corners.push_back(entry->second);
        if (!is_new) continue;
        const Node place = (positions[static_cast<std::size_t>(node)] - centroid).cast<float>();
        places.insert(places.end(), place.begin(), place.end());
      }
    Json node = {{"name", block.name}, {"translation", numbers_of(centroid - origin_)}};
    if (!places.empty()) {
      node["mesh"] = file_.json["meshes"].size();
      const int position = file_.add_positions(places), indices = file_.add_indices(corners);
      const Json primitive = {
          {"attributes", {{"POSITION", position}}}, {"indices", indices}, {"material", material_of_[number]}};
      const Json mesh = {{"name", block.name}, {"primitives", Json::array({primitive})}};
      file_.json["meshes"].push_back(mesh);
    }
    file_.json["nodes"][0]["children"].push_back(file_.json["nodes"].size());
    file_.json["nodes"].push_back(node);
  }

  /// Lets the node of a block follow rows of a path ("translation", "rotation") at the times of an accessor.
  void animate(std::size_t block, const char* path, int times, const std::vector<float>& rows, int components) {
    const Json sampler = {{"input", times}, {"output", file_.add_rows(rows, components)}};
    const Json target = {{"node", block + 1}, {"path", path}};
    Json& animation = file_.json["animations"][0];
    const Json channel = {{"sampler", animation["samplers"].size()}, {"target", target}};
    animation["samplers"].push_back(sampler);
    animation["channels"].push_back(channel);
  }

  GltfFile& file() { return file_; }
  const Vec3& origin() const { return origin_; }

 private:
  /// Blocks of one colour share their material.
  int material_in(const BlockColour& colour) {
    const auto [entry, is_new] = materials_.try_emplace(colour, static_cast<int>(materials_.size()));
    if (!is_new) return entry->second;
    Json surface = {{"metallicFactor", 0}, {"roughnessFactor", 0.9}};
    surface["baseColorFactor"] = {linear(colour[0]), linear(colour[1]), linear(colour[2]), 1};
    Json material;
    material["pbrMetallicRoughness"] = surface;
    file_.json["materials"].push_back(material);
    return entry->second;
  }

  const BlockSystem& system_;
  Vec3 origin_;
  GltfFile file_;
  std::map<BlockColour, int> materials_;
  std::vector<int> material_of_;  ///< a block
};

/// Where a block's node stands and how it is turned, frame by frame.
struct Track {
  std::vector<float> places, turns;
  Eigen::Quaternionf last = Eigen::Quaternionf::Identity();

  void add(const Vec3& place, const Mat3& rotation) {
    const Node at = place.cast<float>();
    places.insert(places.end(), at.begin(), at.end());
    Eigen::Quaternionf turn(Eigen::Quaterniond(rotation).cast<float>());
    if (turn.dot(last) < 0) turn.coeffs() *= -1;  // the same, on the short way from the one before
    last = turn;
    turns.insert(turns.end(), {turn.x(), turn.y(), turn.z(), turn.w()});
  }
  /// Whether the rows differ from each other.
  static bool varies(const std::vector<float>& rows, std::size_t width) {
    for (std::size_t i = width; i < rows.size(); ++i)
      if (rows[i] != rows[i % width]) return true;
    return false;
  }
};

}  // namespace

std::string glb_of(const BlockSystem& system, const Frame& frame, std::span<const BlockColour> colours) {
  BlocksFile blocks(system, colours);
  std::size_t first = 0;
  for (const BlockTravel& travel : block_travels(system, frame)) {
    const auto number = static_cast<std::size_t>(travel.block);
    std::vector<Vec3> positions = system.blocks[number].mesh.nodes;
    for (std::size_t n = 0; n < positions.size(); ++n) positions[n] += frame.displacement[first + n];
    blocks.add_block(number, positions, travel.centroid);
    first += positions.size();
  }
  return blocks.file().bytes();
}

std::string animated_glb_of(const ResultReader& results, std::span<const BlockColour> colours, Progress& progress) {
  const BlockSystem& system = results.system();
  const std::vector<int> frames = all_frames(results);
  if (frames.empty()) throw InputError("frames", "the results hold no frame yet", "wait for the run to write one");
  BlocksFile blocks(system, colours);
  std::vector<float> times;
  std::vector<Track> tracks(system.blocks.size());
  for_each_frame(results, frames, progress, [&](const Frame& frame) {
    const auto time = static_cast<float>(frame.time);
    if (!times.empty() && time <= times.back()) return;  // times of an animation grow
    const std::vector<BlockTravel> travels = block_travels(system, frame);
    for (std::size_t b = 0; b < travels.size(); ++b) {
      if (times.empty())
        blocks.add_block(b, system.blocks[b].mesh.nodes, travels[b].centroid - travels[b].displacement);
      tracks[b].add(travels[b].centroid - blocks.origin(), travels[b].rotation);
    }
    times.push_back(time);
  });
  const int input = blocks.file().add_times(times);
  for (std::size_t b = 0; b < tracks.size(); ++b) {
    if (Track::varies(tracks[b].places, 3)) blocks.animate(b, "translation", input, tracks[b].places, 3);
    if (Track::varies(tracks[b].turns, 4)) blocks.animate(b, "rotation", input, tracks[b].turns, 4);
  }
  return blocks.file().bytes();
}

}  // namespace talus
