#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "verification/known_answers/support/known_case.hpp"

/// Holds the solver to known answers: one list of cases, one way to run them.
namespace talus {

/// The samples with a known answer in the folder `samples`, then the cases that are built in the program. Every name is
/// there once: a sample's is samples/NAME, a built-in case's one word. Throws InputError when `samples` is no folder or
/// holds a faulty project.
std::vector<KnownCase> all_cases(const std::filesystem::path& samples);

/// Those named, in that order; without names all that are quick, or all. A sample is also found by its folder's name
/// alone where no built-in case has it. For other bodies than tetrahedra only those that ask for no strain. Throws
/// InputError for a name there is not, or a case that does not make sense for these bodies.
std::vector<KnownCase> chosen_cases(const std::vector<KnownCase>& cases, const std::vector<std::string>& names,
                                    bool all, BodyKind body = BodyKind::tetrahedra);

/// What came of running a case once more under other circumstances that must not matter.
struct Repetition {
  CaseOptions options;
  bool same_bits = false;  ///< of all computed numbers, tables and remarks
  /// Between Finding::relative of the two runs, over the larger where that is above one.
  struct Difference {
    double value = 0;
    std::string quantity;  ///< where it is largest; empty: there is no such number, or none differs
  };
  Difference largest;     ///< of numbers whose expected one is not zero
  Difference about_zero;  ///< of the others: in units of their tolerance
  std::string failure;    ///< why it came to no numbers that can be compared; empty: it did
  bool passed = false;
};

struct CaseResult {
  std::string name, title, source;
  CaseOptions options;
  CaseOutcome outcome;
  std::string failure;  ///< why the case came to no answer; empty: it did
  double seconds = 0;   ///< wall time of the first run
  std::vector<Repetition> repetitions;
  bool passed() const;  ///< it came to an end, all that is held was met, and no repetition differs
};

struct VerifyOptions {
  CaseOptions run;
  /// Also once more on two threads (on one, where `run` has several), which must give the same bits, and at a tenth of
  /// the scale, which must give the same relative numbers: within the case's `same_at_any_scale`, or, where zero is
  /// expected, within `noise_about_zero` of the tolerance, since round-off does not scale.
  bool repeat = false;
};
inline constexpr double repeated_scale = 0.1;
inline constexpr double same_at_any_scale = 1e-6;
inline constexpr double noise_about_zero = 1e-2;

/// Runs a case. Whatever it throws is its failure; only Cancelled goes on to the caller. A case whose answer belongs to
/// one scale runs at scale 1.
CaseResult verify(const KnownCase& known, const VerifyOptions& options, Progress& progress);

/// Runs all of them and hands each result on as it comes. Throws Cancelled when `progress` says so.
void verify(const std::vector<KnownCase>& cases, const VerifyOptions& options, Progress& progress,
            const std::function<void(const CaseResult&)>& ended);

}  // namespace talus
