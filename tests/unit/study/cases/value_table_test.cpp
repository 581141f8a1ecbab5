#include "study/cases/value_table.hpp"

#include <gmock/gmock.h>

#include "base/error.hpp"

namespace talus {
namespace {

using testing::ElementsAre;

std::string table_refusal(const std::string& text) {
  try {
    read_value_table(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(ValueTable, HasARowACaseAndAColumnAPlace) {
  const ValueTable table = read_value_table(
      "case,/joints/J1/friction_angle,/solids/0/body,/gravity\n"
      "dry,30,rigid,\"[0, 0, -1.62]\"\n"
      "# not a case\n"
      "own,,,\n");
  EXPECT_THAT(table.columns, ElementsAre("/joints/J1/friction_angle", "/solids/0/body", "/gravity"));
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.rows[0].name, "dry");
  EXPECT_EQ(table.rows[0].line, 2);
  EXPECT_THAT(table.rows[0].values, ElementsAre("30", "\"rigid\"", "[0, 0, -1.62]"));
  EXPECT_EQ(table.rows[1].line, 4);
  EXPECT_THAT(table.rows[1].values, ElementsAre("", "", ""));
}

TEST(ValueTable, WithoutNamesNumbersItsCases) {
  const ValueTable table = read_value_table("/joints/J1/friction_angle\n30\n25.5\n");
  EXPECT_EQ(table.rows[1].name, "2");
  EXPECT_EQ(table.rows[1].values[0], "25.5");
}

TEST(ValueTable, TakesDecimalCommasAndDegreesBetweenSemicolons) {
  const ValueTable table = read_value_table("case;/joints/J1/friction_angle;/a\na;28,5°;1e-3\n");
  EXPECT_THAT(table.rows[0].values, ElementsAre("28.5", "0.001"));
}

TEST(ValueTable, CellsComeBackAsTheyWere) {
  EXPECT_EQ(value_as_cell("\"rigid\""), "rigid");
  EXPECT_EQ(value_as_cell("[1, 2]"), "[1, 2]");
  EXPECT_EQ(value_as_cell(""), "");
}

TEST(ValueTable, SaysLineAndColumnOfWhatIsWrong) {
  EXPECT_THAT(table_refusal("case,/a\n\xB7,1\n"), testing::StartsWith("the table: is no UTF-8 text"));
  EXPECT_THAT(table_refusal(""), testing::HasSubstr("has no case"));
  EXPECT_THAT(table_refusal("case\na\n"), testing::StartsWith("line 1: the table changes nothing"));
  EXPECT_THAT(table_refusal("friction\n30\n"), testing::StartsWith("line 1, column friction: is no place"));
  EXPECT_THAT(table_refusal("/a,/a\n1,2\n"), testing::StartsWith("line 1, column /a: is there twice"));
  EXPECT_THAT(table_refusal("case,/a\nx,1\nx,2\n"), testing::StartsWith("line 3, column case: another case"));
  EXPECT_THAT(table_refusal("/a\n1,2\n"), testing::StartsWith("line 2: has 2 cells, the header 1"));
}

}  // namespace
}  // namespace talus
