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

}  // namespace

ErrorMeasure::ErrorMeasure(const Project& project) {
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

std::vector<double> ErrorMeasure::answer_of(const StudyRun& run) const {
  std::vector<double> answer;
  if (run.status != StudyStatus::completed) return answer;
  if (known()) {
    for (std::size_t i = 0; i < run.expect.size(); ++i) {
      if (!run.expect[i].reached) return {};
      answer.push_back(run.expect[i].computed / scales_[i]);
    }
    return answer;
  }
  for (const StudyMoment& moment : run.moments)
    for (const Vec3& u : moment.displacements) answer.insert(answer.end(), u.begin(), u.end());
  return answer;
}

std::optional<double> ErrorMeasure::from_known(const StudyRun& run) const {
  const std::vector<double> answer = answer_of(run);
  if (!known() || answer.size() != expected_.size()) return std::nullopt;
  return largest_difference(answer, expected_);
}

std::optional<double> ErrorMeasure::between(const StudyRun& a, const StudyRun& b, const StudyRun& reference) const {
  const std::vector<double> of_a = answer_of(a), of_b = answer_of(b);
  if (of_a.empty() || of_a.size() != of_b.size()) return std::nullopt;
  if (known()) return largest_difference(of_a, of_b);
  const double scale = norm(answer_of(reference));
  return norm_of_difference(of_a, of_b) / (scale > 0 ? scale : 1);
}

}  // namespace talus
