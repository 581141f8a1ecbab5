#include "process.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

namespace talus::test {

namespace {

constexpr std::chrono::minutes patience{2};

/// In the child: standard input from a file, standard output or error into one.
void redirect(int stream, const std::filesystem::path& file) {
  const int how = stream == STDIN_FILENO ? O_RDONLY : O_WRONLY | O_CREAT | O_TRUNC;
  const int descriptor = open(file.c_str(), how, 0600);
  dup2(descriptor, stream);
  close(descriptor);
}

}  // namespace

Folder::Folder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "talus-cli-test-XXXXXX").string();
  path_ = mkdtemp(pattern.data());
}

Folder::~Folder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

void write_text(const std::filesystem::path& file, const std::string& text) { std::ofstream(file) << text; }

Cli::Cli(const std::vector<std::string>& arguments, const std::filesystem::path& input) {
  std::vector<std::string> words{TALUS_CLI};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  process_ = fork();
  if (process_ != 0) return;
  redirect(STDIN_FILENO, input);
  redirect(STDOUT_FILENO, streams_ / "out");
  redirect(STDERR_FILENO, streams_ / "err");
  unsetenv("DISPLAY");
  execv(TALUS_CLI, pointers.data());
  _exit(127);
}

Cli::~Cli() {
  if (ended_) return;
  kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
}

void Cli::send(int signal) const { kill(process_, signal); }

std::string Cli::said() const { return text_of(streams_ / "err"); }

Ending Cli::wait() {
  Ending ending;
  int status = 0;
  const auto give_up = std::chrono::steady_clock::now() + patience;
  while (waitpid(process_, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() > give_up) {
      ADD_FAILURE() << "talus-cli goes on after two minutes";
      kill(process_, SIGKILL);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  ended_ = true;
  if (WIFEXITED(status)) ending.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) ending.signal = WTERMSIG(status);
  ending.out = text_of(streams_ / "out");
  ending.err = said();
  return ending;
}

Ending talus_cli(const std::vector<std::string>& arguments, const std::filesystem::path& input) {
  return Cli(arguments, input).wait();
}

std::string sample(const std::string& name) {
  return (std::filesystem::path(TALUS_SOURCE_DIR) / "samples" / name / (name + ".talus")).string();
}

}  // namespace talus::test
