#include "verification/known_answers/support/ledger_watch.hpp"

#include <gtest/gtest.h>

#include "verification/known_answers/support/scene.hpp"

namespace talus {
namespace {

/// What a step leaves in the ledger when so much was dissipated and eaten in all, of a fall of 100 J.
EnergyLedger after(double friction, double damping, double loss) {
  EnergyLedger ledger;
  ledger.potential = -100;
  ledger.friction_dissipated = friction;
  ledger.damping_dissipated = damping;
  ledger.integration_loss = loss;
  ledger.kinetic = 100 - friction - damping - loss;
  return ledger;
}

TEST(LedgerWatch, WhatDissipatesMayOnlyBecomeMore) {
  LedgerWatch watch{CaseScene{}};
  watch.look(after(1, 0, 2));
  watch.look(after(2, 1, 0.5));  // one account gives to the others
  EXPECT_EQ(watch.growth(), 0);
  watch.look(after(2, 1, 0.25));
  watch.look(after(2, 1, 0.3));
  EXPECT_DOUBLE_EQ(watch.growth(), 0.25);
  EXPECT_EQ(watch.moved(), 100);
  EXPECT_TRUE(watch.grows(2e-3));
  EXPECT_FALSE(watch.grows(3e-3));
}

TEST(LedgerWatch, GrowthInTheFirstStepIsSeen) {
  LedgerWatch watch{CaseScene{}};
  watch.look(after(0, 0, -1));
  EXPECT_DOUBLE_EQ(watch.growth(), 1);
}

TEST(LedgerWatch, WhatHeldBlocksTakeWithThemIsNoGrowth) {
  LedgerWatch watch{CaseScene{}};
  watch.look(after(0, 0, 5));
  watch.holds_change();
  watch.look(after(0, 0, 1));
  EXPECT_EQ(watch.growth(), 0);
  watch.look(after(0, 0, 0.5));
  EXPECT_DOUBLE_EQ(watch.growth(), 0.5);
}

TEST(LedgerWatch, ClosesWithinAShareOfWhatMovedOrTheRoundingOfPositions) {
  LedgerWatch still{CaseScene{}};
  EnergyLedger ledger = after(0, 0, 0);
  ledger.remainder = 0.9e-6;
  still.look(ledger);
  EXPECT_TRUE(still.closes());
  ledger.remainder = -1.1e-6;
  still.look(ledger);
  EXPECT_FALSE(still.closes());

  // A cube of 2600 kg, 1000 km away: 25.5 kN × 1e6 m × 2.2e-16 = 5.7e-6 J a step.
  CaseScene far = rock_scene(30);
  far.add_box("block", Vec3(1e6, 0, 0), Vec3(1e6 + 1, 1, 1));
  far.system.blocks[0].volume = 1;
  LedgerWatch rounding(far);
  rounding.look(ledger);
  EXPECT_TRUE(rounding.closes());
  ledger.remainder = 6e-6;
  rounding.look(ledger);
  EXPECT_TRUE(rounding.closes()) << "two steps may round twice";
  LedgerWatch once(far);
  once.look(ledger);
  EXPECT_FALSE(once.closes());
}

}  // namespace
}  // namespace talus
