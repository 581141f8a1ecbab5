#include "unit/model/slope_project.hpp"

namespace talus {
namespace {

using namespace test;

class SolverRules : public testing::TestWithParam<BadProject> {};

TEST_P(SolverRules, SayPlaceProblemAndRemedy) { expect_refused(GetParam()); }

const std::vector<BadProject> bad_settings{
    {"spectral radius", [](Project& p) { p.solver.spectral_radius = 1.1; }, "/solver/spectral_radius", "0 to 1, is 1.1",
     "0.8 is usual"},
    {"spectral radius NaN", [](Project& p) { p.solver.spectral_radius = nan; }, "/solver/spectral_radius",
     "not a finite", "finite"},
    {"sleep tolerance NaN", [](Project& p) { p.solver.sleep_tolerance = nan; }, "/solver/sleep_tolerance",
     "not a finite", "finite"},
    {"nobody's spectral radius",
     [](Project& p) {
       p.solver.spectral_radius = 1;
       p.solver.integrator = Integrator::constant_acceleration;
     },
     "/solver/spectral_radius", "'constant-acceleration' has no spectral radius", "generalized-alpha"},
    {"penetration", [](Project& p) { p.solver.penetration_tolerance = 0; }, "/solver/penetration_tolerance",
     "greater than 0", "mesh size"},
    {"adaptive displacement", [](Project& p) { p.solver.adaptive.displacement_limit = 0; },
     "/solver/adaptive/displacement_limit", "greater than 0", "0.005 is usual"},
    {"adaptive error", [](Project& p) { p.solver.adaptive.error_limit = nan; }, "/solver/adaptive/error_limit",
     "not a finite", "finite"},
    {"adaptive iterations", [](Project& p) { p.solver.adaptive.iterations = 0; }, "/solver/adaptive/iterations",
     "at least one", "8 is usual"},
    {"adaptive shortest", [](Project& p) { p.solver.adaptive.shortest = 1.5; }, "/solver/adaptive/shortest",
     "longer than the stage's time_step", "at most 1"},
    {"adaptive shortest 0", [](Project& p) { p.solver.adaptive.shortest = 0; }, "/solver/adaptive/shortest",
     "greater than 0", "1e-3 is usual"},
    {"adaptive without", [](Project& p) { p.solver.adaptive.shortest = 0.5; }, "/solver/adaptive", "steps are fixed",
     "time_step_control"},
    {"sleep tolerance", [](Project& p) { p.solver.sleep_tolerance = -1e-9; }, "/solver/sleep_tolerance",
     "must not be negative", "0 keeps all awake"},
    {"contact stiffness", [](Project& p) { p.solver.contact_stiffness = 0; }, "/solver/contact_stiffness",
     "greater than 0", "10 is usual"},
    {"tolerance", [](Project& p) { p.solver.tolerance = 0.02; }, "/solver/tolerance", "1e-12 to 0.01", "\"standard\""},
    {"tolerance of rounding", [](Project& p) { p.solver.tolerance = 1e-13; }, "/solver/tolerance", "is 1e-13",
     "\"standard\""},
    {"tolerance NaN", [](Project& p) { p.solver.tolerance = nan; }, "/solver/tolerance", "not a finite", "finite"},
    {"open-close limit", [](Project& p) { p.solver.open_close_limit = 0; }, "/solver/open_close_limit", "at least one",
     "160 is usual"},
};
INSTANTIATE_TEST_SUITE_P(Values, SolverRules, testing::ValuesIn(bad_settings));

}  // namespace
}  // namespace talus
