#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mesh/block.hpp"
#include "results/frame.hpp"
#include "results/history.hpp"
#include "results/run_report.hpp"

namespace talus {

/// How much of a results folder a run has written at some moment.
struct WrittenResults {
  std::int32_t frames = 0;
  std::uint64_t history = 0, steps = 0, log = 0;  ///< bytes of history.csv, steps.csv and log.txt

  void archive(auto& state) { state(frames, history, steps, log); }
};

/// Writes a results folder as the run goes: results.h5, results.vtkhdf, results.xdmf, history.csv, steps.csv, log.txt,
/// project.talus and at the end frames.h5 and summary.json. After every call what was written so far is readable, also
/// after a kill.
class ResultWriter {
 public:
  /// Makes the folder, or takes earlier results out of it; refuses (InputError) one that holds files but no results.
  /// `project_text` is kept beside the results as project.talus.
  ResultWriter(const std::filesystem::path& folder, const Project& project, const BlockSystem& system,
               const std::string& project_text);
  /// Goes on in a folder where a run has left off, behind what it had `written` at some moment; what it wrote later is
  /// written again. Throws InputError where less is there.
  ResultWriter(const std::filesystem::path& folder, const Project& project, const BlockSystem& system,
               const std::string& project_text, const WrittenResults& written);
  ~ResultWriter();
  ResultWriter(const ResultWriter&) = delete;
  ResultWriter& operator=(const ResultWriter&) = delete;

  void add_frame(const Frame& frame);
  void add_step(const StepReport& step);
  void add_history(const HistoryRow& row);
  void log(const std::string& line);
  int frames() const;  ///< written so far
  /// What has been written so far; it is on the disk.
  WrittenResults written() const;
  void finish(const RunReport& report);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Reads a results folder, also one whose run goes on or was killed.
class ResultReader {
 public:
  /// Throws InputError when the folder holds no readable results.
  explicit ResultReader(const std::filesystem::path& folder);
  ~ResultReader();
  ResultReader(const ResultReader&) = delete;
  ResultReader& operator=(const ResultReader&) = delete;

  const BlockSystem& system() const;
  const std::string& project_name() const;
  const std::vector<std::string>& stage_names() const;
  const std::vector<std::string>& monitor_names() const;
  const std::vector<HistoryMonitor>& history_monitors() const;  ///< the same, and what their columns are
  const std::vector<double>& frame_times() const;               ///< s
  Frame frame(int index) const;
  std::vector<HistoryRow> history() const;
  std::vector<StepReport> steps() const;
  std::optional<RunReport> report() const;  ///< as far as read_summary reads it; none while the run goes on

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace talus
