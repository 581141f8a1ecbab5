#include <gmock/gmock.h>
#include <unistd.h>

#include <cmath>
#include <fstream>

#include "rock.hpp"

namespace talus {
namespace {

using namespace rock;
using testing::StartsWith;

class StepFiles : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) / ("talus_step_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
  Project reading(const std::string& name, double scale = 1) const {
    Project p = project();
    p.solids = {solid("hill", FileShape{name, scale}, 40)};
    return p;
  }
  std::string slope() const {
    std::ifstream file(std::string(TALUS_SOURCE_DIR) + "/samples/step_slope/slope.step");
    return {std::istreambuf_iterator<char>(file), {}};
  }

  std::filesystem::path folder_;
};

TEST_F(StepFiles, ThatAreNoneAreRefused) {
  write("rubbish.step", "this is not STEP\n");
  EXPECT_EQ(error_of(reading("rubbish.step"), folder_),
            "rubbish.step: is not a readable STEP file; export the solid again as STEP");
  write("empty.stp", "");
  EXPECT_THAT(error_of(reading("empty.stp"), folder_), StartsWith("empty.stp: is not a readable STEP file; "));
  write("half.step", slope().substr(0, 9000));
  EXPECT_THAT(error_of(reading("half.step"), folder_), StartsWith("half.step: "));
  EXPECT_EQ(error_of(reading("missing.step"), folder_),
            "missing.step: there is no such file; correct the path of solid hill");
}

/// OpenCASCADE looked for the ends of such an edge for minutes.
TEST_F(StepFiles, WithAnEdgeThatGoesAroundForEverAreRefusedAtOnce) {
  std::string text = slope();
  const std::string point = "CARTESIAN_POINT('',(2.799087392928,40.))";  // of an edge, on a cylinder
  const auto at = text.find(point);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, point.size(), "CARTESIAN_POINT('',(9007199254740992,40.))");
  write("round.step", text);
  EXPECT_EQ(error_of(reading("round.step"), folder_),
            "round.step: line 611: is damaged: an edge of a round face lies at an angle beyond a million; export the "
            "solid again as STEP");
}

/// OpenCASCADE went from the edge to itself until there was no memory left.
TEST_F(StepFiles, WithAnEdgeThatIsPartOfItselfAreRefusedAtOnce) {
  std::string text = slope();
  const std::string edge = "ORIENTED_EDGE('',*,*,#193,.T.)";
  const auto at = text.find("#192 = " + edge);
  ASSERT_NE(at, std::string::npos);
  text.replace(text.find("#193", at), 4, "#192");
  write("circle.step", text);
  EXPECT_EQ(error_of(reading("circle.step"), folder_),
            "circle.step: line 229: is damaged: what stands there is part of itself; export the solid again as STEP");
}

/// m³ of samples/step_slope, as tools/step_slope.geo describes it: a box less a pit whose radius grows with height,
/// by the midpoint rule.
double slope_volume() {
  const double back = 40 / std::tan(65 * std::acos(-1.0) / 180), toe = 160, berm = 8;
  constexpr int heights = 800, widths = 600;
  double dug = 0;
  for (int i = 0; i < heights; ++i) {
    const double z = 20 + 80 * (i + 0.5) / heights;
    const double radius = z < 60 ? toe + back * (z - 20) / 40 : toe + back + berm + back * (z - 60) / 40;
    for (int k = 0; k < widths; ++k) {
      const double y = 120 * (k + 0.5) / widths - 60;
      dug += (160 - (260 - std::sqrt(radius * radius - y * y))) * 80 / heights * 120 / widths;
    }
  }
  return 160.0 * 120 * 100 - dug;
}

TEST_F(StepFiles, AreReadInTheirOwnUnitAndScaled) {
  const std::string metres = slope();
  write("metres.step", metres);
  const BlockSystem system = build(reading("metres.step"), folder_);
  ASSERT_EQ(system.blocks.size(), 1u);
  EXPECT_EQ(system.blocks[0].name, "hill");
  EXPECT_NEAR(system.solids_volume, slope_volume(), 1);

  std::string millimetres = metres;
  const std::string unit = "SI_UNIT($,.METRE.)";
  const auto at = millimetres.find(unit);
  ASSERT_NE(at, std::string::npos);
  millimetres.replace(at, unit.size(), "SI_UNIT(.MILLI.,.METRE.)");
  write("millimetres.step", millimetres);
  EXPECT_NEAR(build(reading("millimetres.step", 500), folder_).solids_volume, system.solids_volume / 8, 1e-6);
}

TEST_F(StepFiles, AreCutLikeOtherSolids) {
  write("slope.step", slope());
  Project p = reading("slope.step");
  p.cuts = {cut("J1", 40, 90, {88, 60, 42}), cut("J2", 80, 90, {40, 60, 80})};
  const BlockSystem system = build(p, folder_);
  EXPECT_GE(system.blocks.size(), 4u);
  double sum = 0, joint_area = 0;
  for (const Block& b : system.blocks) {
    sum += b.volume;
    joint_area += joint_areas(b)[0];
    EXPECT_NEAR(mesh_volume(b), b.volume, 0.03 * b.volume);
    EXPECT_NEAR(surface_volume(b, b.mesh.nodes[0]), mesh_volume(b), 1e-9 * b.volume);
  }
  EXPECT_NEAR(sum, system.solids_volume, 1e-9 * sum);
  EXPECT_GT(joint_area, 2 * 5000);
}

/// Few large triangles would cut curved faces short.
TEST_F(StepFiles, CurvedFacesKeepTheirMeshWhateverTheBody) {
  write("slope.step", slope());
  Project p = reading("slope.step");
  p.solids[0].mesh_size.reset();
  const std::size_t nodes = build(p, folder_).blocks[0].mesh.nodes.size();
  p.solids[0].body = BodyKind::rigid;
  EXPECT_EQ(build(p, folder_).blocks[0].mesh.nodes.size(), nodes);
}

}  // namespace
}  // namespace talus
