#include <stdexcept>

#include "fuzz/given.hpp"
#include "orientation/joint_table.hpp"
#include "results/steps.hpp"
#include "results/summary.hpp"
#include "results/text_table.hpp"

// A table of joints, which is written so that it reads as the same; and the same text as the tables of a run.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace talus;
  const std::string_view text = fuzz::text_of(bytes, size);
  const JointTable table = read_joint_table(text);
  if (const auto joints = table.joints(); !joints.empty()) {
    const JointTable again = read_joint_table(joint_table_text(joints));
    if (again.lines.size() != joints.size()) throw std::logic_error("a table has not the lines that were written");
  }
  const auto file = fuzz::file_of(text, "table");
  fuzz::allow_refusal([&] {
    for (const auto& row : read_text_table(file, steps_header().size())) step_report(row);
  });
  fuzz::allow_refusal([&] { read_summary(file); });
  return 0;
}
