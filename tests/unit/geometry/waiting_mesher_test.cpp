#include "geometry/waiting_mesher.hpp"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <thread>

#include "base/progress.hpp"
#include "rock.hpp"

namespace talus {
namespace {

using namespace rock;

Project halved_cube(double mesh_size) {
  Project p = project();
  p.solids = {box("cube", {0, 0, 0}, {10, 10, 10}, mesh_size)};
  p.cuts = {cut("J1", 0, 0, {0, 0, 5})};
  return p;
}

/// Programs that this thread has started and that have not been waited for.
std::vector<pid_t> children() {
  std::ifstream list("/proc/self/task/" + std::to_string(gettid()) + "/children");
  std::vector<pid_t> found;
  for (pid_t one = 0; list >> one;) found.push_back(one);
  return found;
}

TEST(WaitingMesher, IsStartedOnceForManyJobs) {
  end_waiting_mesher();
  EXPECT_TRUE(children().empty());
  build(halved_cube(5));
  const std::vector<pid_t> first = children();
  EXPECT_EQ(first.size(), 1u);
  for (const double size : {2.5, 5.0}) EXPECT_EQ(build(halved_cube(size)).blocks.size(), 2u);
  EXPECT_EQ(children(), first);
  end_waiting_mesher();
  EXPECT_TRUE(children().empty());
}

TEST(WaitingMesher, IsStartedAnewOnceItHasDied) {
  build(halved_cube(5));
  const std::vector<pid_t> first = children();
  for (const pid_t one : first) kill(one, SIGKILL);
  EXPECT_EQ(build(halved_cube(5)).blocks.size(), 2u);
  EXPECT_NE(children(), first);
}

TEST(WaitingMesher, GivesEachJobTheSameBitsAsTheFirst) {
  end_waiting_mesher();
  const BlockSystem first = build(halved_cube(2.5)), later = build(halved_cube(2.5));
  ASSERT_EQ(later.blocks.size(), first.blocks.size());
  for (std::size_t b = 0; b < first.blocks.size(); ++b) {
    EXPECT_EQ(later.blocks[b].mesh.nodes, first.blocks[b].mesh.nodes);
    EXPECT_EQ(later.blocks[b].mesh.tetrahedra, first.blocks[b].mesh.tetrahedra);
  }
}

TEST(WaitingMesher, DoesJobsOfSeveralThreadsAtOnce) {
  std::vector<std::size_t> blocks(4);
  std::vector<std::thread> threads;
  for (std::size_t& count : blocks) threads.emplace_back([&] { count = build(halved_cube(2.5)).blocks.size(); });
  for (std::thread& one : threads) one.join();
  EXPECT_THAT(blocks, testing::Each(2u));
}

/// What is asked of it in a fork of the program that started it is no job of that program's mesher.
TEST(WaitingMesher, OfAForkIsItsOwn) {
  build(halved_cube(5));
  const pid_t fork_of_this = fork();
  if (fork_of_this == 0) {
    const bool had_none = children().empty();
    const bool meshed = build(halved_cube(5)).blocks.size() == 2;
    _exit(had_none && meshed && children().size() == 1 ? 0 : 1);
  }
  int status = 0;
  waitpid(fork_of_this, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(build(halved_cube(5)).blocks.size(), 2u) << "the one of this program goes on";
}

}  // namespace
}  // namespace talus
