#include "export/export.hpp"

#include <gmock/gmock.h>

#include <cstring>
#include <fstream>
#include <map>

#include "base/error.hpp"
#include "export/export_folder.hpp"
#include "results/field.hpp"
#include "results/text_table.hpp"
#include "support/xml_elements.hpp"
#include "unit/results/example_results.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

std::string attribute(const std::string& element, const std::string& name) {
  const std::size_t begin = element.find(' ' + name + "=\"") + name.size() + 3;
  return element.substr(begin, element.find('"', begin) - begin);
}

/// What was written in base64, up to the first character that is none of its letters.
std::string from_base64(std::string_view text) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char letter : text) {
    const std::size_t value = letters.find(letter);
    if (value == std::string_view::npos) break;
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 255);
  }
  return bytes;
}

/// The bytes of each appended array of a .vtu, by name.
std::map<std::string, std::string> arrays_of(const std::string& vtu) {
  std::map<std::string, std::string> arrays;
  const std::size_t appended = vtu.find('_', vtu.find("<AppendedData encoding=\"base64\">")) + 1;
  for (std::size_t at = 0; (at = vtu.find("<DataArray ", at)) < appended; ++at) {
    const std::string element = vtu.substr(at, vtu.find("/>", at) - at);
    const std::size_t offset = appended + std::stoul(attribute(element, "offset"));
    const std::string length_text = from_base64(std::string_view(vtu).substr(offset, 12));
    std::uint64_t length;
    std::memcpy(&length, length_text.data(), sizeof length);
    const std::size_t letters = (sizeof length + length + 2) / 3 * 4;
    arrays[attribute(element, "Name")] =
        from_base64(std::string_view(vtu).substr(offset, letters)).substr(sizeof length, length);
  }
  return arrays;
}

template <class Number>
std::vector<Number> numbers(const std::string& bytes) {
  std::vector<Number> result(bytes.size() / sizeof(Number));
  std::memcpy(result.data(), bytes.data(), bytes.size());
  return result;
}

/// Results with three frames, to be exported.
class Export : public testing::Test {
 protected:
  const std::filesystem::path& written() const {
    ResultWriter writer(temporary.path / "results", example_project(), system, "{}");
    for (int i = 0; i < 3; ++i) writer.add_frame(example_frame(system, i));
    writer.add_step({});
    writer.add_history({.time = 0.1, .stage = 1, .monitors = std::vector<MonitorSample>(2)});
    RunReport report;
    report.events = {{0.25, "B1: sliding on J1, J2"}};
    writer.finish(report);
    return temporary.path;
  }
  const BlockSystem system = example_system();
  const TemporaryFolder temporary;
  const ResultReader results{written() / "results"};
  const std::vector<int> all = all_frames(results);
  const fs::path out = temporary.path / "out/deeper";
  NoProgress progress;
};

TEST_F(Export, VtuHoldsTheFramesNumbers) {
  export_vtu(results, all, out, progress);
  const Frame frame = example_frame(system, 2);
  const std::string vtu = text_of(out / "frame_00002.vtu");
  EXPECT_THAT(test::xml_elements(vtu), testing::Contains("AppendedData")) << "well-formed";
  EXPECT_THAT(vtu, testing::HasSubstr("<Piece NumberOfPoints=\"20\" NumberOfCells=\"5\">"));
  auto arrays = arrays_of(vtu);
  EXPECT_THAT(numbers<double>(arrays["TimeValue"]), testing::ElementsAre(frame.time));
  EXPECT_EQ(numbers<double>(arrays["velocity"]).at(3 * 7 + 1), frame.velocity[7].y());
  EXPECT_EQ(numbers<double>(arrays["stress"]).at(6 * 4 + 5), frame.stress[4][5]);
  EXPECT_EQ(numbers<double>(arrays["von Mises stress"]).at(4), von_mises(frame.stress[4]));
  const Vec3 moved = system.blocks[1].mesh.nodes[2] + frame.displacement[10];
  EXPECT_EQ(numbers<double>(arrays["points"]).at(3 * 10 + 2), moved.z());
  EXPECT_THAT(numbers<std::int32_t>(arrays["block"]), testing::ElementsAre(0, 0, 1, 1, 1));
  EXPECT_THAT(numbers<std::int32_t>(arrays["material"]), testing::ElementsAre(0, 0, 1, 1, 1));
  EXPECT_THAT(numbers<std::int64_t>(arrays["offsets"]), testing::ElementsAre(4, 8, 12, 16, 20));
  EXPECT_EQ(numbers<std::int64_t>(arrays["connectivity"]).at(8), 8);
  EXPECT_THAT(numbers<std::uint8_t>(arrays["types"]), testing::Each(10));
}

