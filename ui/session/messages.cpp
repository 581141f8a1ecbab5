#include "session/messages.hpp"

#include "base/error.hpp"

namespace talus {

Problem problemOf(const InputError& error, Problem::Severity severity) {
  return {severity, QString::fromStdString(error.place()), QString::fromStdString(error.problem()),
          QString::fromStdString(error.remedy())};
}

void Messages::add(const Problem& problem) {
  problems_.push_back(problem);
  log(QStringLiteral("%1: %2; %3").arg(problem.place, problem.problem, problem.remedy));
  emit problemAdded(problem);
  emit problemsChanged();
}

void Messages::clear() {
  problems_.clear();
  emit problemsChanged();
}

void Messages::clearTroubles() {
  std::erase_if(problems_, [](const Problem& problem) { return problem.where.has_value(); });
  emit problemsChanged();
}

}  // namespace talus
