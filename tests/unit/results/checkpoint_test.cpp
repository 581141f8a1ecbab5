#include "results/checkpoint.hpp"

#include <gmock/gmock.h>

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

}  // namespace
}  // namespace talus
