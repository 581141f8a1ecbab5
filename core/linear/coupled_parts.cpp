#include "linear/coupled_parts.hpp"

namespace talus {

void CoupledParts::find(const SymmetricBlocks& matrix, std::span<const UnsymmetricBlocks::Pair> unsymmetric) {
  const std::vector<int>&column_begin = matrix.pattern().column_begin(), &rows = matrix.pattern().rows();
  has_value_.resize(matrix.pattern().slots());
  for (int slot = 0; slot < matrix.pattern().slots(); ++slot) has_value_[slot] = !matrix.value(slot).isZero(0);
  const auto each_coupling = [&](const auto& visit) {
    for (int column = 0; column < matrix.nodes(); ++column)
      for (int slot = column_begin[column] + 1; slot < column_begin[column + 1]; ++slot)  // the first is the diagonal
        if (has_value_[slot]) visit(column, rows[slot]);
  };
  together_.reset(matrix.nodes());
  each_coupling([&](int column, int row) { together_.join(column, row); });
  for (const UnsymmetricBlocks::Pair& pair : unsymmetric) together_.join(pair.row, pair.column);

  part_of_.resize(matrix.nodes());
  number_of_.resize(matrix.nodes());
  begin_.assign(1, 0);
  for (int node = 0; node < matrix.nodes(); ++node) {  // the first of each part comes before its others
    const int first = together_.first_of(node);
    if (first == node) {
      part_of_[node] = static_cast<int>(begin_.size()) - 1;
      begin_.push_back(0);
    }
    part_of_[node] = part_of_[first];
    number_of_[node] = begin_[part_of_[node] + 1]++;
  }
  for (std::size_t part = 1; part < begin_.size(); ++part) begin_[part] += begin_[part - 1];
  nodes_.resize(matrix.nodes());
  for (int node = 0; node < matrix.nodes(); ++node) nodes_[begin_[part_of_[node]] + number_of_[node]] = node;
  couplings_.assign(count(), 0);
  each_coupling([&](int column, int) { ++couplings_[part_of_[column]]; });
}

}  // namespace talus
