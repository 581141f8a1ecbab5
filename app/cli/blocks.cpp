#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/line_attitude.hpp"
#include "command.hpp"
#include "cutting_report.hpp"
#include "project_choice.hpp"
#include "removability/block_facts.hpp"
#include "text/json_text.hpp"
#include "text/table.hpp"
#include "text/terminal.hpp"

namespace talus::cli {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Project& project, const BlockSystem& system, const std::vector<BlockFacts>& facts) {
  Json blocks = Json::array();
  for (std::size_t i = 0; i < facts.size(); ++i) {
    const BlockFacts& block = facts[i];
    Json neighbours = Json::array(), joints = Json::array();
    for (const int other : block.neighbours) neighbours.push_back(system.blocks[other].name);
    for (const int joint : block.joints) joints.push_back(project.joints[joint].name);
    Json json = {{"name", system.blocks[i].name},
                 {"volume", system.blocks[i].volume},
                 {"area", block.area},
                 {"free_area", block.free_area},
                 {"faces", block.faces},
                 {"free_faces", block.free_faces},
                 {"neighbours", neighbours},
                 {"joints", joints},
                 {"slenderness", block.slenderness},
                 {"sliver", block.slenderness > sliver_slenderness},
                 {"fixed", block.fixed},
                 {"removable", block.leaving.removable()},
                 {"leaving", to_string(block.leaving.leaving)},
                 {"slides_on", block.slides_on}};
    if (block.leaving.direction != Vec3::Zero()) {
      const LineAttitude line = attitude_of(block.leaving.direction);
      json["trend"] = line.trend;
      json["plunge"] = line.plunge;
    }
    if (block.leaving.factor) json["factor_of_safety"] = *block.leaving.factor;
    blocks.push_back(json);
  }
  Json json = {{"blocks", blocks}};
  json.update(cutting_report_json(project, system));
  return json;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text.empty() ? "-" : text;
}

void print(const Project& project, const BlockSystem& system, const std::vector<BlockFacts>& facts) {
  Table table({"Block", "Volume [m³]", "Faces", "Free", "Neighbours", "Leaves", "On", "Trend/plunge [°]", "F"},
              "lrrrrlllr");
  int slivers = 0;
  for (std::size_t i = 0; i < facts.size(); ++i) {
    const BlockFacts& block = facts[i];
    const Removability leaving = block.fixed ? Removability{} : block.leaving;
    std::string way = "-";
    if (leaving.direction != Vec3::Zero()) {
      const LineAttitude line = attitude_of(leaving.direction);
      way = number(line.trend, 3) + "/" + number(line.plunge, 3);
    }
    const bool sliver = block.slenderness > sliver_slenderness;
    slivers += sliver;
    table.add({system.blocks[i].name + (sliver ? " *" : ""), number(system.blocks[i].volume, 5),
               std::to_string(block.faces), std::to_string(block.free_faces), std::to_string(block.neighbours.size()),
               block.fixed ? "fixed" : std::string(to_string(leaving.leaving)),
               joined(block.fixed ? std::vector<std::string>{} : block.slides_on), way,
               leaving.factor ? number(*leaving.factor, 4) : "-"});
  }
  std::cout << table.text();
  if (slivers > 0)
    std::cout << "* a sliver: its longest side is over " << number(sliver_slenderness) << " times 3 V / A.\n";
  std::cout << cutting_report_text(project, system);
  std::cout << "F: strength over what drives the block, of its own weight on its joints; the others stand still.\n";
}

ExitCode blocks(const ProjectChoice& choice, bool json) {
  const Project project = read(choice);
  catch_interrupts();
  const BlockSystem system = build(project, choice);
  const std::vector<BlockFacts> facts = block_facts(project, system);
  if (json)
    std::cout << json_text(json_of(project, system, facts)) << '\n';
  else
    print(project, system, facts);
  return done;
}

}  // namespace

void add_blocks(CLI::App& program, Invocation& invocation) {
  auto* command = program.add_subcommand(
      "blocks", "Cut a project; print which of its blocks can leave, how, and their factors of safety");
  auto choice = std::make_shared<ProjectChoice>();
  add_project(*command, *choice);
  command->callback(
      [&invocation, choice] { invocation.run = [&invocation, choice] { return blocks(*choice, invocation.json); }; });
}

}  // namespace talus::cli
