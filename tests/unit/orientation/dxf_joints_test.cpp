#include "orientation/dxf_joints.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "orientation/project_joints.hpp"

namespace talus {
namespace {

using testing::Contains;
using testing::HasSubstr;

/// A square that dips 45° east and a triangle that dips 60° north, in millimetres, a line and a closed polyline.
std::string drawing(const std::string& unit = "4") {
  return "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n" + unit + R"(
0
ENDSEC
0
SECTION
2
ENTITIES
0
3DFACE
8
bedding
10
0
20
0
30
10000
11
10000.0
21
0
31
0
12
10000
22
10000
32
0
13
0
23
10000
33
10000
0
3DFACE
8
J1
10
0
20
0
30
17320.508075688772
11
5000
21
0
31
17320.508075688772
12
0
22
10000
32
0
13
0
23
10000
33
0
0
LINE
8
0
10
0
0
POLYLINE
8
J2
70
9
0
VERTEX
10
0
20
0
30
0
0
VERTEX
10
4000
20
0
30
0
0
VERTEX
10
4000
20
0
30
4000
0
SEQEND
0
ENDSEC
0
EOF
)";
}

TEST(DxfJoints, AreFacesWithTheirPlanesAndCorners) {
  const JointTable table = read_dxf_joints(drawing());
  ASSERT_EQ(table.lines.size(), 3u);
  const std::vector<MeasuredJoint> joints = table.joints();
  ASSERT_EQ(joints.size(), 3u);
  EXPECT_EQ(joints[0].set, "bedding");
  EXPECT_NEAR(joints[0].plane.dip, 45, 1e-6);
  EXPECT_NEAR(joints[0].plane.dip_direction, 90, 1e-6);
  EXPECT_TRUE(joints[0].at->isApprox(Vec3(5, 5, 5)));
  EXPECT_EQ(joints[0].corners.size(), 4u);
  EXPECT_NEAR(joints[1].plane.dip, 60, 1e-6);
  EXPECT_NEAR(joints[1].plane.dip_direction, 0, 1e-6);
  EXPECT_EQ(joints[1].corners.size(), 3u) << "a triangle has its third corner twice";
  EXPECT_NEAR(joints[2].plane.dip, 90, 1e-6);
  EXPECT_THAT(table.notes, Contains(HasSubstr("LINE is left out")));
  EXPECT_THAT(table.notes, Contains(HasSubstr("metres")));
}

TEST(DxfJoints, BecomeJointsThatEndAtTheirCorners) {
  const Project project = with_joints({}, read_dxf_joints(drawing("6")).joints(), {}, Vec3::Zero());
  ASSERT_EQ(project.cuts.size(), 3u);
  EXPECT_EQ(project.joints[0].name, "bedding");
  ASSERT_EQ(project.cuts[0].polygon.size(), 4u);
  EXPECT_EQ(project.cuts[0].polygon[1], Vec3(10000, 0, 0)) << "a drawing in metres";
}

TEST(DxfJoints, OnOneLineAreToldWithTheirLine) {
  const JointTable table = read_dxf_joints(
      "0\nSECTION\n2\nENTITIES\n0\n3DFACE\n8\nJ\n10\n0\n20\n0\n30\n0\n11\n1\n21\n0\n31\n0\n12\n2\n22\n0\n32\n0\n13\n2\n"
      "23\n0\n33\n0\n0\nENDSEC\n0\nEOF\n");
  ASSERT_EQ(table.lines.size(), 1u);
  EXPECT_EQ(table.lines[0].number, 5);
  EXPECT_FALSE(table.lines[0].joint);
  EXPECT_EQ(table.lines[0].problems.size(), 1u);
}

TEST(DxfJoints, InWhatIsNoDrawingAreRefused) {
  EXPECT_THROW(read_dxf_joints(""), InputError);
  EXPECT_THROW(read_dxf_joints("AutoCAD Binary DXF\r\n\x1a"), InputError);
  EXPECT_THROW(read_dxf_joints("dip;direction\n45;90\n"), InputError);
  EXPECT_FALSE(read_dxf_joints("0\nSECTION\n2\nENTITIES\n0\nENDSEC\n0\nEOF\n").sound());
}

}  // namespace
}  // namespace talus
