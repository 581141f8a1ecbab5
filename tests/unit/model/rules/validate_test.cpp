#include "unit/model/slope_project.hpp"

namespace talus {
namespace {

using namespace test;
using testing::HasSubstr;

class Validate : public testing::TestWithParam<BadProject> {};

TEST_P(Validate, SaysPlaceProblemAndRemedy) { expect_refused(GetParam()); }

const std::vector<BadProject> bad_values{
    {"gravity", [](Project& p) { p.gravity[1] = nan; }, "/gravity/1", "not a finite number", "finite"},
    {"density negative", [](Project& p) { p.materials[0].density = -1; }, "/materials/rock/density",
     "greater than 0, is -1", "kg/m³"},
    {"density NaN", [](Project& p) { p.materials[0].density = nan; }, "/materials/rock/density", "not a finite",
     "finite"},
    {"young zero", [](Project& p) { p.materials[0].young = 0; }, "/materials/rock/young", "Young's modulus", "Pa"},
    {"young infinite", [](Project& p) { p.materials[0].young = infinity; }, "/materials/rock/young", "not a finite",
     "finite"},
    {"poisson half", [](Project& p) { p.materials[0].poisson = 0.5; }, "/materials/rock/poisson",
     "between -1 and 0.5, is 0.5", "0.49"},
    {"poisson low", [](Project& p) { p.materials[0].poisson = -1; }, "/materials/rock/poisson", "is -1", "0.1"},
    {"friction 90", [](Project& p) { p.joints[0].friction_angle = 90; }, "/joints/J1/friction_angle", "below 90",
     "degrees"},
    {"cohesion", [](Project& p) { p.joints[0].cohesion = -5; }, "/joints/J1/cohesion", "not be negative", "Pa"},
    {"tension", [](Project& p) { p.joints[0].tensile_strength = -5; }, "/joints/J1/tensile_strength", "not be negative",
     "Pa"},
    {"residual", [](Project& p) { p.joints[0].residual_friction_angle = 31; }, "/joints/J1/residual_friction_angle",
     "exceeds", "at most"},
    {"restitution", [](Project& p) { p.joints[0].restitution = 1.2; }, "/joints/J1/restitution", "between 0 and 1",
     "the fraction of its speed"},
    {"normal stiffness", [](Project& p) { p.joints[0].normal_stiffness = 0; }, "/joints/J1/normal_stiffness",
     "greater than 0", "Pa/m"},
    {"shear stiffness", [](Project& p) { p.joints[0].shear_stiffness = -1; }, "/joints/J1/shear_stiffness",
     "greater than 0", "Pa/m"},
    {"no solid", [](Project& p) { p.solids.clear(); }, "/solids", "no solid", "add a box"},
    {"flat box", [](Project& p) { std::get<BoxShape>(p.solids[0].shape).max[2] = 0; }, "/solids/0/box/max/2",
     "greater than min: 0 against 0", "swap"},
    {"open polyhedron",
     [](Project& p) {
       p.solids[0].shape = PolyhedronShape{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}},
                                           {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {1, 4, 2}}};
     },
     "/solids/0/polyhedron/faces/3", "in the same direction", "outside"},
    {"drawing",
     [](Project& p) {
       p.solids[0].shape = FileShape{"hill.dwg", 1};
     },
     "/solids/0/file", "'.dwg'", "STEP"},
    {"scale",
     [](Project& p) {
       p.solids[0].shape = FileShape{"hill.STP", 0};
     },
     "/solids/0/scale", "greater than 0", "metres per unit"},
    {"terrain of a drawing",
     [](Project& p) {
       p.solids[0].shape = TerrainShape{"land.dwg", 0, 0};
     },
     "/solids/0/terrain/file", "'.dwg'", "grid of heights"},
    {"terrain tolerance",
     [](Project& p) {
       p.solids[0].shape = TerrainShape{"land.asc", 0, -1};
     },
     "/solids/0/terrain/tolerance", "not be negative", " m"},
    {"cylinder without length",
     [](Project& p) {
       p.solids[0].shape = CylinderShape{{1, 1, 1}, {1, 1, 1}, 1, 8};
     },
     "/solids/0/cylinder/to", "no length", "two ends"},
    {"cylinder of two sides",
     [](Project& p) {
       p.solids[0].shape = CylinderShape{{0, 0, 0}, {1, 1, 1}, 1, 2};
     },
     "/solids/0/cylinder/sides", "not 2", "24"},
    {"section of a line",
     [](Project& p) {
       p.solids[0].shape = SectionShape{{{0, 0}, {1, 1}, {2, 2}}, {0, 0, 0}, 90, 1};
     },
     "/solids/0/section/points", "no area", "not in one line"},
    {"section that crosses itself",
     [](Project& p) {
       p.solids[0].shape = SectionShape{{{0, 0}, {3, 2}, {3, 0}, {0, 1}}, {0, 0, 0}, 90, 1};
     },
     "/solids/0/section/points", "crosses itself", "in order"},
    {"section that touches itself",
     [](Project& p) {
       p.solids[0].shape = SectionShape{{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}, {0, 0, 0}, 90, 1};
     },
     "/solids/0/section/points", "touches", "in order"},
    {"section that touches itself but for rounding",
     [](Project& p) {
       p.solids[0].shape = SectionShape{{{0, 0}, {4, 0}, {4, 4}, {2, 5e-324}, {0, 4}}, {0, 0, 0}, 90, 1};
     },
     "/solids/0/section/points", "touches", "in order"},
    {"turned about nothing",
     [](Project& p) {
       p.solids[0].turn = Turn{{0, 0, 0}, 10, {0, 0, 0}};
     },
     "/solids/0/turn/axis", "no direction", "upright"},
    {"combined of one",
     [](Project& p) {
       p.solids.push_back(p.solids[0]);
       p.solids[1].name = "all";
       p.solids[1].shape = CombinedShape{CombineOperation::unite, {p.solids[0].name}};
     },
     "/solids/1/combine/solids", "nothing to combine", "two solids"},
    {"combined of itself",
     [](Project& p) {
       p.solids.push_back(p.solids[0]);
       p.solids[1].name = "all";
       p.solids[1].shape = CombinedShape{CombineOperation::unite, {p.solids[0].name, "all"}};
     },
     "/solids/1/combine/solids/1", "does not stand before", "move it up"},
    {"combined twice of one",
     [](Project& p) {
       p.solids.push_back(p.solids[0]);
       p.solids[1].name = "all";
       p.solids[1].shape = CombinedShape{CombineOperation::unite, {p.solids[0].name, p.solids[0].name}};
     },
     "/solids/1/combine/solids/1", "a part of a solid already", "another name"},
    {"combined of nobody",
     [](Project& p) {
       p.solids.push_back(p.solids[0]);
       p.solids[1].name = "all";
       p.solids[1].shape = CombinedShape{CombineOperation::unite, {p.solids[0].name, "tunel"}};
     },
     "/solids/1/combine/solids/1", "no solid 'tunel'", ""},
    {"disc and polygon",
     [](Project& p) {
       p.cuts[0].disc = Disc{{0, 0, 0}, 1};
       p.cuts[0].polygon.assign(3, Vec3::Zero());
     },
     "/cuts/0", "not several", "cuts of their own"},
    {"disc without size",
     [](Project& p) {
       p.cuts[0].disc = Disc{{0, 0, 0}, 0};
     },
     "/cuts/0/disc/radius", "greater than 0", " m"},
    {"polygon of two corners", [](Project& p) { p.cuts[0].polygon.assign(2, Vec3::Zero()); }, "/cuts/0/polygon",
     "at least three", "add corners"},
    {"network in a flat box",
     [](Project& p) {
       p.cuts[0].network = JointNetwork{{{0, 0, 0}, {1, 1, 0}}, 1, 1, RadiusLaw::equal, {}};
     },
     "/cuts/0/network/box/max/2", "greater than min", "thickness"},
    {"deviation of equal radii",
     [](Project& p) {
       p.cuts[0].network = JointNetwork{{{0, 0, 0}, {1, 1, 1}}, 1, 1, RadiusLaw::equal, 0.5};
     },
     "/cuts/0/network/radius_deviation", "no standard deviation", "lognormal"},
    {"joint that ends at nothing", [](Project& p) { p.cuts[0].ends_at = {"J9"}; }, "/cuts/0/ends_at/0",
     "is used here but not defined", "joints"},
    {"splinters of no thickness", [](Project& p) { p.splinters.thickness = 0; }, "/splinters/thickness",
     "greater than 0", " m"},
    {"chips as large as blocks", [](Project& p) { p.splinters.chip_volume = 1; }, "/splinters/chip_volume",
     "share of that of other blocks", "less than 1"},
    {"refined to nothing",
     [](Project& p) {
       p.mesh.refinements = {{{0, 0, 0}, 1, 0}};
     },
     "/mesh/refinements/0/size", "greater than 0", " m"},
    {"refined near an edge",
     [](Project& p) {
       p.mesh.refinements = {{.radius = 1, .size = 1, .face = {{0, 0, 0}, {1, 0, 0}}}};
     },
     "/mesh/refinements/0/face", "three corners", "take the face away"},
    {"no tetrahedra", [](Project& p) { p.mesh.most_tetrahedra = 0; }, "/mesh/most_tetrahedra", "greater than 0",
     "tetrahedra"},
    {"mesh size", [](Project& p) { p.solids[0].mesh_size = 0; }, "/solids/0/mesh_size", "greater than 0", " m"},
    {"dip", [](Project& p) { p.cuts[0].dip = 91; }, "/cuts/0/dip", "0 to 90, is 91", "horizontal"},
    {"dip direction", [](Project& p) { p.cuts[0].dip_direction = -1; }, "/cuts/0/dip_direction", "0 to 360, is -1",
     "north"},
    {"spacing alone", [](Project& p) { p.cuts[0].spacing = 2; }, "/cuts/0", "belong together", "'count'"},
    {"count alone", [](Project& p) { p.cuts[0].count = 2; }, "/cuts/0", "belong together", "'spacing'"},
    {"spacing zero", [](Project& p) { p.cuts[0].spacing = 0, p.cuts[0].count = 2; }, "/cuts/0/spacing",
     "greater than 0", "m"},
    {"law without spacing", [](Project& p) { p.cuts[0].spacing_law = SpacingLaw::exponential; }, "/cuts/0/spacing_law",
     "needs a spacing", "'count'"},
    {"deviation without law", [](Project& p) { p.cuts[0].spacing_deviation = 1; }, "/cuts/0/spacing_deviation",
     "no standard deviation", "leave it out"},
    {"kappa zero", [](Project& p) { p.cuts[0].fisher_kappa = 0; }, "/cuts/0/fisher_kappa", "greater than 0",
     "20 scatters"},
    {"seed alone", [](Project& p) { p.cuts[0].seed = 3; }, "/cuts/0/seed", "nothing to draw", "leave the seed out"},
    {"count zero", [](Project& p) { p.cuts[0].spacing = 1, p.cuts[0].count = 0; }, "/cuts/0/count", "at least 1",
     "planes"},
    {"interface with itself", [](Project& p) { p.interfaces[0].between[0] = "slope.1"; }, "/interfaces/0/between",
     "same block", "two blocks"},
    {"late", [](Project& p) { p.expect[0].time = 2.5; }, "/expect/0/time", "after the end of the run, 2 s",
     "lengthen a stage"},
    {"since", [](Project& p) { p.expect[0].since = 1; }, "/expect/0/since", "earlier than time", "before 1 s"},
    {"tolerance", [](Project& p) { p.expect[0].tolerance = 0; }, "/expect/0/tolerance", "greater than 0", "value"},
    {"frames", [](Project& p) { p.output.every = 0; }, "/output/every", "greater than 0", "seconds"},
};
INSTANTIATE_TEST_SUITE_P(Values, Validate, testing::ValuesIn(bad_values));

