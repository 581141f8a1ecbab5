#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>

#include "rock.hpp"

namespace talus {
namespace {

using namespace rock;
using testing::HasSubstr;
using testing::StartsWith;

Project cube() {
  Project p = project();
  p.solids = {box("cube", {0, 0, 0}, {10, 10, 10}, 5)};
  return p;
}

TEST(Refusal, ACutThatMissesIsNamed) {
  Project p = cube();
  p.cuts = {cut("J1", 0, 0, {0, 0, 5}), cut("J2", 30, 90, {0, 0, 40})};
  EXPECT_EQ(error_of(p), "cut 2 (J2): misses every solid; move its point \"through\", or remove it");
  // Touching an edge divides nothing and lies on no facet.
  p.cuts = {cut("J2", 45, 90, {10, 5, 10})};
  EXPECT_THAT(error_of(p), StartsWith("cut 1 (J2): misses every solid"));
  // It passes through the other solid, which it is not meant for.
  p.solids.push_back(box("other", {0, 0, 20}, {10, 10, 30}, 5));
  p.cuts = {cut("J3", 0, 0, {0, 0, 5})};
  p.cuts[0].solids = {"other"};
  EXPECT_THAT(error_of(p), StartsWith("cut 1 (J3): misses every solid it is limited to"));
}

TEST(Refusal, OverlappingSolidsAreNamedWithThePlace) {
  Project p = cube();
  p.solids.push_back(box("other", {8, 8, 9}, {20, 20, 20}, 5));
  const std::string error = error_of(p);
  EXPECT_THAT(error, StartsWith("solid cube: overlaps solid other by 4 m³ around (9, 9, 9.5); "));
  p.solids[1] = box("inside", {4, 4, 4}, {5, 5, 5}, 1);
  EXPECT_THAT(error_of(p), StartsWith("solid cube: overlaps solid inside by 1 m³"));
  p.solids[1] = box("twin", {0, 0, 0}, {10, 10, 10}, 5);
  EXPECT_THAT(error_of(p), StartsWith("solid cube: overlaps solid twin by 1000 m³"));
}

TEST(Refusal, TouchingSolidsAreNoOverlap) {
  Project p = cube();
  p.solids.push_back(box("face", {10, 0, 0}, {12, 5, 5}, 5));
  p.solids.push_back(box("edge", {-3, 2, 10}, {0, 5, 12}, 5));
  p.solids.push_back(box("corner", {-3, -3, -3}, {0, 0, 0}, 5));
  p.solids.push_back(box("rounded", {2, 2, 9.99999}, {5, 5, 12}, 5));
  EXPECT_EQ(build(p).blocks.size(), 5u);
}

TEST(Refusal, TwoJointsOnOnePlane) {
  Project p = cube();
  p.cuts = {cut("J1", 0, 0, {0, 0, 5}), cut("J2", 0, 0, {3, 3, 5})};
  EXPECT_THAT(error_of(p), StartsWith("cut 2 (J2): lies on the same plane of solid cube as cut 1 (J1); "));
}

TEST(Refusal, ASplinterIsShown) {
  Project p = cube();
  p.cuts = {cut("J1", 45, 90, {10, 5, 9.9999})};
  EXPECT_THAT(error_of(p), AllOf(StartsWith("solid cube: the cuts leave a splinter "), HasSubstr("around (")));
}

TEST(Refusal, PolyhedraThatAreNoBody) {
  PolyhedronShape tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                              {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  Project p = project();
  p.solids = {solid("tet", tetrahedron, 1)};
  EXPECT_NEAR(build(p).blocks[0].volume, 1.0 / 6, 1e-12);

  PolyhedronShape two = tetrahedron;
  for (std::size_t v = 0; v < 4; ++v) two.vertices.push_back(tetrahedron.vertices[v] + Vec3(5, 5, 5));
  for (const auto& face : tetrahedron.faces) two.faces.push_back({face[0] + 4, face[1] + 4, face[2] + 4});
  p.solids = {solid("two", two, 1)};
  EXPECT_THAT(error_of(p), StartsWith("solid two: face 4 is not joined to face 0; "));

  PolyhedronShape open = tetrahedron;
  open.faces[3] = {0, 2, 3};
  p.solids = {solid("open", open, 1)};
  EXPECT_THAT(error_of(p), StartsWith("/solids/0/polyhedron"));
}

TEST(Refusal, OverridesInNoBlockOrInOneTwice) {
  Project p = cube();
  p.cuts = {cut("J1", 0, 0, {0, 0, 5})};
  p.blocks = {{"B", {5, 5, 11}, {}, {}, {}}};
  EXPECT_EQ(error_of(p),
            "block override 1 (B): its point \"at\" lies in no block; move it inside the block that is meant");
  p.blocks = {{"B", {5, 5, 5}, {}, {}, {}}};
  EXPECT_THAT(error_of(p),
              StartsWith("block override 1 (B): its point \"at\" lies on the border of cube.1 and cube.2"));
  p.blocks = {{"B", {5, 5, 6}, {}, {}, {}}, {"C", {4, 4, 7}, {}, {}, {}}};
  EXPECT_THAT(error_of(p), StartsWith("block override 2 (C): lies in the same block as block override 1 (B); "));
  p.blocks = {{"cube.1", {5, 5, 6}, {}, {}, {}}};
  EXPECT_THAT(error_of(p), StartsWith("block cube.1: two blocks have this name; "));
}

class StepFiles : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) /
              ("talus_step_" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) + "_" +
               ::testing::UnitTest::GetInstance()->current_test_info()->name());
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

TEST_F(StepFiles, AreReadInTheirOwnUnitAndScaled) {
  const std::string metres = slope();
  write("metres.step", metres);
  const BlockSystem system = build(reading("metres.step"), folder_);
  ASSERT_EQ(system.blocks.size(), 1u);
  EXPECT_EQ(system.blocks[0].name, "hill");
  // Box less two cone frusta: by quadrature of the pit's cross sections.
  EXPECT_NEAR(system.solids_volume, 1158823.029, 1);

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

/// Sets TALUS_MESHER for one test.
class MesherAt {
 public:
  explicit MesherAt(const std::string& path) { setenv("TALUS_MESHER", path.c_str(), 1); }
  ~MesherAt() { unsetenv("TALUS_MESHER"); }
  MesherAt(const MesherAt&) = delete;
  MesherAt& operator=(const MesherAt&) = delete;
};

TEST(Isolation, ACrashOfTheMesherIsAMessage) {
  const MesherAt dying("/bin/false");
  EXPECT_THAT(error_of(cube()), AllOf(HasSubstr("the mesher crashed while starting"), HasSubstr("mesh_size")));
}

TEST(Isolation, AMissingMesherIsNotTheUsersFault) {
  const MesherAt nowhere("/nonexistent/talus-mesher");
  EXPECT_THROW(build(cube()), std::runtime_error);
}

/// Cancels once the work has said so many things.
class Impatient : public Progress {
 public:
  explicit Impatient(int patience) : patience_(patience) {}
  void report(double fraction, std::string_view what) override {
    EXPECT_GE(fraction, last_);
    EXPECT_LE(fraction, 1);
    EXPECT_FALSE(what.empty());
    last_ = fraction;
    ++said_;
  }
  bool cancelled() const override { return said_ >= patience_; }

 private:
  double last_ = 0;
  int patience_, said_ = 0;
};

TEST(Isolation, CancellingEndsTheMesherAtOnce) {
  Project p = cube();
  p.solids[0].mesh_size = 0.1;  // would take minutes
  Impatient user(3);            // importing, cutting, meshing
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THROW(build_blocks(p, ".", user), Cancelled);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

TEST(Isolation, ProgressRunsToOne) {
  Impatient user(1000);
  Project p = cube();
  p.cuts = {cut("J1", 0, 0, {0, 0, 5})};
  EXPECT_EQ(build_blocks(p, ".", user).blocks.size(), 2u);
}

}  // namespace
}  // namespace talus
