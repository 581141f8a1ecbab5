#include "model/number_text.hpp"
#include "render/scene/block_surface.hpp"
#include "report/sections.hpp"
#include "report/words.hpp"

namespace talus::report {

namespace {

const char* words_of(TroubleCause cause) {
  switch (cause) {
    case TroubleCause::many_iterations:
      return "many iterations";
    case TroubleCause::missed_contact:
      return "a contact that could not be foreseen";
    case TroubleCause::not_converged:
      return "did not converge";
    case TroubleCause::inverted:
      return "a tetrahedron turned inside out";
    case TroubleCause::interpenetrating:
      break;
  }
  return "blocks lay in each other";
}

/// m, of the blocks as they were cut.
double extent(const BlockSystem& system) {
  const Eigen::AlignedBox3d box = bounds(system);
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

}  // namespace

Section hard_places(const RunRecord& run) {
  Section section{"Where it was hard", {}};
  if (!run.report) return section;
  if (run.report->troubles.empty()) {
    section.parts.emplace_back(
        Paragraph{"Nowhere: no step was cut because it did not converge, and none took more than 25 iterations."});
    return section;
  }
  Table table{"",
              {"Contact", "Joint", "Place (m)", "Time (s)", "Why", "Steps cut", "Iterations", "What to change"},
              "lllrlrrl",
              {}};
  const int decimals = decimals_for(extent(run.system()), 5);
  for (const ConvergenceTrouble& trouble : run.report->troubles)
    table.rows.push_back({trouble.blocks[0].empty() ? "no place" : contact_text(trouble),
                          trouble.joint.empty() ? "–" : trouble.joint, vector_text(trouble.position, decimals),
                          given(trouble.time), words_of(trouble.cause), count_text(trouble.cuts),
                          count_text(trouble.iterations), trouble.advice});
  section.parts.emplace_back(Paragraph{run.report->troubles.front().ended_run
                                           ? "The run ended at the first of these places."
                                           : "Steps were cut here, or took more than 25 iterations; the run went on, "
                                             "and every accepted step converged. The hardest places first:"});
  section.parts.emplace_back(table);
  return section;
}

}  // namespace talus::report
