#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/project.hpp"
#include "study/runs/runs_folder.hpp"

namespace talus {

/// Projects that are solved side by side, or one project under the values of a table.
struct CasePlan {
  struct Source {
    std::filesystem::path file;  ///< absolute
    std::string text;            ///< as it was when the study began
  };
  struct Case {
    std::string name;
    int project = 0;                  ///< of `projects`
    std::vector<std::string> values;  ///< a column, as JSON; empty: the project's own
    std::string fingerprint;          ///< of the text with these values, and of the files that it names
  };
  std::string program;         ///< its version: another one may compute other numbers
  bool allow_outside = false;  ///< projects may name files outside their folders
  bool keep_results = true;    ///< else a case leaves its row alone
  std::vector<Source> projects;
  std::vector<std::string> columns;   ///< as the table has them
  std::vector<std::string> pointers;  ///< the same by numbers
  std::vector<Case> cases;

  const Source& source_of(int number) const {
    return projects[static_cast<std::size_t>(cases[static_cast<std::size_t>(number)].project)];
  }
  std::filesystem::path folder_of(int number) const { return source_of(number).file.parent_path(); }
};

struct CaseRequest {
  std::vector<std::filesystem::path> projects;  ///< files, and folders of which all projects are taken
  std::filesystem::path table{};                ///< CSV; empty: the projects as they are
  bool allow_outside = false, keep_results = true;
  std::string program{};
};

/// Reads all projects and the table and checks every case. Throws InputError that begins with the file, and of a table
/// with line and column.
CasePlan make_case_plan(const CaseRequest& request);

/// A case's project, and the text that says it. Throws InputError with the place in this text.
struct CaseProject {
  std::string text;
  Project project;
};
CaseProject project_of_case(const CasePlan& plan, int number);

/// A study of cases with its plan.
class CaseFolder final : public RunsFolder {
 public:
  /// Begins the study in an empty or new folder, or goes on with it where the plan is the same, or has further cases.
  /// Throws InputError where the folder holds another study or something else; with `restart` another study's files go.
  CaseFolder(const std::filesystem::path& folder, const CasePlan& plan, bool restart);
  /// A study that was begun. Throws InputError where there is none.
  explicit CaseFolder(const std::filesystem::path& folder);

  const CasePlan& plan() const { return plan_; }

 private:
  CaseFolder(const std::filesystem::path& folder, CasePlan plan);

  CasePlan plan_;
};

}  // namespace talus
