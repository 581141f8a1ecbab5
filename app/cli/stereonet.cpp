#include <CLI/CLI.hpp>

#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "options.hpp"
#include "orientation/project_joints.hpp"
#include "output_file.hpp"
#include "project_choice.hpp"
#include "render/stereonet/slipped_joints.hpp"
#include "render/stereonet/stereonet_picture.hpp"
#include "sheet.hpp"
#include "text/json_text.hpp"
#include "text/orientation_text.hpp"
#include "text/terminal.hpp"

namespace talus::cli {

namespace {

using Json = nlohmann::ordered_json;

struct StereonetOptions {
  std::filesystem::path file, picture, table;
  std::string title, density = "none", face, window;
  Projection projection = Projection::equal_area;
  FailureMode mode = FailureMode::planar;
  double friction_angle = 30, lateral_limit = 20;
  PictureSize size{1600, 1000};
  Theme theme = Theme::light;
};

/// By an object of JSON or a comment before it: no table begins so.
bool begins_as_project(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  return first != std::string::npos && (text[first] == '{' || text[first] == '/');
}

/// The planes on which blocks of a run slid on each other, as they were at rest, by the names of their joints.
std::vector<MeasuredJoint> joints_that_slipped_in(const std::filesystem::path& folder) {
  catch_interrupts();
  const ResultReader results(folder);
  TerminalProgress progress;
  const std::vector<MeasuredJoint> joints =
      joints_that_slipped(slipped_faces(results, progress), results.system().joint_names);
  if (joints.empty())
    throw InputError(folder.string(), "no block slid on another one that it lay against", "give a project or a table");
  return joints;
}

std::vector<MeasuredJoint> joints_in(const std::filesystem::path& file) {
  if (std::filesystem::is_directory(file)) return joints_that_slipped_in(file);
  const ProjectChoice choice{file, {.allow_outside = true}};  // no file that it names is opened
  const std::string text = text_of(choice);
  Project project;
  const bool is_project = choice.is_standard_input() ? begins_as_project(text) : file.extension() == ".talus";
  if (is_project) project = read(choice, text);
  return about(choice.name(), [&] {
    const std::vector<MeasuredJoint> joints =
        is_project ? joints_of(project).joints : sound_joints(read_joint_table(text));
    if (joints.empty()) throw InputError("joints", "there are none", "give the project a cut, or the table a line");
    return joints;
  });
}

Stereonet net_of(const StereonetOptions& options) {
  Stereonet net;
  if (!options.face.empty())
    net.slope = {plane_from_text(options.face, "--face"), options.friction_angle, options.lateral_limit};
  if (!options.window.empty()) net.window = window_from_text(options.window, "--window");
  if (options.density != "none") net.density = options.density == "kamb" ? DensityMethod::kamb : DensityMethod::fisher;
  net.joints = joints_in(options.file);
  net.projection = options.projection;
  net.mode = options.mode;
  net.theme = options.theme;
  return net;
}

Json json_of(const PlaneAttitude& plane) { return {{"dip", plane.dip}, {"dip_direction", plane.dip_direction}}; }

Json json_of(const SetStatistics& set) {
  const auto cone = confidence_cone(set.fisher, 0.95);
  const PlaneAttitude axis = attitude_of_normal(set.axis.pole);
  return {{"set", set.name},
          {"poles", set.members.size()},
          {"mean", json_of(set.mean_plane())},
          {"resultant", set.fisher.resultant},
          {"kappa", set.fisher.kappa ? Json(*set.fisher.kappa) : Json()},
          {"confidence_cone_95", cone ? Json(*cone) : Json()},
          {"axis_mean", json_of(axis)},
          {"eigenvalues", set.axis.eigenvalues}};
}

Json json_of(const KinematicCount& count) {
  return {{"critical", count.count}, {"of", count.total}, {"percent", count.percent()}};
}

Json json_of(const KinematicCounts& counts, const KinematicSetting& setting) {
  return {{"face", json_of(setting.face)},
          {"friction_angle", setting.friction_angle},
          {"lateral_limit", setting.lateral_limit},
          {"planar", json_of(counts.planar)},
          {"planar_without_limits", json_of(counts.planar_unlimited)},
          {"wedge", json_of(counts.wedge)},
          {"wedge_on_one_plane", json_of(counts.on_one_plane)},
          {"wedge_with_flat_line", json_of(counts.wedge_flat)},
          {"flexural_toppling", json_of(counts.flexural)},
          {"direct_toppling", json_of(counts.direct)},
          {"direct_toppling_oblique", json_of(counts.direct_oblique)},
          {"base_planes", json_of(counts.base)},
          {"base_planes_oblique", json_of(counts.base_oblique)}};
}

/// What the command found: sets, the set in the window, how many poles and intersections are critical.
struct Findings {
  std::vector<SetStatistics> sets;
  std::vector<SetStatistics> picked;  ///< none or one
  std::optional<KinematicCounts> counts;
};

Findings findings_of(const Stereonet& net) {
  Findings found;
  found.sets = statistics_by_set(net.joints);
  if (net.window) {
    auto members = picked(*net.window, poles_of(net.joints));
    if (members.empty()) throw InputError("--window", "no pole lies in it", "make it wider");
    found.picked.push_back(statistics_of(net.joints, std::move(members), window_text(*net.window)));
  }
  if (net.slope) {
    std::vector<PlaneAttitude> planes;
    for (const MeasuredJoint& joint : net.joints) planes.push_back(joint.plane);
    found.counts = kinematic_counts(planes, *net.slope);
  }
  return found;
}

void print(const Findings& found, const Stereonet& net) {
  std::cout << sets_text(found.sets);
  if (!found.picked.empty()) std::cout << "\nIn the window\n" << sets_text(found.picked);
  if (found.counts) std::cout << '\n' << kinematics_text(*found.counts, *net.slope);
}

Json json_of(const Findings& found, const Stereonet& net) {
  Json json = {{"poles", net.joints.size()}, {"sets", Json::array()}};
  for (const SetStatistics& set : found.sets) json["sets"].push_back(json_of(set));
  if (!found.picked.empty()) json["window"] = json_of(found.picked.front());
  if (found.counts) json["kinematics"] = json_of(*found.counts, *net.slope);
  return json;
}

ExitCode stereonet(const StereonetOptions& options, bool json) {
  const Stereonet net = net_of(options);
  const Findings found = findings_of(net);
  std::vector<std::string> files;
  if (!options.picture.empty()) {
    const std::string of_results = std::filesystem::is_directory(options.file) ? "Joints that slipped: " : "";
    const std::string title =
        options.title.empty() && options.file != "-" ? of_results + options.file.stem().string() : options.title;
    write_sheet({{{stereonet_painting(net, title)}}, options.size, colours(net.theme).surface, title}, options.picture);
    files.push_back(options.picture.string());
  }
  if (!options.table.empty()) {
    write_output(options.table, joint_table_text(net.joints));
    files.push_back(options.table.string());
  }
  if (json) {
    Json result = json_of(found, net);
    result["files"] = files;
    std::cout << json_text(result) << '\n';
  } else {
    print(found, net);
    for (const std::string& file : files) std::cout << file << '\n';
  }
  return done;
}

void add_analysis(CLI::App& command, StereonetOptions& options) {
  command
      .add_option("--density", options.density, "Contours of the density of poles: smoothed by Fisher, or by Kamb in σ")
      ->check(CLI::IsMember({"none", "fisher", "kamb"}).description(""))
      ->type_name("none|fisher|kamb")
      ->capture_default_str();
  command.add_option("--face", options.face, "Slope face for the kinematic check, dip/dip direction as in 65/140")
      ->type_name("DIP/DIR");
  command.add_option("--friction", options.friction_angle, "Friction angle of all joints in degrees")
      ->check(CLI::Range(0.0, 90.0).description(""))
      ->type_name("DEG")
      ->capture_default_str();
  command.add_option("--lateral", options.lateral_limit, "Limits to either side of the face's direction in degrees")
      ->check(CLI::Range(0.0, 90.0).description(""))
      ->type_name("DEG")
      ->capture_default_str();
  const std::map<std::string, FailureMode> modes{{"planar", FailureMode::planar},
                                                 {"wedge", FailureMode::wedge},
                                                 {"flexural", FailureMode::flexural},
                                                 {"direct", FailureMode::direct}};
  command
      .add_option_function<std::string>(
          "--mode", [&options, modes](const std::string& name) { options.mode = modes.at(name); },
          "Way of failing whose critical zone the picture shows")
      ->check(CLI::IsMember(modes).description(""))
      ->type_name("planar|wedge|flexural|direct")
      ->default_str("planar");
  command
      .add_option("--window", options.window,
                  "Picks a set: all within an angle of a plane's pole, or ranges of dip (above 90: dipping the other "
                  "way) and dip direction")
      ->type_name("45/120~15|30..60/100..140");
}

}  // namespace

void add_stereonet(CLI::App& program, Invocation& invocation) {
  auto* command = program.add_subcommand(
      "stereonet", "Sets of joints with their means, the kinematic check of a face, and a stereonet");
  auto options = std::make_shared<StereonetOptions>();
  command
      ->add_option(
          "FILE", options->file,
          "Project, or table of joints (CSV, TSV, text); - reads standard input; of a results folder the joints that "
          "slipped")
      ->required()
      ->type_name("P.talus|T.csv|RESULTS");
  command
      ->add_option_function<std::string>(
          "--projection",
          [options](const std::string& name) {
            options->projection = name == "area" ? Projection::equal_area : Projection::equal_angle;
          },
          "Equal area (Schmidt) or equal angle (Wulff); lower hemisphere")
      ->check(CLI::IsMember({"area", "angle"}).description(""))
      ->type_name("area|angle")
      ->default_str("area");
  add_analysis(*command, *options);
  command->add_option("--picture", options->picture, "Draws the net")->type_name("P.png|P.svg|P.pdf");
  command->add_option("--title", options->title, "Of the picture (default: the file's name)")->type_name("WORDS");
  command->add_option("--table", options->table, "Writes the joints as CSV")->type_name("T.csv");
  add_size(*command, options->size);
  add_theme(*command, options->theme);
  command->callback([&invocation, options] {
    invocation.run = [&invocation, options] { return stereonet(*options, invocation.json); };
  });
}

}  // namespace talus::cli
