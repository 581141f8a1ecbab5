#pragma once

#include "verification/verify.hpp"
#include "widgets/verification/outcome_page.hpp"

namespace talus {

/// One case with a known answer: where the answer comes from, and what the last run of it came to.
class CasePage : public OutcomePage {
  Q_OBJECT
 public:
  /// `result` may be null: not run yet.
  void show(const KnownCase& known, const CaseResult* result);

 private:
  void addFindings(const CaseResult& result);
  void addSentences(const CaseResult& result);
  void addTable(const CaseTable& table);
};

}  // namespace talus
