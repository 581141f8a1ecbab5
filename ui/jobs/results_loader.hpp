#pragma once

#include <QObject>
#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "base/error.hpp"
#include "results/result_folder.hpp"

namespace talus {

/// What a results folder holds apart from its frames.
struct ResultsIndex {
  std::filesystem::path folder;
  std::shared_ptr<const BlockSystem> system;
  std::string project_name;
  std::vector<std::string> stage_names, monitor_names;
  std::vector<double> frame_times;  ///< s
  std::vector<HistoryRow> history;
  std::vector<StepReport> steps;
  std::optional<RunReport> report;  ///< as ResultReader::report
};

/// Throws InputError.
ResultsIndex read_results_index(const std::filesystem::path& folder);

/// Reads a results folder on a thread of its own. Of several requests for frames that wait only the last is read:
/// who drags the timeline wants the frame under his hand.
class ResultsLoader : public QObject {
  Q_OBJECT
 public:
  explicit ResultsLoader(QObject* parent = nullptr);
  ~ResultsLoader() override;

  void open(const std::filesystem::path& folder);
  /// Of the folder that was opened last; answers of folders opened before are dropped.
  void requestFrame(int index);
  /// Lets the folder go, so that a new run may write there; waits for a frame that is being read.
  void close();

 signals:
  void opened(std::shared_ptr<const talus::ResultsIndex> index);
  void frameReady(std::shared_ptr<const talus::Frame> frame);
  void failed(const talus::InputError& error);

 private:
  void work();
  void openFolder(const std::filesystem::path& folder, int generation);
  void readFrame(int index, int generation);
  /// Calls `function` on the window's thread, unless another folder has been opened since.
  template <class Function>
  void answer(int generation, Function function);
  template <class Function>
  void reportingErrors(int generation, Function function);

  std::mutex mutex_;
  std::condition_variable woken_;
  std::optional<std::filesystem::path> wantedFolder_;
  std::optional<int> wantedFrame_;
  int generation_ = 0;  ///< counts folders
  bool closing_ = false, ending_ = false;

  std::unique_ptr<ResultReader> reader_;  ///< of the working thread alone
  std::thread thread_;
};

}  // namespace talus
