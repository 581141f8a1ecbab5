#include "verification/verify.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "base/error.hpp"
#include "verification/verify_json.hpp"

namespace talus {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::filesystem::path samples = std::filesystem::path(TALUS_SOURCE_DIR) / "samples";

KnownCase known(const std::string& name, std::function<CaseOutcome(const CaseOptions&, Progress&)> run) {
  KnownCase one;
  one.name = name;
  one.title = "Title of " + name;
  one.source = "nowhere";
  one.run = std::move(run);
  return one;
}

/// The fall of a stone from the height of the scale: v = √(2 g h), in m/s; `wrong` is added to it.
CaseOutcome fall(const CaseOptions& options, double wrong = 0) {
  CaseOutcome outcome;
  const double speed = std::sqrt(2 * 9.81 * options.scale);
  outcome.findings.push_back({"speed", "m/s", speed, speed + wrong, 1e-3});
  outcome.findings.push_back({"drift", "m", 0, 0, 1e-9 * options.scale, true});
  return outcome;
}

VerifyOptions again() {
  VerifyOptions options;
  options.repeat = true;
  return options;
}

TEST(Finding, ErrorsAreRelativeUnlessZeroIsExpectedOrTheToleranceIsAbsolute) {
  const Finding relative{"a", "m", 4, 5, 0.2}, zero{"b", "m", 0, 1e-10, 1e-9},
      angle{"c", "°", 33.36, 33.39, 0.05, true};
  EXPECT_DOUBLE_EQ(relative.error(), 0.25);
  EXPECT_FALSE(relative.passed());
  EXPECT_DOUBLE_EQ(zero.error(), 1e-10);
  EXPECT_NEAR(angle.error(), 0.03, 1e-12);
  EXPECT_TRUE(angle.passed());
  const Finding missing{"d", "s", 45, std::numeric_limits<double>::quiet_NaN(), 10};
  EXPECT_FALSE(missing.passed());
}

TEST(Finding, RelativeIsTheSameAtAnyScale) {
  EXPECT_DOUBLE_EQ((Finding{"a", "m", 4, 5, 0.2}.relative()), 1.25);
  EXPECT_DOUBLE_EQ((Finding{"b", "m", 0, 1e-10, 1e-9}.relative()), 0.1);
  EXPECT_DOUBLE_EQ((Finding{"rows missed", "", 0, 3, 0}.relative()), 3);
}

TEST(Verify, EveryCaseHasANameOfItsOwnATitleAndASource) {
  std::set<std::string> names;
  for (const KnownCase& one : all_cases(samples)) {
    EXPECT_TRUE(names.insert(one.name).second) << one.name;
    EXPECT_THAT(one.name, testing::MatchesRegex("(samples/)?[a-z0-9_]+"));
    EXPECT_FALSE(one.title.empty()) << one.name;
    EXPECT_FALSE(one.source.empty()) << one.name;
  }
  EXPECT_TRUE(names.contains("samples/free_fall"));
}

TEST(Verify, FindsASampleByItsFolderUnlessABuiltInCaseHasTheName) {
  const std::vector<KnownCase> cases{known("samples/fall", {}), known("samples/slide", {}), known("fall", {})};
  EXPECT_EQ(chosen_cases(cases, {"slide"}, false)[0].name, "samples/slide");
  EXPECT_EQ(chosen_cases(cases, {"fall"}, false)[0].name, "fall");
  EXPECT_EQ(chosen_cases(cases, {"samples/fall"}, false)[0].name, "samples/fall");
}

TEST(Verify, RunsWhatIsNamedOrAllThatIsQuick) {
  std::vector<KnownCase> cases{known("a", {}), known("b", {}), known("c", {})};
  cases[1].takes_long = true;
  const auto names = [](const std::vector<KnownCase>& chosen) {
    std::vector<std::string> found;
    for (const KnownCase& one : chosen) found.push_back(one.name);
    return found;
  };
  EXPECT_THAT(names(chosen_cases(cases, {}, false)), ElementsAre("a", "c"));
  EXPECT_THAT(names(chosen_cases(cases, {}, true)), ElementsAre("a", "b", "c"));
  EXPECT_THAT(names(chosen_cases(cases, {"c", "b"}, false)), ElementsAre("c", "b"));
  EXPECT_THROW(chosen_cases(cases, {"d"}, true), InputError);
  cases[2].of_any_body = true;
  EXPECT_THAT(names(chosen_cases(cases, {}, true, BodyKind::rigid)), ElementsAre("c"));
  EXPECT_THAT(names(chosen_cases(cases, {"c"}, false, BodyKind::affine)), ElementsAre("c"));
  EXPECT_THROW(chosen_cases(cases, {"a"}, true, BodyKind::affine), InputError);
}

TEST(Verify, ACaseThatThrowsFailsWithItsReasonAndTheNextOneRuns) {
  const std::vector<KnownCase> cases{
      known("stuck", [](auto&, auto&) -> CaseOutcome { throw std::runtime_error("contact 3 at (1, 2, 3)"); }),
      known("empty", [](auto&, auto&) { return CaseOutcome{}; }),
      known("fall", [](auto& options, auto&) { return fall(options); })};
  std::vector<CaseResult> results;
  NoProgress progress;
  verify(cases, {}, progress, [&](const CaseResult& result) { results.push_back(result); });
  ASSERT_EQ(results.size(), 3U);
  EXPECT_EQ(results[0].failure, "contact 3 at (1, 2, 3)");
  EXPECT_FALSE(results[0].passed());
  EXPECT_FALSE(results[1].passed()) << "a case that computes nothing holds nothing";
  EXPECT_TRUE(results[2].passed());
  EXPECT_EQ(results[2].title, "Title of fall");
}

TEST(Verify, ATableWhoseRowsHaveNotItsColumnsIsAFault) {
  NoProgress progress;
  const KnownCase crooked = known("crooked", [](auto& options, auto&) {
    CaseOutcome outcome = fall(options);
    outcome.tables.push_back({"rows", {"one", "two"}, {{"1", "2"}, {"1"}}});
    return outcome;
  });
  EXPECT_THAT(verify(crooked, {}, progress).failure, HasSubstr("rows"));
}

/// Tells how far it is, and says stop once it has come to `stop_at`.
class Stopping final : public Progress {
 public:
  explicit Stopping(double stop_at) : stop_at_(stop_at) {}
  void report(double fraction, std::string_view what) override {
    EXPECT_GE(fraction, fraction_);
    fraction_ = fraction;
    words = what;
  }
  bool cancelled() const override { return fraction_ >= stop_at_; }
  std::string words;

