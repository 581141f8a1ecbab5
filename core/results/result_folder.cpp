#include "results/result_folder.hpp"

#include <fstream>
#include <stdexcept>

#include "base/error.hpp"
#include "results/folder.hpp"
#include "results/history.hpp"
#include "results/result_file.hpp"
#include "results/steps.hpp"
#include "results/summary.hpp"
#include "results/superblock.hpp"
#include "results/text_table.hpp"
#include "results/xdmf.hpp"

namespace talus {

namespace fs = std::filesystem;

namespace {

const fs::path& prepared(const fs::path& folder) {
  prepare_results_folder(folder);
  return folder;
}

std::vector<HistoryMonitor> monitors_of(const Project& project) {
  std::vector<HistoryMonitor> monitors;
  for (const Monitor& monitor : project.monitors) monitors.push_back({monitor.name, monitor.stress});
  return monitors;
}

std::uint64_t node_count(const BlockSystem& system) {
  std::uint64_t count = 0;
  for (const Block& block : system.blocks) count += block.mesh.nodes.size();
  return count;
}

std::uint64_t tetrahedron_count(const BlockSystem& system) {
  std::uint64_t count = 0;
  for (const Block& block : system.blocks) count += block.mesh.tetrahedra.size();
  return count;
}

/// A folder whose results can be read as far as a run has them that goes on there. HDF5 believes what a damaged file
/// says of its parts while it writes, too, and crashes or waits for ever: reading is held to the file's bounds. Before
/// the folder is locked, for one that is written to is read with patience.
const fs::path& with_sound_results(const fs::path& folder, int frames) {
  const ResultFileReader results(folder / "results.h5");
  if (frames > 0 && static_cast<std::size_t>(frames) <= results.frame_times.size()) results.frame(frames - 1);
  return folder;
}

/// What a kill may leave marked as open is marked as closed, unless a run still writes there or the disk is read-only.
void mend(const fs::path& folder) {
  const fs::path file = folder / "results.h5";
  try {
    if (!is_marked_open(file)) return;
    const FolderLock nobody_writes(folder);
    mark_closed(file);
  } catch (const std::runtime_error&) {
    // Talus reads it all the same; only programs that know nothing of a writer would refuse it.
  }
}

}  // namespace

struct ResultWriter::State {
  State(const fs::path& results_folder, const Project& project, const BlockSystem& system)
      : folder(prepared(results_folder)),
        lock(folder),
        file(folder / "results.h5", project, system),
        index(folder / "results.xdmf", project.name, node_count(system), tetrahedron_count(system)),
        history(folder / "history.csv", history_header(monitors_of(project))),
        steps(folder / "steps.csv", steps_header()),
        log(folder / "log.txt") {}
  State(const fs::path& results_folder, const Project& project, const BlockSystem& system,
        const WrittenResults& written)
      : folder(with_sound_results(results_folder, written.frames)),
        lock(folder),
        file(folder / "results.h5", system, written.frames),
        index(folder / "results.xdmf", project.name, node_count(system), tetrahedron_count(system)),
        history(folder / "history.csv", written.history),
        steps(folder / "steps.csv", written.steps),
        frames(written.frames) {
    for (const double time : file.frame_times()) index.add_frame(time);
    cut_off(folder / "log.txt", written.log);
    log.open(folder / "log.txt", std::ios::app);
    fs::remove(folder / "summary.json");
  }

  fs::path folder;
  FolderLock lock;
  ResultFileWriter file;
  XdmfIndex index;
  TextTableWriter history, steps;
  std::ofstream log;
  int frames = 0;
};

namespace {

/// Makes what a writer needs; whatever is wrong with the folder is said of the folder.
auto in_folder(const fs::path& folder, const auto& make) {
  try {
    return make();
  } catch (const InputError&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw InputError(folder.string(), std::string("cannot be written to: ") + error.what(), "choose another --out");
  }
}

}  // namespace

ResultWriter::ResultWriter(const fs::path& folder, const Project& project, const BlockSystem& system,
                           const std::string& project_text) {
  in_folder(folder, [&] {
    state_ = std::make_unique<State>(folder, project, system);
    replace_file(folder / "project.talus", project_text);
  });
}

ResultWriter::ResultWriter(const fs::path& folder, const Project& project, const BlockSystem& system,
                           const std::string& project_text, const WrittenResults& written) {
  in_folder(folder, [&] {
    state_ = std::make_unique<State>(folder, project, system, written);
    replace_file(folder / "project.talus", project_text);
  });
}

int ResultWriter::frames() const { return state_->frames; }

WrittenResults ResultWriter::written() const {
  for (const char* file : {"results.h5", "history.csv", "steps.csv", "log.txt"}) flush_to_disk(state_->folder / file);
  return {state_->frames, fs::file_size(state_->folder / "history.csv"), fs::file_size(state_->folder / "steps.csv"),
          fs::file_size(state_->folder / "log.txt")};
}

ResultWriter::~ResultWriter() = default;

void ResultWriter::add_frame(const Frame& frame) {
  state_->file.add_frame(frame);
  state_->index.add_frame(frame.time);
  ++state_->frames;
}

void ResultWriter::add_step(const StepReport& step) { state_->steps.add(to_columns(step)); }

void ResultWriter::add_history(const HistoryRow& row) { state_->history.add(to_columns(row)); }

void ResultWriter::log(const std::string& line) {
  state_->log << line + '\n' << std::flush;
  if (!state_->log) throw WriteError(state_->folder / "log.txt");
}

void ResultWriter::finish(const RunReport& report) {
  state_->index.finish();
  replace_file(state_->folder / "summary.json", summary_json(report));
}

struct ResultReader::State {
  explicit State(const fs::path& results_folder) : folder(results_folder), file(folder / "results.h5") {}

  fs::path folder;
  ResultFileReader file;
};

ResultReader::ResultReader(const fs::path& folder) {
  if (!fs::is_regular_file(folder / "results.h5"))
    throw InputError(folder.string(), "holds no results.h5", "choose a results folder written by Talus");
  mend(folder);
  state_ = std::make_unique<State>(folder);
}

ResultReader::~ResultReader() = default;

const BlockSystem& ResultReader::system() const { return state_->file.system; }
const std::string& ResultReader::project_name() const { return state_->file.project_name; }
const std::vector<std::string>& ResultReader::stage_names() const { return state_->file.stage_names; }
const std::vector<std::string>& ResultReader::monitor_names() const { return state_->file.monitor_names; }
const std::vector<HistoryMonitor>& ResultReader::history_monitors() const { return state_->file.history_monitors; }
const std::vector<double>& ResultReader::frame_times() const { return state_->file.frame_times; }
Frame ResultReader::frame(int index) const { return state_->file.frame(index); }

std::vector<HistoryRow> ResultReader::history() const {
  std::vector<HistoryRow> rows;
  const std::vector<HistoryMonitor>& monitors = history_monitors();
  const std::size_t columns = history_header(monitors).size();
  for (const auto& row : read_text_table(state_->folder / "history.csv", columns))
    rows.push_back(history_row(row, monitors));
  return rows;
}

std::vector<StepReport> ResultReader::steps() const {
  std::vector<StepReport> steps;
  for (const auto& row : read_text_table(state_->folder / "steps.csv", steps_header().size()))
    steps.push_back(step_report(row));
  return steps;
}

std::optional<RunReport> ResultReader::report() const { return read_summary(state_->folder / "summary.json"); }

}  // namespace talus
