#pragma once

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include "command.hpp"
#include "text/markdown_page.hpp"
#include "text/paragraph.hpp"
#include "text/terminal.hpp"
#include "verification/named_runs.hpp"

namespace talus::cli {

/// What `verify` runs and prints one by one. A `Result` has a name, seconds and passed().
template <typename Result>
struct ListOfRuns {
  using Results = std::vector<Result>;
  std::string what;  ///< "cases"
  std::size_t count = 0;
  std::function<void(Progress&, const std::function<void(const Result&)>&)> run;
  std::string columns;                                   ///< above the first
  std::function<std::string(const Result&)> text;        ///< of one, as it ends
  std::function<std::string(const Results&)> summary{};  ///< of all, before the verdict; may be empty
  std::function<std::string(const Results&)> markdown;
  std::function<std::string(const Results&, bool complete)> json;
};

/// The line at the end: how many passed in how long, and which did not.
template <typename Result>
std::string verdict_text(const std::string& what, const std::vector<Result>& results) {
  double seconds = 0;
  std::string failed;
  for (const Result& result : results) {
    seconds += result.seconds;
    if (!result.passed()) failed += (failed.empty() ? "" : ", ") + result.name;
  }
  std::string text = passed_text(what, results) + ", " + duration_text(seconds) + " of computing\n";
  if (!failed.empty()) text += paragraph("failed: " + failed, 0);
  return text;
}

/// Runs the list and prints each as it ends, or all as JSON, and into the page `markdown` where that is not empty.
template <typename Result>
ExitCode run_list(const ListOfRuns<Result>& list, const std::filesystem::path& markdown, bool as_json) {
  if (!markdown.empty()) check_page(markdown);
  catch_interrupts();
  if (!as_json) std::cout << list.columns << std::flush;
  std::vector<Result> results;
  bool complete = true;
  TerminalProgress progress;
  try {
    list.run(progress, [&](const Result& result) {
      progress.clear_bar();
      if (!as_json) std::cout << list.text(result) << std::flush;
      results.push_back(result);
    });
  } catch (const Cancelled&) {
    complete = false;
  }
  progress.clear_bar();
  if (as_json)
    std::cout << list.json(results, complete);
  else
    std::cout << '\n' << (list.summary ? list.summary(results) + '\n' : "") << verdict_text(list.what, results);
  if (!complete)
    std::cerr << "talus-cli: stopped; " << list.count - results.size() << ' ' << list.what << " were not run\n";
  if (complete && !markdown.empty()) write_into_page(markdown, list.markdown(results));
  const bool passed = std::all_of(results.begin(), results.end(), [](const Result& one) { return one.passed(); });
  return complete && passed ? done : failed;
}

}  // namespace talus::cli
