#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/vector.hpp"

/// Where a step of a run hardly converges, as data: the same place is told in words, in tables and in the picture.
namespace talus {

/// Why a trial step was hard, or ended the run; the gravest last.
enum class TroubleCause { many_iterations, missed_contact, not_converged, inverted, interpenetrating };

/// The word summary.json uses.
constexpr std::string_view to_string(TroubleCause cause) {
  switch (cause) {
    case TroubleCause::many_iterations:
      return "many-iterations";
    case TroubleCause::missed_contact:
      return "missed-contact";
    case TroubleCause::not_converged:
      return "not-converged";
    case TroubleCause::inverted:
      return "inverted-tetrahedron";
    case TroubleCause::interpenetrating:
      break;
  }
  return "interpenetrating";
}

/// One hard trial step, or all of a run between the same two blocks: then place, time and cause are those of the
/// hardest.
struct ConvergenceTrouble {
  TroubleCause cause = TroubleCause::many_iterations;
  /// That touch there. The second is empty where one block is concerned alone; both are where no place can be told.
  std::array<std::string, 2> blocks{};
  std::string joint{};           ///< of the contact; empty where there is none
  Vec3 position = Vec3::Zero();  ///< m, at `time`
  /// Where that place lay before the run, as a point of a block at the contact [m]: with it a picture follows the
  /// block.
  Vec3 rest_position = Vec3::Zero();
  double time = 0;                  ///< s, at the start of the trial step
  int step = 0;                     ///< number of the step
  double relative_penetration = 0;  ///< of the contact, of the local mesh size, at the start of the trial step
  long iterations = 0;              ///< open–close iterations spent
  int most_iterations = 0;          ///< in one trial step
  int cuts = 0;                     ///< how often the step was cut because of it
  bool ended_run = false;           ///< no shorter step was left to try: the run has not converged
  std::string advice{};             ///< what to change

  void archive(auto& state) {
    state(cause, blocks, joint, position, rest_position, time, step, relative_penetration, iterations);
    state(most_iterations, cuts, ended_run, advice);
  }
};

/// "base – cube", "block cube"; empty where no place can be told.
std::string contact_text(const ConvergenceTrouble& trouble);
/// "(1.25, 3, 0) m", with four significant digits.
std::string position_text(const ConvergenceTrouble& trouble);
/// Why the run ended: what happened, when, where, and what to change.
std::string failure_text(const ConvergenceTrouble& trouble);

/// The hard places of a run, a pair of blocks each.
class TroubleList {
 public:
  void add(const ConvergenceTrouble& trouble);
  bool empty() const { return places_.empty(); }
  /// The hardest first: where the run ended, then by steps cut, then by iterations; at most `most`.
  std::vector<ConvergenceTrouble> hardest(std::size_t most = 5) const;

  void archive(auto& state) { state(places_); }

 private:
  std::vector<ConvergenceTrouble> places_;
};

}  // namespace talus
