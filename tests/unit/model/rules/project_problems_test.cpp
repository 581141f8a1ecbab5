#include "model/rules/project_problems.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "base/error.hpp"
#include "model/rules/validate.hpp"

namespace talus {
namespace {

using Kind = ProjectProblem::Kind;

Project slab() {
  Project project;
  project.materials = {{.name = "rock", .density = 2600, .young = 1e9, .poisson = 0.25}};
  project.solids = {
      {.name = "base", .shape = BoxShape{Vec3::Zero(), Vec3(2, 2, 1)}, .material = "rock", .mesh_size = {}}};
  project.solids[0].body = BodyKind::fixed;
  project.stages.resize(1);
  project.stages[0].name = "wait";
  project.stages[0].time_step = 0.01;
  project.stages[0].steps = 2;
  project.monitors = {{"P1", "base", Vec3(1, 1, 1)}};
  return project;
}

std::vector<std::string> places(const Project& project, Kind kind) {
  std::vector<std::string> found;
  for (const ProjectProblem& problem : problems_of(project))
    if (problem.kind == kind) found.push_back(problem.place);
  return found;
}

TEST(ProjectProblems, ASoundProjectHasNone) { EXPECT_TRUE(problems_of(slab()).empty()); }

TEST(ProjectProblems, AllBrokenRulesAreToldAtOnceAndTheFirstIsTheOneThatValidateThrows) {
  Project project = slab();
  project.materials[0].density = -1;
  project.materials[0].poisson = 0.7;
  project.solids[0].material = "rok";
  project.solids.push_back({.name = "hill", .shape = FileShape{"hill.dwg", 1}, .material = "rock", .mesh_size = {}});
  project.stages[0].steps.reset();
  project.monitors[0].block = "bse";
  EXPECT_THAT(places(project, Kind::error),
              testing::UnorderedElementsAre("/materials/rock/density", "/materials/rock/poisson", "/solids/0/material",
                                            "/solids/1/file", "/stages/0", "/monitors/0/block", "/default_joint"));
  try {
    validate(project);
    FAIL() << "it is broken";
  } catch (const InputError& error) {
    EXPECT_EQ(error.place(), problems_of(project)[0].place);
    EXPECT_EQ(error.problem(), problems_of(project)[0].problem);
  }
}

TEST(ProjectProblems, OnePlaceIsToldOfOnce) {
  Project project = slab();
  project.materials[0].poisson = NAN;
  EXPECT_THAT(places(project, Kind::error), testing::ElementsAre("/materials/rock/poisson"));
}

TEST(ProjectProblems, APolyhedronWhoseFacesNameNoVertexIsToldOfAndNotReadFurther) {
  Project project = slab();
  PolyhedronShape shape;
  shape.vertices = {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  shape.faces = {{0, 1, 99}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  project.solids[0].shape = shape;
  project.stages.clear();
  EXPECT_THAT(places(project, Kind::error), testing::ElementsAre("/stages", "/solids/0/polyhedron/faces/0/2"));
}

TEST(ProjectProblems, OddThingsAreWarningsAndHints) {
  Project project = slab();
  project.materials.push_back({.name = "clay", .density = 2, .young = 20, .poisson = 0.3});
  project.joints.resize(2);
  project.joints[0].name = "J1";
  project.joints[1].name = "J2";
  project.default_joint = "J1";
  project.solids[0].body = BodyKind::tetrahedra;
  project.monitors.clear();
  EXPECT_THAT(places(project, Kind::error), testing::IsEmpty());
  EXPECT_THAT(places(project, Kind::warning),
              testing::ElementsAre("/materials/clay/density", "/materials/clay/young", "/solids/0/body"));
  EXPECT_THAT(places(project, Kind::hint), testing::ElementsAre("/monitors", "/materials/clay", "/joints/J2"));
}

}  // namespace
}  // namespace talus
