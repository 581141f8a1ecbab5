#pragma once

#include <QObject>
#include <QString>
#include <filesystem>
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
  /// What was tried when it came; it goes when that is tried again.
  enum class Of { project, run, results, file, picture } of = Of::project;
  QString field{};  ///< JSON pointer of what is to be changed; empty where no field of the project mends it
  int number = 0;   ///< given by Messages
};

/// What an error says that the user can mend.
Problem problemOf(const InputError& error, Problem::Severity severity = Problem::Severity::error);
Problem problemOf(const InputError& error, Problem::Of of);
/// The same of what is wrong in or with a file, which its words leave out.
Problem problemIn(const std::filesystem::path& file, const InputError& error);

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
  /// Takes away the problems that came of the same thing when it was tried before.
  void settle(Problem::Of of);

 signals:
  void problemsChanged();
  void problemAdded(const talus::Problem& problem);
  void logged(const QString& line);

 private:
  std::vector<Problem> problems_;
  int added_ = 0;
};

}  // namespace talus
