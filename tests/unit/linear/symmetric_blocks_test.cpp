#include "linear/symmetric_blocks.hpp"

#include <gmock/gmock.h>

namespace talus {
namespace {

const Mat3 block = (Mat3() << 1, 2, 3, 4, 5, 6, 7, 8, 9).finished();

TEST(SymmetricBlocks, SlotTakesWhatItsRowAndColumnTake) {
  SymmetricBlocks by_nodes, by_slots;
  for (SymmetricBlocks* matrix : {&by_nodes, &by_slots}) {
    matrix->set_pattern(3, {{0, 2}});
    matrix->set_weight(0.5);
  }
  by_nodes.add(0, 2, block.transpose());
  by_nodes.add(2, 0, block);
  const int slot = by_slots.pattern().slot(0, 2);
  by_slots.add_at(slot, block);
  by_slots.add_at(slot, block);
  EXPECT_EQ(by_nodes.value(slot), by_slots.value(slot));
  EXPECT_EQ(by_slots.value(slot), block);
}

TEST(SymmetricBlocks, TakesOverAPartAndSaysWhetherABitHasChanged) {
  SymmetricBlocks whole, part;
  whole.set_pattern(4, {{0, 2}, {1, 3}});
  part.set_pattern(2, {{0, 1}});
  const std::vector<int> nodes{1, 3};
  EXPECT_FALSE(part.assign_part(whole, nodes)) << "both are zero";
  whole.add(2, 0, block);
  EXPECT_FALSE(part.assign_part(whole, nodes)) << "of other nodes";
  whole.add(3, 3, block);
  whole.add(3, 1, 2 * block);
  EXPECT_TRUE(part.assign_part(whole, nodes));
  EXPECT_EQ(part.value(part.pattern().slot(1, 1)), block);
  EXPECT_EQ(part.value(part.pattern().slot(1, 0)), 2 * block);
  EXPECT_FALSE(part.assign_part(whole, nodes));
}

}  // namespace
}  // namespace talus
