#pragma once

#include <functional>
#include <map>
#include <utility>

#include "widgets/verification/run_list.hpp"

namespace talus {

/// A list of cases that each come to a result of the same name; the page shows a case with its result.
template <class Case, class Result, class Page>
class ResultList : public RunList {
 public:
  /// Results of this session, in the list's order.
  std::vector<Result> results() const {
    std::vector<Result> ordered;
    for (std::size_t i = 0; i < cases_.size(); ++i)
      if (const Result* came = result(i)) ordered.push_back(*came);
    return ordered;
  }

 protected:
  ResultList(RunListWords words, std::vector<RunItem> items, std::vector<Case> cases, Page* page,
             Qt::Orientation orientation)
      : RunList(std::move(words), std::move(items), page, orientation), cases_(std::move(cases)), page_(page) {}

  /// Starts `job()`: `run(chosen, progress, ended)` works these cases off on the job's thread.
  template <class Run>
  void startJob(const std::vector<std::size_t>& indices, Run run) {
    std::vector<Case> chosen;
    for (const std::size_t index : indices) chosen.push_back(cases_[index]);
    job().template start<Result>([chosen = std::move(chosen), run = std::move(run)](
                                     Progress& progress, const auto& ended) { run(chosen, progress, ended); },
                                 [this](const Result& result) {
                                   results_.insert_or_assign(result.name, result);
                                   takeEnded();
                                 });
  }
  /// Null where it has not been run.
  const Result* result(std::size_t index) const {
    const auto found = results_.find(cases_[index].name);
    return found == results_.end() ? nullptr : &found->second;
  }
  void showPage(std::size_t index) override { page_->show(cases_[index], result(index)); }

 private:
  std::vector<Case> cases_;
  std::map<std::string, Result> results_;  ///< by name
  Page* page_;
};

}  // namespace talus
