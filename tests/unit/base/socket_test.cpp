#include "base/socket.hpp"

#include <gtest/gtest.h>

#include <string>

namespace talus {
namespace {

std::string heard_by(Socket& socket, std::size_t size) {
  std::string bytes(size, '\0');
  bytes.resize(socket.read(bytes.data(), size));
  return bytes;
}

TEST(Socket, SendsAnotherAlong) {
  auto [one, other] = connected_sockets();
  auto [mine, yours] = connected_sockets();
  EXPECT_TRUE(one.send_with("take", yours));
  yours = Socket();
  char bytes[4];
  auto received = other.read_with(bytes, sizeof bytes);
  EXPECT_EQ(std::string(bytes, received.first), "take");
  EXPECT_TRUE(mine.send("hello"));
  EXPECT_EQ(heard_by(received.second, 5), "hello");
  EXPECT_TRUE(one.send("alone"));
  EXPECT_EQ(other.read_with(bytes, sizeof bytes).second.descriptor(), -1);
}

TEST(Socket, TellsWhenTheOtherEndIsClosedOrHasFinished) {
  auto [one, other] = connected_sockets();
  EXPECT_FALSE(one.wait(0));
  other.finish();
  EXPECT_TRUE(one.wait(0));
  EXPECT_EQ(heard_by(one, 1), "");
  EXPECT_TRUE(one.send("x")) << "it still listens";
  EXPECT_EQ(heard_by(other, 1), "x");
  other = Socket();
  EXPECT_FALSE(one.send("x"));
}

}  // namespace
}  // namespace talus
