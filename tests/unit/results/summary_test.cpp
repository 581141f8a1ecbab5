#include "results/summary.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "example_results.hpp"

namespace talus {
namespace {

using Json = nlohmann::json;

RunReport example_report() {
  RunReport report;
  report.version = "1.2.3";
  report.finished = "2026-03-01T17:04:00Z";
  report.status = RunStatus::not_converged;
  report.reason = "contact of B1 and B2 at (1, 2, 3) on J1";
  report.time = 1.5;
  report.wall_seconds = 2.5;
  report.steps = 150;
  report.threads = 2;
  report.tolerance = 1e-6;
  report.frames = 16;
  report.iterations = 321;
  report.cuts = 4;
  report.blocks = {{.name = "B2",
                    .body = BodyKind::tetrahedra,
                    .volume = 8,
                    .relative_volume_change = 1e-12,
                    .displacement = Vec3(1, 2, 3),
                    .rotation_degrees = 7,
                    .velocity = Vec3(4, 5, 6),
                    .motion = {.mode = MotionMode::falling, .direction = Vec3(1, 0, 0)}}};
  report.max_penetration = 1e-5;
  report.max_relative_penetration = 1e-4;
  report.last_step.open = 1;
  report.last_step.stick = 2;
  report.last_step.slip = 3;
  report.last_step.energy = {1, 2, 3, 4, 5, 6, 7, 8};
  report.phases = {.detect = 0.1, .assemble = 0.2, .factor = 0.3, .solve = 0.4, .update = 0.5, .write = 0.6};
  report.effects = {{"inertia", true, "always", 0.25, 2, 700, 150}, {"damping", false, "nobody asks for it"}};
  report.work = {.body_pairs = 1,
                 .facet_searches = 2,
                 .facet_pairs = 3'000'000'000,
                 .contact_points = 4,
                 .factorisations = 5,
                 .dense_factorisations = 6,
                 .linear_solves = 7,
                 .gmres_iterations = 8,
                 .systems = 9,
                 .largest_system = 10,
                 .block_steps_asleep = 11,
                 .wakings = 12,
                 .stress_recoveries = 13,
                 .correction_limits = 14,
                 .impact_sweep_limits = 15,
                 .gmres_limits = 16,
                 .failed_factorisations = 17};
  report.troubles = {{.cause = TroubleCause::inverted,
                      .blocks = {"B1", "B2"},
                      .joint = "J1",
                      .position = Vec3(1, 2, 3),
                      .rest_position = Vec3(4, 5, 6),
                      .time = 1.5,
                      .step = 150,
                      .relative_penetration = 0.02,
                      .iterations = 300,
                      .most_iterations = 160,
                      .cuts = 4,
                      .ended_run = true,
                      .advice = "a finer mesh"},
                     {.blocks = {"B2", ""}}};
  report.events = {{0.75, "J5 opened"}};
  report.expect.resize(2);
  report.expect[0].expectation.quantity = "P1.displacement.z";
  report.expect[0].expectation.time = 1;
  report.expect[0].expectation.value = -4.905;
  report.expect[0].expectation.tolerance = 1e-6;
  report.expect[0].computed = -4.905;
  report.expect[0].reached = report.expect[0].passed = true;
  return report;
}

std::vector<std::string> keys(const Json& object) {
  std::vector<std::string> names;
  for (const auto& [name, value] : object.items()) names.push_back(name);
  return names;
}

TEST(Summary, HoldsWhatTheContractNames) {
  const Json json = Json::parse(summary_json(example_report()));
  EXPECT_EQ(json["version"], "1.2.3");
  EXPECT_EQ(json["finished"], "2026-03-01T17:04:00Z");
  EXPECT_EQ(json["status"], "not-converged");
  EXPECT_EQ(json["reason"], "contact of B1 and B2 at (1, 2, 3) on J1");
  EXPECT_EQ(json["time"], 1.5);
  EXPECT_EQ(json["steps"], 150);
  EXPECT_EQ(json["wall_seconds"], 2.5);
  EXPECT_EQ(json["threads"], 2);
  EXPECT_EQ(json["tolerance"], 1e-6);
  EXPECT_EQ(json["frames"], 16);
  EXPECT_EQ(json["iterations"], 321);
  EXPECT_EQ(json["cuts"], 4);
  EXPECT_EQ(json["blocks"], Json::parse(R"([{"name": "B2", "body": "tetrahedra", "volume": 8.0,
      "relative_volume_change": 1e-12, "displacement": [1.0, 2.0, 3.0], "rotation_degrees": 7.0,
      "velocity": [4.0, 5.0, 6.0], "motion": {"mode": "falling", "text": "falling", "came_to_rest": false,
      "joints": [], "against": [], "trend": 90.0, "plunge": 0.0, "line": null, "axis": null, "rotation_share": 0.0}}])"));
  EXPECT_EQ(json["contacts"], Json::parse(R"({"max_penetration": 1e-5, "max_relative_penetration": 1e-4,
      "open": 1, "stick": 2, "slip": 3})"));
  EXPECT_EQ(json["energy"], Json::parse(R"({"kinetic": 1.0, "elastic": 2.0, "potential": 3.0, "contact": 4.0,
      "friction_dissipated": 5.0, "damping_dissipated": 6.0, "constraint_work": 7.0, "integration_loss": 8.0,
      "remainder": 0.0})"));
  EXPECT_EQ(json["effects"],
            Json::parse(R"([{"name": "inertia", "active": true, "reason": "always", "seconds": 0.25, "built": 2,
                             "evaluations": 700, "assemblies": 150},
                            {"name": "damping", "active": false, "reason": "nobody asks for it", "seconds": 0.0,
                             "built": 0, "evaluations": 0, "assemblies": 0}])"));
  EXPECT_EQ(json["work"], Json::parse(R"({"body_pairs": 1, "facet_searches": 2, "facet_pairs": 3000000000,
      "contact_points": 4, "factorisations": 5, "dense_factorisations": 6, "linear_solves": 7, "gmres_iterations": 8,
      "systems": 9, "largest_system": 10, "block_steps_asleep": 11, "wakings": 12, "stress_recoveries": 13, "correction_limits": 14,
      "impact_sweep_limits": 15, "gmres_limits": 16, "failed_factorisations": 17})"));
  EXPECT_EQ(json["phases"], Json::parse(R"({"detect": 0.1, "assemble": 0.2, "factor": 0.3, "solve": 0.4,
      "update": 0.5, "write": 0.6})"));
  EXPECT_EQ(json["convergence_trouble"][0], Json::parse(R"({"blocks": ["B1", "B2"], "cause": "inverted-tetrahedron",
      "position": [1, 2, 3], "rest_position": [4, 5, 6], "joint": "J1", "time": 1.5, "step": 150, "relative_penetration": 0.02, "iterations": 300,
      "most_iterations": 160, "cuts": 4, "ended_run": true, "advice": "a finer mesh"})"));
  EXPECT_EQ(json["convergence_trouble"][1]["blocks"], Json::parse(R"(["B2"])"));
  EXPECT_EQ(json["events"], Json::parse(R"([{"time": 0.75, "what": "J5 opened"}])"));
  EXPECT_THAT(keys(json["expect"][0]),
              testing::IsSupersetOf({"quantity", "time", "value", "computed", "error", "tolerance", "passed"}));
  EXPECT_EQ(json["expect"][0]["computed"], -4.905);
  EXPECT_EQ(json["expect"][0]["passed"], true);
}

