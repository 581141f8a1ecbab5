#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "options.hpp"
#include "output_file.hpp"
#include "render/paint/picture_difference.hpp"
#include "render/scene/offscreen.hpp"
#include "render/views/view_of_results.hpp"
#include "side_by_side.hpp"
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
  std::vector<std::filesystem::path> results;
  std::filesystem::path out;
  FrameChoice choice;
  PictureSize size{1600, 1000};
  bool has_size = false;  ///< it was given
  Look look;
  bool over = false;  ///< the second results over the first
  PictureCheck check;
};

std::filesystem::path difference_file(std::filesystem::path out) { return out.replace_extension(".difference.png"); }

void write_junit(const PictureCheck& check, const std::string& failure) {
  if (!check.junit.empty()) write_output(check.junit, junit_text(check.baseline.filename().string(), failure));
}

/// In which way the pictures differ; empty where they do not.
std::string compared(const PictureCheck& check, const Image& drawn, const std::filesystem::path& out,
                     nlohmann::ordered_json& json, std::string& text) {
  const Image expected = read_png(check.baseline);
  const std::string differs = out.string() + " differs from " + check.baseline.string() + ": ";
  if (expected.width != drawn.width || expected.height != drawn.height)
    return differs + "it has " + pixels_text(drawn.width, drawn.height) + ", the baseline " +
           pixels_text(expected.width, expected.height) + "; draw with --size " + std::to_string(expected.width) + "x" +
           std::to_string(expected.height) + " or replace the baseline by --update";

  const PictureDifference found = compare_pictures(expected, drawn, check.threshold);
  json["similarity"] = found.similarity;
  json["worst"] = tile_json(found.worst);
  json["tiles"] = found.tiles;
  json["differing"] = found.differing;
  if (found.differing == 0) {
    text += out.string() + " is as " + check.baseline.string() + ": " + difference_text(found, check.threshold) + '\n';
    return {};
  }
  const std::filesystem::path picture = difference_file(out);
  write_png(difference_picture(expected, drawn, check.threshold), picture);
  json["region"] = tile_json(found.region);
  json["difference_picture"] = picture.string();
  return differs + difference_text(found, check.threshold) + "; look at " + picture.string();
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
  const std::string difference = compared(check, drawn, out, json, text);
  json["same"] = difference.empty();
  write_junit(check, difference);
  if (difference.empty()) return done;
  json["problem"] = difference;
  text += difference + '\n';
  return failed;
}

SideBySide drawn_as_saved(const RenderOptions& options) {
  if (options.results.size() > 1)
    throw InputError("--view-file", "a view is drawn of one results folder",
                     "leave the view out, or draw them one by one");
  const std::filesystem::path& folder = options.results.front();
  const ResultReader results(folder);
  const SavedView view = read_view(options.look.view_file);
  const bool other_frame = options.choice.time || options.choice.frame;
  const int index =
      about(folder, [&] { return other_frame ? frame_index(results, options.choice) : frame_of_view(view, results); });
  const auto frame = std::make_shared<const Frame>(results.frame(index));
  about(folder, [&] { need_field(results.system(), *frame, view.settings); });
  const bool as_it_was = !options.has_size;
  const auto scene = about(options.look.view_file,
                           [&] { return scene_of_view(view, results, monitors_of(folder, results), as_it_was); });
  scene->set_frame(frame);
  return {as_it_was ? draw_view(*scene, view) : draw_image(*scene, options.size.width, options.size.height),
          {{folder, index, frame->time}}};
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
  const auto [drawn, frames] =
      options.look.view_file.empty()
          ? draw_side_by_side(options.results, options.choice, options.look, options.over, options.size)
          : drawn_as_saved(options);
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
  command
      .add_option_function<double>(
          "--threshold",
          [&check](double share) {
            if (!(share >= 0 && share <= 1)) throw CLI::ValidationError("--threshold", "write a number from 0 to 1");
            check.threshold = share;
          },
          "Similarity that the worst tile must have; 1: equal pictures")
      ->type_name("T")
      ->default_str("0.75")
      ->needs(compare);
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
  command
      ->add_option("RESULTS", options->results,
                   "Results folder, also of a run that goes on or was killed; up to four are drawn side by side")
      ->required()
      ->type_name("DIR");
  command->add_option("--out", options->out, "Picture to write")->required()->type_name("P.png");
  add_frame_choice(*command, options->choice);
  const CLI::Option* size = add_size(*command, options->size);
  add_over(*command, options->over);
  add_look(*command, options->look);
  add_picture_check(*command, options->check);
  command->callback([&invocation, options, size] {
    options->has_size = size->count() > 0;
    invocation.run = [&invocation, options] { return render(*options, invocation.json); };
  });
}

}  // namespace talus::cli
