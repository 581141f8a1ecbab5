#include "verification/verify.hpp"

#include <algorithm>
#include <exception>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/part_of_progress.hpp"
#include "base/stopwatch.hpp"
#include "verification/known_answers/known_cases.hpp"
#include "verification/known_sample.hpp"
#include "verification/named_runs.hpp"
#include "verification/repetition.hpp"

namespace talus {

namespace {

auto find_named(const std::vector<KnownCase>& cases, const std::string& name) {
  const auto of_name = [&cases](const std::string& wanted) {
    return std::find_if(cases.begin(), cases.end(), [&](const KnownCase& known) { return known.name == wanted; });
  };
  const auto found = of_name(name);
  return found == cases.end() ? of_name(sample_prefix + name) : found;
}

/// What is wrong with the outcome itself; empty: nothing.
std::string fault_of(const CaseOutcome& outcome) {
  if (outcome.findings.empty()) return "computed no number that is known";
  for (const CaseTable& table : outcome.tables)
    for (const auto& row : table.rows)
      if (row.size() != table.columns.size()) return "a row of the table '" + table.title + "' has not its columns";
  return {};
}

/// The case's outcome, or why there is none.
void run_into(CaseResult& result, const KnownCase& known, Progress& progress) {
  const Stopwatch watch(result.seconds);
  const ThreadLimit limit(result.options.threads);
  try {
    result.outcome = known.run(result.options, progress);
    result.failure = fault_of(result.outcome);
  } catch (const std::exception& error) {
    result.failure = error.what();
  }
}

Repetition repeated(const CaseResult& first, const KnownCase& known, const CaseOptions& options, Progress& progress) {
  CaseResult second;
  second.options = options;
  run_into(second, known, progress);
  return compared(first, second);
}

CaseOptions on_other_threads(CaseOptions options) {
  options.threads = options.threads == 1 ? 2 : 1;
  return options;
}

CaseOptions at_other_scale(CaseOptions options) {
  options.scale *= repeated_scale;
  return options;
}

}  // namespace

std::vector<KnownCase> all_cases(const std::filesystem::path& samples) {
  std::vector<KnownCase> cases;
  for (const KnownSample& sample : find_known_samples(samples)) cases.push_back(case_of(sample));
  for (KnownCase& known : known_cases()) cases.push_back(std::move(known));
  return cases;
}

std::vector<KnownCase> chosen_cases(const std::vector<KnownCase>& cases, const std::vector<std::string>& names,
                                    bool all, BodyKind body) {
  const auto fits = [body](const KnownCase& known) { return body == BodyKind::tetrahedra || known.of_any_body; };
  std::vector<KnownCase> chosen;
  for (const std::string& name : names) {
    const auto found = find_named(cases, name);
    if (found == cases.end()) throw none_of_that_name("case", name, cases);
    if (!fits(*found))
      throw InputError(
          "case '" + found->name + "'",
          "asks for strain, which " + std::string(to_string(body)) + " blocks do not have or not fine enough",
          "run it with tetrahedra");
    chosen.push_back(*found);
  }
  if (names.empty())
    std::copy_if(cases.begin(), cases.end(), std::back_inserter(chosen),
                 [&](const KnownCase& known) { return fits(known) && (all || !known.takes_long); });
  return chosen;
}

bool CaseResult::passed() const {
  return failure.empty() && outcome.passed() &&
         std::all_of(repetitions.begin(), repetitions.end(), [](const Repetition& r) { return r.passed; });
}

CaseResult verify(const KnownCase& known, const VerifyOptions& options, Progress& progress) {
  CaseResult result{known.name, known.title, known.source, options.run, {}, {}, 0, {}};
  if (!known.scales) result.options.scale = 1;
  std::vector<CaseOptions> repetitions;
  if (options.repeat) repetitions.push_back(on_other_threads(result.options));
  if (options.repeat && known.scales) repetitions.push_back(at_other_scale(result.options));

  const double share = 1 / (1 + static_cast<double>(repetitions.size()));
  PartOfProgress first(progress, 0, share, "");
  run_into(result, known, first);
  if (!result.failure.empty()) return result;
  for (const CaseOptions& again : repetitions) {
    PartOfProgress next(progress, share * static_cast<double>(1 + result.repetitions.size()), share, "again");
    result.repetitions.push_back(repeated(result, known, again, next));
  }
  return result;
}

void verify(const std::vector<KnownCase>& cases, const VerifyOptions& options, Progress& progress,
            const std::function<void(const CaseResult&)>& ended) {
  run_in_turn(cases, progress, [&](const KnownCase& known, Progress& part) { ended(verify(known, options, part)); });
}

}  // namespace talus
