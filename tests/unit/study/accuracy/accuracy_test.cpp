#include "study/accuracy/accuracy.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "base/error.hpp"
#include "base/temporary_folder.hpp"
#include "study/accuracy/accuracy_files.hpp"

// Studies of a free elastic bar whose answer is known. It deforms as one, u = (z − L/2)·s(t) with
// ρL²/12·s̈ + E·s = P(t)/A, and is pulled at both ends by a force that grows from zero, P = kt, so that nothing begins
// with a blow: u(L) = kL/2EA·(t − sin(ωt)/ω), ω² = 12E/ρL². All of its error is time integration's.
namespace talus {
namespace {

constexpr double end = 1.4;  ///< s, in periods of 1 s too

double known_stretch(double time) {
  const double omega = 2 * std::numbers::pi;
  return 1e-5 * (time - std::sin(omega * time) / omega);
}

nlohmann::json bar(const std::string& integrator) {
  const double density = 2600, young = density * std::pow(2 * std::numbers::pi, 2) / 12;
  nlohmann::json project = {
      {"talus", 1},
      {"gravity", {0, 0, 0}},
      {"materials", {{"rock", {{"density", density}, {"young", young}, {"poisson", 0}}}}},
      {"solids",
       {{{"name", "bar"},
         {"box", {{"min", {0, 0, 0}}, {"max", {1, 1, 1}}}},
         {"material", "rock"},
         {"body", "affine"}}}},
      {"stages", {{{"name", "pull"}, {"type", "dynamic"}, {"time_step", 0.002}, {"duration", end}}}},
      {"solver", {{"integrator", integrator}}},
      {"monitors", {{{"name", "P1"}, {"block", "bar"}, {"at", {0.5, 0.5, 1}}}}},
      {"expect", nlohmann::json::array()}};
  for (const int side : {0, 1}) {
    const double force = (2 * side - 1) * 4e-5 * young;
    project["loads"].push_back(
        {{"block", "bar"}, {"at", {0.5, 0.5, side}}, {"table", {{0, 0, 0, 0}, {2, 0, 0, force}}}});
  }
  for (const double time : {0.6, 1.0, end})
    project["expect"].push_back(
        {{"quantity", "P1.displacement.z"}, {"time", time}, {"value", known_stretch(time)}, {"tolerance", 0.01}});
  return project;
}

/// A cube that turns once a second, free of all forces: its corner comes to the opposite one after 4 1/2 turns.
nlohmann::json spinning_cube(const std::string& body) {
  return {{"talus", 1},
          {"gravity", {0, 0, 0}},
          {"materials", {{"rock", {{"density", 2500}, {"young", 50e9}, {"poisson", 0.25}}}}},
          {"solids",
           {{{"name", "cube"},
             {"box", {{"min", {-0.5, -0.5, -0.5}}, {"max", {0.5, 0.5, 0.5}}}},
             {"material", "rock"},
             {"body", body}}}},
          {"velocities", {{{"block", "cube"}, {"angular", {0, 0, 2 * std::numbers::pi}}}}},
          {"stages", {{{"name", "spin"}, {"type", "dynamic"}, {"time_step", 0.005}, {"duration", 4.5}}}},
          {"monitors", {{{"name", "P1"}, {"block", "cube"}, {"at", {0.5, 0.5, 0.5}}}}},
          {"expect",
           {{{"quantity", "P1.displacement.x"}, {"time", 4.5}, {"value", -1}, {"tolerance", 0.01}},
            {{"quantity", "P1.displacement.y"}, {"time", 4.5}, {"value", -1}, {"tolerance", 0.01}}}}};
}

class AccuracyStudyTest : public testing::Test {
 protected:
  AccuracyStudy studied(const nlohmann::json& project, std::optional<double> target = {},
                        const LadderWish& wish = parse_ladder_wish({"time_step"}, {}), int repeats = 1) {
    const auto file = folder_.path() / "bar.talus";
    std::ofstream(file) << project.dump();
    plan_ = make_plan({file, false, wish, "test", repeats});
    const StudyFolder study(folder_.path() / "study", plan_, true);
    NoProgress nobody;
    for (const int run : study.missing_runs()) perform_study_run(study, run, nobody);
    return evaluate(study, target);
  }

