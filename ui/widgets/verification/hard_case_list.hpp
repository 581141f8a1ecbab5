#pragma once

#include "verification/verify_hard_cases.hpp"
#include "widgets/verification/result_list.hpp"
#include "widgets/verification/trial_page.hpp"

namespace talus {

/// The cases chosen to break contact codes: what each must come to, what it came to, and what no case may break.
class HardCaseList : public ResultList<HardCase, Trial, TrialPage> {
  Q_OBJECT
 public:
  explicit HardCaseList(const std::vector<HardCase>& cases);

 protected:
  void start(const std::vector<std::size_t>& indices, bool repeat) override;
  std::optional<RunVerdict> verdict(std::size_t index) const override;
  std::string json() const override;
};

}  // namespace talus
