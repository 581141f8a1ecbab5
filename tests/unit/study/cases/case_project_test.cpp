#include "study/cases/case_project.hpp"

#include <gmock/gmock.h>

#include "base/error.hpp"

namespace talus {
namespace {

const std::string commented_project = R"({
  // kept
  "joints": {"J1": {"friction_angle": 30}, "a/b": {"friction_angle": 20}},
  "solids": [{"name": "base"}, {"name": "slope", "mesh_size": 2}]
})";

std::string place_refusal(const std::string& column) {
  try {
    numbered_pointer(commented_project, column);
  } catch (const InputError& error) {
    return error.problem() + "; " + error.remedy();
  }
  return "none";
}

TEST(CaseProject, ThingsInListsAreFoundByNumberAndByName) {
  EXPECT_EQ(numbered_pointer(commented_project, "/solids/slope/mesh_size"), "/solids/1/mesh_size");
  EXPECT_EQ(numbered_pointer(commented_project, "/solids/1/mesh_size"), "/solids/1/mesh_size");
  EXPECT_EQ(numbered_pointer(commented_project, "/joints/a~1b/friction_angle"), "/joints/a~1b/friction_angle");
}

TEST(CaseProject, TheLastStepMayBeLeftToItsDefault) {
  EXPECT_EQ(numbered_pointer(commented_project, "/joints/J1/cohesion"), "/joints/J1/cohesion");
  EXPECT_EQ(numbered_pointer(commented_project, "/gravity"), "/gravity");
}

TEST(CaseProject, PlacesThatAreNotThereAreRefusedWithWhatIs) {
  EXPECT_EQ(place_refusal("/joints/J9/cohesion"), "the project has no 'J9' in /joints; it has J1, a/b");
  EXPECT_EQ(place_refusal("/solids/2/mesh_size"), "the project has no '2' in /solids; it has 0 to 1");
  EXPECT_EQ(place_refusal("/solids/2"), "the project has no '2' in /solids; it has 0 to 1");
  EXPECT_EQ(place_refusal("/joints/J1/friction_angle/x"),
            "the project has no 'x' in /joints/J1/friction_angle; look at how the project is written");
  EXPECT_THAT(place_refusal("/~x"), testing::StartsWith("is no place in a project"));
}

TEST(CaseProject, OnlyTheValuesChange) {
  const std::string changed =
      with_values(commented_project, {"/joints/J1/friction_angle", "/joints/J1/cohesion", "/solids/1/mesh_size"},
                  {"12.5", "1000", ""});
  EXPECT_EQ(changed, R"({
  // kept
  "joints": {"J1": {"friction_angle": 12.5, "cohesion": 1000}, "a/b": {"friction_angle": 20}},
  "solids": [{"name": "base"}, {"name": "slope", "mesh_size": 2}]
})");
}

}  // namespace
}  // namespace talus
