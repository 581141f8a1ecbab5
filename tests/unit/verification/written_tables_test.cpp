#include "support/written_tables.hpp"

#include <gtest/gtest.h>

namespace talus::test {
namespace {

TEST(WrittenTables, SayTheSameUpToOneInTheLastDigit) {
  EXPECT_TRUE(same_line("| a | 2.3e-05 | 0.0297 |", "| a | 2.4e-05 | 0.0298 |"));
  EXPECT_FALSE(same_line("| a | 2.3e-05 | 0.0297 |", "| a | 2.5e-05 | 0.0297 |"));
  EXPECT_FALSE(same_line("| a | 2.3e-05 |", "| a | -2.3e-05 |"));
}

TEST(WrittenTables, LetRoundingNoiseBeAnything) {
  EXPECT_TRUE(same_line("| a | 5.1e-11 |", "| a | 2.6e-16 |"));
  EXPECT_FALSE(same_line("| a | 5.1e-11 |", "| a | 2.6e-07 |"));
}

TEST(WrittenTables, HaveTheSameWordsAndCounts) {
  EXPECT_FALSE(same_line("| cube_2 | 31 |", "| cube_3 | 31 |"));
  EXPECT_FALSE(same_line("| cube_2 | 31 |", "| cube_2 | 32 |"));
  EXPECT_FALSE(same_line("| cube_2 | 0.5 | yes |", "| cube_2 | 0.5 | NO |"));
  EXPECT_FALSE(same_line("| cube_2 | 0.5 |", "| cube_2 | 0.5 | 0.5 |"));
}

TEST(WrittenTables, NameTheFirstLineThatDiffers) {
  EXPECT_EQ(difference("a\nb 1.5\n", "a\nb 1.6\n"), "");
  EXPECT_EQ(difference("a\nb\n", "a\nc\n"), "written:\n  b\nnow:\n  c\n");
  EXPECT_EQ(difference("", "a\n"), "written:\n  nothing\nnow:\n  a\n");
}

}  // namespace
}  // namespace talus::test
