#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "command.hpp"
#include "model/rules/switched_effects.hpp"
#include "model/stage_length.hpp"
#include "model/tolerance_text.hpp"
#include "project_choice.hpp"
#include "results/checkpoint.hpp"
#include "results/result_folder.hpp"
#include "results/summary.hpp"
#include "run/effect_costs.hpp"
#include "study/accuracy/study_record.hpp"
#include "text/chosen_bodies.hpp"
#include "text/effect_text.hpp"
#include "text/forecast_text.hpp"
#include "text/json_text.hpp"
#include "text/report_text.hpp"
#include "text/table.hpp"
#include "text/terminal.hpp"

namespace talus::cli {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Material& material) {
  Json json = {{"name", material.name},
               {"density", material.density},
               {"young", material.young},
               {"poisson", material.poisson},
               {"law", to_string(material.law)}};
  if (const auto& strength = material.strength) {
    json["strength"] = {{"friction_angle", strength->friction_angle}, {"cohesion", strength->cohesion}};
    if (strength->tensile_strength) json["strength"]["tensile_strength"] = *strength->tensile_strength;
  }
  return json;
}

Json json_of(const Joint& joint) {
  Json json = {{"name", joint.name},
               {"friction_angle", joint.friction_angle},
               {"cohesion", joint.cohesion},
               {"tensile_strength", joint.tensile_strength}};
  if (joint.restitution) json["restitution"] = *joint.restitution;
  if (joint.residual_friction_angle) json["residual_friction_angle"] = *joint.residual_friction_angle;
  return json;
}

Json json_of(const Stage& stage) {
  return {{"name", stage.name},
          {"type", to_string(stage.kind)},
          {"time_step", stage.time_step},
          {"duration", length_of(stage)}};
}

Json json_of(const EffectCost& effect) {
  return {{"name", to_string(effect.kind)},
          {"active", effect.active},
          {"reason", effect.reason},
          {"items", effect.items},
          {"estimated_seconds_an_iteration", effect.seconds}};
}

Json json_of(const ProjectProblem& problem) {
  return {{"kind", problem.kind == ProjectProblem::Kind::warning ? "warning" : "note"},
          {"place", problem.place},
          {"problem", problem.problem},
          {"remedy", problem.remedy}};
}

template <typename Things>
Json list_of(const Things& things) {
  Json array = Json::array();
  for (const auto& thing : things) array.push_back(json_of(thing));
  return array;
}

Json blocks_of(const BlockSystem& system) {
  Json blocks = Json::array();
  for (const Block& block : system.blocks) {
    Json json = {{"name", block.name}, {"body", to_string(block.body)}};
    if (!block.body_reason.empty()) json["body_reason"] = block.body_reason;
    json.update(
        {{"volume", block.volume}, {"nodes", block.mesh.nodes.size()}, {"tetrahedra", block.mesh.tetrahedra.size()}});
    blocks.push_back(json);
  }
  return blocks;
}

/// How blocks move in the last frame: motion_json's object, with the name; none where nobody watched.
Json motions_of(const ResultReader& results) {
  Json motions = Json::array();
  if (results.frame_times().empty()) return motions;
  const Frame last = results.frame(static_cast<int>(results.frame_times().size()) - 1);
  const MotionNames names = motion_names(results.system());
  for (std::size_t b = 0; b < last.motions.size(); ++b) {
    if (results.system().blocks[b].body == BodyKind::fixed) continue;
    Json motion = {{"name", names.blocks[b]}};
    motion.update(Json::parse(motion_json(last.motions[b], names)));
    motion["direction"] = attitude_text(last.motions[b].direction);
    motions.push_back(motion);
  }
  return motions;
}

void print_motions(const Json& motions) {
  if (motions.empty()) return;
  Table table({"Block", "Motion", "Trend/plunge"}, "lll");
  for (const Json& motion : motions) table.add({motion["name"], motion["text"], motion["direction"]});
  std::cout << table.text();
}

void print_blocks(const Json& blocks, const BlockSystem& system) {
  Table table({"Block", "Body", "Volume [m³]", "Nodes", "Tetrahedra"}, "llrrr");
  for (const Json& block : blocks)
    table.add(
        {block["name"], block["body"], number(block["volume"], 8), block["nodes"].dump(), block["tetrahedra"].dump()});
  std::cout << table.text() << chosen_bodies_text(system);
}

