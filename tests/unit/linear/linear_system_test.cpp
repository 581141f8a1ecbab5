#include "linear/linear_system.hpp"

#include <gmock/gmock.h>

#include <array>

namespace talus {
namespace {

using testing::HasSubstr;
using Couplings = std::vector<std::pair<int, int>>;

constexpr double tolerance = 1e-4;
constexpr int long_chain = 20;  ///< nodes, too many for the dense solver

/// Chains of nodes joined by springs, each node held by a weak spring of its own.
class Chains {
 public:
  /// `lengths`: nodes of each chain. With `interleaved` numbers the chains take turns.
  explicit Chains(std::vector<int> lengths, bool interleaved = false) {
    int node = 0;
    chains_.resize(lengths.size());
    if (interleaved) {
      for (int k = 0; node < total(lengths); ++k)
        for (std::size_t c = 0; c < lengths.size(); ++c)
          if (k < lengths[c]) chains_[c].push_back(node++);
    } else {
      for (std::size_t c = 0; c < lengths.size(); ++c)
        for (int k = 0; k < lengths[c]; ++k) chains_[c].push_back(node++);
    }
    refresh_pattern({});
    for (std::size_t c = 0; c < chains_.size(); ++c) add_springs(c, 1);
  }
  void refresh_pattern(Couplings more) {
    for (const std::vector<int>& chain : chains_)
      for (std::size_t k = 0; k + 1 < chain.size(); ++k) more.emplace_back(chain[k + 1], chain[k]);
    matrix.set_pattern(total_nodes(), std::move(more));
    unsymmetric.set_pattern(matrix.pattern());
  }
  void add_springs(std::size_t chain, double stiffness) {
    const Mat3 spring = stiffness * (Mat3() << 2, 0.1, 0.2, 0.1, 3, 0.3, 0.2, 0.3, 4).finished();
    for (std::size_t k = 0; k < chains_[chain].size(); ++k) {
      const int node = chains_[chain][k];
      matrix.add(node, node, 0.3 * spring);
      if (k == 0) continue;
      const int last = chains_[chain][k - 1];
      matrix.add(node, node, spring);
      matrix.add(last, last, spring);
      matrix.add(node, last, -spring);
    }
  }
  const std::vector<int>& chain(std::size_t c) const { return chains_[c]; }
  int total_nodes() const {
    std::size_t nodes = 0;
    for (const std::vector<int>& chain : chains_) nodes += chain.size();
    return static_cast<int>(nodes);
  }
  Eigen::VectorXd times(const Eigen::VectorXd& x) const {
    Eigen::VectorXd y;
    matrix.multiply(x, y);
    UnsymmetricBlocks::add_product(unsymmetric.pairs(), x, y);
    return y;
  }
  Eigen::VectorXd wanted() const { return Eigen::VectorXd::LinSpaced(3 * total_nodes(), -1, 3); }

  SymmetricBlocks matrix;
  UnsymmetricBlocks unsymmetric;

