#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "output_file.hpp"
#include "pictures/baseline_list.hpp"
#include "pictures/picture_check.hpp"
#include "render/paint/picture_difference.hpp"
#include "text/json_text.hpp"
#include "text/picture_text.hpp"

namespace talus::cli {

namespace {

struct BaselineOptions {
  std::filesystem::path folder = "baselines", out = "differing_pictures", junit;
  std::vector<std::string> names;  ///< of the pictures that are meant; empty: all
  double threshold = alike_enough;
};

/// Those that are meant. Throws InputError for a name that the list does not have.
std::vector<Baseline> chosen(const BaselineOptions& options) {
  std::vector<Baseline> all = read_baselines(options.folder), some;
  if (options.names.empty()) return all;
  for (const std::string& name : options.names) {
    const auto found = std::ranges::find(all, name, &Baseline::name);
    if (found == all.end())
      throw InputError("--picture " + name, "the list has no such picture",
                       "take one of " + (options.folder / "baselines.txt").string());
    if (!std::ranges::count(some, name, &Baseline::name)) some.push_back(*found);
  }
  return some;
}

Image drawn(const Baseline& baseline) {
  return about(baseline.line, [&] { return draw(baseline.drawing).picture; });
}

/// Draws the picture and leaves it in `out`, with what differs, where it is not as its baseline. What cannot be drawn
/// is told as a difference: the others are looked at all the same.
PictureVerdict check_one(const Baseline& baseline, const BaselineOptions& options) {
  const std::filesystem::path picture = options.out / baseline.name;
  std::error_code ignored;  // what an earlier call has left says nothing of this one
  std::filesystem::remove(picture, ignored);
  std::filesystem::remove(difference_file(picture), ignored);
  try {
    const Image image = drawn(baseline);
    const PictureVerdict verdict =
        std::filesystem::exists(baseline.file)
            ? compare_with_baseline(image, picture, baseline.file, options.threshold, difference_file(picture))
            : PictureVerdict{.problem = "there is no " + baseline.file.string() + "; look at " + picture.string() +
                                        " and, if it is right, make it the baseline by baseline update"};
    if (!verdict.problem.empty()) {
      std::filesystem::create_directories(picture.parent_path());
      write_png(image, picture);
    }
    return verdict;
  } catch (const InputError& error) {
    return {.problem = error.what()};
  }
}

ExitCode check(const BaselineOptions& options, bool as_json) {
  std::vector<PictureTest> tests;
  nlohmann::ordered_json pictures = nlohmann::ordered_json::array();
  std::ptrdiff_t same = 0;
  for (const Baseline& baseline : chosen(options)) {
    const PictureVerdict verdict = check_one(baseline, options);
    const bool is_same = verdict.problem.empty();
    same += is_same;
    tests.push_back({baseline.name, verdict.problem});
    pictures.push_back({{"picture", baseline.name}, {"baseline", baseline.file.string()}, {"same", is_same}});
    pictures.back().update(verdict.json);
    if (!is_same) pictures.back()["problem"] = verdict.problem;
    if (!as_json)
      std::cout << (is_same ? baseline.file.string() + ": " + verdict.agreement : verdict.problem) << '\n'
                << std::flush;
  }
  if (!options.junit.empty()) write_output(options.junit, junit_text("talus-cli baseline", tests));
  const bool all_same = same == std::ssize(tests);
  if (as_json)
    std::cout << json_text({{"same", all_same}, {"threshold", options.threshold}, {"pictures", pictures}}) << '\n';
  else
    std::cout << same << " of " << tests.size() << " pictures are as their baselines\n";
  return all_same ? done : failed;
}

/// Whether the picture is so unlike its baseline that this is to be replaced.
bool is_outdated(const Baseline& baseline, const Image& image, double threshold) {
  if (!std::filesystem::exists(baseline.file)) return true;
  const Image before = read_png(baseline.file);
  return before.width != image.width || before.height != image.height ||
         compare_pictures(before, image, threshold).differing > 0;
}

ExitCode update(const BaselineOptions& options, bool as_json) {
  nlohmann::ordered_json updated = nlohmann::ordered_json::array(), kept = updated;
  for (const Baseline& baseline : chosen(options)) {
    const Image image = drawn(baseline);
    const bool outdated = is_outdated(baseline, image, options.threshold);
    if (outdated) {
      std::filesystem::create_directories(baseline.file.parent_path());
      write_output(baseline.file, png_of(image));
    }
    (outdated ? updated : kept).push_back(baseline.file.string());
    if (!as_json)
      std::cout << baseline.file.string() << (outdated ? ": is now what was drawn\n" : ": stays as it is\n")
                << std::flush;
  }
  if (as_json) std::cout << json_text({{"updated", updated}, {"kept", kept}}) << '\n';
  return done;
}

void add_choice(CLI::App& command, BaselineOptions& options) {
  command
      .add_option(
          "FOLDER", options.folder,
          "Of the baselines; its list baselines.txt has a line each: PICTURE.png RESULTS… and options of render, "
          "paths from the folder on")
      ->type_name("DIR")
      ->capture_default_str();
  command.add_option("--picture", options.names, "Only this one; may be given again")->type_name("NAME.png");
  add_threshold(command, options.threshold);
}

void add_check(CLI::App& group, Invocation& invocation) {
  auto* command = group.add_subcommand(
      "check",
      "Draw all pictures of a list again and compare them with their baselines; ends with 1 where one differs");
  auto options = std::make_shared<BaselineOptions>();
  add_choice(*command, *options);
  command->add_option("--out", options->out, "Folder for the pictures that differ, and what differs in them")
      ->type_name("DIR")
      ->capture_default_str();
  command->add_option("--junit", options->junit, "Write the outcome as a JUnit report, a test a picture")
      ->type_name("FILE.xml");
  command->callback(
      [&invocation, options] { invocation.run = [&invocation, options] { return check(*options, invocation.json); }; });
}

void add_update(CLI::App& group, Invocation& invocation) {
  auto* command = group.add_subcommand(
      "update", "Make what is drawn now the baselines of pictures that are new or differ from theirs");
  auto options = std::make_shared<BaselineOptions>();
  add_choice(*command, *options);
  command->callback([&invocation, options] {
    invocation.run = [&invocation, options] { return update(*options, invocation.json); };
  });
}

}  // namespace

void add_baseline(CLI::App& program, Invocation& invocation) {
  auto* command =
      program.add_subcommand("baseline", "Check or replace pictures that were right, by a list of how they are drawn");
  command->require_subcommand(1);
  add_check(*command, invocation);
  add_update(*command, invocation);
  for (CLI::App* part : command->get_subcommands({})) part->fallthrough();  // --json may follow the folder
}

}  // namespace talus::cli
