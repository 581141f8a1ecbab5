#include "bodies/pair_springs.hpp"

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

void PairSprings::clear() { set_zero(sums_); }

void PairSprings::add(const RigidPair::State& pair, const Meeting& place, const Mat3& spring) {
  const Meeting::Levers& at = place.levers(pair);
  const std::array<Mat3, 3> columns = times_columns(spring, pair, at);
  for (int k = 0; k < 2; ++k) {
    const Mat3 moved = pair.half_turned.transpose() * columns[k];
    if (k == 0) sums_[0][0] += moved;
    sums_[1][k] += cross_times(at.end, moved);
  }
  for (int k = 0; k < 3; ++k) sums_[2][k] += cross_times(at.second, columns[k]);
}

void PairSprings::find(const RigidPair& pair, const RigidPair::State& state, PairBlocks& blocks) const {
  const double first = 1 / pair.first_radius();
  blocks[0][0] = sums_[0][0];
  blocks[1][0] = first * sums_[1][0];
  blocks[1][1] = -first * first * sums_[1][1];
  blocks[2][0].noalias() = -state.tangent.transpose() * sums_[2][0];
  blocks[2][1].noalias() = first * state.tangent.transpose() * sums_[2][1];
  const Mat3 turned = sums_[2][2] * state.tangent;
  blocks[2][2].noalias() = -state.tangent.transpose() * turned;
}

void UnsymmetricPairSprings::clear() {
  symmetric_.clear();
  set_zero(sums_);
  force_.setZero();
  force_arm_.setZero();
}

void UnsymmetricPairSprings::add(const RigidPair::State& pair, const Meeting& place, const Vec3& force,
                                 const Mat3& spring, const Mat3& other) {
  symmetric_.add(pair, place, spring);
  const Meeting::Levers& at = place.levers(pair);
  const std::array<Mat3, 3> columns = times_columns(spring + other, pair, at);
  for (int k = 0; k < 3; ++k) {
    sums_[0][k] += columns[k];
    sums_[1][k] += cross_times(at.first, columns[k]);
    sums_[2][k] += cross_times(at.second, columns[k]);
  }
  const Mat3 on_first = cross_matrix(place.weight() * force);
  force_ += on_first;
  force_arm_ += times_cross(on_first, at.end);
}

void UnsymmetricPairSprings::find(const RigidPair& pair, const RigidPair::State& state, PairBlocks& blocks) const {
  const double first = 1 / pair.first_radius(), second = 1 / pair.second_radius();
  const double of_row[] = {1, first, -second};
  PairBlocks symmetric;
  symmetric_.find(pair, state, symmetric);
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
