#include <gmock/gmock.h>
#include <hdf5.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <random>
#include <thread>

#include "base/error.hpp"
#include "example_results.hpp"
#include "results/result_file.hpp"
#include "results/superblock.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

/// Another process that writes frame after frame, and says on a pipe which one it has written.
class WritingProcess {
 public:
  WritingProcess(const fs::path& folder, const BlockSystem& system) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    process_ = fork();
    if (process_ == 0) {
      close(ends[0]);
      write_forever(folder, system, ends[1]);
    }
    close(ends[1]);
    pipe_ = ends[0];
  }
  ~WritingProcess() {
    kill_and_count();
    close(pipe_);
  }
  WritingProcess(const WritingProcess&) = delete;
  WritingProcess& operator=(const WritingProcess&) = delete;

  /// Kills it and returns how many frames it had announced.
  int kill_and_count() {
    if (process_ != 0) {
      kill(process_, SIGKILL);
      waitpid(process_, nullptr, 0);
      process_ = 0;
    }
    for (char byte; read(pipe_, &byte, 1) == 1;) ++announced_;
    return announced_;
  }

  /// Waits until it has announced one more.
  bool wait_for_one() {
    char byte;
    const bool came = read(pipe_, &byte, 1) == 1;
    announced_ += came;
    return came;
  }
  int announced() const { return announced_; }

 private:
  [[noreturn]] static void write_forever(const fs::path& folder, const BlockSystem& system, int pipe_end) {
    ResultWriter writer(folder, example_project(), system, "{}");
    for (int i = 0;; ++i) {
      StepReport step;
      step.step = i;
      writer.add_step(step);
      writer.add_history({.time = 0.1 * i, .stage = 0, .monitors = std::vector<MonitorSample>(2)});
      writer.add_frame(example_frame(system, i));
      const char byte = 1;
      if (write(pipe_end, &byte, 1) != 1) _exit(1);
    }
  }

  pid_t process_ = 0;
  int pipe_ = -1, announced_ = 0;
};

/// Tags close in order, one root, nothing but spaces and instructions behind it.
void expect_well_formed(const std::string& xml) {
  std::vector<std::string> open;
  int roots = 0;
  for (std::size_t at = 0; at < xml.size();) {
    if (xml[at] != '<') {
      if (open.empty()) {
        ASSERT_TRUE(std::isspace(static_cast<unsigned char>(xml[at]))) << "text outside the root";
      }
      ++at;
      continue;
    }
    const bool instruction = xml.compare(at, 2, "<?") == 0;
    const std::size_t end = xml.find(instruction ? "?>" : ">", at);
    ASSERT_NE(end, std::string::npos) << "a tag without end";
    const std::string tag = xml.substr(at + 1, end - at - 1);
    at = end + (instruction ? 2 : 1);
    if (instruction || tag.back() == '/') continue;
    const std::string name = tag.substr(0, tag.find(' '));
    if (name[0] != '/') {
      roots += open.empty();
      open.push_back(name);
    } else {
      ASSERT_FALSE(open.empty()) << name;
      ASSERT_EQ('/' + open.back(), name);
      open.pop_back();
    }
  }
  EXPECT_TRUE(open.empty());
  EXPECT_EQ(roots, 1);
}

int frames_in_index(const fs::path& folder) {
  std::ifstream stream(folder / "results.xdmf");
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  expect_well_formed(text);
  int frames = 0;
  for (std::size_t at = 0; (at = text.find("<Grid Name=\"frame ", at)) != std::string::npos; ++at) ++frames;
  return frames;
}

void expect_whole(const fs::path& folder, const BlockSystem& system, int announced) {
  const ResultReader reader(folder);
  const int frames = static_cast<int>(reader.frame_times().size());
  ASSERT_GE(frames, announced);
  ASSERT_LE(frames, announced + 1);
  for (int i = 0; i < frames; ++i) ASSERT_TRUE(same(reader.frame(i), example_frame(system, i))) << i;
  EXPECT_EQ(reader.system().blocks[1].mesh.nodes, system.blocks[1].mesh.nodes);
  const auto steps = reader.steps();
  EXPECT_GE(static_cast<int>(steps.size()), announced);
  EXPECT_GE(static_cast<int>(reader.history().size()), announced);
  for (int i = 0; i < static_cast<int>(steps.size()); ++i) EXPECT_EQ(steps[i].step, i);
  EXPECT_GE(frames_in_index(folder), announced);
  EXPECT_FALSE(is_marked_open(folder / "results.h5"));  // others can open it now
}