 private:
  static int total(const std::vector<int>& lengths) {
    int sum = 0;
    for (const int length : lengths) sum += length;
    return sum;
  }
  std::vector<std::vector<int>> chains_;
};

/// Solves for what gives `wanted`; returns the norm of the error over that of the right-hand side's.
double error_of(LinearSystem& system, const Chains& chains) {
  const Eigen::VectorXd b = chains.times(chains.wanted());
  Eigen::VectorXd x;
  system.solve(chains.matrix, chains.unsymmetric, b, {}, x);
  return (chains.times(x) - b).norm() / b.norm();
}

TEST(LinearSystem, SolvesSmallAndLargeSystemsWithInterleavedNumbersExactly) {
  Chains chains({2, long_chain, 1, 30, 8}, true);
  LinearSystem system({tolerance, 40});
  system.set_pattern(chains.matrix.pattern());
  EXPECT_LT(error_of(system, chains), 1e-13);
  EXPECT_EQ(system.work().systems, 5);
  EXPECT_EQ(system.work().largest_system, 30);
  EXPECT_EQ(system.work().factorisations, 2);
  EXPECT_EQ(system.work().dense_factorisations, 3);
  EXPECT_EQ(system.work().gmres_iterations, 0);
}

/// An incomplete factor of a chain is a whole one; of a wide net it is not, and of one with springs of very different
/// stiffness it is no good.
TEST(LinearSystem, DoesWithoutAWholeFactorWhereThatLeadsOn) {
  Chains chains({600, 700});
  LinearSystem system({tolerance, 40, 40});
  system.set_pattern(chains.matrix.pattern());
  EXPECT_LT(error_of(system, chains), 1e-10);
  EXPECT_EQ(system.work().factorisations, 0);
  EXPECT_EQ(system.work().gmres_iterations, 2);
  system.demand_factors();
  EXPECT_LT(error_of(system, chains), 1e-13);
  EXPECT_EQ(system.work().factorisations, 2);
}

TEST(LinearSystem, IsLeftAloneWithIncompleteFactorsForSomeTimeWhereTheyFail) {
  const int wide = 24;
  SymmetricBlocks net;
  Couplings couplings;
  for (int i = 0; i < wide * wide; ++i) {
    if (i % wide > 0) couplings.emplace_back(i, i - 1);
    if (i >= wide) couplings.emplace_back(i, i - wide);
  }
  net.set_pattern(wide * wide, couplings);
  UnsymmetricBlocks none;
  none.set_pattern(net.pattern());
  LinearSystem system({1e-10, 40, 5});
  system.set_pattern(net.pattern());
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(3 * wide * wide, -1, 3);
  Eigen::VectorXd x, back;
  std::vector<long> iterations;
  for (int time = 0; time < 8; ++time) {
    net.set_zero();
    for (int i = 0; i < wide * wide; ++i) net.add(i, i, (1e-4 + 1e-6 * time) * Mat3::Identity());
    for (const auto& [i, j] : couplings) {
      for (const int node : {i, j}) net.add(node, node, Mat3::Identity());
      net.add(i, j, -Mat3::Identity());
    }
    system.outdate();
    const long before = system.work().gmres_iterations;
    system.solve(net, none, b, {}, x);
    iterations.push_back(system.work().gmres_iterations - before);
    net.multiply(x, back);
    EXPECT_LT((back - b).norm(), 1e-9 * b.norm());
  }
  EXPECT_THAT(iterations, testing::ElementsAre(5, 0, 5, 0, 0, 0, 5, 0));
}

TEST(LinearSystem, MatrixThatStaysTheSameIsFactoredOnce) {
  Chains chains({3, long_chain});
  LinearSystem system({tolerance, 40});
  system.set_pattern(chains.matrix.pattern());
  for (int i = 0; i < 10; ++i) EXPECT_LT(error_of(system, chains), 1e-13);
  EXPECT_EQ(system.work().factorisations, 1);
  EXPECT_EQ(system.work().dense_factorisations, 1);
  EXPECT_EQ(system.work().solves, 20);
  EXPECT_EQ(system.work().gmres_iterations, 0);
}

TEST(LinearSystem, OnlyWhatHasChangedIsSolvedWithAnOldFactorOrFactoredWhenSmall) {
  Chains chains({3, long_chain, 3, long_chain});
  LinearSystem system({tolerance, 40});
  system.set_pattern(chains.matrix.pattern());
  error_of(system, chains);
  chains.add_springs(0, 0.05);
  chains.add_springs(1, 0.05);
  EXPECT_LT(error_of(system, chains), tolerance);
  EXPECT_EQ(system.work().factorisations, 2) << "an old factor serves";
  EXPECT_EQ(system.work().dense_factorisations, 3);
  EXPECT_GT(system.work().gmres_iterations, 0);
}

TEST(LinearSystem, FactorIsRenewedWhenItIsOutdatedOrTakesTooManyIterations) {
  Chains chains({long_chain});
  LinearSystem system({tolerance, 40});
  system.set_pattern(chains.matrix.pattern());
  error_of(system, chains);
  chains.matrix.add(7, 7, 5 * Mat3::Identity());
  system.outdate();
  EXPECT_LT(error_of(system, chains), 1e-13);
  EXPECT_EQ(system.work().factorisations, 2);
  system.outdate();
  EXPECT_LT(error_of(system, chains), 1e-13) << "the very matrix that was factored";
  EXPECT_EQ(system.work().factorisations, 2);

  for (int node = 0; node < long_chain; ++node)
    chains.matrix.add(node, node, (1 + node * node) * Vec3(1, 7, 30).asDiagonal().toDenseMatrix());
  error_of(system, chains);
  const long iterations = system.work().gmres_iterations;
  ASSERT_GT(iterations, 5);
  EXPECT_LT(error_of(system, chains), 1e-13);
  EXPECT_EQ(system.work().factorisations, 3);
  EXPECT_EQ(system.work().gmres_iterations, iterations);
}

TEST(LinearSystem, SolvesTheUnsymmetricPartInSmallAndLargeSystems) {
  Chains chains({3, long_chain, long_chain}, true);
  LinearSystem system({1e-9, 40});
  system.set_pattern(chains.matrix.pattern());
  const Mat3 dyad = 0.5 * Vec3(1, 2, 0) * Vec3(0, 1, 3).transpose();
  for (const std::size_t c : {0, 1}) {
    chains.unsymmetric.add(chains.chain(c)[0], chains.chain(c)[1], dyad);
    chains.unsymmetric.add(chains.chain(c)[1], chains.chain(c)[0], -0.3 * dyad);
    chains.unsymmetric.add(chains.chain(c)[2], chains.chain(c)[2], 2 * dyad);
  }
  EXPECT_LT(error_of(system, chains), 1e-9);
  EXPECT_GT(system.work().gmres_iterations, 1);
  EXPECT_LE(system.work().gmres_iterations, 4) << "of rank three";
  EXPECT_EQ(system.work().factorisations, 2);
  chains.unsymmetric.set_zero();
  const long iterations = system.work().gmres_iterations;
  EXPECT_LT(error_of(system, chains), 1e-13);
  EXPECT_EQ(system.work().gmres_iterations, iterations);
}

TEST(LinearSystem, CountsSolvesThatUseAllIterations) {
  for (const int limit : {40, 1}) {
    Chains chains({long_chain}, true);
    LinearSystem system({tolerance, limit});
    system.set_pattern(chains.matrix.pattern());
    const Mat3 dyad = 0.5 * Vec3(1, 2, 0) * Vec3(0, 1, 3).transpose();
    chains.unsymmetric.add(chains.chain(0)[0], chains.chain(0)[1], dyad);
    chains.unsymmetric.add(chains.chain(0)[1], chains.chain(0)[0], -0.3 * dyad);
    error_of(system, chains);
    EXPECT_EQ(system.work().gmres_limits, limit == 1 ? 1 : 0);
  }
}

TEST(LinearSystem, LeavesAloneSystemsWithANegligibleRightHandSide) {
  Chains chains({3, long_chain, 3, long_chain});
  LinearSystem system({tolerance, 40});
  system.set_pattern(chains.matrix.pattern());
  Eigen::VectorXd b = Eigen::VectorXd::Zero(3 * chains.total_nodes()), x;
  b[3 * chains.chain(1)[4]] = 1;
  b[3 * chains.chain(2)[1]] = 1e-9;
  b[3 * chains.chain(3)[1]] = 1e-9;
  const double negligible[] = {0, 0, 2e-9, 2e-9}, less[] = {0, 0, 1e-10, 2e-9};
  system.solve(chains.matrix, chains.unsymmetric, b, negligible, x);
  EXPECT_EQ(system.work().solves, 1);
  EXPECT_GT(x.norm(), 0);
  EXPECT_LE((chains.times(x) - b).norm(), 4e-9);
  for (const std::size_t c : {0, 2, 3})
    for (const int node : chains.chain(c)) EXPECT_EQ(x.segment<3>(3 * node).norm(), 0);
  system.solve(chains.matrix, chains.unsymmetric, b, less, x);
  EXPECT_EQ(system.work().solves, 3) << "one more is not negligible";
}

TEST(LinearSystem, NewCouplingElsewhereKeepsAnalysisAndFactor) {
  Chains chains({long_chain, long_chain, long_chain, 3});
  LinearSystem system({tolerance, 40});
  system.set_pattern(chains.matrix.pattern());
  error_of(system, chains);
  ASSERT_EQ(system.work().factorisations, 3);
  chains.refresh_pattern({{chains.chain(0)[5], chains.chain(1)[2]}});
  for (const std::size_t c : {0, 1, 2, 3}) chains.add_springs(c, 1);
  chains.matrix.add(chains.chain(0)[5], chains.chain(1)[2], 0.1 * Mat3::Ones());
  system.set_pattern(chains.matrix.pattern());
  EXPECT_EQ(system.work().systems, 3);
  EXPECT_EQ(system.work().largest_system, 2 * long_chain);
  EXPECT_LT(error_of(system, chains), 1e-13);
  EXPECT_EQ(system.work().factorisations, 4) << "of the two that are joined now";
  EXPECT_EQ(system.work().dense_factorisations, 1);
}

/// The pattern joins them, no spring does.
Chains chains_that_might_couple(const std::vector<int>& lengths) {
  Chains chains(lengths, true);
  chains.refresh_pattern({{chains.chain(0)[2], chains.chain(1)[3]}, {chains.chain(1)[1], chains.chain(2)[6]}});
  for (const std::size_t c : {0, 1, 2}) chains.add_springs(c, 1);
  return chains;
}

TEST(LinearSystem, SolvesPartsThatOnlyMightCoupleOneByOne) {
  Chains chains = chains_that_might_couple({5, 200, 7});  // nearly all of the pairs are in one
  LinearSystem system({tolerance, 40});
  system.set_pattern(chains.matrix.pattern());
  EXPECT_EQ(system.work().systems, 1);
  EXPECT_LT(error_of(system, chains), 1e-13);
  EXPECT_EQ(system.work().dense_factorisations, 2);
  EXPECT_EQ(system.work().factorisations, 1) << "of all, for the large part";
  const Mat3 unsymmetric = (Mat3() << 0, 0.2, 0, 0.1, 0, 0, 0.3, 0, 0).finished();
  for (const std::size_t c : {0, 1}) chains.unsymmetric.add(chains.chain(c)[1], chains.chain(c)[0], unsymmetric);
  EXPECT_LT(error_of(system, chains), tolerance);
  chains.matrix.add(chains.chain(0)[2], chains.chain(1)[3], 0.1 * Mat3::Ones());  // now they do touch
  EXPECT_LT(error_of(system, chains), tolerance);
  EXPECT_EQ(system.work().dense_factorisations, 3) << "two, none where the matrix is as it was, one";
}

TEST(LinearSystem, LeavesAloneSmallPartsWithANegligibleRightHandSide) {
  Chains chains = chains_that_might_couple({5, 70, 7});
  LinearSystem system({tolerance, 40});
  system.set_pattern(chains.matrix.pattern());
  Eigen::VectorXd b = Eigen::VectorXd::Zero(3 * chains.total_nodes()), x;
  b[3 * chains.chain(0)[1]] = 1;
  b[3 * chains.chain(2)[1]] = 1e-9;
  const double negligible[] = {4e-9};
  system.solve(chains.matrix, chains.unsymmetric, b, negligible, x);
  EXPECT_EQ(system.work().dense_factorisations, 1);
  EXPECT_EQ(system.work().factorisations, 0) << "nothing pushes on the large part";
  EXPECT_LE((chains.times(x) - b).norm(), 4e-9);
}

TEST(LinearSystem, FactorsASparsePartOfAllNodesAlone) {
  Chains chains({70});
  Couplings possible;
  for (int k = 0; k + 3 < 70; ++k) possible.emplace_back(chains.chain(0)[k + 3], chains.chain(0)[k]);
  chains.refresh_pattern(possible);
  chains.add_springs(0, 1);
  LinearSystem system({tolerance, 40});
  system.set_pattern(chains.matrix.pattern());
  for (int i = 1; i <= 3; ++i) {
    EXPECT_LT(error_of(system, chains), 1e-13);
    EXPECT_EQ(system.work().factorisations, i);
    chains.add_springs(0, 0.05);
  }
  EXPECT_EQ(system.work().gmres_iterations, 0);
}

TEST(LinearSystem, FactorsLargePartsThatOnlyMightCoupleOneByOne) {
  Chains chains = chains_that_might_couple({70, 75, 80});
  LinearSystem system({tolerance, 40});
  system.set_pattern(chains.matrix.pattern());
  EXPECT_EQ(system.work().systems, 1);
  EXPECT_LT(error_of(system, chains), 1e-13);
  EXPECT_EQ(system.work().factorisations, 3);
  EXPECT_EQ(system.work().dense_factorisations, 0);
  EXPECT_EQ(system.work().gmres_iterations, 0);
  const Mat3 unsymmetric = (Mat3() << 0, 0.2, 0, 0.1, 0, 0, 0.3, 0, 0).finished();
  for (const std::size_t c : {0, 1, 2}) chains.add_springs(c, 10);
  for (const std::size_t c : {0, 2}) chains.unsymmetric.add(chains.chain(c)[1], chains.chain(c)[0], unsymmetric);
  EXPECT_LT(error_of(system, chains), tolerance);
  EXPECT_EQ(system.work().factorisations, 6);
  EXPECT_GT(system.work().gmres_iterations, 1);
}

void expect_not_positive_definite_at(int node, const Chains& chains) {
  LinearSystem system({tolerance, 40});
  system.set_pattern(chains.matrix.pattern());
  Eigen::VectorXd x;
  try {
    system.solve(chains.matrix, chains.unsymmetric, chains.wanted(), {}, x);
    FAIL() << "it was solved";
  } catch (const NotPositiveDefinite& error) {
    EXPECT_EQ(error.node, node);
    EXPECT_THAT(error.what(), HasSubstr("node " + std::to_string(node)));
  }
}

TEST(LinearSystem, SaysAtWhichNodeOfALargePartAMatrixIsNotPositiveDefinite) {
  Chains chains = chains_that_might_couple({70, 75, 80});
  const int bad = chains.chain(1)[40];
  chains.matrix.add(bad, bad, -100 * Mat3::Identity());
  expect_not_positive_definite_at(bad, chains);
}

TEST(LinearSystem, SaysAtWhichNodeAMatrixIsNotPositiveDefinite) {
  for (const int length : {3, long_chain}) {
    Chains chains({2, length});
    const int bad = chains.chain(1)[2];
    chains.matrix.add(bad, bad, -100 * Mat3::Identity());
    expect_not_positive_definite_at(bad, chains);
  }
}

}  // namespace
}  // namespace talus
