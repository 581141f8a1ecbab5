#include "base/one_line.hpp"

#include <gmock/gmock.h>

namespace talus {
namespace {

TEST(OneLine, IsTheMessageWhereThatIsOne) {
  EXPECT_EQ(one_line("a.talus: no joint; add one"), "a.talus: no joint; add one");
}

TEST(OneLine, HasNoControlCharacters) { EXPECT_EQ(one_line("a\nb\x1b[31m\x7f"), "a b [31m "); }

TEST(OneLine, KeepsTheBeginningAndTheEndOfALongOne) {
  const std::string line = one_line("begins " + std::string(100000, 'x') + " ends");
  EXPECT_EQ(line.size(), 480u);
  EXPECT_THAT(line, testing::StartsWith("begins xxx"));
  EXPECT_THAT(line, testing::EndsWith("xxx ends"));
}

TEST(OneLine, CutsNoCharacterInTwo) {
  for (std::size_t before = 0; before < 4; ++before) {
    std::string message(before, 'x');
    for (int i = 0; i < 300; ++i) message += "\U0001faa8";
    const std::string line = one_line(message);
    EXPECT_LE(line.size(), 480u);
    const std::size_t between = line.find(" … ");
    EXPECT_EQ((between - before) % 4, 0u);
    EXPECT_EQ((line.size() - between - std::string(" … ").size()) % 4, 0u);
  }
}

}  // namespace
}  // namespace talus
