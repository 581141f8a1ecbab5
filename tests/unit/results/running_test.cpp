// What other processes see of a run that goes on.
#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>

#include "example_results.hpp"
#include "results/folder.hpp"
#include "results/result_folder.hpp"
#include "results/text_table.hpp"

namespace talus {
namespace {

using testing::ElementsAre;
using testing::Optional;

TEST(RunningRun, ItsProgramIsTold) {
  const TemporaryFolder temporary, other;
  EXPECT_FALSE(writer_of(temporary.path));
  {
    const ResultWriter writer(temporary.path, example_project(), example_system(), "{}");
    const auto found = writer_of(temporary.path);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->process, getpid());
    EXPECT_EQ(found->program, "test_results");
    EXPECT_FALSE(writer_of(other.path));
  }
  EXPECT_FALSE(writer_of(temporary.path));
  EXPECT_FALSE(writer_of(temporary.path / "nowhere"));
}

TEST(RunningRun, TheLastRowOfItsTableIsWhole) {
  const TemporaryFolder temporary;
  const auto file = temporary.path / "steps.csv";
  EXPECT_FALSE(last_row(file, 3)) << "there is no file";
  TextTableWriter table(file, {"time", "of", "day"});
  EXPECT_FALSE(last_row(file, 3)) << "a heading alone";
  for (int i = 1; i <= 100; ++i) table.add({i / 3.0, 0.5 * i, -1.0 * i});
  const auto last = ElementsAre(100 / 3.0, 50, -100);
  EXPECT_THAT(last_row(file, 3), Optional(last));
  std::ofstream(file, std::ios::app) << "0.5,torn";
  EXPECT_THAT(last_row(file, 3), Optional(last));
  std::ofstream(file, std::ios::app) << "\n";
  EXPECT_FALSE(last_row(file, 3)) << "damaged";
}

}  // namespace
}  // namespace talus
