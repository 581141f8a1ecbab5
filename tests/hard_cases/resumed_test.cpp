#include <gmock/gmock.h>

#include <algorithm>
#include <bit>
#include <memory>

#include "base/state_archive.hpp"
#include "bodies/body_set.hpp"
#include "solve/simulation.hpp"
#include "verification/hard_cases/scenes/all_hard_cases.hpp"

namespace talus {
namespace {

/// A run is taken up anew so often.
constexpr long times = 25;

std::vector<double> figures_of(const StepReport& report, const BodySet& bodies) {
  std::vector<double> figures = {double(report.iterations), double(report.cuts),   report.time,
                                 report.energy.kinetic,     report.energy.contact, report.energy.integration_loss,
                                 report.energy.remainder};
  for (const auto& list : {bodies.nodes.position, bodies.nodes.velocity})
    for (const Vec3& vector : list) figures.insert(figures.end(), vector.begin(), vector.end());
  return figures;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(
      a, b, [](double p, double q) { return std::bit_cast<std::uint64_t>(p) == std::bit_cast<std::uint64_t>(q); });
}

class ResumedHardCase : public testing::TestWithParam<HardCase> {};

TEST_P(ResumedHardCase, TakesTheSameStepsToTheBit) {
  const CaseScene scene = GetParam().build();
  Simulation whole(scene.project, scene.system);
  auto resumed = std::make_unique<Simulation>(scene.project, scene.system);
  const long every = std::max(1L, whole.total_steps() / times);
  for (long step = 0; !whole.finished(); ++step) {
    if (step % every == 0) {
      StateArchive written;
      resumed->archive(written);
      resumed = std::make_unique<Simulation>(scene.project, scene.system);
      StateArchive read(written.bytes());
      resumed->archive(read);
    }
    const StepReport report = whole.step();
    ASSERT_TRUE(same_bits(figures_of(report, whole.bodies()), figures_of(resumed->step(), resumed->bodies())))
        << "step " << report.step;
  }
  EXPECT_TRUE(resumed->finished());
}

std::vector<HardCase> quick() {
  std::vector<HardCase> chosen = hard_cases();
  std::erase_if(chosen, [](const HardCase& scene) { return scene.takes_long; });
  return chosen;
}

std::string test_name(const testing::TestParamInfo<HardCase>& one) { return one.param.name; }

INSTANTIATE_TEST_SUITE_P(, ResumedHardCase, testing::ValuesIn(quick()), test_name);

}  // namespace

/// For messages of GoogleTest.
void PrintTo(const HardCase& scene, std::ostream* stream) { *stream << scene.name; }

}  // namespace talus
