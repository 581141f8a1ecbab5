#include "study/accuracy/study_record.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "base/error.hpp"
#include "base/temporary_folder.hpp"
#include "io/whole_file.hpp"
#include "study/accuracy/accuracy_files.hpp"

namespace talus {
namespace {

const char* const falling_block = R"({
  "talus": 1, "gravity": [0, 0, -9.81],
  "materials": {"rock": {"density": 2600, "young": 1e9, "poisson": 0.25}},
  "solids": [{"name": "block", "box": {"min": [0, 0, 0], "max": [1, 1, 1]}, "material": "rock", "body": "rigid"}],
  "stages": [{"name": "fall", "type": "dynamic", "time_step": 0.02, "steps": 10}]
})";

class StudyRecordTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto file = folder_.path() / "fall.talus";
    std::ofstream(file) << falling_block;
    const StudyFolder study(folder_.path() / "fall.accuracy",
                            make_plan({file, false, parse_ladder_wish({"time_step"}, {}), "test"}), false);
    NoProgress nobody;
    for (const int run : study.missing_runs()) perform_study_run(study, run, nobody);
    replace_whole_file(study.path() / "accuracy.json", accuracy_json(evaluate(study, std::nullopt)));
  }

  TemporaryFolder folder_;
};

TEST_F(StudyRecordTest, IsReadWhereOneLies) {
  EXPECT_FALSE(read_study(folder_.path() / "other.accuracy"));
  const auto record = read_study(folder_.path() / "fall.accuracy");
  ASSERT_TRUE(record);
  EXPECT_EQ(record->place, folder_.path() / "fall.accuracy");
  EXPECT_EQ(record->study.rows.size(), 5u);
  EXPECT_TRUE(record->study.complete());
}

TEST_F(StudyRecordTest, KnowsTheRunOfAProjectUnderEachOfItsSettingsAndOfNoOther) {
  const auto record = read_study(folder_.path() / "fall.accuracy");
  ASSERT_TRUE(record);
  for (std::size_t i = 0; i < record->study.rows.size(); ++i)
    EXPECT_EQ(run_of(*record, under(record->study.rows[i].setting, *record->project)), static_cast<int>(i));
  Project heavier = *record->project;
  heavier.materials[0].density = 2700;
  EXPECT_FALSE(run_of(*record, heavier));
  ASSERT_TRUE(record->study.rows[0].error);
  EXPECT_EQ(error_of(*record, *record->project), record->study.rows[0].error);
  EXPECT_FALSE(error_of(*record, heavier));
}

TEST_F(StudyRecordTest, IsReadFromItsJsonAloneWithAllButTheProject) {
  const auto file = folder_.path() / "fall.accuracy" / "accuracy.json", alone = folder_.path() / "sent.json";
  std::filesystem::copy_file(file, alone);
  EXPECT_EQ(read_accuracy_file(file).project, read_study(file.parent_path())->project);
  const StudyRecord record = read_accuracy_file(alone);
  EXPECT_FALSE(record.project);
  EXPECT_EQ(accuracy_json(record.study), accuracy_json(read_study(file.parent_path())->study));
  EXPECT_FALSE(run_of(record, *read_study(file.parent_path())->project));
  replace_whole_file(alone, "{}");
  EXPECT_THROW(read_accuracy_file(alone), InputError);
  EXPECT_THROW(read_accuracy_file(folder_.path() / "none.json"), InputError);
}

TEST_F(StudyRecordTest, ChoosesAnewForAnotherTarget) {
  AccuracyStudy study = read_study(folder_.path() / "fall.accuracy")->study;
  EXPECT_EQ(study.recommended, -1);
  set_target(study, 1e3);
  ASSERT_GE(study.recommended, 0);
  for (const AccuracyRow& row : study.rows)
    EXPECT_LE(study.rows[static_cast<std::size_t>(study.recommended)].run->cpu_seconds, row.run->cpu_seconds);
  set_target(study, std::nullopt);
  EXPECT_EQ(study.recommended, -1);
}

TEST_F(StudyRecordTest, OrdersTheBestByCost) {
  AccuracyStudy study = read_study(folder_.path() / "fall.accuracy")->study;
  const double seconds[] = {4, 2, 9, 1, 3};
  for (std::size_t i = 0; i < 5; ++i) {
    study.rows[i].run->cpu_seconds = seconds[i];
    study.rows[i].pareto = i != 1;
  }
  EXPECT_THAT(best_by_cost(study), testing::ElementsAre(3, 4, 0, 2));
}

}  // namespace
}  // namespace talus
