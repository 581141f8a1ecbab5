#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "base/memory_limit.hpp"
#include "rock.hpp"

// What cutting comes to is foreseen, and refused before it is done.
namespace talus::rock {
namespace {

using testing::HasSubstr;

Project cube(BodyKind body) {
  Project p = project();
  p.solids = {box("b", {0, 0, 0}, {10, 10, 10})};
  p.solids[0].body = body;
  return p;
}

std::vector<Cut> cuts_by_chance(int count, unsigned seed) {
  std::mt19937 chance(seed);
  const auto up_to = [&](double most) { return most * static_cast<double>(chance()) / 4294967296.0; };
  std::vector<Cut> cuts;
  for (int i = 0; i < count; ++i) {
    const double dip = up_to(90), direction = up_to(360);
    cuts.push_back(cut("J1", dip, direction, {up_to(10), up_to(10), up_to(10)}));
  }
  return cuts;
}

std::string refusal(const Project& p) {
  NoProgress nobody;
  try {
    cut_blocks(p, ".", nobody);
    return "none";
  } catch (const InputError& error) {
    return error.what();
  }
}

std::string refusal_of_more_than_one_tetrahedron(Project p) {
  p.mesh.most_tetrahedra = 1;
  return refusal(p);
}

TEST(CutEstimate, CountsTheBlocksOfAGrid) {
  Project p = cube(BodyKind::rigid);
  p.cuts = {joint_set("J1", 0, 0, {5, 5, 2}, 2, 4), joint_set("J2", 90, 0, {5, 2, 5}, 2, 4),
            joint_set("J3", 90, 90, {2, 5, 5}, 2, 4)};
  EXPECT_THAT(refusal_of_more_than_one_tetrahedron(p), HasSubstr("/cuts: they would make about 130 blocks, "));  // 5³
}

TEST(CutEstimate, CountsTheBlocksOfPlanesByChance) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    Project p = cube(BodyKind::rigid);
    p.cuts = cuts_by_chance(15, seed);
    NoProgress nobody;
    const BlockSystem system = cut_blocks(p, ".", nobody);
    const auto blocks = static_cast<double>(system.blocks.size() + system.splinters.size());
    ASSERT_GT(blocks, 100);
    const double digit = 10;
    EXPECT_THAT(refusal_of_more_than_one_tetrahedron(p),
                HasSubstr("about " + std::to_string(std::lround(digit * std::round(blocks / digit))) + " blocks"))
        << seed;
  }
}

TEST(CutEstimate, JointsThatEndCountWhereTheyMeet) {
  Project p = cube(BodyKind::rigid);
  p.cuts = {cut("J1", 0, 0, {5, 5, 5}), cut("J2", 90, 0, {5, 5, 5})};
  EXPECT_THAT(refusal_of_more_than_one_tetrahedron(p), HasSubstr("about 4 blocks"));
  p.cuts[0].disc = Disc{{2, 2, 5}, 1};
  EXPECT_THAT(refusal_of_more_than_one_tetrahedron(p), HasSubstr("about 3 blocks"));
}

TEST(CutEstimate, OfMoreBlocksThanAnyMeshHoldsIsRefusedAtOnce) {
  // To try it takes hours and all memory.
  for (const BodyKind body : {BodyKind::rigid, BodyKind::tetrahedra}) {
    Project p = cube(body);
    p.cuts = cuts_by_chance(1000, 1);
    EXPECT_THAT(refusal(p), HasSubstr(" blocks, which no mesh of 5e6 tetrahedra holds; take fewer or shorter cuts"));
  }
}

TEST(CutEstimate, OfMoreMemoryThanThereIsIsRefused) {
  Project p = cube(BodyKind::tetrahedra);
  p.cuts = cuts_by_chance(60, 1);
  set_memory_limit(1e8);
  EXPECT_THAT(refusal(p), HasSubstr("/cuts: cutting about "));
  p.cuts.clear();
  p.solids[0].mesh_size = 0.3;
  EXPECT_EQ(refusal(p), "none");
  NoProgress nobody;
  EXPECT_THROW(build_blocks(p, ".", nobody), InputError) << "of some 160 000 tetrahedra";
  set_memory_limit(HUGE_VAL);
}

}  // namespace
}  // namespace talus::rock
