#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "process.hpp"

// Studies of accuracy as users run them: every run of a study is a process of its own.
namespace talus::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using testing::HasSubstr;

class Study : public testing::Test {
 protected:
  std::vector<std::string> command(const std::string& project, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"study",  "accuracy", project,  "--out",   folder().string(),
                                   "--jobs", "2",        "--size", "1200x800"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  fs::path folder() const { return folder_ / "study"; }
  Json json() const { return Json::parse(text_of(folder() / "accuracy.json")); }

  /// When each run was written.
  std::map<std::string, fs::file_time_type> runs() const {
    std::map<std::string, fs::file_time_type> files;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder() / "runs", none))
      if (entry.path().extension() == ".json") files[entry.path().filename()] = entry.last_write_time();
    return files;
  }

  /// A project whose runs take some tenths of a second.
  std::string slow_project() const {
    Json project = Json::parse(text_of(sample("free_fall")));
    project["solids"][0]["mesh_size"] = 0.3;
    const auto file = folder_ / "slow.talus";
    write_text(file, project.dump());
    return file.string();
  }

  Folder folder_;
};

TEST_F(Study, TellsErrorsCostsAndTheCheapestThatIsGoodEnough) {
  const Ending ending = talus_cli(command(sample("incline_slide"), {"--axes", "body,time_step", "--target", "0.1%"}));
  ASSERT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_THAT(ending.out, HasSubstr("is the cheapest that meets it"));
  EXPECT_THAT(text_of(folder() / "accuracy.png"), HasSubstr("PNG"));
  EXPECT_THAT(text_of(folder() / "accuracy.csv"), HasSubstr("number,label,body,strain,"));
  const Json study = json();
  EXPECT_TRUE(study["complete"]);
  ASSERT_TRUE(study["recommended"].is_number());
  const Json& chosen = study["runs"][study["recommended"].get<std::size_t>()];
  EXPECT_LE(chosen["error"], 0.001);

  // and what it recommends meets the target when it is solved again
  const Ending again =
      talus_cli({"solve", (folder() / "recommended.talus").string(), "--out", (folder_ / "r").string(), "--json"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  for (const Json& outcome : Json::parse(again.out)["expect"])
    EXPECT_LE(outcome["error"], outcome["value"] == 0 ? 1e-6 : 0.001);  // in m where zero is expected
}

TEST_F(Study, SaysTheErrorOfARunBeforeItIsMade) {
  const std::string project = slow_project();
  const auto forecast = [&] {
    return Json::parse(talus_cli({"info", project, "--json", "--forecast"}).out)["forecast"];
  };
  EXPECT_EQ(forecast()["error_from"], "step doubling");
  const Ending ending = talus_cli({"study", "accuracy", project, "--axes", "time_step"});
  ASSERT_EQ(ending.exit_code, 0) << ending.err;
  const Json made = Json::parse(text_of(folder_ / "slow.accuracy" / "accuracy.json"));
  EXPECT_EQ(forecast()["error_from"], "study");
  EXPECT_EQ(forecast()["error"], made["runs"][0]["error"]);
  EXPECT_THAT(talus_cli({"info", project, "--forecast"}).out, HasSubstr("(accuracy study)"));
  write_text(folder_ / "slow.accuracy" / "study.json", "{");
  const Ending broken = talus_cli({"info", project, "--json", "--forecast"});
  EXPECT_EQ(broken.exit_code, 0);
  EXPECT_THAT(broken.err, HasSubstr("study.json"));
  EXPECT_EQ(Json::parse(broken.out)["forecast"]["error_from"], "step doubling");
}

TEST_F(Study, ThatWasKilledGoesOnWhereItWas) {
  const auto study = command(slow_project(), {"--axes", "time_step,integrator"});
  std::map<std::string, fs::file_time_type> kept;
  {
    Cli cli(study);
    while (runs().size() < 3) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    cli.send(SIGKILL);
    EXPECT_EQ(cli.wait().signal, SIGKILL);
    std::this_thread::sleep_for(std::chrono::seconds(1));  // those that went on have noticed
    kept = runs();
  }
  const Ending again = talus_cli(study);
  ASSERT_EQ(again.exit_code, 0) << again.err;
  const auto all = runs();
  EXPECT_GT(all.size(), kept.size());
  for (const auto& [name, written] : kept) EXPECT_EQ(all.at(name), written) << name << " was run again";
  EXPECT_TRUE(json()["complete"]);
}

TEST_F(Study, ThatIsInterruptedEndsItsRunsAndSaysHowToGoOn) {
  Cli cli(command(slow_project()));
  while (runs().empty()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  cli.send(SIGINT);
  const Ending ending = cli.wait();
  EXPECT_EQ(ending.exit_code, 1);
  EXPECT_THAT(ending.err, HasSubstr("the same command goes on"));
  const auto made = runs();
  std::this_thread::sleep_for(std::chrono::seconds(1));
  EXPECT_EQ(runs(), made) << "a run went on";
}

TEST_F(Study, ShowsARunThatDoesNotConvergeAsARow) {
  Json project = Json::parse(text_of(sample("spinning_block")), nullptr, true, true);
  project["solids"][0]["body"] = "rigid";
  project["solver"]["open_close_limit"] = 1;  // enough for a rigid block, and for no other
  const auto file = folder_ / "hasty.talus";
  write_text(file, project.dump());
  const Ending ending = talus_cli(command(file.string(), {"--values", "body=rigid,affine"}));
  EXPECT_EQ(ending.exit_code, 0) << ending.err;
  EXPECT_THAT(ending.out, testing::ContainsRegex("\n +1 +affine +not converged "));
  EXPECT_THAT(text_of(folder() / "accuracy.csv"), HasSubstr(",not-converged,"));
  EXPECT_EQ(json()["runs"][1]["status"], "not-converged");
  EXPECT_EQ(json()["runs"].size(), 2u) << "an axis whose values are given is the one that is run";
}

TEST_F(Study, OfAnotherProjectIsNotMixedIn) {
  const std::vector<std::string> few{"--axes", "time_step", "--values", "time_step=1,2"};
  ASSERT_EQ(talus_cli(command(sample("free_fall"), few)).exit_code, 0);
  const Ending other = talus_cli(command(sample("incline_slide"), few));
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_THAT(other.err, HasSubstr("--restart"));
  auto restarted = few;
  restarted.push_back("--restart");
  EXPECT_EQ(talus_cli(command(sample("incline_slide"), restarted)).exit_code, 0);
}

TEST_F(Study, WrongWishesAreOneLine) {
  for (const auto& [words, expected] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"--axes", "colour"}, "axis 'colour': there is none of that name"},
           {{"--target", "soon"}, "target 'soon'"},
           {{"--values", "time_step=x"}, "axis time_step: 'x' is none of its values"},
           {{"--engine", "cloud"}, "--engine"}}) {
    const Ending ending = talus_cli(command(sample("free_fall"), words));
    EXPECT_EQ(ending.exit_code, 2);
    EXPECT_THAT(ending.err, HasSubstr(expected));
    EXPECT_EQ(std::count(ending.err.begin(), ending.err.end(), '\n'), 1);
  }
  EXPECT_FALSE(fs::exists(folder()));
  EXPECT_THAT(talus_cli({"study", "run", folder_.path().string(), "0"}).err, HasSubstr("holds no study"));
}

}  // namespace
}  // namespace talus::test
