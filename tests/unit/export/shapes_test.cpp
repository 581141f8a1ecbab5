#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cstring>
#include <nlohmann/json.hpp>

#include "base/units.hpp"
#include "export/export.hpp"
#include "measures/block_travel.hpp"
#include "unit/results/example_results.hpp"

// STL and glTF, read back by their formats' own rules.
namespace talus {
namespace {

using Json = nlohmann::json;
using testing::ElementsAre;

template <class Number>
Number number_at(const std::string& bytes, std::size_t at) {
  Number number;
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}

Eigen::Vector3f vector_at(const std::string& bytes, std::size_t at) {
  return {number_at<float>(bytes, at), number_at<float>(bytes, at + 4), number_at<float>(bytes, at + 8)};
}

/// A fixed block and one that has gone by (1, 2, −3) and turned by `angle` about its own vertical axis.
BlockSystem two_blocks() {
  BlockSystem system;
  system.blocks = {example_block("base", 1, 0), example_block("wedge", 1, 5)};
  system.blocks[0].body = BodyKind::fixed;
  for (Block& block : system.blocks)
    for (Vec3& node : block.mesh.nodes) node.z() -= 400000;
  return system;
}

const Vec3 way(1, 2, -3);

Frame moved(const BlockSystem& system, double angle, int index = 0) {
  Frame frame;
  frame.index = index;
  frame.time = 0.5 * index;
  const Mat3 turn = Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
  Vec3 middle = Vec3::Zero();
  for (const Vec3& node : system.blocks[1].mesh.nodes) middle += node / 4;
  frame.displacement.assign(4, Vec3::Zero());
  for (const Vec3& node : system.blocks[1].mesh.nodes)
    frame.displacement.push_back(index * way + turn * (node - middle) - (node - middle));
  frame.velocity.assign(8, way);
  frame.stress.assign(2, Voigt::Zero());
  return frame;
}

const std::vector<BlockColour> colours = {{0.5, 0.5, 0.5}, {1, 0, 0}};

TEST(BlockTravel, IsThatOfTheCentroidAndTheRotationAboutIt) {
  const BlockSystem system = two_blocks();
  const std::vector<BlockTravel> travels = block_travels(system, moved(system, 0.3, 1));
  ASSERT_EQ(travels.size(), 2u);
  EXPECT_EQ(travels[0].turn(), 0);
  EXPECT_NEAR((travels[1].displacement - way).norm(), 0, 1e-12);
  EXPECT_NEAR((travels[1].velocity - way).norm(), 0, 1e-12);
  EXPECT_NEAR(travels[1].turn(), degrees(0.3), 1e-9);
}

TEST(Stl, IsTheClosedSurfaceOfAllBlocksWhereTheyAre) {
  const BlockSystem system = two_blocks();
  const std::string stl = stl_of(system, moved(system, 0, 1));
  const auto count = number_at<std::uint32_t>(stl, 80);
  EXPECT_EQ(count, 8u);
  ASSERT_EQ(stl.size(), 84u + 50 * count);
  EXPECT_NE(stl.substr(0, 5), "solid") << "that would be taken for text";
  double volume = 0;
  for (std::size_t at = 84; at < stl.size(); at += 50) {
    const Eigen::Vector3f normal = vector_at(stl, at), a = vector_at(stl, at + 12), b = vector_at(stl, at + 24),
                          c = vector_at(stl, at + 36);
    EXPECT_NEAR(normal.dot((b - a).cross(c - a).normalized()), 1, 1e-6);
    volume += a.dot(b.cross(c)) / 6;
  }
  EXPECT_NEAR(volume, 2 / 6.0, 1e-5) << "what the surface encloses, outwards";
  const Vec3 corner = system.blocks[1].mesh.nodes[static_cast<std::size_t>(system.blocks[1].surface[0].nodes[0])] + way;
  EXPECT_NEAR((vector_at(stl, 84 + 4 * 50 + 12).cast<double>() - corner).norm(), 0, 1e-5);
}

/// A .glb taken apart, after its frame and all that points into its numbers was checked.
struct ReadGlb {
  Json json;
  std::string numbers;

  explicit ReadGlb(const std::string& file) {
    EXPECT_EQ(file.substr(0, 4), "glTF");
    EXPECT_EQ(number_at<std::uint32_t>(file, 4), 2u);
    EXPECT_EQ(number_at<std::uint32_t>(file, 8), file.size());
    const auto length = number_at<std::uint32_t>(file, 12);
    EXPECT_EQ(length % 4, 0u);
    EXPECT_EQ(file.substr(16, 4), "JSON");
    json = Json::parse(file.substr(20, length));
    EXPECT_EQ(file.substr(24 + length, 4), std::string("BIN\0", 4));
    numbers = file.substr(28 + length);
    EXPECT_EQ(numbers.size(), number_at<std::uint32_t>(file, 20 + length));
    EXPECT_EQ(json["asset"]["version"], "2.0");
    EXPECT_LE(json["buffers"].at(0)["byteLength"], numbers.size());
    for (const Json& accessor : json["accessors"]) EXPECT_LE(end_of(accessor), json["buffers"][0]["byteLength"]);
    for (const Json& node : json["nodes"])
      if (node.contains("mesh")) check(json["meshes"].at(node["mesh"].get<std::size_t>()));
  }

