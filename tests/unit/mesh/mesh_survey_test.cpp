#include "mesh/mesh_survey.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "support/small_scenes.hpp"

namespace talus {
namespace {

/// A regular tetrahedron, the corner of a cube, and one that is nearly flat.
BlockSystem three_tetrahedra() {
  Block sound, flat;
  sound.mesh = {{Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1), Vec3(5, 0, 0), Vec3(6, 0, 0),
                 Vec3(5, 1, 0), Vec3(5, 0, 1)},
                {{0, 2, 1, 3}, {4, 5, 6, 7}}};
  flat.mesh = {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0.3, 0.3, 1e-4)}, {{0, 1, 2, 3}}};
  return {.blocks = {sound, flat}, .joint_names = {}};
}

long sum(const Histogram& histogram) { return std::accumulate(histogram.counts.begin(), histogram.counts.end(), 0L); }

TEST(MeshSurvey, PutsKnownTetrahedraIntoTheirBins) {
  NoProgress nobody;
  const MeshSurvey survey = survey_mesh(three_tetrahedra(), nobody);
  EXPECT_EQ(survey.quality.counts.back(), 1) << "the regular one, of quality 1";
  EXPECT_EQ(survey.quality.counts[14], 1) << "the cube's corner: √3 − 1 = 0.732";
  EXPECT_EQ(survey.quality.counts.front(), 1);
  EXPECT_EQ(survey.dihedral.counts[14], 1) << "70.53°";
  EXPECT_EQ(survey.dihedral.counts[10], 1) << "54.74°";
  EXPECT_EQ(survey.dihedral.counts.front(), 1);
  EXPECT_EQ(sum(survey.quality), 3);
  EXPECT_EQ(sum(survey.dihedral), 3);
}

TEST(MeshSurvey, TellsTheWorstFirstAndWhereTheyAre) {
  NoProgress nobody;
  const MeshSurvey survey = survey_mesh(three_tetrahedra(), nobody, 2);
  ASSERT_EQ(survey.worst.size(), 2u);
  EXPECT_EQ(survey.worst[0].block, 1);
  EXPECT_LT(survey.worst[0].quality, 1e-3);
  EXPECT_TRUE(survey.worst[0].centre.isApprox(Vec3(1.3, 1.3, 1e-4) / 4, 1e-12));
  EXPECT_EQ(survey.worst[1].tetrahedron, 1);
  EXPECT_NEAR(survey.worst[1].quality, std::sqrt(3) - 1, 1e-14);
}

TEST(MeshSurvey, OfABlockIsItsMeshQuality) {
  const BlockSystem system = three_tetrahedra();
  NoProgress nobody;
  const MeshSurvey survey = survey_mesh(system, nobody);
  for (std::size_t b = 0; b < 2; ++b) {
    const MeshQuality alone = mesh_quality(system.blocks[b].mesh);
    EXPECT_DOUBLE_EQ(survey.blocks[b]->worst, alone.worst);
    EXPECT_DOUBLE_EQ(survey.blocks[b]->mean, alone.mean);
    EXPECT_DOUBLE_EQ(survey.blocks[b]->smallest_dihedral, alone.smallest_dihedral);
    EXPECT_DOUBLE_EQ(survey.blocks[b]->largest_dihedral, alone.largest_dihedral);
  }
}

TEST(MeshSurvey, LeavesBlocksOutThatStandOnTheirCorners) {
  BlockSystem system = three_tetrahedra();
  system.blocks[1].stands_on_corners = true;
  NoProgress nobody;
  const MeshSurvey survey = survey_mesh(system, nobody);
  ASSERT_EQ(survey.blocks.size(), 2u);
  EXPECT_FALSE(survey.blocks[1]);
  EXPECT_EQ(sum(survey.quality), 2);
  EXPECT_EQ(sum(survey.dihedral), 2);
  EXPECT_EQ(survey.worst.size(), 2u);
  for (const PoorTetrahedron& one : survey.worst) EXPECT_EQ(one.block, 0);
}

TEST(Histogram, HasBinsThatAreClosedBelowAndTheLastOneOnBothSides) {
  const Histogram tenths{0, 1, std::vector<long>(10)};
  EXPECT_EQ(tenths.bin_of(0), 0u);
  EXPECT_EQ(tenths.bin_of(0.25), 2u);
  EXPECT_EQ(tenths.bin_of(0.5), 5u);
  EXPECT_EQ(tenths.bin_of(0.4999), 4u);
  EXPECT_EQ(tenths.bin_of(1), 9u);
  EXPECT_EQ(tenths.bin_of(-3), 0u);
  EXPECT_EQ(tenths.bin_of(3), 9u);
}

}  // namespace
}  // namespace talus
