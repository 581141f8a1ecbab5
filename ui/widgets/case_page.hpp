#pragma once

#include <QScrollArea>
#include <optional>

#include "study/verify.hpp"
#include "widgets/parts.hpp"

namespace talus {

/// One case with a known answer: where the answer comes from, and what the last run of it came to.
class CasePage : public QWidget {
  Q_OBJECT
 public:
  CasePage();
  /// `result` may be null: not run yet.
  void show(const KnownCase& known, const CaseResult* result);

 private:
  void addFindings(const CaseResult& result);
  void addSentences(const CaseResult& result);
  void addTable(const CaseTable& table);
  void addSentence(const QString& text, const char* role = nullptr);

  QLabel *title_, *verdict_;
  QVBoxLayout* content_;
};

}  // namespace talus
