#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdio>

#include "geometry/mesh_estimate.hpp"
#include "geometry/waiting_mesher.hpp"
#include "rock.hpp"
#include "support/in_a_child.hpp"

// What the mesher holds at most, told before it is asked.
namespace talus {
namespace {

using namespace rock;

/// Bytes that the mesher held at most. A child of the test starts it: its count is of that mesher alone.
double bytes_held(const Project& project) {
  return test::in_a_child([&] {
    build(project);
    end_waiting_mesher();
    rusage mesher{};
    getrusage(RUSAGE_CHILDREN, &mesher);
    return 1024.0 * static_cast<double>(mesher.ru_maxrss);
  });
}

Project cut_cube(BodyKind body, double spacing, std::optional<double> size) {
  Project p = project();
  p.solids = {box("cube", {0, 0, 0}, {10, 10, 10}, size)};
  p.solids[0].body = body;
  const int count = std::max(1, static_cast<int>(10 / spacing));
  p.splinters.rule = SplinterRule::merge;
  p.cuts = {joint_set("J1", 35, 90, {5, 5, 1}, spacing, count), joint_set("J2", 70, 200, {5, 1, 5}, spacing, count),
            joint_set("J3", 80, 300, {2, 5, 5}, spacing, count)};
  return p;
}

Project crowd(int side) {
  Project p = project();
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j)
      for (int k = 0; k < side; ++k) {
        const Vec3 low(i, j, k);
        p.solids.push_back(box("c" + std::to_string(p.solids.size()), low, low + Vec3::Ones()));
        p.solids.back().body = BodyKind::rigid;
      }
  return p;
}

void expect_told_ahead(const char* what, const Project& p) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers hold memory of their own";
#endif
  constexpr double within = 1.5;
  NoProgress nobody;
  const BlockSystem cut = cut_blocks(p, ".", nobody);
  const double told = mesh_estimate(p, cut).bytes, held = bytes_held(p);
  std::printf("%s, %zu blocks: %.0f MB told, %.0f MB held\n", what, cut.blocks.size(), told / 1e6, held / 1e6);
  EXPECT_LT(held, within * told) << what;
  EXPECT_GT(held, told / within) << what;
}

TEST(MesherMemory, IsToldForOneBlock) {
  expect_told_ahead("a cube of 10 edges", cut_cube(BodyKind::tetrahedra, 20, 1));
  expect_told_ahead("a cube of 33 edges", cut_cube(BodyKind::tetrahedra, 20, 0.3));
}

TEST(MesherMemory, IsToldForManyMeshedBlocks) {
  expect_told_ahead("coarse blocks", cut_cube(BodyKind::tetrahedra, 1.5, 2));
  expect_told_ahead("many blocks", cut_cube(BodyKind::tetrahedra, 0.8, 2));
  expect_told_ahead("fine blocks", cut_cube(BodyKind::tetrahedra, 2.5, 0.4));
}

TEST(MesherMemory, IsToldForBlocksThatStandOnTheirCorners) {
  expect_told_ahead("a cut cube", cut_cube(BodyKind::rigid, 0.6, {}));
  expect_told_ahead("a crowd", crowd(12));
}

}  // namespace
}  // namespace talus