  TemporaryFolder folder_;
  StudyPlan plan_;
};

TEST_F(AccuracyStudyTest, OrdersComeOutAsTheorySays) {
  for (const auto& [integrator, theory] :
       {std::pair("newmark", 1.0), std::pair("constant-acceleration", 1.0), std::pair("generalized-alpha", 2.0)}) {
    const AccuracyStudy study = studied(bar(integrator));
    ASSERT_EQ(study.orders.size(), 1u);
    EXPECT_EQ(study.orders[0].theory, theory);
    EXPECT_EQ(study.orders[0].fit.convergence, Convergence::converging);
    EXPECT_NEAR(study.orders[0].fit.order, theory, 0.1) << integrator;
  }
}

TEST_F(AccuracyStudyTest, TheClaimedErrorIsTheMeasuredOne) {
  for (const char* integrator : {"newmark", "generalized-alpha"}) {
    const AccuracyStudy study = studied(bar(integrator));
    ASSERT_TRUE(study.known_answer);
    for (const AccuracyRow& row : study.rows) {
      ASSERT_TRUE(row.error && row.from_finest) << row.note;
      EXPECT_NEAR(*row.from_finest + study.reference_error, *row.error, 0.1 * *row.error) << integrator << row.label;
    }
  }
}

TEST_F(AccuracyStudyTest, WithoutAKnownAnswerErrorsAreFromTheFinestWithItsEstimate) {
  nlohmann::json project = bar("newmark");
  project.erase("expect");
  const AccuracyStudy study = studied(project);
  EXPECT_FALSE(study.known_answer);
  const AccuracyRow& finest = study.rows[static_cast<std::size_t>(study.reference)];
  EXPECT_EQ(finest.setting.time_step, 0.25);
  EXPECT_EQ(finest.error, study.reference_error);
  EXPECT_EQ(finest.error_estimate, 0);
  EXPECT_EQ(study.rows[0].error_estimate, study.reference_error);
  // halving the step halves the error
  EXPECT_NEAR(*study.rows[0].error + study.reference_error, 4 * study.reference_error, 0.4 * study.reference_error);
}

TEST_F(AccuracyStudyTest, TheRecommendedSettingMeetsItsTargetWhenRunAgain) {
  const double target = 0.01;
  const AccuracyStudy study = studied(bar("newmark"), target);
  ASSERT_GE(study.recommended, 0);
  const auto chosen = static_cast<std::size_t>(study.recommended);
  std::ofstream(folder_.path() / "again.talus") << recommended_project(study, plan_, folder_.path());
  const StudyFolder again(
      folder_.path() / "again",
      make_plan({folder_.path() / "again.talus", false, parse_ladder_wish({"time_step"}, {"time_step=1"}), "test"}),
      false);
  NoProgress nobody;
  perform_study_run(again, 0, nobody);
  const AccuracyStudy repeated = evaluate(again, target);
  EXPECT_LE(*repeated.rows[0].error, target);
  EXPECT_EQ(*repeated.rows[0].error, *study.rows[chosen].error);
}

TEST_F(AccuracyStudyTest, AnotherProjectInTheSameFolderIsRefused) {
  studied(bar("newmark"));
  StudyPlan changed = plan_;
  changed.fingerprint = "0";
  EXPECT_THROW(StudyFolder(folder_.path() / "study", changed, false), InputError);
  EXPECT_EQ(StudyFolder(folder_.path() / "study", plan_, false).missing_runs().size(), 0u);
  EXPECT_EQ(StudyFolder(folder_.path() / "study", changed, true).missing_runs().size(), 5u);
  EXPECT_THROW(StudyFolder(folder_.path(), plan_, false), InputError);  // it holds other files
}

TEST_F(AccuracyStudyTest, ARunThatFailsIsARow) {
  nlohmann::json project = bar("newmark");
  project["loads"][0]["at"] = {0.5, 0.5, 3};  // outside its block, which only the blocks tell
  const AccuracyStudy study = studied(project);
  EXPECT_TRUE(study.complete());
  EXPECT_EQ(study.reference, -1);
  for (const AccuracyRow& row : study.rows) EXPECT_EQ(row.run->status, StudyStatus::failed);
  EXPECT_THAT(accuracy_csv(study), testing::HasSubstr(",failed,no,"));
}

TEST_F(AccuracyStudyTest, ARunThatDoesNotConvergeIsARowAndTheOthersAreJudgedWithoutIt) {
  nlohmann::json project = spinning_cube("rigid");
  project["solver"]["open_close_limit"] = 1;  // enough for a rigid block, whose equations are linear, and for no other
  const AccuracyStudy study = studied(project, 0.01, parse_ladder_wish({"body"}, {"body=affine,rigid"}));
  ASSERT_EQ(study.rows.size(), 2u);
  EXPECT_TRUE(study.complete());
  const AccuracyRow &rigid = study.rows[0], &affine = study.rows[1];
  EXPECT_EQ(rigid.run->status, StudyStatus::completed);
  EXPECT_LT(*rigid.error, 1e-12);
  EXPECT_EQ(affine.run->status, StudyStatus::not_converged);
  EXPECT_FALSE(affine.error);
  EXPECT_FALSE(affine.pareto);
  EXPECT_THAT(affine.note, testing::HasSubstr("cube"));
  EXPECT_EQ(study.reference, 0);
  EXPECT_EQ(study.recommended, 0);
  EXPECT_THAT(accuracy_csv(study), testing::HasSubstr("\n1,affine,affine,"));
  EXPECT_THAT(accuracy_csv(study), testing::HasSubstr(",,,,not-converged,no,"));
  const auto json = nlohmann::json::parse(accuracy_json(study))["runs"][1];
  EXPECT_EQ(json["status"], "not-converged");
  EXPECT_TRUE(json["error"].is_null());
  EXPECT_GT(json["iterations"], 0);
}

/// A run whose steps were cut has another step than it says.
TEST_F(AccuracyStudyTest, RunsWhoseStepsWereCutTakeNoPartInTheOrder) {
  const AccuracyStudy whole = studied(bar("newmark"));
  const StudyFolder folder(folder_.path() / "study");
  const auto is_longest = [](const AccuracyRow& row) { return row.setting.time_step == 4; };
  const int longest = static_cast<int>(std::ranges::find_if(whole.rows, is_longest) - whole.rows.begin());
  std::ifstream file(folder.run_file(longest));
  nlohmann::json run = nlohmann::json::parse(file);
  run["cuts"] = run["steps"];
  std::ofstream(folder.run_file(longest)) << run.dump();

  const AccuracyStudy study = evaluate(folder, {});
  ASSERT_EQ(study.orders.size(), 1u);
  EXPECT_THAT(study.orders[0].cut_runs, testing::ElementsAre(longest));
  EXPECT_EQ(study.orders[0].runs.size(), whole.orders[0].runs.size() - 1);
  EXPECT_THAT(study.orders[0].runs, testing::Not(testing::Contains(longest)));
  EXPECT_NEAR(study.orders[0].fit.order, 1, 0.1);
}

TEST_F(AccuracyStudyTest, ItsFilesHoldARowARun) {
  const AccuracyStudy study = studied(bar("newmark"), 0.01);
  const std::string csv = accuracy_csv(study);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 6);
  const auto json = nlohmann::json::parse(accuracy_json(study));
  EXPECT_EQ(json["runs"].size(), 5u);
  EXPECT_EQ(json["measured_against"], "expect");
  EXPECT_EQ(json["recommended"], study.recommended);
  EXPECT_NEAR(json["orders"][0]["order"].get<double>(), 1, 0.1);
  EXPECT_GT(json["runs"][0]["effects"].size(), 3u);
}

TEST_F(AccuracyStudyTest, RepeatsOfASmoothMotionChangeNoErrorAndNoOrder) {
  const AccuracyStudy once = studied(bar("newmark"));
  const AccuracyStudy study = studied(bar("newmark"), {}, parse_ladder_wish({"time_step"}, {}), 3);
  EXPECT_EQ(study.repeats, 3);
  EXPECT_EQ(plan_.runs(), 15);
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    const AccuracyRow& row = study.rows[i];
    ASSERT_TRUE(row.error && row.spread);
    EXPECT_NEAR(*row.error, *once.rows[i].error, 1e-6) << "by what is changed, no more";
    EXPECT_GT(*row.spread, 1e-8);
    EXPECT_LT(*row.spread, 1e-6);
    EXPECT_DOUBLE_EQ(row.standard_error, *row.spread / std::sqrt(3.0));
    EXPECT_DOUBLE_EQ(row.error_estimate, row.standard_error);
  }
  EXPECT_NEAR(study.orders[0].fit.order, 1, 0.1);
  EXPECT_EQ(study.told_apart, true);
  EXPECT_FALSE(once.told_apart);
  EXPECT_FALSE(once.rows[0].spread);
}

