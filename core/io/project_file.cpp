#include "io/project_file.hpp"

#include <optional>

#include "base/error.hpp"
#include "io/json_format.hpp"
#include "io/json_merge.hpp"
#include "io/json_text.hpp"
#include "io/project_reader.hpp"
#include "io/project_to_json.hpp"
#include "io/schema_check.hpp"
#include "io/whole_file.hpp"
#include "model/place.hpp"
#include "model/rules/validate.hpp"
#include "model/solid_shape.hpp"

namespace talus {
namespace {

/// Before all else: a text of another kind or version would only earn misleading messages.
void check_version(const JsonText& json) {
  if (!json.value.is_object() || !json.value.contains("talus")) {
    throw InputError(place_in_text(json, "/"), "this is not a Talus project: it has no \"talus\" key",
                     "begin the file with { \"talus\": 1, …");
  }
  const auto& version = json.value.at("talus");
  if (version.is_number_integer() && version == 1) return;
  throw InputError(place_in_text(json, "/talus"),
                   "the file's version is " + version.dump() + ", and this program understands version 1",
                   "use \"talus\": 1, or a program of that version");
}

void refuse_outside(const Place& place, const std::string& path) {
  throw InputError(place.text(), "'" + path + "' lies outside the project's folder",
                   "copy the file beside the project, or allow it with --allow-outside");
}

bool climbs_out(const std::filesystem::path& path) {
  if (path.is_absolute()) return true;
  const auto normal = path.lexically_normal();
  return !normal.empty() && *normal.begin() == "..";
}

void for_each_file(const Project& project, const auto& visit) {
  for (std::size_t i = 0; i < project.solids.size(); ++i) {
    const SolidShape& shape = project.solids[i].shape;
    const Place solid = Place() / "solids" / i;
    if (const std::string* path = file_of(shape))
      visit((std::holds_alternative<TerrainShape>(shape) ? solid / "terrain" : solid) / "file", *path);
  }
}

/// By the words of the path alone: what parse_project can know.
void check_paths(const Project& project) {
  for_each_file(project, [](const Place& place, const std::string& path) {
    if (climbs_out(path)) refuse_outside(place, path);
  });
}

/// By where links lead, once the folder is known.
void check_links(const Project& project, const std::filesystem::path& folder) {
  std::error_code error;
  const auto home = std::filesystem::weakly_canonical(folder.empty() ? "." : folder, error);
  if (error) return;  // a folder that cannot be looked at holds nothing to be read either
  for_each_file(project, [&](const Place& place, const std::string& path) {
    const auto real = std::filesystem::weakly_canonical(home / path, error);
    if (!error && climbs_out(real.lexically_relative(home))) refuse_outside(place, path);
  });
}

/// Runs a check of the model and adds the line to the place where it fails.
void check_with_lines(const JsonText& json, const auto& check) {
  try {
    check();
  } catch (const InputError& error) {
    throw InputError(place_in_text(json, error.place()), error.problem(), error.remedy());
  }
}

struct ParsedProject {
  JsonText json;
  Project project;
};

ParsedProject parse(const std::string& text, const ReadOptions& options) {
  ParsedProject parsed{parse_json_text(text), {}};
  check_version(parsed.json);
  check_against_schema(parsed.json, options.unfinished);
  parsed.project = project_from_json(parsed.json.value);
  check_with_lines(parsed.json, [&] {
    options.unfinished ? validate_what_is_there(parsed.project) : validate(parsed.project);
    if (!options.allow_outside) check_paths(parsed.project);
  });
  return parsed;
}

}  // namespace

Project parse_project(const std::string& text, const ReadOptions& options) { return parse(text, options).project; }

Project parse_project_in(const std::filesystem::path& folder, const std::string& text, const ReadOptions& options) {
  const auto parsed = parse(text, options);
  if (!options.allow_outside) check_with_lines(parsed.json, [&] { check_links(parsed.project, folder); });
  return parsed.project;
}

Project read_project(const std::filesystem::path& file, const ReadOptions& options) {
  return parse_project_in(file.parent_path(), read_whole_file(file), options);
}

std::string write_project(const Project& project) {
  const JsonLayout layout;
  return format_json(project_to_json(project), 0, layout, true) + std::string(layout.newline);
}

std::string write_project(const Project& project, const std::string& previous_text) {
  std::optional<ParsedProject> previous;
  try {
    previous = parse(previous_text, {.allow_outside = true, .unfinished = true});
  } catch (const InputError&) {
    return write_project(project);
  }
  return merge_json(previous->json, project_to_json(previous->project), project_to_json(project));
}

std::string change_project_text(const std::string& text, const std::string& value) {
  const JsonText old = parse_json_text(text);
  return merge_json(old, old.value, parse_json_text(value).value);
}

void save_project(const Project& project, const std::filesystem::path& file) {
  std::error_code error;
  const bool there = std::filesystem::is_regular_file(file, error);
  replace_whole_file(file, there ? write_project(project, read_whole_file(file)) : write_project(project));
}

}  // namespace talus
