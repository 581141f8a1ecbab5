#pragma once

#include "base/progress.hpp"
#include "study/cases/case_plan.hpp"

namespace talus {

/// Cuts, meshes and solves case `number` on one thread, measures what it came to, and writes its file once it has
/// ended, however it ended. One that was killed goes on from its checkpoint. What the user could mend in the case, and
/// that it did not converge, are a status. Throws Cancelled, and InputError where its results cannot be written.
void perform_case(const CaseFolder& study, int number, Progress& progress);

}  // namespace talus