Json json_of_project(const Project& project, const BlockSystem& system, const std::vector<EffectCost>& costs) {
  Json monitors = Json::array();
  for (const Monitor& monitor : project.monitors) monitors.push_back(monitor.name);
  return {{"project", project.name},
          {"gravity", {project.gravity.x(), project.gravity.y(), project.gravity.z()}},
          {"blocks", blocks_of(system)},
          {"materials", list_of(project.materials)},
          {"joints", list_of(project.joints)},
          {"stages", list_of(project.stages)},
          {"monitors", monitors},
          {"expectations", project.expect.size()},
          {"effects", list_of(costs)},
          {"warnings", list_of(problems_of_switched_effects(project))}};
}

/// Of the materials that have a strength, with an empty line after it; nothing where none has.
std::string strengths_text(const Json& materials) {
  Table table({"Strength of", "Friction angle [°]", "Cohesion [Pa]", "Tensile strength [Pa]"}, "lrrr");
  bool any = false;
  for (const Json& material : materials)
    if (material.contains("strength")) {
      const Json& strength = material["strength"];
      const bool is_cut_off = strength.contains("tensile_strength");
      table.add({material["name"], number(strength["friction_angle"]), number(strength["cohesion"]),
                 is_cut_off ? number(strength["tensile_strength"]) : "to the envelope's apex"});
      any = true;
    }
  return any ? table.text() + '\n' : std::string();
}

void print_project(const Json& info, const Project& project, const BlockSystem& system,
                   const std::vector<EffectCost>& costs) {
  std::cout << info["project"].get<std::string>() << "\n\n";
  print_blocks(info["blocks"], system);
  Table materials({"Material", "Density [kg/m³]", "Young's modulus [Pa]", "Poisson's ratio", "Law"}, "lrrrl");
  for (const Json& m : info["materials"])
    materials.add({m["name"], number(m["density"]), number(m["young"]), number(m["poisson"]), m["law"]});
  Table joints({"Joint", "Friction angle [°]", "Cohesion [Pa]", "Tensile strength [Pa]"}, "lrrr");
  for (const Json& j : info["joints"])
    joints.add({j["name"], number(j["friction_angle"]), number(j["cohesion"]), number(j["tensile_strength"])});
  Table stages({"Stage", "Type", "Time step [s]", "Duration [s]"}, "llrr");
  for (const Json& s : info["stages"])
    stages.add({s["name"], s["type"], number(s["time_step"]), number(s["duration"])});
  std::cout << '\n'
            << materials.text() << '\n'
            << strengths_text(info["materials"]) << joints.text() << '\n'
            << stages.text() << '\n'
            << costs_text(costs) << switched_effects_text(project) << '\n'
            << info["monitors"].size() << " monitors, " << info["expectations"] << " expectations\n";
}

/// Seconds of the processor that a forecast may take.
constexpr double forecast_budget = 4;

/// A study that cannot be read is a note: all else can be said without it. Standard input has none.
std::optional<double> studied_error(const ProjectChoice& choice, const Project& project) {
  if (choice.is_standard_input()) return std::nullopt;
  try {
    const auto study = read_study(study_folder_of(choice.file));
    return study ? error_of(*study, project) : std::nullopt;
  } catch (const InputError& error) {
    std::cerr << "talus-cli: note: " << error.what() << '\n';
    return std::nullopt;
  }
}

ExitCode inform_of_project(const ProjectChoice& choice, bool with_forecast, bool json) {
  const Project project = read(choice);
  catch_interrupts();
  const BlockSystem system = build(project, choice);
  const SceneSize size = about(choice.name(), [&] { return scene_size(project, system); });
  const std::vector<EffectCost> costs = effect_costs(project, system, size);
  Json info = json_of_project(project, system, costs);
  std::optional<RunAhead> ahead;
  if (with_forecast && !project.stages.empty()) {
    TerminalProgress progress;
    ahead = RunAhead{about(choice.name(), [&] { return forecast(project, system, forecast_budget, progress); }),
                     studied_error(choice, project)};
    info["forecast"] = forecast_json(*ahead);
  }
  if (json) {
    std::cout << json_text(info) << '\n';
    return done;
  }
  print_project(info, project, system, costs);
  if (ahead) std::cout << '\n' << forecast_text(*ahead);
  return done;
}

