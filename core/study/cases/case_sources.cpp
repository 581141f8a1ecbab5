#include "study/cases/case_sources.hpp"

#include <algorithm>
#include <map>

#include "base/error.hpp"
#include "io/whole_file.hpp"
#include "study/cases/case_plan.hpp"
#include "study/cases/case_project.hpp"
#include "study/cases/value_table.hpp"
#include "study/runs/fingerprint.hpp"

namespace talus {

namespace {

namespace fs = std::filesystem;

/// A folder that a run or a study has written.
bool written_by_talus(const fs::path& folder) {
  const std::string kind = folder.extension().string();
  return kind == ".results" || kind == ".accuracy" || kind == ".cases";
}

std::vector<fs::path> projects_below(const fs::path& folder) {
  std::vector<fs::path> found;
  const auto skipping = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator entry(folder, skipping), end; entry != end; ++entry) {
    if (entry->is_directory() && written_by_talus(entry->path())) entry.disable_recursion_pending();
    if (entry->path().extension() == ".talus" && entry->is_regular_file()) found.push_back(entry->path());
  }
  std::ranges::sort(found);
  return found;
}

/// Puts `where` in front of the place of an InputError that comes out of `work`.
template <typename Work>
auto about(const std::string& where, Work work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw InputError(error.place().empty() ? where : where + ": " + error.place(), error.problem(), error.remedy());
  }
}

/// The names of files without their ending, with so many folders in front as tell them all apart.
std::vector<std::string> names_of(const std::vector<fs::path>& files) {
  const auto name_of = [](const fs::path& file, int folders) {
    fs::path name = file.stem(), above = file.parent_path();
    for (int i = 0; i < folders && above.has_filename(); ++i, above = above.parent_path())
      name = above.filename() / name;
    return name.string();
  };
  constexpr int most_folders = 64;
  for (int folders = 0;; ++folders) {
    std::map<std::string, int> uses;
    std::vector<std::string> names;
    for (const fs::path& file : files) ++uses[names.emplace_back(name_of(file, folders))];
    if (uses.size() == files.size() || folders == most_folders) return names;
  }
}

CasePlan::Source source_of(const fs::path& file) {
  const fs::path whole = fs::absolute(file).lexically_normal();
  return {whole, about(file.string(), [&] { return read_whole_file(whole); })};
}

/// Checks the case's project. Throws InputError with the place in its text.
std::string checked_fingerprint(const CasePlan& plan, int number) {
  const auto [text, project] = project_of_case(plan, number);
  return fingerprint_of(text, project, plan.folder_of(number));
}

/// The line, and the column where the error's place is one that the table changes.
std::string place_in_table(const CasePlan& plan, int line, const InputError& error) {
  for (std::size_t i = 0; i < plan.columns.size(); ++i)
    if (error.place().ends_with(" " + plan.pointers[i])) return cell_place(line, plan.columns[i]);
  return "line " + std::to_string(line) + ": " + error.place();
}

void add_rows(CasePlan& plan, const ValueTable& table) {
  for (const ValueTable::Row& row : table.rows) {
    plan.cases.push_back({row.name, 0, row.values, {}});
    const int number = static_cast<int>(plan.cases.size()) - 1;
    try {
      plan.cases.back().fingerprint = checked_fingerprint(plan, number);
    } catch (const InputError& error) {
      throw InputError(place_in_table(plan, row.line, error), error.problem(), error.remedy());
    }
  }
}

/// As it is, the project must hold, too: its text is changed afterwards.
void check_alone(const CasePlan& plan) {
  CasePlan alone = plan;
  alone.cases = {{}};
  about(plan.projects.front().file.string(), [&] { checked_fingerprint(alone, 0); });
}

void add_table(CasePlan& plan, const fs::path& file) {
  check_alone(plan);
  about(file.string(), [&] {
    const ValueTable table = read_value_table(read_whole_file(file));
    plan.columns = table.columns;
    for (const std::string& column : table.columns)
      about("column " + column, [&] { plan.pointers.push_back(numbered_pointer(plan.projects.front().text, column)); });
    add_rows(plan, table);
  });
}

void add_projects(CasePlan& plan) {
  std::vector<fs::path> files;
  for (const CasePlan::Source& source : plan.projects) files.push_back(source.file);
  const std::vector<std::string> names = names_of(files);
  for (std::size_t i = 0; i < files.size(); ++i) {
    plan.cases.push_back({names[i], static_cast<int>(i), {}, {}});
    about(files[i].string(), [&] { plan.cases.back().fingerprint = checked_fingerprint(plan, static_cast<int>(i)); });
  }
}

}  // namespace

std::vector<fs::path> projects_in(const std::vector<fs::path>& files_and_folders) {
  std::vector<fs::path> projects;
  for (const fs::path& one : files_and_folders) {
    if (!fs::is_directory(one)) {
      projects.push_back(one);
      continue;
    }
    const std::vector<fs::path> below = projects_below(one);
    if (below.empty()) throw InputError(one.string(), "holds no project", "name a folder with .talus files");
    projects.insert(projects.end(), below.begin(), below.end());
  }
  return projects;
}

CasePlan make_case_plan(const CaseRequest& request) {
  CasePlan plan;
  plan.program = request.program;
  plan.allow_outside = request.allow_outside;
  plan.keep_results = request.keep_results;
  for (const fs::path& file : projects_in(request.projects)) plan.projects.push_back(source_of(file));
  if (request.table.empty()) {
    add_projects(plan);
    return plan;
  }
  if (plan.projects.size() != 1)
    throw InputError("--table", "changes one project, and there are " + std::to_string(plan.projects.size()),
                     "name one project, or leave the table out");
  add_table(plan, request.table);
  return plan;
}

}  // namespace talus
