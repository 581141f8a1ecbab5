#include "base/base64.hpp"

#include <gtest/gtest.h>

namespace talus {
namespace {

TEST(Base64, OfRfc4648sExamples) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Base64, OfBytesThatAreNoLetters) { EXPECT_EQ(base64(std::string("\xff\xfe\x00\xfb", 4)), "//4A+w=="); }

}  // namespace
}  // namespace talus
