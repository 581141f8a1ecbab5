#include <cmath>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "io/project_file.hpp"
#include "unit/io/sample_project.hpp"

namespace talus {
namespace {

using test::full_project;
using test::replaced;
using test::small_project;
using testing::HasSubstr;
using testing::Not;

TEST(ProjectRoundTrip, EveryKeyIsRead) {
  const Project p = parse_project(full_project);
  EXPECT_EQ(p.name, "Full \"slope\" – Südhang");
  EXPECT_EQ(p.gravity, Vec3(0, 0, -9.80665));
  EXPECT_TRUE(std::signbit(p.gravity[1]));
  ASSERT_EQ(p.materials.size(), 2u);
  EXPECT_EQ(p.materials[0],
            (Material{"soft rock", 2100, 1e9, 0.3, 0, MaterialLaw::neo_hookean, RockStrength{2e6, 35, 5e5}}));
  EXPECT_EQ(p.materials[1], (Material{"hard/rock", 2600, 25e9, -0.1, 0.5}));
  ASSERT_EQ(p.joints.size(), 2u);
  EXPECT_EQ(p.joints[0], (Joint{"J2", 8, 0, 0, {}, {}, {}, {}}));
  EXPECT_EQ(p.joints[1], (Joint{"J1", 30, 2e5, 1e4, 25, 1e10, 4e9, 0.4}));
  EXPECT_EQ(p.default_joint, "J1");
  ASSERT_EQ(p.solids.size(), 7u);
  EXPECT_EQ(p.solids[0],
            (Solid{"slope", BoxShape{{0, 0, 0}, {10, 10, 10}}, "soft rock", BodyKind::tetrahedra, 1.0 / 3}));
  const PolyhedronShape wedge{{{20, 0, 0}, {21, 0, 0}, {20, 1, 0}, {20, 0, std::nextafter(1.0, 2.0)}},
                              {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  EXPECT_EQ(p.solids[1], (Solid{"wedge", wedge, "hard/rock", BodyKind::automatic, {}}));
  EXPECT_EQ(p.solids[2], (Solid{"hill",
                                FileShape{"shapes/hill.step", 0.001},
                                "soft rock",
                                BodyKind::fixed,
                                {},
                                Turn{{0, 0, 1}, 30, {1, 2, 3}},
                                {0, 0, -0.5}}));
  EXPECT_EQ(p.solids[3].shape, SolidShape(TerrainShape{"land.asc", 100, 0.25}));
  EXPECT_EQ(p.solids[4].shape, SolidShape(CylinderShape{{30, 0, 2}, {30, 10, 2}, 1.5, 12}));
  EXPECT_EQ(p.solids[5].shape, SolidShape(SectionShape{{{0, 0}, {20, 0}, {20, 10}, {10, 10}}, {40, 0, 0}, 75, 8}));
  EXPECT_EQ(p.solids[6].shape, SolidShape(CombinedShape{CombineOperation::subtract, {"bench", "bore"}}));
  ASSERT_EQ(p.cuts.size(), 6u);
  EXPECT_EQ(p.cuts[0], (Cut{"J1", 35, 120, {5, 5, 5}, {}, {}, {"slope", "hill"}}));
  EXPECT_EQ(p.cuts[1], (Cut{"J2", 60, 30, {5, 5, 5}, 1.5, 4, {}, SpacingLaw::lognormal, 0.25, 120.0, 7}));
  EXPECT_EQ(p.cuts[2], (Cut{"J2", 90, 360, {1e-3, 5, 5}, 2.0, 3, {}}));
  Cut disc{"J2", 10, 45, {4, 4, 4}, {}, {}, {}};
  disc.disc = Disc{{4, 4, 4}, 2.5};
  disc.ends_at = {"J1"};
  EXPECT_EQ(p.cuts[3], disc);
  Cut polygon{"J2", 0, 0, {8.0 / 3, 4.0 / 3, 2}, {}, {}, {}};
  polygon.polygon = {{0, 0, 2}, {4, 0, 2}, {4, 4, 2}};
  EXPECT_EQ(p.cuts[4], polygon);
  Cut network{"J1", 70, 200, {5, 5, 5}, {}, {}, {}, SpacingLaw::equal, {}, 50, 3};
  network.network = JointNetwork{{{0, 0, 0}, {10, 10, 10}}, 0.5, 2, RadiusLaw::lognormal, 0.75};
  EXPECT_EQ(p.cuts[5], network);
  EXPECT_EQ(p.origin, Vec3(2600000, 1200000.5, 400));
  EXPECT_EQ(p.merges, (std::vector{Merge{{1, 1, 1}, {2, 1, 1}}}));
  EXPECT_EQ(p.splinters, (Splinters{0.01, SplinterRule::merge, 1e-5}));
  EXPECT_EQ(
      p.mesh,
      (MeshSettings{1.25,
                    {{{5, 5, 10}, 2, 0.2}, {.radius = 1, .size = 0.25, .face = {{0, 0, 10}, {4, 0, 10}, {4, 4, 10}}}},
                    200000}));
  ASSERT_EQ(p.blocks.size(), 3u);
  EXPECT_EQ(p.blocks[0], (BlockOverride{"top", {5, 5, 9}, BodyKind::tetrahedra, "hard/rock", 0.5}));
  EXPECT_EQ(p.blocks[1], (BlockOverride{"foot", {5, 5, 1}, BodyKind::fixed, {}, {}}));
  EXPECT_EQ(p.blocks[2], (BlockOverride{"dug out", {9, 9, 9}, {}, {}, {}, true}));
  EXPECT_EQ(p.interfaces.at(0), (Interface{{"top", "wedge"}, "J2"}));
  ASSERT_EQ(p.constraints.size(), 3u);
  EXPECT_EQ(p.constraints[0], (Constraint{"foot", Vec3(0, 0, 0), {0.0, std::nullopt, -0.001}}));
  EXPECT_EQ(p.constraints[1],
            (Constraint{"foot", {}, {0, 0, 0}, {{0, {0, 0, 0}}, {0.5, {0.02, 0, 0}}, {1, {-0.02, 0, 1e-3}}}}));
  EXPECT_EQ(p.constraints[2],
            (Constraint{"top", Vec3(5, 5, 10), {0, {}, 0}, {{0, {0, 0, 0}}, {2.5, {0.001, 0, -0.5}}}}));
  ASSERT_EQ(p.loads.size(), 2u);
  EXPECT_EQ(p.loads[0], (PointLoad{"top", {5, 5, 10}, {0, 0, -1e6}}));
  EXPECT_EQ(p.loads[1], (PointLoad{"top", {5, 0, 10}, {0, 0, 0}, {{0, {0, 0, 0}}, {1, {0, 0.25, -2e6}}}}));
  ASSERT_EQ(p.velocities.size(), 2u);
  EXPECT_EQ(p.velocities[0], (InitialVelocity{"wedge", {1, 0, 0}, {0, 0, 0.1}}));
  EXPECT_EQ(p.velocities[1], (InitialVelocity{"top", {0, 0, 0}, {0, 0, 0}}));
  ASSERT_EQ(p.monitors.size(), 2u);
  EXPECT_EQ(p.monitors[0], (Monitor{"P1", "top", {5, 5, 10}}));
  EXPECT_EQ(p.monitors[1], (Monitor{"P2", "top", {5, 5, 9}, true}));
  ASSERT_EQ(p.expect.size(), 2u);
  EXPECT_EQ(p.expect[0], (Expectation{"P1.displacement.z", 41, -4.905, 1e-6, 40.0, "½gt²"}));
  EXPECT_EQ(p.expect[1], (Expectation{"slope.2.velocity.magnitude", 100, 0, 1e-9, {}, ""}));
  EXPECT_EQ(p.output, (Output{0.25}));
}

TEST(ProjectRoundTrip, StressesInSituAreRead) {
  const Project p = parse_project(full_project);
  ASSERT_EQ(p.in_situ.size(), 2u);
  InSituStress everywhere;
  everywhere.stress << -1e6, -2e6, -3e6, 1, 2, 3;
  everywhere.gradient << 1e4, 2e4, 26e3, 0, 0, 0.5;
  everywhere.level = 10;
  EXPECT_EQ(p.in_situ[0], everywhere);
  InSituStress locked;
  locked.blocks = {"top", "slope.2"};
  locked.stress << 0, 0, 0, 0, 0, 4e5;
  EXPECT_EQ(p.in_situ[1], locked);
}

TEST(ProjectRoundTrip, StagesAndTheirChangesAreRead) {
  const Project p = parse_project(full_project);
  ASSERT_EQ(p.stages.size(), 2u);
  Stage gravity;
  gravity.name = "gravity";
  gravity.kind = StageKind::static_;
  gravity.time_step = 0.01;
  gravity.steps = 4000;
  gravity.until_equilibrium = true;
  gravity.equilibrium_tolerance = 0.001;
  gravity.damping = 0.2;
  gravity.blocks = {{"top", BodyKind::fixed}};
  EXPECT_EQ(p.stages[0], gravity);
  Stage slide;
  slide.name = "slide";
  slide.time_step = 0.005;
  slide.duration = 60;
  slide.joints = {{"J2", 6, {}, {}, {}}, {"J1", 20, 15, 0, 5e3}};
  slide.loads.emplace();
  slide.constraints = {{"top", Vec3(5, 5, 10), {{{}, 0, {}}}, {}}};
  slide.blocks = {{"top", BodyKind::tetrahedra}};
  EXPECT_EQ(p.stages[1], slide);
}

TEST(ProjectRoundTrip, SolverSettingsAreRead) {
  SolverSettings solver;
  solver.preset = Preset::paper;
  solver.integrator = Integrator::generalized_alpha;
  solver.spectral_radius = 0.6;
  solver.contact = ContactModel::area;
  solver.contact_stiffness = 12.5;
  solver.sleep_tolerance = 1e-7;
  solver.penetration_tolerance = 1e-6;
  solver.tolerance = standard_tolerance.value;
  solver.open_close_limit = 8;
  solver.time_step_control = TimeStepControl::adaptive;
  solver.adaptive = {0.01, 1e-5, 6, 0.01};
  solver.effects = {.contact = Switch::on,
                    .rebound = Switch::off,
                    .restitution = Switch::off,
                    .missed_contacts = Switch::on,
                    .updated_normals = Switch::off,
                    .penalty_scaling = Switch::on,
                    .followed_springs = Switch::off,
                    .acceleration_reset = Switch::on,
                    .sleep = Switch::on,
                    .elimination = Switch::off};
  EXPECT_EQ(parse_project(full_project).solver, solver);
}

TEST(ProjectRoundTrip, APresetSetsWhatTheProjectLeavesOut) {
  const auto with = [](const std::string& solver) {
    return parse_project(replaced(small_project, "\"materials\"", "\"solver\": " + solver + ", \"materials\""));
  };
  const Project paper = with(R"({"preset": "paper"})");
  EXPECT_EQ(paper.solver, settings_of(Preset::paper));
  EXPECT_EQ(paper.solver.open_close, OpenCloseMethod::states);
  EXPECT_EQ(paper.solver.open_close_limit, 6);
  EXPECT_EQ(paper.solver.extras, Extras::none);
  const Project own =
      with(R"({"preset": "paper", "contact": "area", "strain": "corotational", "extras": "called_for"})");
  EXPECT_EQ(own.solver.contact, ContactModel::area);
  EXPECT_EQ(own.solver.integrator, Integrator::constant_acceleration);
  for (const Project& project : {paper, own}) EXPECT_EQ(parse_project(write_project(project)).solver, project.solver);
  EXPECT_EQ(with(R"({"preset": "talus"})").solver, SolverSettings{});
}

TEST(ProjectRoundTrip, AToleranceIsANameOrANumber) {
  for (const auto& [text, value] : {std::pair{R"("draft")", 1e-3},
                                    {R"("standard")", 1e-6},
                                    {R"("reference")", 1e-10},
                                    {"1e-3", 1e-3},
                                    {"2.5e-5", 2.5e-5}}) {
    const std::string file =
        replaced(full_project, R"("tolerance": "standard")", "\"tolerance\": " + std::string(text));
    const Project project = parse_project(file);
    EXPECT_EQ(project.solver.tolerance, value) << text;
    EXPECT_EQ(write_project(project, file), file) << "to the byte";
    EXPECT_EQ(parse_project(write_project(project)), project);
  }
  Project usual = parse_project(full_project);
  usual.solver.tolerance = SolverSettings{}.tolerance;
  EXPECT_THAT(write_project(usual), Not(HasSubstr("\"tolerance\": \"")));
}

/// Each word of a choice comes back as the choice it was.
TEST(ProjectRoundTrip, EveryChoiceOfTheSolverComesBack) {
  Project project = parse_project(small_project);
  for (const auto integrator : {Integrator::newmark, Integrator::constant_acceleration, Integrator::generalized_alpha})
    for (const auto strain : {Strain::corotational, Strain::incremental})
      for (const auto contact : {ContactModel::area, ContactModel::facet_wise})
        for (const auto control : {TimeStepControl::fixed, TimeStepControl::adaptive}) {
          project.solver.integrator = integrator;
          project.solver.strain = strain;
          project.solver.contact = contact;
          project.solver.time_step_control = control;
          EXPECT_EQ(parse_project(write_project(project)).solver, project.solver);
        }
}

TEST(ProjectRoundTrip, EveryBodyComesBack) {
  Project project = parse_project(small_project);
  project.blocks = {{"top", {5, 5, 9}, {}, {}, {}}};
  for (const auto body :
       {BodyKind::fixed, BodyKind::rigid, BodyKind::affine, BodyKind::tetrahedra, BodyKind::automatic}) {
    project.solids[0].body = body;
    project.blocks[0].body = body;
    EXPECT_EQ(parse_project(write_project(project, small_project)), project) << to_string(body);
  }
  project.stages.push_back(project.stages[0]);
  project.stages[1].name = "then";
  project.stages[0].blocks = {{"top", BodyKind::fixed}};
  project.stages[1].blocks = {{"top", BodyKind::automatic}};
  EXPECT_EQ(parse_project(write_project(project)), project);
}

/// Loads that a stage takes away are something else than loads it leaves alone.
TEST(ProjectRoundTrip, AnEmptyListInAStageIsNotAbsence) {
  Project project = parse_project(small_project);
  EXPECT_FALSE(project.stages[0].loads);
  project.stages[0].loads.emplace();
  project.stages[0].constraints.emplace();
  const std::string written = write_project(project, small_project);
  EXPECT_EQ(written, replaced(small_project, "\"steps\": 100}", "\"steps\": 100, \"loads\": [], \"constraints\": []}"));
  EXPECT_EQ(parse_project(written), project);
}

TEST(ProjectRoundTrip, WhatIsLeftOutHasItsDefault) {
  const Project p = parse_project(small_project);
  EXPECT_EQ(p.gravity, Vec3(0, 0, -9.81));
  EXPECT_EQ(p.solids[0].body, BodyKind::tetrahedra);
  EXPECT_FALSE(p.solids[0].mesh_size);
  EXPECT_EQ(p.solver, SolverSettings{});
  EXPECT_EQ(p.output, Output{});
}

TEST(ProjectRoundTrip, WritingLosesNothing) {
  for (const auto& text : {full_project, small_project}) {
    const Project project = parse_project(text);
    const std::string written = write_project(project);
    EXPECT_EQ(parse_project(written), project);
    EXPECT_EQ(write_project(parse_project(written)), written);
  }
  EXPECT_TRUE(std::signbit(parse_project(write_project(parse_project(full_project))).gravity[1]));
}

TEST(ProjectRoundTrip, OddNumbersComeBackDigitForDigit) {
  Project project = parse_project(small_project);
  for (const double value : {1.0 / 3, 5e-324, 1.7976931348623157e308, 9007199254740993.0, 1e22, 1e23, 0.1 + 0.2}) {
    project.materials[0].density = value;
    EXPECT_EQ(parse_project(write_project(project)).materials[0].density, value);
  }
}

TEST(ProjectRoundTrip, NumbersThatAreNotFiniteAreNotWritten) {
  Project project = parse_project(small_project);
  project.gravity[2] = std::nan("");
  EXPECT_THROW(write_project(project), InputError);
  EXPECT_THROW(write_project(project, small_project), InputError);
}

TEST(ProjectMerge, AnUnchangedProjectIsTheSameTextByteForByte) {
  for (const auto& text : {full_project, small_project}) EXPECT_EQ(write_project(parse_project(text), text), text);
  std::string windows;
  for (const char c : full_project) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(write_project(parse_project(windows), windows), windows);
  const std::string marked = "\xEF\xBB\xBF" + small_project;
  EXPECT_EQ(write_project(parse_project(marked), marked), marked);
}

TEST(ProjectMerge, AChangedNumberIsTheOnlyChange) {
  Project project = parse_project(full_project);
  project.materials[0].young = 2.5e9;
  EXPECT_EQ(write_project(project, full_project), replaced(full_project, "\"young\": 1e9", "\"young\": 2.5e9"));
}

TEST(ProjectMerge, AChangedDefaultIsAdded) {
  Project project = parse_project(small_project);
  project.gravity = {0, 0, -1.62};
  EXPECT_EQ(write_project(project, small_project),
            replaced(small_project, "  \"materials\"", "  \"gravity\": [0, 0, -1.62],\n  \"materials\""));
}

TEST(ProjectMerge, ARowAddedToATableLeavesTheOthersAlone) {
  Project project = parse_project(full_project);
  project.constraints[1].table.push_back({1.5, {0, 0, 0}});
  EXPECT_EQ(write_project(project, full_project),
            replaced(full_project, "[1, -0.02, 0, 1e-3]]}",
                     "[1, -0.02, 0, 1e-3],\n                                [1.5, 0, 0, 0]]}"));
}

TEST(ProjectMerge, ATableMayTakeThePlaceOfAForce) {
  Project project = parse_project(full_project);
  project.loads[0].force.setZero();
  project.loads[0].table = {{0, {0, 0, -1e6}}, {2, {0, 0, 0}}};
  EXPECT_EQ(write_project(project, full_project),
            replaced(full_project, "\"force\": [0, 0, -1e6]", "\"table\": [[0, 0, 0, -1e6], [2, 0, 0, 0]]"));
}

TEST(ProjectMerge, WhatBecomesUsualAgainIsTakenAway) {
  Project project = parse_project(full_project);
  project.stages[0].until_equilibrium = false;
  project.stages[0].equilibrium_tolerance = Stage{}.equilibrium_tolerance;
  project.solver.time_step_control = TimeStepControl::fixed;
  project.solver.adaptive = {};
  const std::string text = write_project(project, full_project);
  EXPECT_EQ(parse_project(text), project);
  for (const char* key : {"until_equilibrium", "equilibrium_tolerance", "time_step_control", "adaptive"})
    EXPECT_THAT(text, Not(HasSubstr(key)));
}

TEST(ProjectMerge, AThingAddedInTheMiddleLeavesTheOthersAlone) {
  Project project = parse_project(full_project);
  Cut cut = project.cuts[0];
  cut.dip = 60;
  cut.solids.clear();
  project.cuts.insert(project.cuts.begin() + 1, cut);
  EXPECT_EQ(write_project(project, full_project),
            replaced(full_project, "    {\"joint\": \"J2\", \"dip\": 60",
                     "    {\"joint\": \"J1\", \"dip\": 60, \"dip_direction\": 120, \"through\": [5, 5, 5]},\n"
                     "    {\"joint\": \"J2\", \"dip\": 60"));
}

TEST(ProjectMerge, AThingAddedAtTheEndComesBehindTheLastOnesComment) {
  Project project = parse_project(full_project);
  Cut cut = project.cuts[0];
  cut.solids.clear();
  project.cuts.push_back(cut);
  EXPECT_EQ(write_project(project, full_project),
            replaced(full_project, "\"radius_deviation\": 0.75}} // last\n",
                     "\"radius_deviation\": 0.75}}, // last\n"
                     "    {\"joint\": \"J1\", \"dip\": 35, \"dip_direction\": 120, \"through\": [5, 5, 5]}\n"));
}

TEST(ProjectMerge, AThingRemovedTakesItsCommentsWithIt) {
  Project project = parse_project(full_project);
  project.solids.erase(project.solids.begin() + 1);
  project.interfaces.clear();
  project.velocities.erase(project.velocities.begin());
  const std::string text = write_project(project, full_project);
  EXPECT_EQ(parse_project(text), project);
  EXPECT_THAT(text, Not(HasSubstr("the wedge that falls")));
  EXPECT_THAT(text, Not(HasSubstr("interfaces")));
  EXPECT_THAT(text, HasSubstr("\"velocities\": [{\"block\": \"top\"}],"));
  for (const char* comment : {"// A slope above a road.", "// the format", "laboratory */", "// bedding", "// last",
                              "// nothing else", "// the end", "// broken by the driving block"}) {
    EXPECT_THAT(text, HasSubstr(comment));
  }
}

TEST(ProjectMerge, ARenamedMaterialKeepsItsNeighboursComments) {
  Project project = parse_project(full_project);
  project.materials[1].name = "granite";
  for (const std::size_t solid : {1, 3}) project.solids[solid].material = "granite";
  project.blocks[0].material = "granite";
  const std::string text = write_project(project, full_project);
  EXPECT_EQ(parse_project(text), project);
  EXPECT_THAT(text, HasSubstr("// first, though later in the alphabet\n    \"granite\": {"));
}

TEST(ProjectMerge, MaterialsMayChangePlaces) {
  Project project = parse_project(full_project);
  std::swap(project.materials[0], project.materials[1]);
  const std::string text = write_project(project, full_project);
  EXPECT_EQ(parse_project(text), project);
  EXPECT_LT(text.find("\"hard/rock\": {"), text.find("\"soft rock\": {"));
}

TEST(ProjectMerge, AShapeMayBecomeAnother) {
  Project project = parse_project(full_project);
  project.solids[1].shape = BoxShape{{20, 0, 0}, {21, 1, 1}};
  const std::string text = write_project(project, full_project);
  EXPECT_EQ(parse_project(text), project);
  EXPECT_THAT(text, HasSubstr("// the wedge that falls"));
  EXPECT_THAT(text, HasSubstr("\"box\": {\"min\": [20, 0, 0], \"max\": [21, 1, 1]}"));
}

TEST(ProjectMerge, ALineCommentNeverSwallowsWhatFollowsIt) {
  const std::string text = replaced(small_project, "\"through\": [5, 5, 5]", "\"through\": [5, // x\n5, 5 // z\n]");
  Project project = parse_project(text);
  project.cuts[0].through = {1, 5, 2};
  EXPECT_EQ(write_project(project, text), replaced(text, "[5, // x\n5, 5 // z\n]", "[1, // x\n5, 2 // z\n]"));

  const std::string inline_lists = replaced(small_project, "\"dip\": 35, ", "\"dip\": 35, // steep\n");
  project = parse_project(inline_lists);
  project.cuts.push_back(project.cuts[0]);
  project.cuts[0].spacing = 1;
  project.cuts[0].count = 2;
  EXPECT_EQ(parse_project(write_project(project, inline_lists)), project);
}

TEST(ProjectMerge, WhatIsNoProjectIsReplaced) {
  const Project project = parse_project(small_project);
  EXPECT_EQ(write_project(project, "not JSON"), write_project(project));
}

}  // namespace
}  // namespace talus