const std::vector<BadProject> no_numbers{
    {"poisson", [](Project& p) { p.materials[0].poisson = nan; }, "/materials/rock/poisson", "not a finite", "finite"},
    {"friction", [](Project& p) { p.joints[0].friction_angle = nan; }, "/joints/J1/friction_angle", "not a finite",
     "finite"},
    {"residual", [](Project& p) { p.joints[0].residual_friction_angle = -1; }, "/joints/J1/residual_friction_angle",
     "at least 0 and below 90, is -1", "degrees"},
    {"restitution", [](Project& p) { p.joints[0].restitution = nan; }, "/joints/J1/restitution", "not a finite",
     "finite"},
    {"box's min", [](Project& p) { std::get<BoxShape>(p.solids[0].shape).min[1] = -infinity; }, "/solids/0/box/min/1",
     "not a finite", "finite"},
    {"box's max", [](Project& p) { std::get<BoxShape>(p.solids[0].shape).max[2] = infinity; }, "/solids/0/box/max/2",
     "not a finite", "finite"},
    {"no file",
     [](Project& p) {
       p.solids[0].shape = FileShape{"", 1};
     },
     "/solids/0/file", "the file name is empty", "beside the project"},
    {"dip", [](Project& p) { p.cuts[0].dip = nan; }, "/cuts/0/dip", "not a finite", "finite"},
    {"dip direction", [](Project& p) { p.cuts[0].dip_direction = nan; }, "/cuts/0/dip_direction", "not a finite",
     "finite"},
    {"point of a plane", [](Project& p) { p.cuts[0].through[2] = nan; }, "/cuts/0/through/2", "not a finite", "finite"},
    {"place of an override", [](Project& p) { p.blocks[0].at[0] = nan; }, "/blocks/0/at/0", "not a finite", "finite"},
    {"mesh size of an override", [](Project& p) { p.blocks[0].mesh_size = -1; }, "/blocks/0/mesh_size",
     "greater than 0", " m"},
    {"monitor", [](Project& p) { p.monitors[0].at[1] = nan; }, "/monitors/0/at/1", "not a finite", "finite"},
    {"expectation's time", [](Project& p) { p.expect[0].time = -1; }, "/expect/0/time", "not be negative", "seconds"},
    {"expectation's start", [](Project& p) { p.expect[0].since = -1; }, "/expect/0/since", "not be negative",
     "seconds"},
    {"expected value", [](Project& p) { p.expect[0].value = infinity; }, "/expect/0/value", "not a finite", "finite"},
};
INSTANTIATE_TEST_SUITE_P(NoNumbers, Validate, testing::ValuesIn(no_numbers));

