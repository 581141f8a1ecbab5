#include "contact/narrow/feature_shapes.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "contact/broad/odometers.hpp"
#include "unit/contact/blocks.hpp"

namespace talus {
namespace {

/// A cube of 1 m, its faces cut into two triangles each.
class OfACube : public ::testing::Test {
 protected:
  OfACube() {
    scene_.add(testing::box({0, 0, 0}, {1, 1, 1}));
    features_.emplace(scene_.bodies());
    shapes_.emplace(*features_, odometers_, tolerances_);
    shapes_->look(scene_.x);
  }
  void turn_by_a_quarter() {
    for (Vec3& p : scene_.x) p = Vec3(-p.y(), p.x(), p.z());
    odometers_.add(0, 2);
    shapes_->look(scene_.x);
  }
  int edge(bool sharp) const {
    int number = 0;
    while (features_->edges[number].is_sharp != sharp) ++number;
    return number;
  }

  testing::Scene scene_;
  Odometers odometers_{1};
  ContactTolerances tolerances_;
  std::optional<ContactFeatures> features_;
  std::optional<FeatureShapes> shapes_;
};

TEST_F(OfACube, NormalsPointOutwardsAndTurnWithTheBody) {
  for (int turns = 0; turns < 2; ++turns) {
    for (int f = 0; f < 12; ++f) {
      Vec3 centre = Vec3::Zero();
      for (const int node : features_->facets[f].nodes) centre += scene_.x[node] / 3;
      const Vec3 outwards = centre - (turns ? Vec3(-0.5, 0.5, 0.5) : Vec3(0.5, 0.5, 0.5));
      EXPECT_NEAR(shapes_->normal(f).dot(outwards), 0.5, 1e-12);
    }
    turn_by_a_quarter();
  }
}

TEST_F(OfACube, TheCoreOfACornerIsAsFarFromAllItsFaces) {
  for (int node = 0; node < 8; ++node) {
    const Vec3 inwards = shapes_->towards_core(node), to_centre = Vec3(0.5, 0.5, 0.5) - scene_.x[node];
    EXPECT_LT((inwards - 2 * to_centre).norm(), 1e-6) << inwards.transpose();
  }
}

TEST_F(OfACube, OnlyEdgesOfTheShapeAreClearlyConvex) {
  EXPECT_TRUE(shapes_->edge(edge(true)).is_convex);
  EXPECT_TRUE(shapes_->edge(edge(true)).is_clearly_convex);
  EXPECT_FALSE(shapes_->edge(edge(false)).is_clearly_convex);
}

TEST_F(OfACube, BesideAnEdgeAFacetLiesSquareToIt) {
  const int number = edge(true);
  const ContactEdge& e = features_->edges[number];
  const auto& into = shapes_->edge(number).into;
  EXPECT_NEAR(into[0].dot(into[1]), 0, 1e-12);
  for (const Vec3& v : into) {
    EXPECT_NEAR(v.norm(), 1, 1e-12);
    EXPECT_NEAR(v.dot(scene_.x[e.nodes[1]] - scene_.x[e.nodes[0]]), 0, 1e-12);
    EXPECT_GT(v.dot(Vec3(0.5, 0.5, 0.5) - scene_.x[e.nodes[0]]), 0);
  }
}

TEST_F(OfACube, WhatDidNotMoveIsNotMeasuredAgain) {
  const Vec3 before = shapes_->normal(0);
  for (Vec3& p : scene_.x) p = Vec3(-p.y(), p.x(), p.z());
  shapes_->look(scene_.x);
  EXPECT_EQ(shapes_->normal(0), before);  // nobody has told of the motion
  odometers_.add(0, 2);
  shapes_->look(scene_.x);
  EXPECT_NE(shapes_->normal(0), before);
}

}  // namespace
}  // namespace talus
