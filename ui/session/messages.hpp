#pragma once

#include <QObject>
#include <QString>
#include <optional>
#include <vector>

#include "results/convergence_trouble.hpp"

namespace talus {

class InputError;

/// Something the user should know: what, where, remedy.
struct Problem {
  enum class Severity { info, warning, error };
  Severity severity = Severity::error;
  QString place, problem, remedy;
  std::optional<ConvergenceTrouble> where{};  ///< to be shown in the view
};

/// What an error says that the user can mend.
Problem problemOf(const InputError& error, Problem::Severity severity = Problem::Severity::error);

/// What the window tells its user: the problems since a file was opened, and a log line for all that happens.
class Messages : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  const std::vector<Problem>& problems() const { return problems_; }
  void add(const Problem& problem);
  void log(const QString& line) { emit logged(line); }
  /// Another file has been opened.
  void clear();
  /// Takes away the problems that have a place in the view: they were of the run before.
  void clearTroubles();

 signals:
  void problemsChanged();
  void problemAdded(const talus::Problem& problem);
  void logged(const QString& line);

 private:
  std::vector<Problem> problems_;
};

}  // namespace talus
