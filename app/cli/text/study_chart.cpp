#include "text/study_chart.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "render/charts/log_axis.hpp"
#include "text/study_text.hpp"

namespace talus::cli {

namespace {

/// The processor's clock tells nothing shorter.
constexpr double shortest_seconds = 1e-4;

int group_of(const AccuracyRow& row, std::vector<std::string>& groups) {
  const std::string body = body_text(row.setting);
  const auto found = std::find(groups.begin(), groups.end(), body);
  const auto place = found - groups.begin();
  if (found == groups.end()) groups.push_back(body);
  return static_cast<int>(place);
}

/// Runs without an answer, which have no point.
std::string absent_text(const AccuracyStudy& study) {
  std::string text;
  for (std::size_t i = 0; i < study.rows.size(); ++i)
    if (!study.rows[i].error)
      text += (text.empty() ? "Without a point: run " : ", run ") + std::to_string(i) + " (" + study.rows[i].label +
              ": " + ending_text(study.rows[i]) + ")";
  return text.empty() ? text : text + ".";
}

std::vector<std::string> notes_of(const AccuracyStudy& study) {
  std::vector<std::string> notes;
  for (const AxisOrder& order : study.orders) notes.push_back(order_text(order));
  if (std::string absent = absent_text(study); !absent.empty()) notes.push_back(std::move(absent));
  if (!study.known_answer)
    notes.push_back("Errors are from run " + std::to_string(study.reference) + ", which is itself off by about " +
                    error_text(study.reference_error) + ".");
  if (study.repeats > 1) notes.push_back(repeats_text(study));
  if (study.target) notes.push_back(recommendation_text(study));
  return notes;
}

std::string error_title(const AccuracyStudy& study) {
  const std::string of = study.repeats > 1 ? "Mean of " + std::to_string(study.repeats) + " runs ± spread" : "Error";
  return of + (study.known_answer ? ": largest relative difference from the known answer"
                                  : " " + measure_text(study.measure) + ": relative difference from the finest run");
}

}  // namespace

CostPlot cost_plot(const AccuracyStudy& study, Theme theme) {
  CostPlot plot;
  plot.title = study.project_name + ": what accuracy costs";
  plot.error_title = error_title(study);
  plot.theme = theme;
  plot.target = study.target;
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    const AccuracyRow& row = study.rows[i];
    if (!row.error) continue;
    CostPoint point;
    point.number = static_cast<int>(i);
    point.label = row.label;
    point.seconds = std::max(row.run->cpu_seconds, shortest_seconds);
    point.error = *row.error;
    point.uncertainty = row.error_estimate;
    point.spread = row.spread;
    point.group = group_of(row, plot.groups);
    point.on_front = row.pareto;
    point.recommended = static_cast<int>(i) == study.recommended;
    plot.points.push_back(std::move(point));
  }
  if (plot.points.empty())
    throw InputError(study.project_file, "no run of the study came to an answer", "see the notes in accuracy.csv");
  plot.notes = notes_of(study);
  return plot;
}

}  // namespace talus::cli
