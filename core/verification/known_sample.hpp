#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "results/run_report.hpp"
#include "verification/known_answers/support/known_case.hpp"
#include "verification/reference_events.hpp"

namespace talus {

/// A shipped project with a known answer: `expect` lines, or published events in paper_events.csv beside it.
struct KnownSample {
  std::string name;   ///< of its folder
  std::string title;  ///< the project's name
  std::filesystem::path project;
  std::filesystem::path events;  ///< empty: none published
  std::string source;            ///< of the expected numbers
  bool takes_long = false;       ///< more than `quick_steps` time steps
  bool of_any_body = false;      ///< it asks for no stress: rigid and affine blocks must come to the same answer
};

/// Samples of more time steps than this run only when asked for: the others take a second or two.
inline constexpr int quick_steps = 5000;

/// The samples in DIR/NAME/NAME.talus that have a known answer, by name. Throws InputError when `folder` is no folder
/// or a project in it is faulty.
std::vector<KnownSample> find_known_samples(const std::filesystem::path& folder);

struct SampleOutcome {
  RunReport report;
  std::vector<EventComparison> events;
};

/// Meshes and runs a project in a temporary folder, at the scale that is asked for. A run that does not converge is a
/// status of the report. Throws InputError for a faulty project, Cancelled when `progress` says so.
SampleOutcome run_sample(const KnownSample& sample, const CaseOptions& options, Progress& progress);

/// What a sample's case is called before its folder's name: no built-in case's name holds a slash.
inline const std::string sample_prefix = "samples/";

/// Every `expect` line is a finding; published events are held to their order, and their times are shown.
KnownCase case_of(const KnownSample& sample);

}  // namespace talus
