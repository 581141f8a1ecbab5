// What a run is foreseen to take against what it takes, on random scenes: a table and a chart of docs/accuracy.md.
//   OPENBLAS_NUM_THREADS=1 build/release/tests/bench/bench_forecasts [--seed S] [--scenes N] [--picture FILE.png]
//       [--least SECONDS] [--most SECONDS] [--budget SECONDS]
// Seconds are the processor's; other jobs of the machine change them nevertheless, so that each run is made twice,
// before its forecast and after it, but for runs of minutes (--least 30 and more). Scenes come in turn from all
// families and are passed over where they take less than 0.1 s. The others are made runs of 2 to 40 s, or as --least
// and --most say, by shorter steps: how many times shorter chance draws, too. --budget: what a forecast may spend.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "base/processor_time.hpp"
#include "base/temporary_folder.hpp"
#include "bench/forecast_chart.hpp"
#include "run/run.hpp"
#include "study/accuracy/setting.hpp"
#include "study/forecast/forecast.hpp"
#include "verification/random/random_scene.hpp"

namespace talus {
namespace {

constexpr double shortest_drawn = 0.1;  // s
constexpr double longest_over = 3;      // times the longest wanted, after which a run is given up
constexpr double steady = 1.15;         // the same run twice: else the machine says more than the forecast

class Clock final : public RunObserver {
 public:
  explicit Clock(double longest) : longest_(longest) {}
  void on_step(const StepReport&, const HistoryRow&, double) override {}
  void on_frame(std::shared_ptr<const Frame>) override {}
  bool go_on() override { return seconds() < longest_; }
  double seconds() const { return processor_seconds_of_thread() - begin_; }

 private:
  double longest_, begin_ = processor_seconds_of_thread();
};

/// Nothing where the run is given up.
std::optional<double> seconds_of(const Project& project, const BlockSystem& system, double longest) {
  const TemporaryFolder folder;
  Clock clock(longest);
  const RunReport report = run(project, system, {folder.path() / "results", "{}", 1}, clock);
  if (report.status == RunStatus::stopped) return std::nullopt;
  return clock.seconds();
}

struct Measured {
  std::string name;
  int finer = 1;  ///< times as many steps as drawn
  Forecast said{};
  double seconds = 0;  ///< mean of the run before the forecast and after it
  double apart = 1;    ///< the longer of both over the other: what the machine adds, forecast and run alike

  bool is_steady() const { return apart < steady; }
  double ratio() const { return said.seconds / seconds; }
  bool is_near() const { return ratio() < 1.3 && ratio() > 1 / 1.3; }
  bool is_in_range() const { return said.fewest <= seconds && seconds <= said.most; }
};

/// What is asked of the command line; all in seconds of the processor.
struct Wanted {
  double least = 2, most = 40;  ///< that runs take
  double budget = 4;            ///< of a forecast, as talus-cli info has it
  bool twice() const { return least < 30; }
};

std::optional<Measured> measure(const RandomSceneName& name, const Wanted& wanted) {
  const HardCase drawn = random_scene(name);
  const CaseScene scene = drawn.build();
  const auto as_drawn = seconds_of(scene.project, scene.system, wanted.most);
  if (!as_drawn || *as_drawn < shortest_drawn) return std::nullopt;
  SceneNumbers numbers(mixed_seed(name.seed, "seconds of " + name.family, name.number));
  Measured result{to_string(name)};
  result.finer = std::max(1, static_cast<int>(std::lround(numbers.logarithmic(wanted.least, wanted.most) / *as_drawn)));
  Setting setting = own_setting(scene.project);
  setting.time_step = setting.static_step = 1.0 / result.finer;
  const Project project = under(setting, scene.project);
  const auto before = seconds_of(project, scene.system, longest_over * wanted.most);
  NoProgress nobody;
  result.said = forecast(project, scene.system, wanted.budget, nobody);
  const auto after = wanted.twice() ? seconds_of(project, scene.system, longest_over * wanted.most) : before;
  if (!before || !after) return std::nullopt;
  result.seconds = (*before + *after) / 2;
  result.apart = std::max(*before, *after) / std::min(*before, *after);
  return result;
}

void print(const Measured& one) {
  std::printf("| `%s` | %d | %.3g | %.3g to %.3g | %.3g | %.2f | %.0f %% | %s | %.2f |\n", one.name.c_str(), one.finer,
              one.said.seconds, one.said.fewest, one.said.most, one.seconds, one.ratio(), 100 * one.said.share_seen,
              one.is_in_range() ? "yes" : "no", one.apart);
  std::fflush(stdout);
}

/// How many are near and how many ranges hold, of those that `count`.
template <class Counts>
void print_count(const std::vector<Measured>& all, const char* which, const Counts& counts) {
  int count = 0, near = 0, held = 0;
  for (const Measured& one : all) {
    if (!counts(one)) continue;
    ++count;
    near += one.is_near();
    held += one.is_in_range();
  }
  std::printf("%s%d runs: %d within 30 %%, %d ranges hold\n", which, count, near, held);
}

void print_counts(const std::vector<Measured>& all) {
  const auto unseen = [](const Measured& one) { return one.said.share_seen < 1; };
  print_count(all, "", [](const Measured&) { return true; });
  print_count(all, "not seen whole: ", unseen);
  print_count(all, "while the machine was steady: ", [](const Measured& one) { return one.is_steady(); });
  print_count(all, "of these not seen whole: ", [&](const Measured& one) { return one.is_steady() && unseen(one); });
}

void draw(const std::vector<Measured>& all, std::uint64_t seed, const std::string& file) {
  std::vector<ForecastPoint> points;
  for (const Measured& one : all)
    points.push_back({one.said.seconds, one.said.fewest, one.said.most, one.seconds, one.said.share_seen == 1});
  const std::string title = std::to_string(all.size()) + " random scenes of seed " + std::to_string(seed);
  write_png(draw_forecast_chart(title, points, 1200, 1000), file);
}

void measure_all(std::uint64_t seed, std::size_t scenes, const Wanted& wanted, const std::string& picture) {
  std::printf(
      "| scene | steps, times | said, s | range | measured, s | said/measured | share seen | in range | again, times "
      "|\n"
      "|---|---|---|---|---|---|---|---|---|\n");
  std::vector<Measured> all;
  for (std::uint64_t number = 1; all.size() < scenes; ++number)
    for (const RandomFamily& family : random_families()) {
      if (all.size() == scenes) break;
      const auto one = measure({family.name, seed, number}, wanted);
      if (!one) continue;
      print(*one);
      all.push_back(*one);
      if (!picture.empty()) draw(all, seed, picture);
    }
  print_counts(all);
}

}  // namespace
}  // namespace talus

int main(int count, char** words) {
  std::uint64_t seed = 1;
  std::size_t scenes = 40;
  std::string picture;
  talus::Wanted wanted;
  for (int i = 1; i + 1 < count; i += 2) {
    if (!std::strcmp(words[i], "--seed")) seed = std::strtoull(words[i + 1], nullptr, 10);
    if (!std::strcmp(words[i], "--scenes")) scenes = std::strtoull(words[i + 1], nullptr, 10);
    if (!std::strcmp(words[i], "--picture")) picture = words[i + 1];
    if (!std::strcmp(words[i], "--least")) wanted.least = std::atof(words[i + 1]);
    if (!std::strcmp(words[i], "--most")) wanted.most = std::atof(words[i + 1]);
    if (!std::strcmp(words[i], "--budget")) wanted.budget = std::atof(words[i + 1]);
  }
  talus::measure_all(seed, scenes, wanted, picture);
}
