#include "orientation/joint_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "orientation/text_cells.hpp"

namespace talus {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// What a sound table says.
std::vector<MeasuredJoint> joints_in(const std::string& text) { return sound_joints(read_joint_table(text)); }

std::string complaint_about(const std::string& text) {
  try {
    joints_in(text);
  } catch (const InputError& error) {
    return error.place() + ": " + error.problem();
  }
  return "none";
}

TEST(JointTable, IsReadWithAHeaderInAnyOrder) {
  const auto joints = joints_in(
      "Set, Dip Direction (deg), Dip [°], X, Y, Z, Spacing (cm), Persistence\n"
      "J1, 120, 45.5, 1, 2, -3, 250, 12\n"
      "\"J 2\", 300, 80,,,,,\n");
  ASSERT_EQ(joints.size(), 2u);
  EXPECT_EQ(joints[0], (MeasuredJoint{{45.5, 120}, "J1", Vec3(1, 2, -3), 2.5, 12}));
  EXPECT_EQ(joints[1], (MeasuredJoint{{80, 300}, "J 2"}));
}

TEST(JointTable, IsReadWithoutAHeader) {
  EXPECT_THAT(joints_in("45,120,J1\n80,300,J2\n"),
              ElementsAre(MeasuredJoint{{45, 120}, "J1"}, MeasuredJoint{{80, 300}, "J2"}));
  EXPECT_THAT(joints_in("J1 45 120 10 20 30"), ElementsAre(MeasuredJoint{{45, 120}, "J1", Vec3(10, 20, 30)}));
}

TEST(JointTable, OfASpreadsheetHasTabsAndDecimalCommas) {
  EXPECT_THAT(joints_in("Dip\tDip dir\tSet\r\n45,5°\t120,25°\tA\r\n\t\t\r\n"),
              ElementsAre(MeasuredJoint{{45.5, 120.25}, "A"}));
  EXPECT_THAT(joints_in("45,5;120,25;A"), ElementsAre(MeasuredJoint{{45.5, 120.25}, "A"}));
  EXPECT_THAT(joints_in("45,5 120,25 A\n40 110 A"),
              ElementsAre(MeasuredJoint{{45.5, 120.25}, "A"}, MeasuredJoint{{40, 110}, "A"}));
}

TEST(JointTable, TakesStrikeByTheRightHandRule) {
  EXPECT_THAT(joints_in("strike,dip\n30,45\n300,60\n"),
              ElementsAre(MeasuredJoint{{45, 120}, ""}, MeasuredJoint{{60, 30}, ""}));
}

TEST(JointTable, TakesDipAndDirectionInOneCell) {
  EXPECT_THAT(joints_in("45/120 J1\n5/7 J2"), ElementsAre(MeasuredJoint{{45, 120}, "J1"}, MeasuredJoint{{5, 7}, "J2"}));
  EXPECT_THAT(joints_in("set,plane\nJ1,45/120"), ElementsAre(MeasuredJoint{{45, 120}, "J1"}));
}

TEST(JointTable, WithoutAHeaderTellsDirectionsFromDipsByTheirRange) {
  const JointTable table = read_joint_table("120 45\n80 60\n");
  EXPECT_THAT(table.joints(), ElementsAre(MeasuredJoint{{45, 120}, ""}, MeasuredJoint{{60, 80}, ""}));
  EXPECT_THAT(table.notes, ElementsAre(testing::HasSubstr("taken for dip direction and dip")));
}

TEST(JointTable, LeavesCommentsAndUnknownColumnsOut) {
  const JointTable table =
      read_joint_table("\xEF\xBB\xBF# survey of bench 3\ndip,dip direction,JRC\n// face A\n45,120,8\n");
  EXPECT_THAT(table.joints(), ElementsAre(MeasuredJoint{{45, 120}, ""}));
  EXPECT_THAT(table.notes, ElementsAre("column \"JRC\" is left out"));
  EXPECT_EQ(table.lines.front().number, 4);
}

TEST(JointTable, ProblemsNameLineAndColumn) {
  EXPECT_EQ(complaint_about("dip,dip direction\n45,120\n95,120\n"), "line 3, column dip: 95 is out of range");
  EXPECT_EQ(complaint_about("dip,dip direction\n45,N20E\n"), "line 2, column dip direction: \"N20E\" is no number");
  EXPECT_EQ(complaint_about("dip,dip direction\n45\n"), "line 2, column dip direction: it is missing");
  EXPECT_EQ(complaint_about("dip,dip direction,x,y,z\n45,10,1,,3\n"), "line 2, column y: it is missing");
  EXPECT_EQ(complaint_about("dip,dip direction,spacing\n45,10,0\n"), "line 2, column spacing: 0 is not positive");
  EXPECT_EQ(complaint_about("set,plane\nJ1,4512\n"), "line 2, column dip/dip direction: \"4512\" is no plane");
}

TEST(JointTable, ProblemsOfTheHeaderAreToldOnce) {
  EXPECT_EQ(complaint_about("name,value\na,b\n"), "table: no columns of dip and dip direction were found");
  EXPECT_EQ(complaint_about("dip,dip,dip direction\n1,2,3\n"), "column dip: there are two columns of that meaning");
  EXPECT_EQ(complaint_about("dip,dip direction,spacing [ft]\n1,2,3\n"),
            "column spacing: the unit \"ft\" is not known here");
  EXPECT_EQ(complaint_about("dip,dip direction,x\n1,2,3\n"), "column x: a place needs all of x, y and z");
  EXPECT_EQ(complaint_about("dip,dip direction\n"), "table: there is no line below the header");
  EXPECT_EQ(complaint_about(""), "table: there is no line with a joint");
}

TEST(JointTable, KeepsSoundLinesBesideFaultyOnes) {
  const JointTable table = read_joint_table("dip,dip direction\n45,120\nsteep,120\n60,10\n");
  EXPECT_FALSE(table.sound());
  EXPECT_EQ(table.joints().size(), 2u);
  EXPECT_EQ(table.lines[1].problems.at(0).column, "dip");
}

TEST(JointTable, ComesBackFromItsTextDigitForDigit) {
  const std::vector<MeasuredJoint> joints{
      {{45.1, 120.0 / 7}, "J1", Vec3(0.1, 500000.25, -3), 2.5, {}}, {{80, 300}, "J, \"2\"", {}, {}, 12}, {{0, 0}, ""}};
  EXPECT_THAT(joints_in(joint_table_text(joints)), testing::ElementsAreArray(joints));
  EXPECT_EQ(joint_table_text(std::vector{joints[2]}), "dip [°],dip direction [°]\n0,0\n");
}

TEST(TextCells, ANumberIsReadAsPeopleWriteIt) {
  EXPECT_EQ(number_in_cell("45°", ','), 45);
  EXPECT_EQ(number_in_cell(" 45,5 º", ';'), 45.5);
  EXPECT_EQ(number_in_cell("\xE2\x88\x92"
                           "3.5",
                           ','),
            -3.5);
  EXPECT_EQ(number_in_cell("12 deg", ','), 12);
  EXPECT_FALSE(number_in_cell("45,5", ','));
  EXPECT_FALSE(number_in_cell("4 5", ';'));
  EXPECT_FALSE(number_in_cell("", ';'));
  EXPECT_FALSE(number_in_cell("nan", ';'));
}

}  // namespace
}  // namespace talus