/// Free fall is exact in every step: settings differ by rounding, repeats by what is changed.
TEST_F(AccuracyStudyTest, SaysThatNoSettingIsBetterWhereRepeatsScatterAsMuch) {
  nlohmann::json project = spinning_cube("rigid");
  project.erase("expect");
  project["gravity"] = {0, 0, -10};
  project.erase("velocities");
  const AccuracyStudy study = studied(project, {}, parse_ladder_wish({}, {"time_step=1,2"}), 4);
  ASSERT_TRUE(study.scatter);
  EXPECT_GT(*study.scatter, 1e-8);
  EXPECT_EQ(study.told_apart, false);
  const auto json = nlohmann::json::parse(accuracy_json(study));
  EXPECT_EQ(json["repeats"], 4);
  EXPECT_EQ(json["told_apart"], false);
  EXPECT_EQ(json["scatter"], *study.scatter);
  EXPECT_EQ(json["runs"][0]["spread"], *study.rows[0].spread);
}

TEST_F(AccuracyStudyTest, GoesOnWithMoreRepeatsAndNotWithFewer) {
  studied(bar("newmark"));
  StudyPlan more = plan_;
  more.repeats = 2;
  EXPECT_EQ(StudyFolder(folder_.path() / "study", more, false).missing_runs(), (std::vector{5, 6, 7, 8, 9}));
  EXPECT_EQ(StudyFolder(folder_.path() / "study").plan().repeats, 2);
  EXPECT_THROW(StudyFolder(folder_.path() / "study", plan_, false), InputError);
  EXPECT_EQ(StudyFolder(folder_.path() / "study", more, true).missing_runs().size(), 10u);
}

