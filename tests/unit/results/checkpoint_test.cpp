#include "results/checkpoint.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "base/error.hpp"
#include "example_results.hpp"

namespace talus {
namespace {

/// Whether the file is refused, or its state read as it was written. Its label has no checksum: of another version or
/// project it is refused, too, by who goes on from it.
bool is_refused_or_whole(const std::filesystem::path& file, const std::string& state) {
  try {
    return read_checkpoint(file).value().state == state;
  } catch (const InputError& error) {
    return error.problem().find("is no checkpoint, or damaged: ") == 0;
  }
}

/// In the newest format all that HDF5 goes by has checksums. In the format of before, which has none, it asked for the
/// memory that it found written there, read beyond its own, and divided by a piece's size of 0.
TEST(Checkpoint, WithADamagedWordIsRefusedOrReadsAsItWas) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path / "checkpoint.h5";
  const std::string state(1000, 'x');
  write_checkpoint(file, {"1", "{}", 0.25}, [&](const auto& sink) { sink(state); });
  ASSERT_EQ(read_checkpoint(file).value().state, state);
  const std::string sound = text_of(file);
  const std::string words[] = {std::string(4, '\0'), std::string(4, '\xff'), std::string("\0\0\0\x40", 4)};
  for (std::size_t at = 0; at + 4 <= sound.size(); at += 4) {
    std::ofstream(file, std::ios::binary) << std::string(sound).replace(at, 4, words[at / 4 % 3]);
    ASSERT_TRUE(is_refused_or_whole(file, state)) << at;
  }
}

TEST(Checkpoint, OfAnOlderFormatIsRefused) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path / "checkpoint.h5";
  write_checkpoint(file, {"1", "{}", 0}, [](const auto& sink) { sink("state"); });
  std::string bytes = text_of(file);
  bytes[8] = 0;  // version of the superblock
  std::ofstream(file, std::ios::binary) << bytes;
  try {
    read_checkpoint(file);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.problem(), testing::HasSubstr("it does not begin as one"));
  }
}

}  // namespace
}  // namespace talus
