#include "base/child_process.hpp"

#include <gtest/gtest.h>

#include <system_error>

namespace talus {
namespace {

TEST(ChildProcess, SaysWhatItWritesAndHowItEnded) {
  const ProgramOutput output = output_of("sh", {"-c", "echo one two; exit 3"});
  EXPECT_EQ(output.text, "one two\n");
  EXPECT_EQ(output.exit_code, 3);
}

TEST(ChildProcess, ThatASignalEndsIsToldAsShellsDo) { EXPECT_EQ(output_of("sh", {"-c", "kill -9 $$"}).exit_code, 137); }

TEST(ChildProcess, HearsWhatItIsSentAndAnswers) {
  // A shell reads its program from the socket, and answers through it.
  ChildProcess shell({.program = "sh"});
  shell.socket().send("echo heard >&0; exit 4\n");
  std::string answer(6, ' ');
  ASSERT_TRUE(shell.socket().wait(10000));
  EXPECT_EQ(shell.socket().read(answer.data(), answer.size()), 6u);
  EXPECT_EQ(answer, "heard\n");
  EXPECT_EQ(shell.exit_code(), 4);
}

TEST(ChildProcess, ThatThereIsNotIsRefused) { EXPECT_THROW(output_of("no-such-program", {}), std::system_error); }

}  // namespace
}  // namespace talus
