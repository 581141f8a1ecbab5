#include "render/views/view_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "io/view_text.hpp"
#include "io/whole_file.hpp"

namespace talus {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array edges_words{"none", "blocks", "mesh"};
constexpr std::array arrows_words{"none", "velocity", "force", "stress"};
constexpr std::array trails_words{"none", "selected", "all"};

/// What is on or off, by its key.
struct SettingSwitch {
  const char* key;
  bool SceneSettings::*member;
};
constexpr SettingSwitch switches[] = {
    {"contacts", &SceneSettings::contacts},
    {"trouble", &SceneSettings::troubles},
    {"turning_axes", &SceneSettings::turning_axes},
    {"monitors", &SceneSettings::actions},
    {"legend", &SceneSettings::legend},
    {"time_stamp", &SceneSettings::time_stamp},
    {"axes", &SceneSettings::triad},
    {"scale_bar", &SceneSettings::scale_bar},
};

Json json_of(const Vec3& vector) { return {vector.x(), vector.y(), vector.z()}; }

Vec3 vector_of(const Json& json) { return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()}; }

std::string text_of(Rgb colour) {
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", colour.red, colour.green, colour.blue);
  return text;
}

Rgb colour_of(const std::string& text) {
  unsigned number = 0;
  int read = 0;
  if (std::sscanf(text.c_str(), "#%6x%n", &number, &read) != 1 || read != 7 || text.size() != 7)
    throw InputError("block_colours", "'" + text + "' is no colour", "write it like #77aadd");
  return rgb(number);
}

Json json_of(const BlockColours& colours) {
  Json all = Json::array(), key = Json::array();
  for (const Rgb colour : colours.colours) all.push_back(text_of(colour));
  for (const KeyEntry& entry : colours.key)
    key.push_back({{"colour", text_of(entry.colour)}, {"meaning", entry.meaning}});
  return {{"title", colours.title}, {"colours", all}, {"key", key}};
}

BlockColours block_colours_of(const Json& json) {
  BlockColours colours{json["title"], {}, {}};
  for (const Json& colour : json["colours"]) colours.colours.push_back(colour_of(colour));
  for (const Json& entry : json["key"]) colours.key.push_back({colour_of(entry["colour"]), entry["meaning"]});
  return colours;
}

Json json_of(const CameraPose& camera) {
  return {{"position", json_of(camera.position)},    {"focal_point", json_of(camera.focal_point)},
          {"view_up", json_of(camera.view_up)},      {"view_angle", camera.view_angle},
          {"parallel_scale", camera.parallel_scale}, {"parallel", camera.parallel}};
}

CameraPose camera_of(const Json& json) {
  CameraPose camera;
  camera.position = vector_of(json["position"]);
  camera.focal_point = vector_of(json["focal_point"]);
  camera.view_up = vector_of(json["view_up"]);
  camera.view_angle = json.value("view_angle", camera.view_angle);
  camera.parallel_scale = json.value("parallel_scale", camera.parallel_scale);
  camera.parallel = json.value("parallel", camera.parallel);
  const Vec3 along = camera.focal_point - camera.position;
  if (!(along.norm() > 0) || !(along.cross(camera.view_up).norm() > 0))
    throw InputError("camera", "it looks nowhere",
                     "position and focal_point must differ, and view_up must not lie along the line between them");
  return camera;
}

ValueRange range_of(const Json& json, const char* key) {
  const ValueRange range{json[0], json[1]};
  if (!(range.low < range.high))
    throw InputError(key, "the lowest value is not below the highest", "write the lower one first");
  return range;
}

SceneSettings settings_of(const Json& json) {
  SceneSettings settings;
  settings.theme = json.value("theme", "light") == "dark" ? Theme::dark : Theme::light;
  if (json.contains("field")) settings.field = field_named(json["field"].get<std::string>());
  if (json.contains("range")) settings.range = range_of(json["range"], "range");
  if (json.contains("only")) settings.only = range_of(json["only"], "only");
  const auto number_of = [](const auto& words, const std::string& word) {
    return std::ranges::find(words, word) - words.begin();
  };
  settings.edges = static_cast<Edges>(number_of(edges_words, json.value("edges", "blocks")));
  settings.arrows = static_cast<Arrows>(number_of(arrows_words, json.value("arrows", "none")));
  settings.trails = static_cast<Trails>(number_of(trails_words, json.value("trails", "none")));
  settings.deformation_scale = json.value("deformation_scale", settings.deformation_scale);
  settings.explosion = json.value("explosion", settings.explosion);
  if (json.contains("section")) {
    const Vec3 towards = vector_of(json["section"]["towards"]);
    if (!(towards.norm() > 0)) throw InputError("section", "'towards' has no direction", "give a vector, not zero");
    settings.section = SectionPlane{vector_of(json["section"]["point"]), towards.normalized()};
  }
  if (json.contains("probed_line"))
    settings.probed_line = std::array{vector_of(json["probed_line"][0]), vector_of(json["probed_line"][1])};
  settings.rock_opacity = json.value("rock_opacity", settings.rock_opacity);
  if (json.contains("block_colours"))
    settings.block_colours = std::make_shared<const BlockColours>(block_colours_of(json["block_colours"]));
  for (const SettingSwitch& one : switches) settings.*one.member = json.value(one.key, settings.*one.member);
  settings.title = json.value("title", settings.title);
  settings.text_height = json.value("text_height", settings.text_height);
  return settings;
}