TEST(Summary, SaysWhyABodyWasChosenWhereItWas) {
  RunReport report = example_report();
  report.blocks.push_back(report.blocks[0]);
  report.blocks[1].body = BodyKind::rigid;
  report.blocks[1].body_reason = "hard rock";
  const Json json = Json::parse(summary_json(report));
  EXPECT_FALSE(json["blocks"][0].contains("body_reason"));
  EXPECT_EQ(json["blocks"][1]["body"], "rigid");
  EXPECT_EQ(json["blocks"][1]["body_reason"], "hard rock");
}

TEST(Summary, WhatTheRunDidNotReachIsNullAndNotPassed) {
  const Json json = Json::parse(summary_json(example_report()));
  EXPECT_TRUE(json["expect"][1]["computed"].is_null());
  EXPECT_TRUE(json["expect"][1]["error"].is_null());
  EXPECT_EQ(json["expect"][1]["passed"], false);
}

TEST(Summary, ANumberThatIsNotFiniteIsNull) {
  RunReport report = example_report();
  report.max_penetration = std::numeric_limits<double>::quiet_NaN();
  report.blocks[0].velocity.y() = std::numeric_limits<double>::infinity();
  const std::string text = summary_json(report);
  EXPECT_THAT(text, testing::Not(testing::ContainsRegex("nan|inf|NaN|Infinity")));
  const Json json = Json::parse(text);
  EXPECT_TRUE(json["contacts"]["max_penetration"].is_null());
  EXPECT_TRUE(json["blocks"][0]["velocity"][1].is_null());
}

