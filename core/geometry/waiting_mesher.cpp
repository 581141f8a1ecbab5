#include "geometry/waiting_mesher.hpp"

#include <unistd.h>

#include <memory>
#include <mutex>

#include "base/child_process.hpp"

namespace talus {
namespace {

/// Reads sockets of jobs from one that came with the first job.
class WaitingMesher {
 public:
  ~WaitingMesher() { end(); }

  Socket begin_job(const std::filesystem::path& program, std::string_view first_bytes) {
    const std::lock_guard lock(access_);
    if (started_by_ != getpid() || program_ != program) end();
    auto [ours, its] = connected_sockets();
    if (process_ && orders_.send_with("j", its) && is_begun()) {
      ours.send(first_bytes);
      return std::move(ours);
    }
    end();  // or it has died
    return start(program, first_bytes);
  }

  void end_waiting() {
    const std::lock_guard lock(access_);
    end();
  }

 private:
  /// Jobs under way, of other threads, end with it.
  void end() {
    orders_ = Socket();
    if (started_by_ != getpid()) {  // that of the program that this was forked from is not this one's to wait for
      process_.release();
    } else if (process_) {
      process_->exit_code();
      process_.reset();
    }
  }

  bool is_begun() {
    constexpr int patience = 5000;  // ms
    char word = 0;
    return orders_.wait(patience) && orders_.read(&word, 1) == 1;
  }

  Socket start(const std::filesystem::path& program, std::string_view first_bytes) {
    process_ = std::make_unique<ChildProcess>(ChildProgram{.program = program});
    program_ = program;
    started_by_ = getpid();
    auto [ours, its] = connected_sockets();
    orders_ = std::move(ours);
    process_->socket().send_with(first_bytes, its);
    return std::move(process_->socket());
  }

  std::mutex access_;
  std::unique_ptr<ChildProcess> process_;
  std::filesystem::path program_;
  pid_t started_by_ = getpid();
  Socket orders_;
};

WaitingMesher& waiting_mesher() {
  static WaitingMesher mesher;
  return mesher;
}

}  // namespace

Socket begin_mesher_job(const std::filesystem::path& program, std::string_view first_bytes) {
  return waiting_mesher().begin_job(program, first_bytes);
}

void end_waiting_mesher() { waiting_mesher().end_waiting(); }

}  // namespace talus
