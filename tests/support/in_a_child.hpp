#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <stdexcept>

namespace talus::test {

/// The number that `measure` comes to in a child of the test: of memory, what was held before is not in it.
template <class Measure>
double in_a_child(const Measure& measure) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
  const pid_t child = fork();
  if (child == 0) {
    const double number = measure();
    _exit(write(ends[1], &number, sizeof number) == sizeof number ? 0 : 1);
  }
  close(ends[1]);
  double number = 0;
  const bool told = read(ends[0], &number, sizeof number) == sizeof number;
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (!told || status != 0) throw std::runtime_error("the child told no number");
  return number;
}

}  // namespace talus::test