TEST(Summary, WordsOfTheStatus) {
  RunReport report;
  EXPECT_EQ(Json::parse(summary_json(report))["status"], "completed");
  report.status = RunStatus::stopped;
  EXPECT_EQ(Json::parse(summary_json(report))["status"], "stopped");
}

TEST(Summary, WhatItSaysOfTheRunIsReadBackFromTheFolder) {
  const TemporaryFolder temporary;
  const RunReport written = example_report();
  ResultWriter writer(temporary.path, example_project(), example_system(), "{}");
  EXPECT_FALSE(ResultReader(temporary.path).report()) << "the run goes on";
  writer.finish(written);
  const auto read = ResultReader(temporary.path).report();
  ASSERT_TRUE(read);
  // Of what was read the same text is written, but for blocks, of which frames tell.
  const Json before = Json::parse(summary_json(written)), after = Json::parse(summary_json(*read));
  for (const auto& [name, value] : before.items()) EXPECT_TRUE(name == "blocks" || after[name] == value) << name;
  EXPECT_EQ(read->effects.size(), 2u);
  EXPECT_EQ(read->work.facet_pairs, 3'000'000'000);
  EXPECT_TRUE(read->blocks.empty());
}

TEST(Summary, TroubleIsReadUnderItsOldNamesToo) {
  const TemporaryFolder temporary;
  std::filesystem::create_directories(temporary.path);
  const auto file = temporary.path / "summary.json";
  std::ofstream(file) << R"({"status": "not-converged", "struggles": [{"blocks": ["A", "B"], "cause": "found-late"},
      {"blocks": ["C"], "cause": "not-settled", "cuts": 2}, {"cause": "inverted-tetrahedron"}]})";
  const auto old = read_summary(file);
  ASSERT_TRUE(old);
  ASSERT_EQ(old->troubles.size(), 3u);
  EXPECT_EQ(old->troubles[0].cause, TroubleCause::missed_contact);
  EXPECT_EQ(old->troubles[0].blocks[1], "B");
  EXPECT_EQ(old->troubles[1].cause, TroubleCause::not_converged);
  EXPECT_EQ(old->troubles[1].cuts, 2);
  EXPECT_EQ(old->troubles[2].cause, TroubleCause::inverted);
}

TEST(Summary, WhatAFileLacksOrHasWrongIsLeftOutAndATornOneIsNone) {
  const TemporaryFolder temporary;
  std::filesystem::create_directories(temporary.path);
  const auto file = temporary.path / "summary.json";
  const auto read = [&](const std::string& text) {
    std::ofstream(file) << text;
    return read_summary(file);
  };
  EXPECT_FALSE(read_summary(temporary.path / "none.json"));
  EXPECT_FALSE(read(R"({ "events": [ {"time": )"));
  EXPECT_FALSE(read("[1, 2]"));
  EXPECT_FALSE(read(R"({"status": "fine"})"));
  const auto old = read(R"({"status": "stopped", "steps": 7, "wall_seconds": null, "phases": 3,
      "effects": [{"name": "inertia", "active": true, "reason": "always", "seconds": 0.5}, 4],
      "work": {"factorisations": "many", "wakings": 2}})");
  ASSERT_TRUE(old);
  EXPECT_EQ(old->status, RunStatus::stopped);
  EXPECT_EQ(old->steps, 7);
  EXPECT_EQ(old->wall_seconds, 0);
  ASSERT_EQ(old->effects.size(), 1u);
  EXPECT_EQ(old->effects[0].seconds, 0.5);
  EXPECT_EQ(old->effects[0].built, 0);
  EXPECT_EQ(old->work.factorisations, 0);
  EXPECT_EQ(old->work.wakings, 2);
  EXPECT_TRUE(old->troubles.empty());
  const auto odd =
      read(R"({"status": "stopped", "convergence_trouble": [7, {"blocks": "B1", "position": [1, null], "cuts": 3},
      {"blocks": ["A", "B", "C"], "cause": "boredom", "position": [1, 2, 3, 4]}]})");
  ASSERT_TRUE(odd);
  ASSERT_EQ(odd->troubles.size(), 2u);
  EXPECT_EQ(odd->troubles[0].cuts, 3);
  EXPECT_EQ(odd->troubles[0].blocks[0], "");
  EXPECT_EQ(odd->troubles[1].blocks[1], "B");
  EXPECT_EQ(odd->troubles[1].position, Vec3(1, 2, 3));
}

}  // namespace
}  // namespace talus
