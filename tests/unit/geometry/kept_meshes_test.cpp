// Blocks that stay as they are are not meshed again.
#include "geometry/kept_meshes.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "geometry/block_builder.hpp"
#include "rock.hpp"

namespace talus {
namespace {

using namespace rock;

/// A cube of eight blocks of different shapes, 10 m across, on a slab.
Project cut_cube() {
  Project p = project();
  p.solids = {box("cube", {0, 0, 0}, {10, 10, 10}, 2.0), box("slab", {0, 0, -2}, {10, 10, 0}, 1.5)};
  p.cuts = {cut("J1", 0, 0, {5, 5, 4}), cut("J2", 90, 90, {6, 5, 5}), cut("J2", 80, 0, {5, 5, 5})};
  for (Cut& one : p.cuts) one.solids = {"cube"};
  return p;
}

BlockSystem build_with(KeptMeshes& kept, const Project& project) {
  NoProgress nobody;
  return build_blocks(project, ".", nobody, kept);
}

void expect_the_same(const BlockSystem& a, const BlockSystem& b) {
  ASSERT_EQ(a.blocks.size(), b.blocks.size());
  for (std::size_t i = 0; i < a.blocks.size(); ++i) {
    const Block &one = a.blocks[i], &other = b.blocks[i];
    EXPECT_EQ(one.name, other.name);
    EXPECT_EQ(one.volume, other.volume);
    EXPECT_EQ(one.mesh.nodes, other.mesh.nodes) << one.name;
    EXPECT_EQ(one.mesh.tetrahedra, other.mesh.tetrahedra) << one.name;
    ASSERT_EQ(one.surface.size(), other.surface.size());
    for (std::size_t t = 0; t < one.surface.size(); ++t) {
      EXPECT_EQ(one.surface[t].nodes, other.surface[t].nodes);
      EXPECT_EQ(one.surface[t].joint, other.surface[t].joint);
    }
  }
}

TEST(KeptMeshes, ServeTheBlocksThatStayAsTheyAre) {
  KeptMeshes kept;
  Project p = cut_cube();
  const BlockSystem first = build_with(kept, p);
  ASSERT_EQ(first.blocks.size(), 9u);
  EXPECT_EQ(kept.taken_over(), 0);
  p.joints[0].friction_angle = 17;  // changes no mesh
  expect_the_same(build_with(kept, p), first);
  EXPECT_EQ(kept.taken_over(), 9);

  p.solids[1].mesh_size = 1;
  expect_the_same(build_with(kept, p), build(p));
  EXPECT_EQ(kept.taken_over(), 8) << "all but the slab";

  p.mesh.refinements = {{Vec3(10, 10, 10), 0.5, 0.3}};
  expect_the_same(build_with(kept, p), build(p));
  EXPECT_EQ(kept.taken_over(), 8) << "all but the one that the refinement reaches";

  p.cuts[0].through.z() = 4.5;
  expect_the_same(build_with(kept, p), build(p));
  EXPECT_EQ(kept.taken_over(), 1) << "a cut that moves leaves the slab";
}

TEST(KeptMeshes, ServeTheNeighboursOfABlockThatGetsItsOwnSize) {
  KeptMeshes kept;
  Project p = cut_cube();
  ASSERT_EQ(build_with(kept, p).blocks.size(), 9u);
  p.blocks = {{"fine", {3, 2, 2}, {}, {}, 0.7}};
  expect_the_same(build_with(kept, p), build(p));
  EXPECT_EQ(kept.taken_over(), 8);
  p.blocks[0].mesh_size = 0.9;
  expect_the_same(build_with(kept, p), build(p));
  EXPECT_EQ(kept.taken_over(), 8);
  p.blocks.clear();
  expect_the_same(build_with(kept, p), build(p));
  EXPECT_EQ(kept.taken_over(), 8) << "it has its usual size again";
}

TEST(KeptMeshes, ServeAllBlocksUnderGroundButTheOneWhoseSizeIsAnother) {
  const auto folder = std::filesystem::temp_directory_path() / ("talus_kept_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  constexpr int points = 40;  // as many as are cut as cells
  {
    std::ofstream grid(folder / "land.asc");
    grid << "ncols " << points << "\nnrows " << points
         << "\nxllcorner 0\nyllcorner 0\ncellsize 0.5\nNODATA_value -9999\n";
    for (int row = 0; row < points; ++row)
      for (int column = 0; column < points; ++column)
        grid << 9 + std::sin(0.5 * row) + std::cos(0.4 * column) << (column == points - 1 ? "\n" : " ");
  }
  Project p = project();
  p.solids = {solid("hill", TerrainShape{"land.asc", 0, 0}, 2.0)};
  p.cuts = {cut("J1", 0, 0, {5, 5, 3}), cut("J2", 90, 90, {8, 5, 5})};
  KeptMeshes kept;
  NoProgress nobody;
  const BlockSystem first = build_blocks(p, folder, nobody, kept);
  ASSERT_EQ(first.blocks.size(), 4u);
  p.blocks = {{"fine", {4, 10, 1.5}, {}, {}, 0.8}};
  expect_the_same(build_blocks(p, folder, nobody, kept), build(p, folder));
  EXPECT_EQ(kept.taken_over(), 3);
  std::filesystem::remove_all(folder);
}

TEST(KeptMeshes, OfABuildThatIsCancelledAreThereForTheNext) {
  class UntilTheFifth final : public Progress {
   public:
    void report(double, std::string_view what) override { stop_ = stop_ || what.find("(5 of 9)") != what.npos; }
    bool cancelled() const override { return stop_; }

   private:
    bool stop_ = false;
  };
  KeptMeshes kept;
  UntilTheFifth impatient;
  EXPECT_THROW(build_blocks(cut_cube(), ".", impatient, kept), Cancelled);
  expect_the_same(build_with(kept, cut_cube()), build(cut_cube()));
  EXPECT_EQ(kept.taken_over(), 4);
}

}  // namespace
}  // namespace talus
