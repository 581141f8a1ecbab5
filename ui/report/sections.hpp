#pragma once

#include "report/document.hpp"
#include "report/run_record.hpp"

/// The sections of a report, in its order; one without parts is left out.
namespace talus::report {

/// How the run ended, how far blocks went, and whether it came to what was expected of it.
Section answer(const RunRecord& run);
/// Materials, joints and their attitudes, blocks and mesh.
Section model(const RunRecord& run);
/// The first and the last frame, from one place. Throws std::runtime_error where no off-screen OpenGL is to be had.
Section pictures(const RunRecord& run);
/// Stages, and by what scheme they were solved.
Section settings(const RunRecord& run);
/// Which effects were on and off, why, and what they cost.
Section effects(const RunRecord& run);
/// The blocks that went farthest, and the histories of monitors.
Section motion(const RunRecord& run);
/// How far the rock came that moved, where it lies, and how fast its front was.
Section slide(const RunRecord& run);
/// What happened, in order.
Section events(const RunRecord& run);
/// What joints carry in the last frame.
Section contacts(const RunRecord& run);
/// Where the energy went, and what the ledger misses.
Section energy(const RunRecord& run);
/// How exact the run was, and what it took.
Section accuracy_and_cost(const RunRecord& run);
/// Where steps hardly converged, and what to change.
Section hard_places(const RunRecord& run);

}  // namespace talus::report
