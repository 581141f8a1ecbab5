#pragma once

#include "verification/verify.hpp"
#include "widgets/verification/case_page.hpp"
#include "widgets/verification/result_list.hpp"

namespace talus {

/// What the solver is held to, case by case: expected against computed numbers.
class KnownAnswers : public ResultList<KnownCase, CaseResult, CasePage> {
  Q_OBJECT
 public:
  explicit KnownAnswers(const std::vector<KnownCase>& cases);

 protected:
  void start(const std::vector<std::size_t>& indices, bool repeat) override;
  std::optional<RunVerdict> verdict(std::size_t index) const override;
  std::string json() const override;
};

}  // namespace talus
