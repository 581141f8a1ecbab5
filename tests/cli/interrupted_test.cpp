#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "process.hpp"

// Runs that do not come to their end: Ctrl-C stops after the step, and a kill leaves readable results.
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

  /// Lets the endless run go until it has written that it has taken so many steps.
  void start_and_wait(Cli& cli, int steps) {
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    for (;;) {
      const std::string table = text_of(folder_ / "r/steps.csv");
      if (std::count(table.begin(), table.end(), '\n') > steps) return;
      if (std::chrono::steady_clock::now() > give_up) {
        cli.send(SIGKILL);
        FAIL() << "not so many steps after a minute: " << cli.wait().err;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
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