 private:
  double fraction_ = 0, stop_at_;
};

TEST(Verify, ProgressRunsOverAllCasesAndEndsThemWhenToldTo) {
  const KnownCase half = known("half", [](auto& options, Progress& progress) {
    progress.report(0.5, "step 7");
    if (progress.cancelled()) throw Cancelled{};
    return fall(options);
  });
  int ended = 0;
  Stopping progress(0.75);
  EXPECT_THROW(verify({half, half}, {}, progress, [&](const CaseResult&) { ++ended; }), Cancelled);
  EXPECT_EQ(ended, 1);
  EXPECT_EQ(progress.words, "half: step 7");
}

TEST(Verify, RepeatsOnTwoThreadsAndAtATenthOfTheScale) {
  NoProgress progress;
  const CaseResult result =
      verify(known("fall", [](auto& o, auto&) { return fall(o, 1e-4 * std::sqrt(o.scale)); }), again(), progress);
  ASSERT_EQ(result.repetitions.size(), 2U);
  EXPECT_EQ(result.repetitions[0].options.threads, 2);
  EXPECT_TRUE(result.repetitions[0].same_bits);
  EXPECT_DOUBLE_EQ(result.repetitions[1].options.scale, 0.1);
  EXPECT_LT(result.repetitions[1].largest.value, 1e-15);
  EXPECT_TRUE(result.passed());
}

TEST(Verify, OtherBitsOnTwoThreadsAreAFailure) {
  NoProgress progress;
  const CaseResult result =
      verify(known("racing", [](auto& o, auto&) { return fall(o, o.threads == 2 ? 1e-15 : 0); }), again(), progress);
  EXPECT_TRUE(result.outcome.passed());
  EXPECT_FALSE(result.repetitions[0].passed);
  EXPECT_FALSE(result.passed());
}

TEST(Verify, OtherRelativeNumbersAtAnotherScaleAreAFailure) {
  NoProgress progress;
  const CaseResult off =
      verify(known("off", [](auto& o, auto&) { return fall(o, 1e-4 * o.scale); }), again(), progress);
  const double wrong = 1e-4 / std::sqrt(2 * 9.81);
  EXPECT_FALSE(off.repetitions[1].passed);
  EXPECT_EQ(off.repetitions[1].largest.quantity, "speed");
  EXPECT_NEAR(off.repetitions[1].largest.value, wrong * (1 - std::sqrt(0.1)) / (1 + wrong), 1e-15);

  // Noise about zero is measured by the tolerance: a thousandth of it may differ, a tenth may not.
  const auto noise = [&](double share) {
    return verify(known("noise",
                        [share](const CaseOptions& o, Progress&) {
                          CaseOutcome outcome = fall(o);
                          outcome.findings[1].computed = o.scale == 1 ? 0 : share * outcome.findings[1].tolerance;
                          return outcome;
                        }),
                  again(), progress);
  };
  EXPECT_TRUE(noise(1e-3).passed());
  EXPECT_FALSE(noise(0.1).passed());
}

TEST(Verify, ACaseOfOneScaleRunsAtThatScale) {
  NoProgress progress;
  KnownCase fixed = known("fixed", [](auto& o, auto&) { return fall(o, o.scale - 1); });
  fixed.scales = false;
  VerifyOptions options = again();
  options.run.scale = 0.5;
  const CaseResult result = verify(fixed, options, progress);
  EXPECT_EQ(result.options.scale, 1);
  EXPECT_EQ(result.repetitions.size(), 1U);
  EXPECT_TRUE(result.passed());
}

TEST(Verify, JsonHoldsAllThatWasFound) {
  NoProgress progress;
  std::vector<CaseResult> results;
  const auto keep = [&](const CaseResult& result) { results.push_back(result); };
  verify({known("fall",
                [](auto& o, auto&) {
                  CaseOutcome outcome = fall(o);
                  outcome.remarks = {"a remark"};
                  outcome.tables.push_back({"rows", {"one"}, {{"1"}}});
                  outcome.findings.push_back({"never", "s", 45, std::nan("")});
                  outcome.findings.back().reported = true;
                  return outcome;
                })},
         again(), progress, keep);
  const auto json = nlohmann::json::parse(json_text(results));
  EXPECT_TRUE(json["passed"]);
  const auto& one = json["cases"][0];
  EXPECT_EQ(one["case"], "fall");
  EXPECT_EQ(one["status"], "completed");
  EXPECT_EQ(one["source"], "nowhere");
  EXPECT_EQ(one["checks"].size(), 3U);
  EXPECT_EQ(one["checks"][0]["unit"], "m/s");
  EXPECT_TRUE(one["checks"][2]["computed"].is_null());
  EXPECT_FALSE(one["checks"][2]["held"]);
  EXPECT_EQ(one["tables"][0]["rows"][0][0], "1");
  EXPECT_EQ(one["remarks"][0], "a remark");
  EXPECT_EQ(one["repetitions"].size(), 2U);
  EXPECT_FALSE(nlohmann::json::parse(json_text(results, false))["passed"]) << "not all were run";
}

}  // namespace
}  // namespace talus
