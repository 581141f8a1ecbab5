#include "results/checkpoint.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "example_results.hpp"

namespace talus {
namespace {

TEST(Checkpoint, ThatSaysAPieceTakesFourGigabytesIsRefusedBeforeThereIsRoomMadeForIt) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path / "checkpoint.h5";
  const std::string state(1000, 'x');
  write_checkpoint(file, {"1", "{}", 0}, [&](const auto& sink) { sink(state); });
  ASSERT_EQ(read_checkpoint(file).value().state, state);

  // HDF5 File Format Specification 3.0, III.A.1: a tree of pieces; its first key begins with the bytes that one takes.
  std::string bytes = text_of(file);
  const std::size_t tree = bytes.find("TREE\1");
  ASSERT_NE(tree, std::string::npos);
  bytes.replace(tree + 24, 4, "\xff\xff\xff\xff");
  std::ofstream(file, std::ios::binary) << bytes;
  try {
    read_checkpoint(file);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.problem(), testing::HasSubstr("state is larger than the file"));
  }
}

/// tests/fuzz/corpus/results/checkpoint.h5 with bytes at some places changed.
class DamagedCheckpoint : public testing::Test {
 protected:
  using Change = std::pair<std::size_t, std::string>;

  void damage(const std::vector<Change>& changes) {
    std::string bytes = sound_;
    for (const auto& [at, other] : changes) bytes.replace(at, other.size(), other);
    std::ofstream(file_, std::ios::binary) << bytes;
  }

  std::string error_after(const std::vector<Change>& changes) {
    damage(changes);
    try {
      read_checkpoint(file_);
    } catch (const InputError& error) {
      return error.problem();
    }
    return "";
  }

  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path / "checkpoint.h5";
  std::string sound_ = text_of(std::string(TALUS_SOURCE_DIR) + "/tests/fuzz/corpus/results/checkpoint.h5");
};

// HDF5 multiplies a text's length by the size that the file says a letter has, and asked for petabytes.
TEST_F(DamagedCheckpoint, MakesNoRoomForLettersOfManyBytes) {
  damage({});
  const Checkpoint whole = read_checkpoint(file_).value();
  for (const Change& change : {Change{871, "\xa1"}, Change{1471, "\xa3"}}) {
    damage({change});
    const Checkpoint read = read_checkpoint(file_).value();
    EXPECT_EQ(read.label.version, whole.label.version);
    EXPECT_EQ(read.label.project_text, whole.label.project_text);
    EXPECT_EQ(read.state, whole.state);
  }
}

// HDF5 read beyond its memory, and crashed, or asked for a number of 2 GB.
TEST_F(DamagedCheckpoint, WhosePiecesAreOfAnotherSizeIsRefused) {
  using namespace std::string_literals;
  EXPECT_THAT(error_after({{1735, std::string(4, '\xff')}}), testing::HasSubstr("time holds something else"));
  EXPECT_THAT(error_after({{6480, "\1\0"s}}), testing::HasSubstr("state is not whole"));
  EXPECT_THAT(error_after({{6480, "\3\0"s}}), testing::HasSubstr("state is not whole"));
  EXPECT_THAT(error_after({{6321, std::string(4, '\0')}, {9184, "\xff\xff\xff\x3f"s}}),
              testing::HasSubstr("damaged: "));
  EXPECT_THAT(error_after({{6321, std::string(4, '\0')}, {6324, "\x8d\xff\x17\x63"s}}),
              testing::HasSubstr("damaged: "));
  EXPECT_THAT(error_after({{6245, "\x40"s}}), testing::HasSubstr("damaged: "));
  EXPECT_THAT(error_after({{6126, "\x20\0"s}, {6246, "\1"s}}), testing::HasSubstr("damaged: "));
}

}  // namespace
}  // namespace talus
