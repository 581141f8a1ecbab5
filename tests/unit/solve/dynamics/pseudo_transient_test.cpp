#include "solve/dynamics/pseudo_transient.hpp"

#include <gmock/gmock.h>

namespace talus {
namespace {

TEST(PseudoTransientContinuation, FadesWithTheResidualToThePowerOfThreeHalves) {
  PseudoTransientContinuation pseudo_transient;
  pseudo_transient.accept(1e-3, 1e-2);
  EXPECT_DOUBLE_EQ(pseudo_transient.inertia_fraction(), 1);
  pseudo_transient.accept(1e-6, 1e-2 / 16);
  EXPECT_DOUBLE_EQ(pseudo_transient.inertia_fraction(), 1.0 / 64);
  pseudo_transient.accept(1e-6, 1e-2 / 17);  // the power of two that is not less
  EXPECT_DOUBLE_EQ(pseudo_transient.inertia_fraction(), 1.0 / 64);
  pseudo_transient.accept(1e-9, 1e-9);
  EXPECT_DOUBLE_EQ(pseudo_transient.inertia_fraction(), 0x1p-20);
}

TEST(PseudoTransientContinuation, KeepsOrRestoresInertiaWhereTheResidualStays) {
  PseudoTransientContinuation pseudo_transient;
  for (const double static_residual : {1e-2, 1e-2, 3e-2, 3e-2}) pseudo_transient.accept(1e-3, static_residual);
  EXPECT_DOUBLE_EQ(pseudo_transient.inertia_fraction(), 1);
  pseudo_transient.accept(1e-6, 3e-2 / 16);
  EXPECT_DOUBLE_EQ(pseudo_transient.inertia_fraction(), 0x1p-6);
  pseudo_transient.accept(1e-6, 0.9999 * 3e-2 / 16);
  EXPECT_DOUBLE_EQ(pseudo_transient.inertia_fraction(), 0x1p-4);
  for (int k = 0; k < 2; ++k) pseudo_transient.accept(1e-6, 3e-2 / 16);
  EXPECT_DOUBLE_EQ(pseudo_transient.inertia_fraction(), 1);
}

TEST(PseudoTransientContinuation, IgnoresRounding) {
  PseudoTransientContinuation pseudo_transient;
  pseudo_transient.accept(1e-3, 1e-2);
  pseudo_transient.accept(1e-6, 1e-2 / 16);
  pseudo_transient.accept(1e-16, 1e-12);
  EXPECT_DOUBLE_EQ(pseudo_transient.inertia_fraction(), 1.0 / 64);
}

TEST(PseudoTransientContinuation, LeadsNoFartherThanTwiceAStepWithFullInertia) {
  PseudoTransientContinuation pseudo_transient;
  pseudo_transient.accept(1e-3, 1e-2);
  pseudo_transient.accept(0.9e-3, 1e-2 / 0x1p8);
  EXPECT_DOUBLE_EQ(pseudo_transient.inertia_fraction(), 0.5) << "0.9e-3 m, twice";
  EXPECT_FALSE(pseudo_transient.needs_retry(true, 1.9e-3));
  EXPECT_TRUE(pseudo_transient.needs_retry(true, 2.1e-3));
  pseudo_transient.restore_inertia(true, 2.1e-3);
  EXPECT_DOUBLE_EQ(pseudo_transient.inertia_fraction(), 1);
  EXPECT_FALSE(pseudo_transient.needs_retry(true, 1)) << "it had full inertia";
}

TEST(PseudoTransientContinuation, RestoresAsMuchInertiaAsAStepLedTooFar) {
  PseudoTransientContinuation pseudo_transient;
  pseudo_transient.accept(1e-3, 1e-2);
  pseudo_transient.accept(1e-6, 1e-2 / 0x1p6);
  EXPECT_DOUBLE_EQ(pseudo_transient.inertia_fraction(), 0x1p-9);
  pseudo_transient.restore_inertia(true, 0.02);
  EXPECT_DOUBLE_EQ(pseudo_transient.inertia_fraction(), 0x1p-5) << "ten times too far: the next power of two";
  EXPECT_TRUE(pseudo_transient.needs_retry(false, 0)) << "did not converge";
  pseudo_transient.restore_inertia(false, 0);
  EXPECT_DOUBLE_EQ(pseudo_transient.inertia_fraction(), 1);
}

}  // namespace
}  // namespace talus
