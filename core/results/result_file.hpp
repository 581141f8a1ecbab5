#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "mesh/block.hpp"
#include "model/project.hpp"
#include "results/frame.hpp"
#include "results/history.hpp"

namespace talus {

/// results.h5: VTKHDF 2.0's UnstructuredGrid with moving points under /VTKHDF, and under /Talus what rebuilds the
/// blocks and the contacts of each frame; results.vtkhdf beside it is a link to the former, by the name that ParaView
/// knows. Written in HDF5's single-writer–multiple-readers mode: whatever moment the
/// program is killed at, the frames announced before are whole, and others may read while it grows. Coordinates,
/// displacements, velocities and contacts are doubles; stresses are floats (a relative 6e-8).
class ResultFileWriter {
 public:
  /// Creates the file with everything that does not change. Throws std::runtime_error with the path.
  ResultFileWriter(const std::filesystem::path& file, const Project& project, const BlockSystem& system);
  /// Goes on in a file of the same blocks behind so many of its frames; later ones are written over. Throws
  /// std::runtime_error with the path.
  ResultFileWriter(const std::filesystem::path& file, const BlockSystem& system, int frames);
  ~ResultFileWriter();
  ResultFileWriter(const ResultFileWriter&) = delete;
  ResultFileWriter& operator=(const ResultFileWriter&) = delete;

  /// Sizes of the frame must be those of the system (std::invalid_argument). Throws WriteError.
  void add_frame(const Frame& frame);
  std::vector<double> frame_times() const;  ///< s, of those written so far

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// What results.h5 holds.
class ResultFileReader {
 public:
  /// Throws InputError when the file is none of ours. Knows the frames that are announced at this moment.
  explicit ResultFileReader(const std::filesystem::path& file);
  ~ResultFileReader();
  ResultFileReader(const ResultFileReader&) = delete;
  ResultFileReader& operator=(const ResultFileReader&) = delete;

  BlockSystem system;
  std::string project_name;
  std::vector<std::string> stage_names, monitor_names;
  std::vector<HistoryMonitor> history_monitors;  ///< in the order of their names
  std::vector<double> frame_times;               ///< s

  /// Throws std::out_of_range for a frame that is not there, InputError when it cannot be read.
  Frame frame(int index) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace talus