TEST_F(AccuracyStudyTest, ASettingIsJudgedOnceAllOfItsRepeatsHaveEnded) {
  studied(bar("newmark"), {}, parse_ladder_wish({}, {"time_step=1,2"}), 2);
  const StudyFolder folder(folder_.path() / "study");
  std::filesystem::remove(folder.run_file(plan_.run_of(1, 1)));
  const AccuracyStudy study = evaluate(folder, {});
  EXPECT_FALSE(study.complete());
  EXPECT_FALSE(study.rows[1].error);
  EXPECT_EQ(study.rows[1].note, "1 of 2 repeats have ended");
  EXPECT_TRUE(study.rows[0].error);
}

/// What is measured is a question to the runs, which know all of it: no other runs are made for it.
TEST_F(AccuracyStudyTest, IsMeasuredAnewByAnotherMeasure) {
  nlohmann::json project = spinning_cube("affine");
  project["gravity"] = {0, 0, -10};
  project["monitors"][0]["stress"] = true;
  studied(project, {}, parse_ladder_wish({}, {"time_step=1,2"}));
  const auto by = [&](std::optional<StudyMeasure> measure) {
    StudyPlan other = plan_;
    other.measure = measure;
    const StudyFolder folder(folder_.path() / "study", other, false);
    EXPECT_TRUE(folder.missing_runs().empty());
    return evaluate(StudyFolder(folder_.path() / "study"), {});
  };
  EXPECT_TRUE(by({}).known_answer);
  const AccuracyStudy start = by(StudyMeasure::start), stress = by(StudyMeasure::stress), end = by(StudyMeasure::end);
  EXPECT_FALSE(start.known_answer);
  EXPECT_EQ(start.measure, StudyMeasure::start);
  ASSERT_TRUE(start.rows[1].error);
  EXPECT_LT(*start.rows[1].error, 0.01);
  ASSERT_TRUE(stress.rows[1].error);
  EXPECT_GT(*stress.rows[1].error, 0);
  EXPECT_EQ(end.reference, -1);
  EXPECT_EQ(end.rows[0].note, "no block moves, or some still do at the end");
  EXPECT_EQ(nlohmann::json::parse(accuracy_json(start))["measure"], "start");
  EXPECT_TRUE(nlohmann::json::parse(accuracy_json(by({})))["measure"].is_null());
}

TEST_F(AccuracyStudyTest, OfStressNeedsAMonitorOfIt) {
  const auto file = folder_.path() / "bar.talus";
  std::ofstream(file) << bar("newmark").dump();
  EXPECT_THROW(make_plan({file, false, {}, "test", 1, StudyMeasure::stress}), InputError);
}

}  // namespace
}  // namespace talus
