#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "results/run_report.hpp"
#include "study/reference_events.hpp"

namespace talus {

/// A shipped project with a known answer: `expect` lines, or published events in paper_events.csv beside it.
struct Sample {
  std::string name;  ///< of its folder
  std::filesystem::path project;
  std::filesystem::path events;  ///< empty: none published
  bool takes_long = false;       ///< more than `quick_steps` time steps
};

/// Samples of more time steps than this run only when asked for: the others take a second or two.
inline constexpr int quick_steps = 5000;

/// The samples in DIR/NAME/NAME.talus that have a known answer, by name. Throws InputError when `folder` is no folder
/// or a project in it is faulty.
std::vector<Sample> find_samples(const std::filesystem::path& folder);

struct SampleOutcome {
  std::string name;
  double seconds = 0;  ///< wall time of meshing and run
  RunReport report;
  std::vector<EventComparison> events;
  bool passed = false;  ///< completed, every expectation met, every published event in order
};

/// Runs a sample in a temporary folder and holds it against its known answer. Throws Cancelled when `progress` says so.
SampleOutcome verify(const Sample& sample, int threads, Progress& progress);

}  // namespace talus