TEST_F(Export, TheCollectionNamesEveryFrameWithItsTime) {
  export_vtu(results, all, out, progress);
  const std::string pvd = text_of(out / "frames.pvd");
  for (const char* entry : {"timestep=\"0\" group=\"\" part=\"0\" file=\"frame_00000.vtu\"",
                            "timestep=\"0.1\" group=\"\" part=\"0\" file=\"frame_00001.vtu\"",
                            "timestep=\"0.2\" group=\"\" part=\"0\" file=\"frame_00002.vtu\""})
    EXPECT_THAT(pvd, testing::HasSubstr(entry));
}

TEST_F(Export, CsvHoldsTheFramesNumbers) {
  export_csv(results, all, out, progress);
  const Frame frame = example_frame(system, 2);
  const auto nodes = read_text_table(out / "nodes_00002.csv", 10);
  ASSERT_EQ(nodes.size(), 20u);
  const Vec3 moved = system.blocks[1].mesh.nodes[2] + frame.displacement[10];
  EXPECT_THAT(nodes[10], testing::ElementsAre(1, moved.x(), moved.y(), moved.z(), frame.displacement[10].x(),
                                              frame.displacement[10].y(), frame.displacement[10].z(),
                                              frame.velocity[10].x(), frame.velocity[10].y(), frame.velocity[10].z()));
  const auto tetrahedra = read_text_table(out / "tetrahedra_00002.csv", 11);
  ASSERT_EQ(tetrahedra.size(), 5u);
  EXPECT_THAT(std::vector(tetrahedra[3].begin(), tetrahedra[3].begin() + 5), testing::ElementsAre(1, 12, 13, 14, 15));
  EXPECT_EQ(tetrahedra[3][10], frame.stress[3][5]);
  EXPECT_THAT(read_text_table(out / "frames.csv", 3)[2], testing::ElementsAre(2, 0.2, 0));
  EXPECT_EQ(read_text_table(out / "history.csv", 14).size(), 1u);
  EXPECT_EQ(read_text_table(out / "steps.csv", 31).size(), 1u);
  EXPECT_THAT(text_of(out / "contacts_00002.csv"),
              testing::AllOf(testing::HasSubstr("\n0,1,,open,"), testing::HasSubstr("\n0,1,J1,stick,"),
                             testing::HasSubstr(",area [m2],friction,cohesion [Pa],bond\n"),
                             testing::ContainsRegex(",broken\n0,1,J1,stick,.*,none\n")));
  EXPECT_THAT(text_of(out / "motions_00001.csv"),
              testing::AllOf(testing::StartsWith(
                                 "block,name,mode,motion,trend [deg],plunge [deg],share of rotation\n0,B1,carried,"),
                             testing::HasSubstr("\n1,\"Fels ä, \"\"2\"\"\",falling,\"falling, came to rest\",")));
  EXPECT_THAT(text_of(out / "travels_00002.csv"), testing::HasSubstr("\n1,\"Fels ä, \"\"2\"\"\","));
  EXPECT_EQ(text_of(out / "events.csv"), "time [s],event\n0.25,\"B1: sliding on J1, J2\"\n");
  EXPECT_THAT(text_of(out / "blocks.csv"), testing::HasSubstr("\n1,\"Fels ä, \"\"2\"\"\",tetrahedra,0.5,12,3\n"));
}

TEST_F(Export, OfOneFrameHasThatOneAlone) {
  export_csv(results, std::vector{2}, out, progress);
  EXPECT_FALSE(fs::exists(out / "nodes_00001.csv"));
  EXPECT_TRUE(fs::exists(out / "contacts_00002.csv"));
  EXPECT_THAT(read_text_table(out / "frames.csv", 3), testing::ElementsAre(testing::ElementsAre(2, 0.2, 0)));
}

TEST_F(Export, AFolderThatIsNotEmptyIsRefused) {
  EXPECT_THROW(export_vtu(results, all, temporary.path, progress), InputError);
  EXPECT_THROW(export_csv(results, all, temporary.path, progress), InputError);
}

TEST_F(Export, CanBeCancelled) {
  struct Cancelling : Progress {
    void report(double, std::string_view) override {}
    bool cancelled() const override { return true; }
  } cancelling;
  EXPECT_THROW(export_vtu(results, all, out, cancelling), Cancelled);
}

}  // namespace
}  // namespace talus
