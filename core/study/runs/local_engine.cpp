#include "study/runs/local_engine.hpp"

#include <poll.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <thread>
#include <vector>

#include "base/child_process.hpp"

namespace talus {

namespace {

/// One run as a process, and how far it says it is.
class RunProcess {
 public:
  RunProcess(const RunsFolder& study, int number, const std::filesystem::path& program)
      : number_(number),
        process_({.program = program,
                  .arguments = {"study", "run", study.path().string(), std::to_string(number)},
                  .channel = 1,
                  .log = study.log_file(number)}),
        log_(study.log_file(number)) {}
  /// Silence leaves no file behind.
  ~RunProcess() {
    std::error_code none;
    if (std::filesystem::file_size(log_, none) == 0) std::filesystem::remove(log_, none);
  }
  RunProcess(const RunProcess&) = delete;
  RunProcess& operator=(const RunProcess&) = delete;

  int number() const { return number_; }
  int socket() const { return process_.socket().descriptor(); }
  double fraction() const { return fraction_; }

  /// Takes what it has said; false once it has ended. Its lines are fractions, 0 … 1.
  bool listen() {
    char bytes[512];
    const std::size_t count = process_.socket().read(bytes, sizeof bytes);
    if (count == 0) return false;
    words_.append(bytes, count);
    for (auto end = words_.find('\n'); end != std::string::npos; end = words_.find('\n')) {
      fraction_ = std::clamp(std::atof(words_.substr(0, end).c_str()), 0.0, 1.0);
      words_.erase(0, end + 1);
    }
    return true;
  }

 private:
  int number_;
  ChildProcess process_;
  std::filesystem::path log_;
  std::string words_;
  double fraction_ = 0;
};

/// The runs that are still to be done, and those under way.
class Queue {
 public:
  Queue(const RunsFolder& study, const LocalOptions& options) : study_(study), options_(options) {
    waiting_ = study.missing_runs();
    count_ = waiting_.size();
    std::stable_sort(waiting_.begin(), waiting_.end(), [&](int a, int b) { return cost(a) < cost(b); });
    for (const int run : waiting_) whole_ += cost(run);
  }

  bool done() const { return waiting_.empty() && running_.empty(); }

  void fill() {
    while (!waiting_.empty() && running_.size() < static_cast<std::size_t>(options_.jobs)) {
      running_.push_back(std::make_unique<RunProcess>(study_, waiting_.back(), options_.program));
      waiting_.pop_back();
    }
  }

  void listen(int milliseconds) {
    std::vector<pollfd> watched;
    for (const auto& run : running_) watched.push_back({run->socket(), POLLIN, 0});
    if (poll(watched.data(), watched.size(), milliseconds) <= 0) return;
    for (std::size_t i = running_.size(); i-- > 0;) {
      if (watched[i].revents == 0 || running_[i]->listen()) continue;
      done_ += cost(running_[i]->number());
      running_.erase(running_.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }

  void tell(Progress& progress) const {
    double sum = done_;
    for (const auto& run : running_) sum += run->fraction() * cost(run->number());
    const std::size_t ended = count_ - waiting_.size() - running_.size();
    progress.report(whole_ > 0 ? sum / whole_ : 1, std::to_string(ended) + " of " + std::to_string(count_) +
                                                       " runs have ended, " + std::to_string(running_.size()) +
                                                       " go on");
  }

 private:
  double cost(int run) const { return study_.cost(run); }

  const RunsFolder& study_;
  const LocalOptions& options_;
  std::vector<int> waiting_;  ///< cheapest first
  std::vector<std::unique_ptr<RunProcess>> running_;
  std::size_t count_ = 0;
  double whole_ = 0, done_ = 0;  ///< in units of the project's own setting
};

}  // namespace

int free_cores() {
  double load = 0;
  getloadavg(&load, 1);
  const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  return std::clamp(cores - static_cast<int>(std::lround(load)), 1, cores);
}

void run_locally(const RunsFolder& study, const LocalOptions& options, Progress& progress) {
  Queue queue(study, options);
  while (!queue.done()) {
    if (progress.cancelled()) throw Cancelled{};
    queue.fill();
    constexpr int patience = 50;  // ms, how long a cancelled wait may last
    queue.listen(patience);
    queue.tell(progress);
  }
}

}  // namespace talus
