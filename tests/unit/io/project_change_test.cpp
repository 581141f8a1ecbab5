#include "io/project_change.hpp"

#include <gtest/gtest.h>

namespace talus {
namespace {

std::string project(const std::string& stages, const std::string& name = "slope") {
  return R"({"talus": 1, "name": ")" + name + R"(", "stages": [)" + stages + "]}";
}

const std::string settle = R"({"name": "settle", "type": "static", "time_step": 0.01, "steps": 10})";
const std::string rest = R"({"name": "rest", "type": "static", "time_step": 0.01, "steps": 10})";
std::string slide(double duration, double time_step = 0.25) {
  return R"({"name": "slide", "type": "dynamic", "time_step": )" + std::to_string(time_step) + R"(, "duration": )" +
         std::to_string(duration) + "}";
}

TEST(ProjectChange, LayoutAndCommentsAreNone) {
  EXPECT_EQ(change_since_run(project(settle), "// the same\n" + project("\n  " + settle)), std::nullopt);
}

TEST(ProjectChange, StagesMayFollowAndTheLastMayLastLonger) {
  const std::string before = project(settle + "," + slide(2));
  EXPECT_EQ(change_since_run(before, project(settle + "," + slide(2) + "," + rest)), std::nullopt);
  EXPECT_EQ(change_since_run(before, project(settle + "," + slide(3))), std::nullopt);
  EXPECT_EQ(change_since_run(before, project(settle + "," + slide(3) + "," + rest)), std::nullopt);
}

TEST(ProjectChange, NamesThePlaceOfWhatForbidsToGoOn) {
  const std::string before = project(settle + "," + slide(2));
  EXPECT_EQ(change_since_run(before, project(settle + "," + slide(1))), "stages/1/duration");
  EXPECT_EQ(change_since_run(before, project(settle + "," + slide(2, 0.5))), "stages/1/time_step");
  EXPECT_EQ(change_since_run(before, project(rest + "," + slide(2))).value().substr(0, 9), "stages/0/");
  EXPECT_EQ(change_since_run(before, project(settle)), "stages/1");
  EXPECT_EQ(change_since_run(before, project(settle + "," + slide(2), "other")), "name");
}

}  // namespace
}  // namespace talus
