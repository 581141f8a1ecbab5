#include "jobs/results_loader.hpp"

namespace talus {

namespace {

ResultsIndex index_of(const ResultReader& reader, const std::filesystem::path& folder) {
  ResultsIndex index;
  index.folder = folder;
  index.system = std::make_shared<BlockSystem>(reader.system());
  index.project_name = reader.project_name();
  index.stage_names = reader.stage_names();
  index.monitor_names = reader.monitor_names();
  index.frame_times = reader.frame_times();
  index.history = reader.history();
  index.steps = reader.steps();
  index.report = reader.report();
  return index;
}

}  // namespace

ResultsIndex read_results_index(const std::filesystem::path& folder) { return index_of(ResultReader(folder), folder); }

ResultsLoader::ResultsLoader(QObject* parent) : QObject(parent), thread_([this] { work(); }) {}

ResultsLoader::~ResultsLoader() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  woken_.notify_all();
  thread_.join();
}

void ResultsLoader::open(const std::filesystem::path& folder) {
  const std::lock_guard lock(mutex_);
  wantedFolder_ = folder;
  wantedFrame_.reset();
  ++generation_;
  woken_.notify_all();
}

void ResultsLoader::requestFrame(int index) {
  const std::lock_guard lock(mutex_);
  wantedFrame_ = index;
  woken_.notify_all();
}

void ResultsLoader::close() {
  std::unique_lock lock(mutex_);
  wantedFolder_.reset();
  wantedFrame_.reset();
  ++generation_;
  closing_ = true;
  woken_.notify_all();
  woken_.wait(lock, [this] { return !closing_; });
}

void ResultsLoader::work() {
  for (;;) {
    std::optional<std::filesystem::path> folder;
    std::optional<int> frame;
    int generation = 0;
    {
      std::unique_lock lock(mutex_);
      woken_.wait(lock, [this] { return ending_ || closing_ || wantedFolder_ || wantedFrame_; });
      if (ending_) return;
      if (closing_) {
        reader_.reset();
        closing_ = false;
        woken_.notify_all();
        continue;
      }
      if (wantedFolder_)
        folder = std::exchange(wantedFolder_, std::nullopt);
      else
        frame = std::exchange(wantedFrame_, std::nullopt);
      generation = generation_;
    }
    if (folder)
      openFolder(*folder, generation);
    else
      readFrame(*frame, generation);
  }
}

template <class Function>
void ResultsLoader::answer(int generation, Function function) {
  QMetaObject::invokeMethod(
      this,
      [this, generation, function] {
        if (generation == generation_) function();
      },
      Qt::QueuedConnection);
}

template <class Function>
void ResultsLoader::reportingErrors(int generation, Function function) {
  const auto fail = [&](const InputError& error) { answer(generation, [this, error] { emit failed(error); }); };
  try {
    function();
  } catch (const InputError& error) {
    fail(error);
  } catch (const std::exception& error) {
    fail({"results", error.what(), "solve the project again"});
  }
}

void ResultsLoader::openFolder(const std::filesystem::path& folder, int generation) {
  reader_.reset();
  reportingErrors(generation, [&] {
    reader_ = std::make_unique<ResultReader>(folder);
    const auto index = std::make_shared<const ResultsIndex>(index_of(*reader_, folder));
    answer(generation, [this, index] { emit opened(index); });
  });
}

void ResultsLoader::readFrame(int index, int generation) {
  if (!reader_) return;
  reportingErrors(generation, [&] {
    const auto frame = std::make_shared<const Frame>(reader_->frame(index));
    answer(generation, [this, frame] { emit frameReady(frame); });
  });
}

}  // namespace talus
