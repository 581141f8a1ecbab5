#include "results/field.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "base/error.hpp"

namespace talus {
namespace {

Voigt stress(double xx, double yy, double zz, double xy, double yz, double zx) {
  Voigt s;
  s << xx, yy, zz, xy, yz, zx;
  return s;
}

double single(const Voigt& s, std::string_view name) {
  Frame frame;
  frame.stress = {s};
  return values(frame, field_named(name)).at(0);
}

TEST(Field, VonMisesOfKnownStates) {
  EXPECT_DOUBLE_EQ(von_mises(stress(5e6, 0, 0, 0, 0, 0)), 5e6);
  EXPECT_DOUBLE_EQ(von_mises(stress(7, 7, 7, 0, 0, 0)), 0);
  EXPECT_DOUBLE_EQ(von_mises(stress(0, 0, 0, 0, 2, 0)), 2 * std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(von_mises(stress(0, 0, 0, 2, 0, 0)), 2 * std::sqrt(3.0));
}

TEST(Field, PrincipalStressesOfPlaneShearArePlusAndMinusTau) {
  for (const Voigt& s : {stress(1, 1, 1, 3, 0, 0), stress(1, 1, 1, 0, 3, 0), stress(1, 1, 1, 0, 0, 3)}) {
    const Vec3 principal = principal_stresses(s);
    EXPECT_NEAR(principal[0], 4, 1e-14);
    EXPECT_NEAR(principal[1], 1, 1e-14);
    EXPECT_NEAR(principal[2], -2, 1e-14);
  }
}

TEST(Field, PrincipalAxesMakeTheTensorAgain) {
  const Voigt s = stress(-3, 2, 5, 1.5, -0.5, 4);
  const PrincipalAxes axes = principal_axes(s);
  EXPECT_LT((axes.values - principal_stresses(s)).norm(), 1e-12);
  const Mat3 tensor = axes.directions * axes.values.asDiagonal() * axes.directions.transpose();
  EXPECT_NEAR(tensor(0, 0), -3, 1e-12);
  EXPECT_NEAR(tensor(1, 1), 2, 1e-12);
  EXPECT_NEAR(tensor(0, 1), 1.5, 1e-12);
  EXPECT_NEAR(tensor(1, 2), -0.5, 1e-12);
  EXPECT_NEAR(tensor(0, 2), 4, 1e-12);
}

TEST(Field, PrincipalStressesKeepTheThreeInvariants) {
  const Voigt s = stress(-3, 2, 5, 1.5, -0.5, 4);
  const Vec3 p = principal_stresses(s);
  EXPECT_NEAR(p.sum(), 4, 1e-13);
  EXPECT_NEAR(p[0] * p[1] + p[1] * p[2] + p[2] * p[0], -6 + 10 - 15 - 2.25 - 0.25 - 16, 1e-12);
  EXPECT_NEAR(p.prod(), -30 + 2 * 1.5 * -0.5 * 4 - (-3 * 0.25) - 2 * 16 - 5 * 2.25, 1e-12);
  EXPECT_GT(p[0], p[1]);
  EXPECT_GT(p[1], p[2]);
}

TEST(Field, StressFieldsByName) {
  const Voigt s = stress(1, 1, 1, 3, 0, 0);
  EXPECT_NEAR(single(s, "stress"), 3 * std::sqrt(3.0), 1e-14);
  EXPECT_NEAR(single(s, "stress.von_mises"), 3 * std::sqrt(3.0), 1e-14);
  EXPECT_NEAR(single(s, "stress.max_principal"), 4, 1e-14);
  EXPECT_NEAR(single(s, "stress.min_principal"), -2, 1e-14);
  EXPECT_NEAR(single(s, "stress.max_shear"), 3, 1e-14);
  EXPECT_DOUBLE_EQ(single(s, "stress.mean"), 1);
  const Voigt numbered = stress(1, 2, 3, 4, 5, 6);
  const char* names[] = {"stress.xx", "stress.yy", "stress.zz", "stress.xy", "stress.yz", "stress.zx"};
  for (int i = 0; i < 6; ++i) EXPECT_DOUBLE_EQ(single(numbered, names[i]), i + 1);
}

TEST(Field, NodalFieldsByName) {
  Frame frame;
  frame.displacement = {Vec3(3, 4, 12), Vec3(0, 0, -2)};
  frame.velocity = {Vec3(1, 2, 2), Vec3(0, -7, 0)};
  EXPECT_THAT(values(frame, field_named("displacement")), testing::ElementsAre(13, 2));
  EXPECT_THAT(values(frame, field_named("displacement.z")), testing::ElementsAre(12, -2));
  EXPECT_THAT(values(frame, field_named("velocity")), testing::ElementsAre(3, 7));
  EXPECT_THAT(values(frame, field_named("velocity.y")), testing::ElementsAre(2, -7));
  EXPECT_EQ(field_named("velocity.y").unit, "m/s");
  EXPECT_EQ(field_named("velocity.y").place(), FieldPlace::node);
  EXPECT_EQ(field_named("stress").place(), FieldPlace::tetrahedron);
}

TEST(Field, AnUnknownNameIsAnErrorThatListsTheKnown) {
  try {
    field_named("temperature");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.place(), "field temperature");
    EXPECT_THAT(error.remedy(), testing::HasSubstr("displacement.x"));
    EXPECT_THAT(error.remedy(), testing::HasSubstr("stress.von_mises"));
  }
}

}  // namespace
}  // namespace talus
