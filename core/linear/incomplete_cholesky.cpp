#include "linear/incomplete_cholesky.hpp"

#include <Eigen/Cholesky>

namespace talus {

bool IncompleteCholesky::factor(const SymmetricBlocks& matrix) {
  pattern_ = matrix.pattern();
  for (double shift = 0; shift <= 1; shift = shift == 0 ? 1e-3 : 10 * shift)
    if (factor(matrix, shift)) return true;
  return false;
}

bool IncompleteCholesky::factor(const SymmetricBlocks& matrix, double shift) {
  const std::vector<int>&begin = pattern_.column_begin(), &rows = pattern_.rows();
  values_.resize(pattern_.slots());
  inverse_.resize(pattern_.nodes());
  for (int slot = 0; slot < pattern_.slots(); ++slot) values_[slot] = matrix.value(slot);
  for (int j = 0; j < pattern_.nodes(); ++j) {
    const Eigen::LLT<Mat3> diagonal(Mat3((1 + shift) * values_[begin[j]]));
    if (diagonal.info() != Eigen::Success) return false;
    inverse_[j] = diagonal.solve(Mat3::Identity());
    for (int across = begin[j] + 1; across < begin[j + 1]; ++across) {
      const Mat3 scaled = inverse_[j] * values_[across].transpose();
      int target = begin[rows[across]];
      const int end = begin[rows[across] + 1];
      for (int down = across; down < begin[j + 1]; ++down) {
        while (target < end && rows[target] < rows[down]) ++target;
        if (target == end) break;
        if (rows[target] == rows[down]) values_[target] -= values_[down] * scaled;
      }
      values_[across] = scaled.transpose();
    }
  }
  return true;
}

void IncompleteCholesky::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const {
  const std::vector<int>&begin = pattern_.column_begin(), &rows = pattern_.rows();
  x = b;
  for (int j = 0; j < pattern_.nodes(); ++j) {
    const Vec3 solved = x.segment<3>(3 * j);
    for (int slot = begin[j] + 1; slot < begin[j + 1]; ++slot) x.segment<3>(3 * rows[slot]) -= values_[slot] * solved;
  }
  for (int j = pattern_.nodes() - 1; j >= 0; --j) {
    Vec3 sum = inverse_[j] * x.segment<3>(3 * j);
    for (int slot = begin[j] + 1; slot < begin[j + 1]; ++slot)
      sum -= values_[slot].transpose() * x.segment<3>(3 * rows[slot]);
    x.segment<3>(3 * j) = sum;
  }
}

}  // namespace talus