  std::size_t start_of(const Json& accessor) const {
    return json["bufferViews"].at(accessor["bufferView"].get<std::size_t>())["byteOffset"];
  }
  std::size_t end_of(const Json& accessor) const {
    const std::size_t width = accessor["type"] == "SCALAR" ? 1 : accessor["type"] == "VEC3" ? 3 : 4;
    return start_of(accessor) + 4 * width * accessor["count"].get<std::size_t>();
  }
  std::vector<float> floats(int number) const {
    const Json& accessor = json["accessors"].at(static_cast<std::size_t>(number));
    std::vector<float> values;
    for (std::size_t at = start_of(accessor); at < end_of(accessor); at += 4)
      values.push_back(number_at<float>(numbers, at));
    return values;
  }
  void check(const Json& mesh) const {
    const Json& primitive = mesh["primitives"].at(0);
    const Json& positions = json["accessors"].at(primitive["attributes"]["POSITION"].get<std::size_t>());
    const Json& indices = json["accessors"].at(primitive["indices"].get<std::size_t>());
    EXPECT_EQ(positions["min"].size(), 3u);
    for (std::size_t at = start_of(indices); at < end_of(indices); at += 4)
      EXPECT_LT(number_at<std::uint32_t>(numbers, at), positions["count"]);
    EXPECT_LT(primitive["material"], json["materials"].size());
  }
};

TEST(Gltf, HasANodeABlockInItsColourWhereTheFrameHasIt) {
  const BlockSystem system = two_blocks();
  const ReadGlb glb(glb_of(system, moved(system, 0.3, 1), colours));
  ASSERT_EQ(glb.json["nodes"].size(), 3u);
  EXPECT_EQ(glb.json["scenes"][0]["nodes"], Json({0}));
  EXPECT_EQ(glb.json["nodes"][0]["children"], Json({1, 2}));
  EXPECT_EQ(glb.json["nodes"][2]["name"], "wedge");
  EXPECT_EQ(glb.json["materials"][1]["pbrMetallicRoughness"]["baseColorFactor"], Json({1.0, 0.0, 0.0, 1}));
  EXPECT_NEAR(glb.json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"][0], 0.2140, 1e-4) << "of sRGB 0.5";
  EXPECT_FALSE(glb.json.contains("animations"));
  const Vec3 origin(glb.json["asset"]["extras"]["origin"][0], glb.json["asset"]["extras"]["origin"][1],
                    glb.json["asset"]["extras"]["origin"][2]);
  const Json& at = glb.json["nodes"][2]["translation"];
  const Json& primitive = glb.json["meshes"][1]["primitives"][0];
  const std::vector<float> places = glb.floats(primitive["attributes"]["POSITION"]);
  ASSERT_EQ(places.size(), 12u);
  const int node = system.blocks[1].surface[0].nodes[0];
  const Vec3 expected = system.blocks[1].mesh.nodes[static_cast<std::size_t>(node)] +
                        moved(system, 0.3, 1).displacement[4 + static_cast<std::size_t>(node)];
  const Vec3 found = origin + Vec3(at[0], at[1], at[2]) + Vec3(places[0], places[1], places[2]);
  EXPECT_NEAR((found - expected).norm(), 0, 1e-5);
}

TEST(Gltf, MovesBlocksThroughAllFrames) {
  const BlockSystem system = two_blocks();
  const TemporaryFolder temporary;
  {
    ResultWriter writer(temporary.path / "results", example_project(), system, "{}");
    for (int i = 0; i < 4; ++i) writer.add_frame(moved(system, 1.5 * i, i));
  }
  NoProgress progress;
  const ReadGlb glb(animated_glb_of(ResultReader(temporary.path / "results"), colours, progress));
  const Json& animation = glb.json["animations"].at(0);
  ASSERT_EQ(animation["channels"].size(), 2u) << "what stands still has none";
  for (const Json& channel : animation["channels"]) EXPECT_EQ(channel["target"]["node"], 2);
  EXPECT_THAT(glb.floats(animation["samplers"][0]["input"]), ElementsAre(0, 0.5f, 1, 1.5f));
  const std::vector<float> places = glb.floats(animation["samplers"][0]["output"]);
  ASSERT_EQ(places.size(), 12u);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(places[9 + static_cast<std::size_t>(i)] - places[static_cast<std::size_t>(i)], 3 * way[i], 1e-5);
  const std::vector<float> turns = glb.floats(animation["samplers"][1]["output"]);
  ASSERT_EQ(turns.size(), 16u);
  Eigen::Vector4f before(0, 0, 0, 1);
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector4f turn(turns[4 * i], turns[4 * i + 1], turns[4 * i + 2], turns[4 * i + 3]);
    EXPECT_NEAR(turn.norm(), 1, 1e-6);
    EXPECT_NEAR(std::abs(turn[3]), std::abs(std::cos(0.75 * static_cast<double>(i))), 1e-5);
    EXPECT_GT(turn.dot(before), 0) << "the short way";
    before = turn;
  }
}

}  // namespace
}  // namespace talus
