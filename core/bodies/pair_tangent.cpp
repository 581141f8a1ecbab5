#include "bodies/pair_tangent.hpp"

#include "bodies/finite_rotation.hpp"

namespace talus {

namespace {

void set_zero(PairBlocks& sums) {
  for (auto& row : sums)
    for (Mat3& sum : row) sum.setZero();
}

/// spring · P, spring · P â, spring · l̂.
std::array<Mat3, 3> times_columns(const Mat3& spring, const RigidPair::State& pair, const Meeting::Levers& at) {
  const Mat3 half = spring * pair.half_turned;
  return {half, times_cross(half, at.end), times_cross(spring, at.second)};
}

}  // namespace

void PairTangent::clear() {
  set_zero(springs_);
  set_zero(set_down_);
  set_zero(sums_);
  force_.setZero();
  force_arm_.setZero();
  has_set_down_ = false;
}

void PairTangent::add_springs(const RigidPair::State& pair, const Meeting::Levers& at, const Columns& columns,
                              PairBlocks& sums) {
  for (int k = 0; k < 2; ++k) {
    const Mat3 moved = pair.half_turned.transpose() * columns[k];
    if (k == 0) sums[0][0] += moved;
    sums[1][k] += cross_times(at.end, moved);
  }
  for (int k = 0; k < 3; ++k) sums[2][k] += cross_times(at.second, columns[k]);
}

void PairTangent::add(const RigidPair::State& pair, const Meeting& place, const PointTangent& point) {
  const Meeting::Levers& at = place.levers(pair);
  if (point.has_set_down) {
    add_springs(pair, at, times_columns(point.set_down, pair, at), set_down_);
    has_set_down_ = true;
  }
  if (!point.bears && !point.has_other) return;
  Columns columns = times_columns(point.spring, pair, at);
  if (point.bears) add_springs(pair, at, columns, springs_);
  if (point.has_other) {
    const Columns others = times_columns(point.other, pair, at);
    for (int k = 0; k < 3; ++k) columns[k] += others[k];
  }
  for (int k = 0; k < 3; ++k) {
    sums_[0][k] += columns[k];
    sums_[1][k] += cross_times(at.first, columns[k]);
    sums_[2][k] += cross_times(at.second, columns[k]);
  }
  const Mat3 on_first = cross_matrix(place.weight() * point.force);
  force_ += on_first;
  force_arm_ += times_cross(on_first, at.end);
}

void PairTangent::find(const PairBlocks& sums, const RigidPair& pair, const RigidPair::State& state,
                       PairBlocks& blocks) {
  const double first = 1 / pair.first_radius();
  blocks[0][0] = sums[0][0];
  blocks[1][0] = first * sums[1][0];
  blocks[1][1] = -first * first * sums[1][1];
  blocks[2][0].noalias() = -state.tangent.transpose() * sums[2][0];
  blocks[2][1].noalias() = first * state.tangent.transpose() * sums[2][1];
  const Mat3 turned = sums[2][2] * state.tangent;
  blocks[2][2].noalias() = -state.tangent.transpose() * turned;
}

void PairTangent::find_symmetric(const RigidPair& pair, const RigidPair::State& state, PairBlocks& blocks) const {
  find(springs_, pair, state, blocks);
  if (!has_set_down_) return;
  PairBlocks others;
  find(set_down_, pair, state, others);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column <= row; ++column) blocks[row][column] += others[row][column];
}

void PairTangent::find_unsymmetric(const RigidPair& pair, const RigidPair::State& state, PairBlocks& blocks) const {
  const double first = 1 / pair.first_radius(), second = 1 / pair.second_radius();
  const double of_row[] = {1, first, -second};
  PairBlocks symmetric;
  find(springs_, pair, state, symmetric);
  for (int row = 0; row < 3; ++row) {
    blocks[row][0] = of_row[row] * sums_[row][0];
    blocks[row][1] = -first * of_row[row] * sums_[row][1];
    blocks[row][2].noalias() = of_row[row] * sums_[row][2] * state.tangent;
    for (int column = 0; column < 3; ++column) {
      if (row >= column)
        blocks[row][column] -= symmetric[row][column];
      else
        blocks[row][column] -= symmetric[column][row].transpose();
    }
  }
  // ∂ℓ₁ = −½ â ∂θ₁ of the arm at the end, ∂ℓ₂ = ½ (∂D₁ − ∂D₂) + ∂ℓ₁.
  blocks[1][1] += 0.5 * first * first * force_arm_;
  blocks[2][1] -= 0.5 * first * second * force_arm_;
  blocks[2][0] += 0.5 * second * force_;
}

}  // namespace talus