/// From where `--resume` would go on with a run that has not come to its end [s].
Json checkpoint_of(const std::filesystem::path& folder, const std::optional<RunReport>& report) {
  const bool may_go_on = !report || report->status == RunStatus::stopped;
  const auto label = may_go_on ? read_checkpoint_label(folder / "checkpoint.h5") : std::nullopt;
  return label ? Json(label->time) : Json();
}

/// `report`: none where the run goes on, or was killed.
Json json_of_results(const ResultReader& results, const std::optional<RunReport>& report, const Json& checkpoint) {
  const auto& times = results.frame_times();
  const auto steps = results.steps();
  const Json summary = report ? Json::parse(summary_json(*report)) : Json();
  const auto of_report = [&](const char* part) { return report ? summary[part] : Json::array(); };
  return {{"project", results.project_name()},
          {"status", report ? to_string(report->status) : "unfinished"},
          {"frames", times.size()},
          {"first_time", times.empty() ? Json() : Json(times.front())},
          {"last_time", times.empty() ? Json() : Json(times.back())},
          {"steps", steps.size()},
          {"checkpoint", checkpoint},
          {"tolerance", report ? Json(report->tolerance) : Json()},
          {"stages", results.stage_names()},
          {"monitors", results.monitor_names()},
          {"blocks", blocks_of(results.system())},
          {"motions", motions_of(results)},
          {"effects", of_report("effects")},
          {"work", report ? summary["work"] : Json()},
          {"convergence_trouble", of_report("convergence_trouble")},
          {"events", of_report("events")}};
}

void print_results(const Json& info, const BlockSystem& system, const std::optional<RunReport>& report) {
  std::cout << info["project"].get<std::string>() << "\n"
            << info["status"].get<std::string>() << ", " << info["steps"] << " steps, " << info["frames"] << " frames";
  if (info["frames"] != 0) std::cout << " from " << info["first_time"] << " to " << info["last_time"] << " s";
  if (report) std::cout << ", tolerance " << tolerance_text(report->tolerance);
  std::cout << '\n';
  if (!info["checkpoint"].is_null()) std::cout << "solve --resume goes on from t = " << info["checkpoint"] << " s\n";
  std::cout << '\n';
  print_blocks(info["blocks"], system);
  std::cout << '\n';
  for (const char* list : {"stages", "monitors"}) {
    std::cout << list << ':';
    for (const Json& name : info[list]) std::cout << ' ' << name.get<std::string>();
    std::cout << '\n';
  }
  print_motions(info["motions"]);
  if (report) std::cout << '\n' << profile_text(*report) << '\n';
  for (const Json& event : info["events"])
    std::cout << event["time"] << " s  " << event["what"].get<std::string>() << '\n';
  if (report) std::cout << troubles_text(report->troubles);
}

ExitCode inform_of_results(const std::filesystem::path& folder, bool json) {
  const ResultReader results(folder);
  const std::optional<RunReport> report = results.report();
  const Json info = json_of_results(results, report, checkpoint_of(folder, report));
  if (json)
    std::cout << json_text(info) << '\n';
  else
    print_results(info, results.system(), report);
  return done;
}

}  // namespace

void add_info(CLI::App& program, Invocation& invocation) {
  auto* command = program.add_subcommand(
      "info", "Say what is in a project, which effects it calls for and why; or what is in results");
  auto choice = std::make_shared<ProjectChoice>();
  auto with_forecast = std::make_shared<bool>(false);
  add_project(*command, *choice, "PROJECT|RESULTS", "Project file (.talus; - reads standard input) or results folder");
  command->add_flag("--forecast", *with_forecast,
                    "Say what a run will take, too; that is foreseen from some of its steps, in some 4 to 20 s");
  command->add_flag("--no-forecast")->group("");  // how it was said when a forecast was not to be asked for
  command->callback([&invocation, choice, with_forecast] {
    invocation.run = [&invocation, choice, with_forecast] {
      return !choice->is_standard_input() && std::filesystem::is_directory(choice->file)
                 ? inform_of_results(choice->file, invocation.json)
                 : inform_of_project(*choice, *with_forecast, invocation.json);
    };
  });
}

}  // namespace talus::cli