const std::vector<BadProject> wrong_names{
    {"law that negative Poisson's ratios break",
     [](Project& p) {
       p.materials[0].law = MaterialLaw::neo_hookean;
       p.materials[0].poisson = -0.1;
     },
     "/materials/rock/poisson", "at least 0, is -0.1", "linear law"},
    {"law without an undeformed shape",
     [](Project& p) {
       p.materials[0].law = MaterialLaw::neo_hookean;
       p.solver.strain = Strain::incremental;
     },
     "/materials/rock/law", "incremental strain does not know", "corotational"},
    {"material twice", [](Project& p) { p.materials.push_back(p.materials[0]); }, "/materials/rock",
     "'rock' is taken by /materials/rock", "own name"},
    {"solid and override", [](Project& p) { p.blocks[0].name = "slope"; }, "/blocks/0/name", "taken by /solids/0/name",
     "own name"},
    {"empty name", [](Project& p) { p.monitors[0].name = ""; }, "/monitors/0/name", "empty", "give a name"},
    {"control character", [](Project& p) { p.stages[0].name = "a\nb"; }, "/stages/0/name", "control character",
     "letters"},
    {"material unknown", [](Project& p) { p.solids[0].material = "rocks"; }, "/solids/0/material",
     "material 'rocks' is not defined", "did you mean 'rock'?"},
    {"override's material", [](Project& p) { p.blocks[0].material = "clay"; }, "/blocks/0/material", "'clay'",
     "use one of rock"},
    {"joint unknown", [](Project& p) { p.cuts[0].joint = "X7"; }, "/cuts/0/joint",
     "joint 'X7' is used here but not defined", "define it under joints, or use one of J1"},
    {"interface's joint", [](Project& p) { p.interfaces[0].joint = "X7"; }, "/interfaces/0/joint", "not defined",
     "define it"},
    {"default joint unknown", [](Project& p) { p.default_joint = "X7"; }, "/default_joint", "not defined", "define it"},
    {"default joint missing", [](Project& p) { p.default_joint = ""; }, "/default_joint", "no joint is named",
     "name of one"},
    {"two solids, no joint",
     [](Project& p) {
       p.joints.clear(), p.cuts.clear(), p.interfaces.clear(), p.default_joint.clear();
       p.solids.push_back(p.solids[0]);
       p.solids[1].name = "other";
     },
     "/default_joint", "several solids", "define a joint"},
    {"cut's solid", [](Project& p) { p.cuts[0].solids = {"slop"}; }, "/cuts/0/solids/0", "no solid 'slop'",
     "did you mean 'slope'?"},
    {"load's block", [](Project& p) { p.loads[0].block = "tip"; }, "/loads/0/block", "nothing is called 'tip'",
     "'top'"},
    {"piece of an unknown solid", [](Project& p) { p.monitors[0].block = "hill.1"; }, "/monitors/0/block", "'hill.1'",
     "use one of top, slope"},
    {"removed block", [](Project& p) { p.blocks[0].removed = true; }, "/interfaces/0/between/0",
     "block 'top' is removed", "name another block"},
    {"network of too many discs",
     [](Project& p) {
       p.cuts[0].network = JointNetwork{{{0, 0, 0}, {100, 100, 100}}, 1, 0.5, RadiusLaw::exponential, {}};
     },
     "/cuts/0/network/density", "about 6.37e+05 discs, more than 20000", "raise the radius"},
    {"expected monitor", [](Project& p) { p.expect[0].quantity = "P2.displacement.z"; }, "/expect/0/quantity", "'P2'",
     "use one of P1, top, slope"},
    {"quantity's grammar", [](Project& p) { p.expect[0].quantity = "P1.stress.z"; }, "/expect/0/quantity",
     "cannot read the quantity 'P1.stress.z'", "NAME.displacement.z"},
    {"stress not recorded", [](Project& p) { p.expect[0].quantity = "P1.stress.zz"; }, "/expect/0/quantity",
     "'P1' is no monitor that records stress", "\"stress\": true"},
    {"stress of a block",
     [](Project& p) {
       p.monitors[0].stress = true;
       p.expect[0].quantity = "top.stress.zz";
     },
     "/expect/0/quantity", "'top' is no monitor that records stress", "name a monitor"},
};
INSTANTIATE_TEST_SUITE_P(Names, Validate, testing::ValuesIn(wrong_names));

