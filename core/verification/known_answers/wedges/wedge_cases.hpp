#pragma once

#include <vector>

#include "verification/known_answers/support/known_case.hpp"
#include "verification/known_answers/wedges/wedge_motion.hpp"
#include "verification/known_answers/wedges/wedge_test_table.hpp"

/// The cases of rock wedges, one function each.
namespace talus {

/// All of them: the roof wedge and the wedge tests in the mould block.
std::vector<KnownCase> wedge_cases();

/// Wedges with factors of safety between 0.9 and 1.35 are thresholds: moments, and friction between the two planes,
/// which limit equilibrium leaves out, decide them (docs/validation.md). They are reported, never held to.
constexpr bool at_threshold(double factor_of_safety) { return factor_of_safety >= 0.9 && factor_of_safety <= 1.35; }

/// One of the 65 tests: the wedge meshed with 8^refinements tetrahedra, pressed into its mould by a static stage and
/// then let go for `duration` [s].
CaseScene wedge_test_scene(const WedgeTest& test, double friction_angle, int refinements, double duration);

/// The same, run until the wedge has gone 10 % of its length, lies still, or a second has passed. Where the solver does
/// not converge there is no mode, nor a direction.
WedgeMotion run_wedge_test(const WedgeTest& test, double friction_angle, int refinements, const CaseOptions& options,
                           Progress& progress);

/// All 65 tests beside limit equilibrium, the paper's coupled method and the physical models.
CaseOutcome wedge_tests_case(const CaseOptions& options, Progress& progress);
/// The same at other friction angles: which of them explains the physical models?
CaseOutcome wedge_friction_sweep(const CaseOptions& options, Progress& progress);
/// Acceleration and factor of safety of two of the tests, from motion and from contact forces.
CaseOutcome sliding_wedge_case(const CaseOptions& options, Progress& progress);
/// Plunge and critical friction angle of the wedge between 40°/130° and 60°/220°.
CaseOutcome critical_wedge_case(const CaseOptions& options, Progress& progress);
/// Tetrahedral wedge in a roof, held by horizontal stress.
CaseOutcome roof_wedge_case(const CaseOptions& options, Progress& progress);

}  // namespace talus