/// Puts the file in front of the place of an InputError.
auto about_file(const std::filesystem::path& file, const auto& work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw InputError(file.string() + ": " + error.place(), error.problem(), error.remedy());
  }
}

}  // namespace

std::string view_text(const SavedView& view) {
  const SceneSettings& settings = view.settings;
  Json json = {{"talus_view", 1}, {"size", {view.width, view.height}}, {"camera", json_of(view.camera)}};
  if (view.time) json["time"] = *view.time;
  if (settings.field) json["field"] = settings.field->name;
  if (settings.range) json["range"] = {settings.range->low, settings.range->high};
  if (settings.only) json["only"] = {settings.only->low, settings.only->high};
  json["arrows"] = arrows_words[static_cast<std::size_t>(settings.arrows)];
  json["trails"] = trails_words[static_cast<std::size_t>(settings.trails)];
  json["theme"] = settings.theme == Theme::dark ? "dark" : "light";
  json["edges"] = edges_words[static_cast<std::size_t>(settings.edges)];
  json["deformation_scale"] = settings.deformation_scale;
  json["explosion"] = settings.explosion;
  if (settings.section)
    json["section"] = {{"point", json_of(settings.section->point)}, {"towards", json_of(settings.section->towards)}};
  if (settings.probed_line)
    json["probed_line"] = {json_of((*settings.probed_line)[0]), json_of((*settings.probed_line)[1])};
  json["rock_opacity"] = settings.rock_opacity;
  if (!view.hidden.empty()) json["hidden"] = view.hidden;
  if (!view.selected.empty()) json["selected"] = view.selected;
  if (settings.block_colours) json["block_colours"] = json_of(*settings.block_colours);
  for (const SettingSwitch& one : switches) json[one.key] = settings.*one.member;
  json["title"] = settings.title;
  json["text_height"] = settings.text_height;
  for (const ViewBeside& one : view.beside)
    json["compared"].push_back({{"results", one.results.generic_string()}, {"over", one.over}});
  Json covered = Json::array();
  for (const PixelRect& rect : view.covered) covered.push_back({rect.left, rect.bottom, rect.right, rect.top});
  json["covered"] = covered;
  return laid_out(json.dump());
}

SavedView view_of_text(const std::string& text) {
  const Json json = Json::parse(checked_view_text(text));
  SavedView view;
  view.width = json["size"][0];
  view.height = json["size"][1];
  if (json.contains("time")) view.time = json["time"].get<double>();
  view.camera = camera_of(json["camera"]);
  view.settings = settings_of(json);
  view.settings.parallel_projection = view.camera.parallel;
  view.hidden = json.value("hidden", view.hidden);
  view.selected = json.value("selected", view.selected);
  for (const Json& rect : json.value("covered", Json::array()))
    view.covered.push_back({rect[0], rect[1], rect[2], rect[3]});
  for (const Json& one : json.value("compared", Json::array()))
    view.beside.push_back({one["results"].get<std::string>(), one.value("over", false)});
  return view;
}

SavedView read_view(const std::filesystem::path& file) {
  SavedView view = about_file(file, [&] { return view_of_text(read_whole_file(file)); });
  for (ViewBeside& one : view.beside) one.results = (file.parent_path() / one.results).lexically_normal();
  return view;
}

void save_view(const SavedView& view, const std::filesystem::path& file) {
  SavedView seen = view;
  const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  for (ViewBeside& one : seen.beside) one.results = std::filesystem::proximate(one.results, folder);
  about_file(file, [&] { replace_whole_file(file, view_text(seen)); });
}

std::vector<int> blocks_named(const BlockSystem& system, const std::vector<std::string>& names) {
  std::vector<int> blocks;
  for (const std::string& name : names) {
    const auto found = std::ranges::find(system.blocks, name, &Block::name);
    if (found == system.blocks.end())
      throw InputError("block " + name, "the results have no such block",
                       "take a view that was saved of these results, or leave the name out");
    blocks.push_back(static_cast<int>(found - system.blocks.begin()));
  }
  std::ranges::sort(blocks);
  return blocks;
}

void show_view(const SavedView& view, const BlockSystem& system, Scene& scene) {
  scene.set_settings(view.settings);
  scene.set_hidden(blocks_named(system, view.hidden));
  scene.set_selected(blocks_named(system, view.selected));
  scene.set_covered(view.covered);
  scene.set_pose(view.camera);
}

}  // namespace talus
