#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "process.hpp"

// Runs that do not come to their end: Ctrl-C stops after the step, a kill leaves readable results, and both go on.
namespace talus::test {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

class Interrupted : public testing::Test {
 protected:
  void SetUp() override {
    Json project = Json::parse(text_of(sample("free_fall")));
    project["stages"][0]["duration"] = 1e5;
    project.erase("expect");
    write_text(folder_ / "endless.talus", project.dump());
  }

  /// Lets the endless run go until something that it writes is there, for a minute at most.
  template <typename IsThere>
  void wait_until(Cli& cli, IsThere&& is_there) {
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (!is_there()) {
      if (std::chrono::steady_clock::now() > give_up) {
        cli.send(SIGKILL);
        FAIL() << "not there after a minute: " << cli.wait().err;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }

  /// Lets the endless run go until it has written that it has taken so many steps.
  void start_and_wait(Cli& cli, int steps) {
    wait_until(cli, [&] {
      const std::string table = text_of(folder_ / "r/steps.csv");
      return std::count(table.begin(), table.end(), '\n') > steps;
    });
  }

  std::string results() const { return (folder_ / "r").string(); }

  Folder folder_;
};

TEST_F(Interrupted, CtrlCStopsAfterTheStepAndSaysSo) {
  Cli cli({"solve", (folder_ / "endless.talus").string(), "--out", results(), "--json"});
  ASSERT_NO_FATAL_FAILURE(start_and_wait(cli, 50));
  cli.send(SIGINT);
  const Ending ending = cli.wait();
  EXPECT_EQ(ending.exit_code, 1);
  const Json summary = Json::parse(ending.out);
  EXPECT_EQ(summary["status"], "stopped");
  EXPECT_GE(summary["steps"], 50);
  EXPECT_EQ(Json::parse(text_of(folder_ / "r/summary.json"))["status"], "stopped");
}

TEST_F(Interrupted, OneWishToStopMayComeAsTwoSignals) {
  // As `timeout` sends it: to the process and to its group.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    Cli cli({"solve", (folder_ / "endless.talus").string(), "--out", results(), "--json"});
    ASSERT_NO_FATAL_FAILURE(start_and_wait(cli, 50));
    cli.send(signal);
    cli.send(signal);
    const Ending ending = cli.wait();
    EXPECT_EQ(ending.exit_code, 1) << signal;
    EXPECT_EQ(Json::parse(text_of(folder_ / "r/summary.json"))["status"], "stopped") << signal;
    std::filesystem::remove_all(folder_ / "r");
  }
}

TEST_F(Interrupted, CuttingAndMeshingStopAtOnce) {
  Json project = Json::parse(text_of(folder_ / "endless.talus"));
  project["solids"] = {{{"name", "b"},
                        {"box", {{"min", {0, 0, 0}}, {"max", {10, 10, 10}}}},
                        {"material", "rock"},
                        {"body", "tetrahedra"}}};
  project["cuts"] = Json::array();
  for (int i = 0; i < 100; ++i)
    project["cuts"].push_back(
        {{"joint", "J1"}, {"dip", 0.9 * i}, {"dip_direction", 37 * i % 360}, {"through", {0.1 * i, 5, 3}}});
  project.erase("monitors");
  write_text(folder_ / "many.talus", project.dump());
  const std::pair<const char*, int> tries[] = {{"mesh", SIGTERM}, {"info", SIGINT}, {"solve", SIGHUP}};
  for (const auto& [command, signal] : tries) {
    Cli cli({command, (folder_ / "many.talus").string()});
    ASSERT_NO_FATAL_FAILURE(wait_until(cli, [&] { return cli.said().find("cutting ") != std::string::npos; }));
    const auto sent = std::chrono::steady_clock::now();
    cli.send(signal);
    const Ending ending = cli.wait();
    EXPECT_LT(std::chrono::steady_clock::now() - sent, std::chrono::seconds(1)) << command;
    EXPECT_EQ(ending.exit_code, 1) << command;
    EXPECT_THAT(ending.err, HasSubstr("cutting ")) << command << " tells what it does, and for how long";
    EXPECT_THAT(ending.err, HasSubstr("talus-cli: stopped; nothing was written\n")) << command;
  }
}

TEST_F(Interrupted, AKilledRunGoesOnToTheSameNumbers) {
  Json project = Json::parse(text_of(folder_ / "endless.talus"));
  const auto file = (folder_ / "fall.talus").string();
  const auto set_duration = [&](double duration) {
    project["stages"][0]["duration"] = duration;
    write_text(file, project.dump());
  };
  set_duration(20);
  const auto whole = (folder_ / "whole").string();
  ASSERT_EQ(talus_cli({"solve", file, "--out", whole}).exit_code, 0);

  set_duration(19);
  Cli cli({"solve", file, "--out", results(), "--checkpoint-every", "0.01"});
  ASSERT_NO_FATAL_FAILURE(wait_until(cli, [&] { return std::filesystem::exists(folder_ / "r/checkpoint.h5"); }));
  cli.send(SIGKILL);
  cli.wait();
  EXPECT_GT(Json::parse(talus_cli({"info", results(), "--json"}).out)["checkpoint"], 0);
  EXPECT_THAT(talus_cli({"info", results()}).out, HasSubstr("solve --resume goes on from t = "));
  const Ending resumed = talus_cli({"solve", file, "--out", results(), "--resume"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_THAT(resumed.err, HasSubstr("Goes on at t = "));
  set_duration(20);
  EXPECT_EQ(talus_cli({"solve", file, "--out", results(), "--resume"}).exit_code, 0);
  EXPECT_EQ(text_of(folder_ / "r/history.csv"), text_of(folder_ / "whole/history.csv"));

  project["stages"][0]["time_step"] = 0.5;
  write_text(file, project.dump());
  const Ending refused = talus_cli({"solve", file, "--out", results(), "--resume"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("fall.talus: stages/0/time_step: is not what it was when the run began"));
  EXPECT_EQ(text_of(folder_ / "r/history.csv"), text_of(folder_ / "whole/history.csv")) << "nothing is touched";
}

TEST_F(Interrupted, ARunStopsWhenItsTimeIsUp) {
  const Ending ending =
      talus_cli({"solve", (folder_ / "endless.talus").string(), "--out", results(), "--max-wall", "0.5", "--json"});
  EXPECT_EQ(ending.exit_code, 1);
  EXPECT_EQ(Json::parse(ending.out)["status"], "stopped");
  EXPECT_TRUE(std::filesystem::exists(folder_ / "r/checkpoint.h5"));
}

TEST_F(Interrupted, ARunWithoutACheckpointBeginsAtTheStart) {
  const Ending ending = talus_cli({"solve", sample("free_fall"), "--out", results(), "--resume"});
  EXPECT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_THAT(ending.err, HasSubstr("No checkpoint in " + results()));
}

TEST_F(Interrupted, AKilledRunLeavesWhatItHadReadable) {
  Cli cli({"solve", (folder_ / "endless.talus").string(), "--out", results()});
  ASSERT_NO_FATAL_FAILURE(start_and_wait(cli, 50));
  cli.send(SIGKILL);
  EXPECT_EQ(cli.wait().signal, SIGKILL);

  const Ending info = talus_cli({"info", results(), "--json"});
  ASSERT_EQ(info.exit_code, 0) << info.err;
  const Json found = Json::parse(info.out);
  EXPECT_EQ(found["status"], "unfinished");
  EXPECT_GE(found["steps"], 50);
  EXPECT_GE(found["frames"], 10);

  const auto picture = (folder_ / "p.png").string();
  const Ending render = talus_cli({"render", results(), "--out", picture, "--size", "160x120", "--field", "velocity"});
  EXPECT_EQ(render.exit_code, 0) << render.err;
  EXPECT_THAT(text_of(picture), HasSubstr("PNG"));
  EXPECT_EQ(talus_cli({"plot", results(), "--out", (folder_ / "charts").string()}).exit_code, 0);

  // and the folder may be used again
  const Ending again = talus_cli({"solve", sample("free_fall"), "--out", results()});
  EXPECT_EQ(again.exit_code, 0) << again.err;
}

}  // namespace
}  // namespace talus::test
