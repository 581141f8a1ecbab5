#pragma once

#include <map>

#include "study/verify.hpp"
#include "widgets/run_list.hpp"

namespace talus {

class CasePage;

/// What the solver is held to, case by case: expected against computed numbers.
class KnownAnswers : public RunList {
  Q_OBJECT
 public:
  explicit KnownAnswers(std::vector<KnownCase> cases);

  /// Results of this session, in the list's order.
  std::vector<CaseResult> results() const;

 protected:
  void start(const std::vector<std::size_t>& indices, bool repeat) override;
  std::optional<RunVerdict> verdict(std::size_t index) const override;
  void showPage(std::size_t index) override;
  std::string json() const override;

 private:
  KnownAnswers(std::vector<KnownCase> cases, CasePage* page);
  const CaseResult* result(std::size_t index) const;

  std::vector<KnownCase> cases_;
  std::map<std::string, CaseResult> results_;  ///< by name
  CasePage* page_;
};

}  // namespace talus