TEST(ValidateProject, AcceptsAGoodOne) { EXPECT_NO_THROW(validate(slope())); }

TEST(ValidateProject, ABlockByItselfNeedsNoJoint) {
  Project project = slope();
  project.cuts.clear();
  project.joints.clear();
  project.interfaces.clear();
  project.default_joint.clear();
  EXPECT_NO_THROW(validate(project));
}

TEST(ValidateProject, PlacesEscapeSlashes) {
  Project project = slope();
  project.materials[0].name = "rock/a~b";
  project.materials[0].density = 0;
  try {
    validate(project);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.place(), "/materials/rock~1a~0b/density");
  }
}

/// Blocks of these names that may all move.
std::vector<BuiltBlock> blocks(const std::vector<std::string>& names) {
  std::vector<BuiltBlock> built;
  for (const auto& name : names) built.push_back({name, BodyKind::tetrahedra});
  return built;
}

TEST(ValidateAgainstBlocks, KnowsTheNamesGeometryGave) {
  EXPECT_NO_THROW(validate_against_blocks(slope(), blocks({"slope.1", "top"})));
}

TEST(ValidateForCutting, AsksForSolidsAndNotForStages) {
  Project project = slope();
  project.stages.clear();
  project.expect.clear();
  EXPECT_THROW(validate(project), InputError);
  EXPECT_NO_THROW(validate_for_cutting(project));
  project.materials[0].density = -1;
  EXPECT_THROW(validate_for_cutting(project), InputError) << "what is there must be right";
  EXPECT_THROW(validate_for_cutting(Project{}), InputError);
}

TEST(ValidateAgainstBlocks, NamesTheReferenceThatIsMissing) {
  try {
    validate_against_blocks(slope(), blocks({"slope.2", "top"}));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.place(), "/interfaces/0/between/1");
    EXPECT_THAT(error.problem(), HasSubstr("no block is called 'slope.1'"));
    EXPECT_THAT(error.remedy(), HasSubstr("did you mean 'slope.2'?"));
  }
}

TEST(ValidateAgainstBlocks, AnExpectationMayNameAMonitor) {
  Project project = slope();
  project.expect = {{"P1.displacement.z", 1, 0, 1, std::nullopt, ""},
                    {"slope.9.displacement.z", 1, 0, 1, std::nullopt, ""}};
  try {
    validate_against_blocks(project, blocks({"slope.1", "top"}));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.place(), "/expect/1/quantity");
  }
}

TEST(ValidateAgainstBlocks, RefusesTwoBlocksOfOneName) {
  EXPECT_THROW(validate_against_blocks(slope(), blocks({"slope.1", "top", "top"})), InputError);
}

}  // namespace
}  // namespace talus
