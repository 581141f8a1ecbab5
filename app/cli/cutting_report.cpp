#include "cutting_report.hpp"

#include <nlohmann/json.hpp>

#include "geometry/block_builder.hpp"
#include "model/number_text.hpp"
#include "text/table.hpp"

namespace talus::cli {

namespace {

using Json = nlohmann::ordered_json;

const std::string& solid_of(const Splinter& splinter, const Project& project) {
  return project.solids[static_cast<std::size_t>(splinter.solid)].name;
}

std::string title_of(const EndingJoints& ending, const Project& project) {
  return "cut " + std::to_string(ending.cut + 1) + " (" + project.cuts[static_cast<std::size_t>(ending.cut)].joint +
         ")";
}

std::string line_of(const Splinter& splinter, const Project& project) {
  const Vec3& p = splinter.where;
  const bool merged = splinter.fate == Splinter::Fate::merged;
  return "splinter of " + solid_of(splinter, project) + " at (" + number(p.x()) + ", " + number(p.y()) + ", " +
         number(p.z()) + "), " + number(splinter.volume, 3) + " m³, " + number(splinter.thickness, 3) +
         " m thick: " + (merged ? "made part of " + splinter.merged_into : "left out") + '\n';
}

Json json_of(const Splinter& splinter, const Project& project) {
  Json json = {{"solid", solid_of(splinter, project)},
               {"at", {splinter.where.x(), splinter.where.y(), splinter.where.z()}},
               {"volume", splinter.volume},
               {"thickness", splinter.thickness},
               {"dropped", splinter.fate == Splinter::Fate::dropped}};
  if (!splinter.merged_into.empty()) json["merged_into"] = splinter.merged_into;
  return json;
}

}  // namespace

std::string cutting_report_text(const Project& project, const BlockSystem& system) {
  std::string text;
  for (const Splinter& splinter : system.splinters) text += line_of(splinter, project);
  if (system.excavated_volume > 0) text += "excavated: " + number(system.excavated_volume, 6) + " m³\n";
  for (const EndingJoints& ending : system.endings)
    text += title_of(ending, project) + ": " + count_text(ending.dividing) + " of " +
            counted_text(ending.joints, "joint divides", "joints divide") + " rock\n";
  return text;
}

Json cutting_report_json(const Project& project, const BlockSystem& system) {
  Json splinters = Json::array(), endings = Json::array();
  for (const Splinter& splinter : system.splinters) splinters.push_back(json_of(splinter, project));
  for (const EndingJoints& ending : system.endings)
    endings.push_back({{"cut", ending.cut},
                       {"joint", project.cuts[static_cast<std::size_t>(ending.cut)].joint},
                       {"joints", ending.joints},
                       {"dividing", ending.dividing}});
  return {{"splinters", splinters}, {"excavated_volume", system.excavated_volume}, {"ending_joints", endings}};
}

}  // namespace talus::cli