TEST(KilledWriter, EveryAnnouncedFrameIsWholeWheneverItIsKilled) {
  const BlockSystem system = example_system(60, 140);
  std::mt19937 random(20);
  std::uniform_int_distribution<int> microseconds(0, 25'000);
  int most = 0, killed_early = 0;
  for (int repetition = 0; repetition < 40; ++repetition) {
    const TemporaryFolder temporary;
    WritingProcess writer(temporary.path, system);
    if (repetition % 4 != 0) writer.wait_for_one();
    std::this_thread::sleep_for(std::chrono::microseconds(microseconds(random)));
    const int announced = writer.kill_and_count();
    most = std::max(most, announced);
    if (announced == 0) {
      ++killed_early;  // nothing was promised: either a reader of no frames, or one clear error
      try {
        const ResultReader reader(temporary.path);
        EXPECT_LE(reader.frame_times().size(), 1u);
      } catch (const InputError&) {
      }
      continue;
    }
    expect_whole(temporary.path, system, announced);
    if (HasFatalFailure()) FAIL() << "repetition " << repetition;
  }
  EXPECT_GT(most, 4);
  EXPECT_LT(killed_early, 15);
}

TEST(KilledWriter, ResultsCanBeReadWhileAnotherProcessWrites) {
  const BlockSystem system = example_system(60, 140);
  const TemporaryFolder temporary;
  WritingProcess writer(temporary.path, system);
  int last = 0;
  for (int round = 0; round < 40; ++round) {
    ASSERT_TRUE(writer.wait_for_one());
    const ResultReader reader(temporary.path);
    const int frames = static_cast<int>(reader.frame_times().size());
    ASSERT_GE(frames, writer.announced());
    EXPECT_GE(frames, last);
    last = frames;
    for (const int i : {0, frames / 2, frames - 1}) ASSERT_TRUE(same(reader.frame(i), example_frame(system, i)));
  }
}

int announced_to_others(const fs::path& file) {
  const hid_t opened = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t steps = H5Aopen_by_name(opened, "/VTKHDF/Steps", "NSteps", H5P_DEFAULT, H5P_DEFAULT);
  std::int64_t count = -1;
  H5Aread(steps, H5T_NATIVE_INT64, &count);
  H5Aclose(steps);
  H5Fclose(opened);
  return static_cast<int>(count);
}

TEST(KilledWriter, FramesThatAreWrittenAgainStayAnnounced) {
  const BlockSystem system = example_system();
  const TemporaryFolder temporary;
  const fs::path file = temporary.path / "results.h5";
  {
    ResultFileWriter writer(file, example_project(), system);
    for (int i = 0; i < 5; ++i) writer.add_frame(example_frame(system, i));
  }
  for (const int again : {1, 3, 5}) {  // from two frames on, so many of them
    ResultFileWriter writer(file, system, 2);
    for (int i = 2; i < 2 + again; ++i) writer.add_frame(example_frame(system, i));
    EXPECT_EQ(announced_to_others(file), std::max(5, 2 + again));
    EXPECT_EQ(writer.frame_times().size(), 2u + static_cast<std::size_t>(again));
  }
  const ResultFileReader reader(file);
  ASSERT_EQ(reader.frame_times.size(), 7u);
  for (int i = 0; i < 7; ++i) EXPECT_TRUE(same(reader.frame(i), example_frame(system, i))) << i;
}

TEST(KilledWriter, TheFileLooksClosedToProgramsThatKnowOfNoWriter) {
  const BlockSystem system = example_system();
  const TemporaryFolder temporary;
  ResultWriter writer(temporary.path, example_project(), system, "{}");
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(is_marked_open(temporary.path / "results.h5"));
    writer.add_frame(example_frame(system, i));
  }
}

TEST(KilledWriter, AMarkThatAKillOfAnEarlierVersionLeftIsMendedWhenTheResultsAreOpened) {
  const BlockSystem system = example_system();
  const TemporaryFolder temporary;
  const fs::path file = temporary.path / "results.h5";
  const auto mark = [&] {
    std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekp(11);
    stream.put(5);
  };
  {
    ResultWriter writer(temporary.path, example_project(), system, "{}");
    writer.add_frame(example_frame(system, 0));
  }
  mark();
  ASSERT_TRUE(is_marked_open(file));
  const ResultReader after(temporary.path);
  EXPECT_FALSE(is_marked_open(file));
  EXPECT_TRUE(same(after.frame(0), example_frame(system, 0)));
}

TEST(KilledWriter, OnlyOurKindOfSuperblockIsTouched) {
  const TemporaryFolder temporary;
  const fs::path file = temporary.path / "other";
  std::ofstream(file) << std::string(100, 'x');
  EXPECT_THROW(mark_closed(file), std::runtime_error);
}

}  // namespace
}  // namespace talus
