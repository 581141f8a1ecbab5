#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace talus {

/// A study on the disk: its plan in study.json, and in runs/ a file for each run that has ended, however it ended.
/// Runs are numbered from 0.
class RunsFolder {
 public:
  /// `costs`: of each run, relative to each other.
  RunsFolder(const std::filesystem::path& folder, std::vector<double> costs);

  const std::filesystem::path& path() const { return path_; }  ///< absolute
  int count() const { return static_cast<int>(costs_.size()); }
  double cost(int number) const { return costs_[static_cast<std::size_t>(number)]; }
  std::filesystem::path plan_file() const;           ///< study.json
  std::filesystem::path run_file(int number) const;  ///< runs/003.json
  std::filesystem::path log_file(int number) const;  ///< what a run said that should have said nothing: runs/003.log
  std::filesystem::path results_folder(int number) const;  ///< runs/003.results, of a run that goes on or was killed
  std::vector<int> missing_runs() const;

  /// What a run's file says; none where there is none.
  std::optional<std::string> run_text(int number) const;
  /// Of a file in the folder. Throws InputError where it cannot be read.
  std::string read(const std::string& name) const;
  /// Files are written whole or not at all; these throw InputError where that cannot be.
  void write_run(int number, const std::string& text) const;
  void write(const std::string& name, const std::string& text) const;

  /// Whether a study that was begun here goes on. `restart`: what its runs left goes instead. Throws InputError where
  /// the folder is neither new nor empty nor a study's: only such a one is emptied.
  bool goes_on(bool restart) const;
  /// Throws InputError where the study that goes on is of something `other`; nothing where that is empty.
  void refuse_other(const std::string& other) const;
  /// Makes the folder, or writes another plan into it. Throws InputError where that cannot be.
  void write_plan(const std::string& text) const;

 private:
  std::filesystem::path path_;
  std::vector<double> costs_;
};

/// The text of a study's plan. Throws InputError where the folder holds none.
std::string plan_text(const std::filesystem::path& folder);

/// What a plan is about, "accuracy" or "cases". Throws InputError where the folder holds none.
std::string kind_of_study(const std::filesystem::path& folder);

/// The error of a plan that says nothing that is understood.
[[noreturn]] void refuse_plan(const std::filesystem::path& folder);

}  // namespace talus
