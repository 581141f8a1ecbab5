#include "options.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <map>
#include <thread>

#include "base/error.hpp"
#include "measures/block_trails.hpp"
#include "project_choice.hpp"
#include "render/scene/slope_view.hpp"

namespace talus::cli {

namespace {

PictureSize parsed_size(const std::string& text) {
  PictureSize size{};
  int read = 0;
  const int fields = std::sscanf(text.c_str(), "%dx%d%n", &size.width, &size.height, &read);
  if (fields != 2 || static_cast<std::size_t>(read) != text.size() || size.width <= 0 || size.height <= 0)
    throw CLI::ValidationError("--size", "write it WIDTHxHEIGHT in pixels, like 1600x1000, not '" + text + "'");
  return size;
}

ValueRange parsed_range(const std::string& option, const std::string& text) {
  ValueRange range;
  int read = 0;
  const int numbers = std::sscanf(text.c_str(), "%lf,%lf%n", &range.low, &range.high, &read);
  const bool whole = numbers == 2 && static_cast<std::size_t>(read) == text.size();
  if (!whole || !std::isfinite(range.low) || !std::isfinite(range.high) || range.low >= range.high)
    throw CLI::ValidationError(option, "write it LOW,HIGH with LOW below HIGH, like 0,2.5e6, not '" + text + "'");
  return range;
}

std::string field_names() {
  std::string names;
  for (const Field& field : all_fields()) names += (names.empty() ? "" : ", ") + std::string(field.name);
  return names;
}

}  // namespace

void add_results(CLI::App& command, std::filesystem::path& results) {
  command.add_option("RESULTS", results, "Results folder, also of a run that goes on or was killed")
      ->required()
      ->type_name("DIR");
}

CLI::Option* add_size(CLI::App& command, PictureSize& size) {
  return command
      .add_option_function<std::string>(
          "--size", [&size](const std::string& text) { size = parsed_size(text); }, "Width and height in pixels")
      ->type_name("WxH")
      ->default_str(std::to_string(size.width) + "x" + std::to_string(size.height));
}

void add_theme(CLI::App& command, Theme& theme) {
  command
      .add_option_function<std::string>(
          "--theme", [&theme](const std::string& name) { theme = name == "dark" ? Theme::dark : Theme::light; },
          "Colours of the background and the writing")
      ->check(CLI::IsMember({"light", "dark"}).description(""))
      ->type_name("light|dark")
      ->default_str("light");
}

void add_threads(CLI::App& command, int& threads) {
  command.add_option("--threads", threads, "Threads to use at most; their number changes no bit of the results")
      ->check(CLI::Range(1, 1024).description(""))
      ->type_name("N")
      ->capture_default_str();
}

void add_frame_choice(CLI::App& command, FrameChoice& choice, const std::string& otherwise) {
  auto* time =
      command.add_option("--time", choice.time, "Frame nearest to this model time in s (default: " + otherwise + ")")
          ->type_name("T");
  command.add_option("--frame", choice.frame, "Frame by number, from 0")->type_name("K")->excludes(time);
}

int frame_index(const ResultReader& results, const FrameChoice& choice) {
  const auto& times = results.frame_times();
  const int count = static_cast<int>(times.size());
  if (count == 0) throw InputError("frames", "the results hold no frame yet", "wait for the run to write one");
  if (choice.time) {
    if (!std::isfinite(*choice.time)) throw InputError("--time", "this is no time", "give seconds of the model");
    const auto nearest = std::min_element(times.begin(), times.end(), [&](double a, double b) {
      return std::abs(a - *choice.time) < std::abs(b - *choice.time);
    });
    return static_cast<int>(nearest - times.begin());
  }
  const int frame = choice.frame.value_or(count - 1);
  if (frame < 0 || frame >= count)
    throw InputError("frame " + std::to_string(frame), "the results hold frames 0 to " + std::to_string(count - 1),
                     "choose one of these, or a --time");
  return frame;
}

void add_look(CLI::App& command, Look& look) {
  command.add_option("--field", look.field, "Colour by a field (default: a colour a block): " + field_names())
      ->type_name("NAME");
  command
      .add_option_function<std::string>(
          "--range", [&look](const std::string& text) { look.range = parsed_range("--range", text); },
          "Lowest and highest value of the legend, in the field's SI unit, like 0,2.5e6 (default: of the frame; of a "
          "film, of all frames)")
      ->type_name("LOW,HIGH");
  command
      .add_option_function<std::string>(
          "--only", [&look](const std::string& text) { look.only = parsed_range("--only", text); },
          "Draw only faces on which the field lies from LOW to HIGH, in its SI unit; of the others the edges stay")
      ->type_name("LOW,HIGH");
  const std::map<std::string, Arrows> arrows{{"none", Arrows::none},
                                             {"velocity", Arrows::velocity},
                                             {"force", Arrows::contact_force},
                                             {"stress", Arrows::principal_stress}};
  command
      .add_option_function<std::string>(
          "--arrows", [&look, arrows](const std::string& name) { look.arrows = arrows.at(name); },
          "Arrows of blocks' velocities or of the contact forces between each two blocks, or crosses of principal "
          "stresses")
      ->check(CLI::IsMember(arrows).description(""))
      ->type_name("none|velocity|force|stress")
      ->default_str("none");
  command.add_flag("--trails", look.trails, "Draw the ways that the blocks' centres have gone up to the frame");
  command.add_flag("--turning-axes", look.turning_axes,
                   "Draw the axes about which blocks turn in the frame, by the right hand");
  command
      .add_option("--view", look.view,
                  "Where to look from: auto (before the slope or what moves), iso, front, back, left, right or "
                  "top; or azimuth (clockwise from north) and elevation in degrees, like 300,25")
      ->type_name("NAME|A,E")
      ->capture_default_str();
  command.add_option("--title", look.title, "What stands at the top left (default: the project's name)")
      ->type_name("TEXT");
  const std::map<std::string, Edges> edges{{"none", Edges::none}, {"blocks", Edges::blocks}, {"mesh", Edges::mesh}};
  command
      .add_option_function<std::string>(
          "--edges", [&look, edges](const std::string& name) { look.edges = edges.at(name); },
          "Edges to draw: none, the blocks' or the whole mesh's")
      ->check(CLI::IsMember(edges).description(""))
      ->type_name("none|blocks|mesh")
      ->default_str("blocks");
  command.add_option("--scale", look.scale, "Draw displacements this many times too large")
      ->check(CLI::Validator(CLI::PositiveNumber).description(""))
      ->type_name("N")
      ->capture_default_str();
  command
      .add_option("--explode", look.explosion,
                  "Draw blocks apart, by this part of their way from the middle of all; fields of joints are seen on "
                  "their walls then")
      ->check(CLI::Validator(CLI::NonNegativeNumber).description(""))
      ->type_name("N")
      ->capture_default_str();
  command.add_flag("--contacts", look.contacts, "Show contact points: open grey, stick blue, slip orange");
  command.add_flag("--trouble,--struggles", look.troubles,
                   "Mark the contacts at which steps were cut or took many iterations (--struggles is the old name)");
  add_theme(command, look.theme);
  auto* view_file = command
                        .add_option("--view-file", look.view_file,
                                    "Draw a view that the window has saved, pixel for pixel where no --size is given; "
                                    "--time or --frame choose another frame")
                        ->type_name("VIEW.json");
  for (const char* said_there : {"--field", "--range", "--only", "--arrows", "--trails", "--turning-axes", "--view",
                                 "--edges", "--scale", "--explode", "--contacts", "--trouble", "--theme"})
    view_file->excludes(command.get_option(said_there));
}

SceneSettings scene_settings(const Look& look, const ResultReader& results) {
  SceneSettings settings;
  settings.theme = look.theme;
  settings.edges = look.edges;
  settings.contacts = look.contacts;
  settings.deformation_scale = look.scale;
  settings.explosion = look.explosion;
  settings.range = look.range;
  settings.only = look.only;
  settings.arrows = look.arrows;
  settings.trails = look.trails ? Trails::all : Trails::none;
  settings.turning_axes = look.turning_axes;
  settings.title = look.title.value_or(results.project_name());
  if (!look.field.empty()) settings.field = field_named(look.field);
  return settings;
}

std::vector<ActionGlyph> monitors_of(const std::filesystem::path& folder, const ResultReader& results) {
  std::vector<ActionGlyph> monitors;
  const std::filesystem::path file = folder / "project.talus";
  if (!std::filesystem::exists(file)) return monitors;
  const Project project = read_project(file, {.allow_outside = true});  // no file that it names is opened
  std::ranges::copy_if(action_glyphs(project, results.system()), std::back_inserter(monitors),
                       [](const ActionGlyph& glyph) { return glyph.kind == ActionGlyph::Kind::monitor; });
  return monitors;
}

void tell_trails(const ResultReader& results, Scene& scene) {
  if (scene.settings().trails == Trails::none) return;
  NoProgress quiet;
  scene.set_trails(std::make_shared<const BlockTrails>(block_trails(results, quiet)));
}

void mark_troubles(const Look& look, const ResultReader& results, Scene& scene) {
  if (!look.troubles) return;
  if (const auto report = results.report()) scene.set_troubles(report->troubles);
}

void point_camera(const Look& look, const ResultReader& results, Scene& scene) {
  if (look.view == "auto") {
    const Frame last = results.frame(static_cast<int>(results.frame_times().size()) - 1);
    look_at_slope(scene, results.system(), &last);
    return;
  }
  double azimuth = 0, elevation = 0;
  int read = 0;
  const int numbers = std::sscanf(look.view.c_str(), "%lf,%lf%n", &azimuth, &elevation, &read);
  if (numbers == 2 && static_cast<std::size_t>(read) == look.view.size())
    scene.look(azimuth, elevation);
  else
    scene.look(view_named(look.view));
}

}  // namespace talus::cli
