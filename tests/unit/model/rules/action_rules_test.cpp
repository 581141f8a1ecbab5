#include "unit/model/slope_project.hpp"

namespace talus {
namespace {

using namespace test;

class ActionRules : public testing::TestWithParam<BadProject> {};

TEST_P(ActionRules, SayPlaceProblemAndRemedy) { expect_refused(GetParam()); }

const std::vector<BadProject> bad_actions{
    {"constraint holds nothing", [](Project& p) { p.constraints[0].displacement = {}; }, "/constraints/0/displacement",
     "holds nothing", "remove"},
    {"constraint NaN", [](Project& p) { p.constraints[0].displacement[2] = nan; }, "/constraints/0/displacement/2",
     "not a finite", "finite"},
    {"material damping", [](Project& p) { p.materials[0].damping = -1; }, "/materials/rock/damping", "not be negative",
     "1/s"},
    {"table's time",
     [](Project& p) {
       p.constraints[0].table = {{nan, {0, 0, 0}}};
     },
     "/constraints/0/table/0/0", "not a finite", "finite"},
    {"table's order",
     [](Project& p) {
       p.constraints[0].table = {{1, {0, 0, 0}}, {0.5, {0, 0, 0}}};
     },
     "/constraints/0/table/1/0", "0.5 s follows 1 s", "sort"},
    {"table's value",
     [](Project& p) {
       p.constraints[0].table = {{0, {0, 0, nan}}};
     },
     "/constraints/0/table/0/3", "is no number here", "null in every row"},
    {"table beside displacement",
     [](Project& p) { p.constraints[0].displacement[0] = 1, p.constraints[0].table = {{}}; },
     "/constraints/0/displacement/0", "beside the table", "one of displacement and table"},
    {"load's table",
     [](Project& p) {
       p.loads[0].force.setZero(), p.loads[0].table = {{0, {0, nan, 0}}};
     },
     "/loads/0/table/0/2", "not a finite", "finite"},
    {"load's order",
     [](Project& p) {
       p.loads[0].force.setZero(), p.loads[0].table = {{1, {0, 0, 0}}, {0.5, {0, 0, 0}}};
     },
     "/loads/0/table/1/0", "0.5 s follows 1 s", "sort"},
    {"place of a constraint", [](Project& p) { p.constraints[0].at = Vec3(0, nan, 0); }, "/constraints/0/at/1",
     "not a finite", "finite"},
    {"linear velocity", [](Project& p) { p.velocities[0].linear[0] = nan; }, "/velocities/0/linear/0", "not a finite",
     "finite"},
    {"table beside force", [](Project& p) { p.loads[0].table = {{}}; }, "/loads/0/force", "beside the table",
     "one of force and table"},
    {"stress", [](Project& p) { p.in_situ[0].stress[5] = nan; }, "/in_situ/0/stress/5", "not a finite", "finite"},
    {"gradient", [](Project& p) { p.in_situ[0].gradient[0] = infinity; }, "/in_situ/0/gradient/0", "not a finite",
     "finite"},
    {"level", [](Project& p) { p.in_situ[0].level = nan; }, "/in_situ/0/level", "not a finite", "finite"},
    {"force", [](Project& p) { p.loads[0].force[0] = infinity; }, "/loads/0/force/0", "not a finite", "finite"},
    {"velocity", [](Project& p) { p.velocities[0].angular[2] = nan; }, "/velocities/0/angular/2", "not a finite",
     "finite"},
};
INSTANTIATE_TEST_SUITE_P(Values, ActionRules, testing::ValuesIn(bad_actions));

}  // namespace
}  // namespace talus
