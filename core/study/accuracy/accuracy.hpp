#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/accuracy/convergence_order.hpp"
#include "study/accuracy/study_run.hpp"

/// What a ladder of runs says together: how good each setting is, what it costs, and which is the cheapest good one.
namespace talus {

struct AccuracyRow {
  Setting setting;
  std::string label;
  std::optional<StudyRun> run;        ///< of repeats the mean; none: not run yet, or it ended without a word
  std::optional<double> error;        ///< relative: from the known answer, else from the finest run
  double error_estimate = 0;          ///< by how much that may be wrong; 0 from a known answer
  std::optional<double> from_finest;  ///< relative, also where the answer is known: what the study would have claimed
  std::optional<double> spread;       ///< relative, of one repeat about their mean: standard deviation
  double standard_error = 0;          ///< relative, of the mean: part of `error_estimate`
  bool pareto = false;                ///< no run that costs no more has less error
  std::string note;
};

/// How a run without an error ended, in words: "not converged", "failed", "not run"; "–" where it gave too little.
std::string ending_text(const AccuracyRow& row);

/// Errors along one axis, everything else being the project's own.
struct AxisOrder {
  StudyAxis axis = StudyAxis::time_step;
  std::optional<double> theory;  ///< none: none is expected
  OrderFit fit;
  std::vector<int> runs;      ///< finest first
  std::vector<int> cut_runs;  ///< of the axis, but most of their steps were cut: they have another step than they say
};

struct AccuracyStudy {
  std::string project_name;
  std::string project_file;
  bool known_answer = false;
  StudyMeasure measure = StudyMeasure::displacement;  ///< without a known answer
  int reference = -1;                                 ///< the finest run that completed; −1: none did
  double reference_error = 0;                         ///< its estimated error: the sum over the axes
  std::vector<AccuracyRow> rows;
  std::vector<AxisOrder> orders;
  std::vector<LeftOut> left_out;
  int repeats = 1;                 ///< of each setting; errors are of their means
  std::optional<double> scatter;   ///< relative, of one repeat about the mean of its setting, over all settings
  std::optional<bool> told_apart;  ///< means of settings differ by more than repeats scatter; empty: one run each
  std::optional<double> target;
  int recommended = -1;  ///< the cheapest whose error, with its estimate, is within the target; −1: none, or no target

  bool complete() const;  ///< every run has ended
};

/// Of the runs that have ended so far. Throws InputError for a file that cannot be understood.
AccuracyStudy evaluate(const StudyFolder& study, std::optional<double> target);

/// Takes another target, or none, and chooses the cheapest run that meets it.
void set_target(AccuracyStudy& study, std::optional<double> target);

}  // namespace talus
