#include "unit/model/slope_project.hpp"

namespace talus {
namespace {

using namespace test;

class StageRules : public testing::TestWithParam<BadProject> {};

TEST_P(StageRules, SayPlaceProblemAndRemedy) { expect_refused(GetParam()); }

const std::vector<BadProject> bad_stages{
    {"no stage", [](Project& p) { p.stages.clear(); }, "/stages", "no stage", "time_step"},
    {"time step 0", [](Project& p) { p.stages[0].time_step = 0; }, "/stages/0/time_step",
     "the time step must be greater than 0, is 0", "seconds"},
    {"steps and duration", [](Project& p) { p.stages[0].steps = 10; }, "/stages/0", "both steps and duration",
     "one of them"},
    {"neither", [](Project& p) { p.stages[0].duration.reset(); }, "/stages/0", "neither steps nor duration",
     "one of them"},
    {"no steps", [](Project& p) { p.stages[0].duration.reset(), p.stages[0].steps = 0; }, "/stages/0/steps",
     "at least 1, is 0", "number of time steps"},
    {"short stage", [](Project& p) { p.stages[0].duration = 0.001; }, "/stages/0/duration",
     "shorter than one time step", "lengthen"},
    {"no duration", [](Project& p) { p.stages[0].duration = 0; }, "/stages/0/duration",
     "the duration must be greater than 0, is 0", "seconds"},
    {"dynamic equilibrium", [](Project& p) { p.stages[0].until_equilibrium = true; }, "/stages/0/until_equilibrium",
     "dynamic stage does not end", "static"},
    {"equilibrium tolerance", [](Project& p) { p.stages[0].equilibrium_tolerance = 0; },
     "/stages/0/equilibrium_tolerance", "greater than 0", "1e-5 is usual"},
    {"tolerance alone", [](Project& p) { p.stages[0].equilibrium_tolerance = 0.1; }, "/stages/0/equilibrium_tolerance",
     "does not ask for equilibrium", "until_equilibrium"},
    {"stage damping", [](Project& p) { p.stages[0].damping = -1; }, "/stages/0/damping", "not be negative", "1/s"},
    {"change of nothing",
     [](Project& p) {
       p.stages[0].joints = {{"J1", {}, {}, {}, {}}};
     },
     "/stages/0/joints/J1", "changes nothing", "friction_angle"},
    {"joint changed twice",
     [](Project& p) {
       p.stages[0].joints = {{"J1", 1, {}, {}, {}}, {"J1", 2, {}, {}, {}}};
     },
     "/stages/0/joints/J1", "changed twice", "keep one"},
    {"changed cohesion",
     [](Project& p) {
       p.stages[0].joints = {{"J1", {}, {}, -1, {}}};
     },
     "/stages/0/joints/J1/cohesion", "not be negative", "Pa"},
    {"below the residual",
     [](Project& p) {
       p.joints[0].residual_friction_angle = 25;
       p.stages[0].joints = {{"J1", 20, {}, {}, {}}};
     },
     "/stages/0/joints/J1/residual_friction_angle", "25°, exceeds the friction angle, 20°", "at most"},
    {"raised by an earlier stage",
     [](Project& p) {
       p.stages.push_back(p.stages[0]);
       p.stages[1].name = "later";
       p.stages[0].joints = {{"J1", 10, {}, {}, {}}};
       p.stages[1].joints = {{"J1", {}, 20, {}, {}}};
     },
     "/stages/1/joints/J1/residual_friction_angle", "20°, exceeds the friction angle, 10°", "at most"},
    {"load of a stage",
     [](Project& p) {
       p.stages[0].loads = {{"top", {0, 0, nan}, {0, 0, 0}}};
     },
     "/stages/0/loads/0/at/2", "not a finite", "finite"},
    {"constraint of a stage",
     [](Project& p) {
       p.stages[0].constraints = {{"top", Vec3(0, 0, 0), {}}};
     },
     "/stages/0/constraints/0/displacement", "holds nothing", "remove"},
};
INSTANTIATE_TEST_SUITE_P(Values, StageRules, testing::ValuesIn(bad_stages));

const std::vector<BadProject> bad_names{
    {"stage's load",
     [](Project& p) {
       p.stages[0].loads = {{"tip", {0, 0, 0}, {0, 0, 0}}};
     },
     "/stages/0/loads/0/block", "nothing is called 'tip'", "'top'"},
    {"stage's constraint",
     [](Project& p) {
       p.stages[0].constraints = {{"tip", Vec3(0, 0, 0)}};
     },
     "/stages/0/constraints/0/block", "nothing is called 'tip'", "'top'"},
    {"stage's block",
     [](Project& p) {
       p.stages[0].blocks = {{"tip", BodyKind::fixed}};
     },
     "/stages/0/blocks/0/name", "nothing is called 'tip'", "'top'"},
    {"stage's joint",
     [](Project& p) {
       p.stages[0].joints = {{"X7", 1, {}, {}, {}}};
     },
     "/stages/0/joints/X7", "joint 'X7' is used here but not defined", "define it"},
    {"stressed block",
     [](Project& p) {
       p.in_situ[0].blocks = {"top", "tip"};
     },
     "/in_situ/0/blocks/1", "nothing is called 'tip'", "'top'"},
};
INSTANTIATE_TEST_SUITE_P(Names, StageRules, testing::ValuesIn(bad_names));

}  // namespace
}  // namespace talus
