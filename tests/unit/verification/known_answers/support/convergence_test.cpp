#include "verification/known_answers/support/convergence.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace talus;

namespace {

double midpoint_rule(int parts) {  // of ∫ eˣ over 0…1
  double sum = 0;
  for (int i = 0; i < parts; ++i) sum += std::exp((i + 0.5) / parts) / parts;
  return sum;
}

}  // namespace

TEST(Convergence, FindsTheOrderAndLimitOfTheMidpointRule) {
  const double exact = std::exp(1.0) - 1, coarse = midpoint_rule(16), fine = midpoint_rule(32);
  EXPECT_NEAR(observed_order(coarse - exact, fine - exact), 2, 1e-3);
  EXPECT_NEAR(richardson_limit(coarse, fine, 2), exact, 1e-8);
}

TEST(Convergence, TellsTheOrderFromTheSecondRowOn) {
  const CaseTable table = convergence_table("beam", "cells", "deflection [m]", {{"2", 0.5, 0.4}, {"4", 0.8, 0.1}});
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.rows[0].back(), "");
  EXPECT_EQ(table.rows[1].back(), "2");
}
