// What the paper published, what its scheme comes to here, and Talus: the tables of docs/validation.md.
//   OPENBLAS_NUM_THREADS=1 build/release/tests/bench/bench_paper_scheme

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <map>
#include <string>
#include <vector>

#include "base/units.hpp"
#include "model/number_text.hpp"
#include "verification/known_answers/wedges/wedge_cases.hpp"
#include "verification/known_sample.hpp"

namespace talus {
namespace {

constexpr int refinements = 1;  // as the known answer has it: eight tetrahedra a wedge

/// Seconds of the processor since the start: the machine may be busy.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double degrees_between(const Vec3& a, const Vec3& b) { return degrees(std::acos(std::min(1.0, a.dot(b)))); }

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// What a column says of one wedge.
struct Answer {
  std::optional<WedgeMode> mode;
  Vec3 direction = Vec3::Zero();
};

struct Column {
  std::vector<Answer> answers{};  ///< of each of the wedge tests
  long steps = 0, iterations = 0;
  double seconds = 0;

  std::string count(auto counts) const {
    int sum = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) sum += counts(wedge_tests()[i], answers[i]);
    return std::to_string(sum);
  }
};

Column published() {
  Column column;
  for (const WedgeTest& test : wedge_tests()) {
    const auto& d = test.coupled_direction;
    const Vec3 direction(d[0], d[1], d[2]);
    column.answers.push_back({test.coupled, direction.isZero() ? direction : direction.normalized()});
  }
  return column;
}

Column computed(Preset preset) {
  Column column;
  NoProgress progress;
  const double before = processor_seconds();
  for (const WedgeTest& test : wedge_tests()) {
    const WedgeMotion motion = run_wedge_test(test, plaster_friction_angle, refinements, {.preset = preset}, progress);
    column.answers.push_back({motion.mode, motion.direction});
    column.steps += motion.steps;
    column.iterations += motion.iterations;
  }
  column.seconds = processor_seconds() - before;
  return column;
}

WedgeMode in_equilibrium(const WedgeTest& test) { return test.equilibrium().mode(plaster_friction_angle); }
double factor(const WedgeTest& test) { return test.equilibrium().factor(plaster_friction_angle); }

/// Degrees off limit equilibrium, of the wedges that go as it says.
std::string deviations(const Column& column) {
  std::vector<double> all;
  for (std::size_t i = 0; i < column.answers.size(); ++i) {
    const Answer& answer = column.answers[i];
    const WedgeTest& test = wedge_tests()[i];
    if (!answer.direction.isZero() && answer.mode == in_equilibrium(test))
      all.push_back(degrees_between(answer.direction, test.equilibrium().direction));
  }
  return significant(median(all), 2) + ", " + significant(*std::max_element(all.begin(), all.end()), 2);
}

void print_wedges(const Column& paper, const Column& scheme, const Column& own) {
  const auto row = [&](const std::string& what, auto cell) {
    std::printf("| %s | %s | %s | %s |\n", what.c_str(), cell(paper).c_str(), cell(scheme).c_str(), cell(own).c_str());
  };
  std::printf("| 65 wedges | published | the paper's scheme | Talus |\n|---|--:|--:|--:|\n");
  row("mode of the physical model", [](const Column& c) {
    return c.count([](const WedgeTest& test, const Answer& a) { return a.mode == test.physical; });
  });
  row("published mode", [](const Column& c) {
    return c.count([](const WedgeTest& test, const Answer& a) { return a.mode == test.coupled; });
  });
  row("mode of limit equilibrium", [](const Column& c) {
    return c.count([](const WedgeTest& test, const Answer& a) { return a.mode == in_equilibrium(test); });
  });
  row("another one off the thresholds, of 52", [](const Column& c) {
    return c.count([](const WedgeTest& test, const Answer& a) {
      return !at_threshold(factor(test)) && a.mode != in_equilibrium(test);
    });
  });
  row("no answer", [](const Column& c) { return c.count([](const WedgeTest&, const Answer& a) { return !a.mode; }); });
  row("degrees off limit equilibrium: median, most", deviations);
  row("steps", [](const Column& c) { return c.steps ? count_text(c.steps) : "–"; });
  row("iterations a step", [](const Column& c) {
    return c.steps ? decimals(static_cast<double>(c.iterations) / static_cast<double>(c.steps), 2) : "–";
  });
  row("seconds", [](const Column& c) { return c.steps ? decimals(c.seconds, 1) : "–"; });

  std::printf(
      "\n| wedge | physical model | published | the paper's scheme | Talus | limit equilibrium | factor of safety "
      "|\n|---|---|---|---|---|---|--:|\n");
  for (std::size_t i = 0; i < wedge_tests().size(); ++i) {
    const WedgeTest& test = wedge_tests()[i];
    const auto is_physical = [&](const Column& c) { return c.answers[i].mode == test.physical; };
    if (is_physical(paper) && is_physical(scheme) && is_physical(own)) continue;
    std::printf("| %s | %s | %s | %s | %s | %s | %s |\n", test.name().c_str(), to_string(test.physical).data(),
                mode_text(paper.answers[i].mode).data(), mode_text(scheme.answers[i].mode).data(),
                mode_text(own.answers[i].mode).data(), to_string(in_equilibrium(test)).data(),
                decimals(factor(test), 3).c_str());
  }
}

struct Run {
  SampleOutcome outcome;
  double seconds = 0;  ///< of the processor, without the mesher
};

/// By the project's own scheme where there is no preset.
Run run(const KnownSample& sample, std::optional<Preset> preset) {
  NoProgress progress;
  const double before = processor_seconds();
  SampleOutcome outcome = run_sample(sample, {.preset = preset}, progress);
  return {std::move(outcome), processor_seconds() - before};
}

std::string time_text(const std::optional<double>& time) { return time ? decimals(*time, 1) : "did not happen"; }

std::string cost_text(const Run& run) {
  const RunReport& report = run.outcome.report;
  return decimals(static_cast<double>(report.iterations) / report.steps, 2) + ", " + count_text(report.cuts) + ", " +
         decimals(run.seconds, 1);
}

void print_events(const KnownSample& sample) {
  const Run scheme = run(sample, Preset::paper), own = run(sample, std::nullopt);
  std::printf("\n| Jiweishan, s | published | the paper's scheme | Talus |\n|---|--:|--:|--:|\n");
  for (std::size_t i = 0; i < scheme.outcome.events.size(); ++i) {
    const ReferenceEvent& event = scheme.outcome.events[i].event;
    std::printf("| %s | %s | %s | %s |\n", event.what.c_str(), decimals(event.time, 0).c_str(),
                time_text(scheme.outcome.events[i].computed).c_str(),
                time_text(own.outcome.events[i].computed).c_str());
  }
  std::printf("| steps | 10 000 | %s | %s |\n", count_text(scheme.outcome.report.steps).c_str(),
              count_text(own.outcome.report.steps).c_str());
  std::printf("| iterations a step, cuts, seconds | – | %s | %s |\n", cost_text(scheme).c_str(),
              cost_text(own).c_str());
}

/// The worst of what a sample is held to: the largest relative error, or where nothing but zero is expected the largest
/// one; where it ended, if before its time.
std::string held_text(const SampleOutcome& outcome) {
  if (outcome.report.status != RunStatus::completed) return "ends at " + significant(outcome.report.time) + " s";
  const ExpectationOutcome* worst = nullptr;
  const auto is_relative = [](const ExpectationOutcome& e) { return e.expectation.value != 0; };
  for (const ExpectationOutcome& e : outcome.report.expect)
    if (!worst || std::pair(is_relative(e), e.error) > std::pair(is_relative(*worst), worst->error)) worst = &e;
  if (!worst) return "runs to its end";
  return worst->expectation.quantity + ": " + (is_relative(*worst) ? "" : "±") + significant(worst->error, 2);
}

void print_sample(const KnownSample& sample) {
  const Run scheme = run(sample, Preset::paper), own = run(sample, std::nullopt);
  std::printf("| `%s` | %s | %s | %s | %s |\n", sample.name.c_str(), held_text(scheme.outcome).c_str(),
              cost_text(scheme).c_str(), held_text(own.outcome).c_str(), cost_text(own).c_str());
  std::fflush(stdout);
}

}  // namespace
}  // namespace talus

int main() {
  using namespace talus;
  print_wedges(published(), computed(Preset::paper), computed(Preset::talus));
  const std::filesystem::path folder(TALUS_SAMPLES);
  std::vector<KnownSample> samples = find_known_samples(folder);
  for (const KnownSample& sample : samples)
    if (!sample.events.empty()) print_events(sample);
  std::printf(
      "\n| sample | the paper's scheme: largest error | iterations a step, cuts, seconds | Talus: largest error | "
      "iterations a step, cuts, seconds |\n|---|---|--:|---|--:|\n");
  KnownSample& slope = samples.emplace_back();
  slope.name = "step_slope";
  slope.project = folder / slope.name / (slope.name + ".talus");
  for (const KnownSample& sample : samples)
    if (sample.events.empty()) print_sample(sample);
}
