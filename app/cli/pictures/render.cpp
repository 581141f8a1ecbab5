#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "output_file.hpp"
#include "pictures/drawing.hpp"
#include "pictures/picture_check.hpp"
#include "render/paint/picture_difference.hpp"
#include "text/json_text.hpp"
#include "text/picture_text.hpp"

namespace talus::cli {

namespace {

/// What is drawn is held against a picture that was right.
struct PictureCheck {
  std::filesystem::path baseline;  ///< empty: nothing is compared
  std::filesystem::path junit;     ///< empty: no report
  double threshold = alike_enough;
  bool update = false;  ///< the baseline becomes what was drawn
};

struct RenderOptions {
  Drawing drawing;
  std::filesystem::path out;
  PictureCheck check;
};

void write_junit(const PictureCheck& check, const std::string& failure) {
  if (!check.junit.empty())
    write_output(check.junit, junit_text("talus-cli render", {{check.baseline.filename().string(), failure}}));
}

/// Drawing into `out` must not replace the baseline that it is compared with.
void refuse_to_overwrite_baseline(const PictureCheck& check, const std::filesystem::path& out) {
  std::error_code none_yet;
  if (std::filesystem::equivalent(out, check.baseline, none_yet))
    throw InputError("--compare " + check.baseline.string(), "is the picture to draw, too", "give --out another name");
}

/// Compares what was drawn, and written to `out`, with the baseline, or replaces this; adds what came of it to `json`
/// and to `text`, as a line of its own. Throws InputError where there is no baseline.
ExitCode check_picture(const PictureCheck& check, const Image& drawn, const std::filesystem::path& out,
                       nlohmann::ordered_json& json, std::string& text) {
  if (check.baseline.empty()) return done;
  json["baseline"] = check.baseline.string();
  // The difference that an earlier call has drawn says nothing of this one.
  std::error_code ignored;
  std::filesystem::remove(difference_file(out), ignored);
  if (check.update) {
    write_output(check.baseline, png_of(drawn));
    json["updated"] = true;
    text += check.baseline.string() + ": is now what was drawn\n";
    return done;
  }
  if (!std::filesystem::exists(check.baseline)) {
    write_junit(check, "there is no " + check.baseline.string());
    throw InputError(check.baseline.string(), "there is no such baseline",
                     "look at " + out.string() + " and, if it is right, make it the baseline by --update");
  }
  json["threshold"] = check.threshold;
  const PictureVerdict verdict =
      compare_with_baseline(drawn, out, check.baseline, check.threshold, difference_file(out));
  json.update(verdict.json);
  json["same"] = verdict.problem.empty();
  write_junit(check, verdict.problem);
  text += (verdict.problem.empty() ? out.string() + " is as " + check.baseline.string() + ": " + verdict.agreement
                                   : verdict.problem) +
          '\n';
  if (verdict.problem.empty()) return done;
  json["problem"] = verdict.problem;
  return failed;
}

void print(const RenderOptions& options, const std::vector<DrawnFrame>& frames, const std::string& verdict) {
  std::cout << options.out.string() << ": ";
  for (const DrawnFrame& one : frames)
    std::cout << (frames.size() > 1 ? one.results.string() + " " : "") << "frame " << one.frame << ", " << one.time
              << (&one == &frames.back() ? " s\n" : " s; ");
  std::cout << verdict;
}

ExitCode render(const RenderOptions& options, bool json) {
  refuse_to_overwrite_baseline(options.check, options.out);
  const auto [drawn, frames] = draw(options.drawing);
  write_png(drawn, options.out);

  nlohmann::ordered_json picture = {{"picture", options.out.string()},
                                    {"width", drawn.width},
                                    {"height", drawn.height},
                                    {"frame", frames.front().frame},
                                    {"time", frames.front().time}};
  for (std::size_t i = 1; i < frames.size(); ++i)
    picture["beside"].push_back(
        {{"results", frames[i].results.string()}, {"frame", frames[i].frame}, {"time", frames[i].time}});
  std::string verdict;
  const ExitCode code = check_picture(options.check, drawn, options.out, picture, verdict);
  if (json)
    std::cout << json_text(picture) << '\n';
  else
    print(options, frames, verdict);
  return code;
}

void add_picture_check(CLI::App& command, PictureCheck& check) {
  auto* compare = command
                      .add_option("--compare", check.baseline,
                                  "Compare with this picture, tile by tile; ends with 1 where they differ, and draws "
                                  "the difference into P.difference.png")
                      ->type_name("BASELINE.png");
  add_threshold(command, check.threshold)->needs(compare);
  auto* junit = command.add_option("--junit", check.junit, "Write the outcome of --compare as a JUnit report")
                    ->type_name("FILE.xml")
                    ->needs(compare);
  command.add_flag("--update", check.update, "Make what was drawn the baseline that --compare names")
      ->needs(compare)
      ->excludes(junit);
}

}  // namespace

void add_render(CLI::App& program, Invocation& invocation) {
  auto* command = program.add_subcommand(
      "render", "Draw one frame as a PNG, also of several results side by side; needs no display");
  auto options = std::make_shared<RenderOptions>();
  command->add_option("--out", options->out, "Picture to write")->required()->type_name("P.png");
  add_drawing(*command, options->drawing);
  add_picture_check(*command, options->check);
  command->callback([&invocation, options] {
    invocation.run = [&invocation, options] { return render(*options, invocation.json); };
  });
}

}  // namespace talus::cli
