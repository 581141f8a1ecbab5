#pragma once

#include <map>

#include "study/verify_stability.hpp"
#include "widgets/run_list.hpp"

namespace talus {

class TrialPage;

/// The scenes chosen to break contact codes: what each must come to, what it came to, and what no scene may break.
class StabilityList : public RunList {
  Q_OBJECT
 public:
  explicit StabilityList(std::vector<StabilityScene> scenes);

  /// Trials of this session, in the list's order.
  std::vector<Trial> trials() const;

 protected:
  void start(const std::vector<std::size_t>& indices, bool repeat) override;
  std::optional<RunVerdict> verdict(std::size_t index) const override;
  void showPage(std::size_t index) override;
  std::string json() const override;

 private:
  StabilityList(std::vector<StabilityScene> scenes, TrialPage* page);
  const Trial* trial(std::size_t index) const;

  std::vector<StabilityScene> scenes_;
  std::map<std::string, Trial> trials_;  ///< by name
  TrialPage* page_;
};

}  // namespace talus
