#include "base/memory_limit.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "base/error.hpp"

namespace talus {
namespace {

using testing::HasSubstr;

class Memory : public testing::Test {
 protected:
  void TearDown() override { set_memory_limit(HUGE_VAL); }

  std::string refusal(double bytes) {
    try {
      require_memory(bytes, "/mesh", "meshing", "take less");
      return "none";
    } catch (const InputError& error) {
      return error.what();
    }
  }
};

TEST_F(Memory, IsWhatTheMachineHasToSpareUntilToldOtherwise) {
  EXPECT_FALSE(memory_limit().told);
  EXPECT_GT(memory_limit().bytes, 1e7);
  EXPECT_LT(memory_limit().bytes, 1e14);
  set_memory_limit(3e9);
  EXPECT_TRUE(memory_limit().told);
  EXPECT_EQ(memory_limit().bytes, 3e9);
}

TEST_F(Memory, IsRefusedAboveTheLimit) {
  set_memory_limit(3e9);
  EXPECT_EQ(refusal(3e9), "none");
  EXPECT_EQ(
      refusal(4.26e9),
      "/mesh: meshing takes about 4.3 GB of memory, and --max-memory allows 3.0 GB; take less, or allow more with "
      "--max-memory");
}

TEST_F(Memory, IsRefusedAboveWhatTheMachineHas) {
  EXPECT_EQ(refusal(1e6), "none");
  EXPECT_THAT(refusal(1e20), HasSubstr("this machine has "));
}

TEST_F(Memory, IsToldInTwoDigits) {
  EXPECT_EQ(bytes_text(500), "0.5 kB");
  EXPECT_EQ(bytes_text(0), "0.0 kB");
  EXPECT_EQ(bytes_text(12345), "12 kB");
  EXPECT_EQ(bytes_text(346.7e6), "350 MB");
  EXPECT_EQ(bytes_text(9.96e9), "10 GB");
  EXPECT_EQ(bytes_text(4.4e21), "4.4e+09 TB");
}

TEST_F(Memory, IsReadAsPeopleWriteIt) {
  EXPECT_EQ(bytes_from("16GB"), 16e9);
  EXPECT_EQ(bytes_from("1.5 TB"), 1.5e12);
  EXPECT_EQ(bytes_from("800M"), 8e8);
  EXPECT_EQ(bytes_from("2000 B"), 2000);
  EXPECT_EQ(bytes_from("2e9"), 2e9);
  for (const char* wrong : {"", "GB", "-3", "0", "nan", "inf", "3 gigabytes", "3GBs", "3 XB"})
    EXPECT_FALSE(bytes_from(wrong)) << wrong;
}

}  // namespace
}  // namespace talus
