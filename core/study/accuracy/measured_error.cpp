#include "study/accuracy/measured_error.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "model/quantity.hpp"

namespace talus {

namespace {

Quantity::Field field_of(const Expectation& expectation) {
  const auto quantity = parse_quantity(expectation.quantity);
  return quantity ? quantity->field : Quantity::Field::displacement;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

double norm(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum);
}

double norm_of_difference(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
  return norm(a);
}

std::vector<double> or_none(const std::optional<double>& value) {
  return value ? std::vector{*value} : std::vector<double>{};
}

/// Empty: there is nothing of it.
std::vector<double> measured(StudyMeasure measure, const StudyRun& run) {
  const StudyTravel& travel = run.travel;
  std::vector<double> answer;
  switch (measure) {
    case StudyMeasure::run_out:
      return {travel.run_out};
    case StudyMeasure::deposit:
      return {travel.mean.x(), travel.mean.y(), travel.mean.z(), travel.extent_growth};
    case StudyMeasure::start:
      return or_none(travel.start);
    case StudyMeasure::end:
      return or_none(travel.end);
    case StudyMeasure::stress:
      for (const StudyMoment& moment : run.moments)
        for (const Voigt& stress : moment.stresses) answer.insert(answer.end(), stress.begin(), stress.end());
      break;
    case StudyMeasure::displacement:
      for (const StudyMoment& moment : run.moments)
        for (const Vec3& u : moment.displacements) answer.insert(answer.end(), u.begin(), u.end());
      break;
  }
  return answer;
}

/// What differences are taken over; where nothing moves they are what they are.
double scale_of(const StudyAnswer& reference) {
  const double scale = norm(reference.mean);
  return scale > 0 ? scale : 1;
}

}  // namespace

ErrorMeasure::ErrorMeasure(const Project& project, std::optional<StudyMeasure> measure)
    : measure_(measure.value_or(StudyMeasure::displacement)) {
  if (measure) return;
  std::map<Quantity::Field, double> largest;
  for (const Expectation& e : project.expect) {
    double& of_its_kind = largest[field_of(e)];
    of_its_kind = std::max(of_its_kind, std::abs(e.value));
  }
  for (const Expectation& e : project.expect) {
    const double zero_scale = largest[field_of(e)] > 0 ? largest[field_of(e)] : e.tolerance;
    scales_.push_back(e.value != 0 ? std::abs(e.value) : zero_scale > 0 ? zero_scale : 1);
    expected_.push_back(e.value / scales_.back());
  }
}

std::vector<double> ErrorMeasure::numbers_of(const StudyRun& run) const {
  std::vector<double> answer;
  if (run.status != StudyStatus::completed) return answer;
  if (known()) {
    for (std::size_t i = 0; i < run.expect.size(); ++i) {
      if (!run.expect[i].reached) return {};
      answer.push_back(run.expect[i].computed / scales_[i]);
    }
    return answer;
  }
  return measured(measure_, run);
}

std::optional<StudyAnswer> ErrorMeasure::mean_answer(const std::vector<StudyRun>& repeats) const {
  std::vector<std::vector<double>> answers;
  for (const StudyRun& run : repeats) {
    answers.push_back(numbers_of(run));
    if (answers.back().empty() || answers.back().size() != answers.front().size()) return std::nullopt;
  }
  if (answers.empty()) return std::nullopt;
  StudyAnswer answer{std::vector<double>(answers.front().size(), 0.0), {}, static_cast<int>(answers.size())};
  answer.deviation = answer.mean;
  const double runs = answer.runs;
  for (std::size_t i = 0; i < answer.mean.size(); ++i) {
    for (const auto& one : answers) answer.mean[i] += one[i] / runs;
    double squares = 0;
    for (const auto& one : answers) squares += (one[i] - answer.mean[i]) * (one[i] - answer.mean[i]);
    if (answer.runs > 1) answer.deviation[i] = std::sqrt(squares / (runs - 1));
  }
  return answer;
}

std::optional<double> ErrorMeasure::from_known(const StudyAnswer& answer) const {
  if (!known() || answer.mean.size() != expected_.size()) return std::nullopt;
  return largest_difference(answer.mean, expected_);
}

std::optional<double> ErrorMeasure::between(const StudyAnswer& a, const StudyAnswer& b,
                                            const StudyAnswer& reference) const {
  if (a.mean.size() != b.mean.size()) return std::nullopt;
  if (known()) return largest_difference(a.mean, b.mean);
  return norm_of_difference(a.mean, b.mean) / scale_of(reference);
}

double ErrorMeasure::spread(const StudyAnswer& answer, const StudyAnswer& reference) const {
  if (known()) return *std::max_element(answer.deviation.begin(), answer.deviation.end());
  return norm(answer.deviation) / scale_of(reference);
}

}  // namespace talus
