#include "model/suggestion.hpp"

#include <gtest/gtest.h>

namespace talus {
namespace {

const std::vector<std::string> keys{"density", "young", "poisson"};

TEST(Suggestion, FindsWhatWasMeant) {
  EXPECT_EQ(nearest_name("densty", keys), "density");
  EXPECT_EQ(nearest_name("Young", keys), "young");
  EXPECT_EQ(nearest_name("posison", keys), "poisson");  // two letters swapped and one moved
  EXPECT_EQ(nearest_name("yuong", keys), "young");
}

TEST(Suggestion, DoesNotGuessWhenNothingIsNear) {
  EXPECT_EQ(nearest_name("colour", keys), "");
  EXPECT_EQ(nearest_name("J7", {"A", "B"}), "");
  EXPECT_EQ(nearest_name("", keys), "");
  EXPECT_EQ(nearest_name(std::string(100000, 'x'), keys), "");
}

TEST(Suggestion, WordsTheRemedy) {
  EXPECT_EQ(suggest_name("densty", keys), "did you mean 'density'?");
  EXPECT_EQ(suggest_name("colour", keys), "use one of density, young, poisson");
  EXPECT_EQ(suggest_name("colour", {}), "");
}

}  // namespace
}  // namespace talus
