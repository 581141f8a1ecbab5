#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "model/project.hpp"

/// Cases with a known answer: what a user may hold the solver to (docs/validation.md).
namespace talus {

struct CaseOptions {
  double scale = 1;       ///< of all lengths; times go with its square root, stresses and moduli with itself
  int threads = 1;        ///< at most
  bool thorough = false;  ///< every row and angle of a case that is thinned otherwise
  BodyKind body = BodyKind::tetrahedra;  ///< of the blocks that are meshed with tetrahedra otherwise
  std::optional<double> tolerance{};     ///< SolverSettings::tolerance, in place of the project's
  std::optional<Preset> preset{};        ///< the scheme that all of it is solved by, in place of the project's
};

/// One computed number held against a known one. All three numbers belong to the scale that was asked for: a case
/// scales what it expects, and an absolute tolerance, as it scales its scene; `relative` is then the same at any scale.
struct Finding {
  std::string quantity;  ///< "acceleration", "critical friction angle"
  std::string unit{};    ///< "" for a pure number
  double expected = 0, computed = 0;
  double tolerance = 0;   ///< relative to |expected|; in the unit itself where `absolute`
  bool absolute = false;  ///< always where expected is zero
  bool reported = false;  ///< shown beside the expected number but not held to it; the case says why

  double error() const;
  bool passed() const;  ///< a number that is not finite never passes
  /// What was computed over what was expected; over the tolerance where zero was; as it is where both are zero.
  double relative() const;
};

/// More than a number: the rows of the wedge tests, a chart's points.
struct CaseTable {
  std::string title;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
  bool holds_words(std::size_t column) const;  ///< some cell is neither a number nor empty nor "–"
};

struct CaseOutcome {
  std::vector<Finding> findings;
  std::vector<CaseTable> tables;
  std::vector<std::string> remarks;  ///< what falls short and why, in figures
  bool passed() const;               ///< all findings that are not only reported
};

/// A case: what it is, where its answer comes from, and how it is computed. `run` throws Cancelled when told to, and
/// std::runtime_error with contact and place where the solver does not converge.
struct KnownCase {
  std::string name;    ///< one_word, for the command line
  std::string title;   ///< a line for tables
  std::string source;  ///< of the expected numbers
  bool takes_long = false;
  bool thinned = false;      ///< has rows that only a thorough run computes
  bool scales = true;        ///< the answer is the same, in relative terms, at any scale
  bool of_any_body = false;  ///< rigid and affine blocks must come to the same answer: it asks for no strain
  std::function<CaseOutcome(const CaseOptions&, Progress&)> run;
};

/// A case that speaks of full size, made to say what was computed at its scale: findings in m are multiplied by s,
/// those in s and m/s by √s.
KnownCase at_any_scale(KnownCase full_size);

}  // namespace talus
