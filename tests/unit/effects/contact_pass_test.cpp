// All laws of contact at once against each by itself, and on one and several cores.
#include "effects/contact_pass.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "base/parallel.hpp"
#include "effects/normal_contact.hpp"
#include "effects/shear_contact.hpp"
#include "support/solver_scenes.hpp"

namespace talus {
namespace {

constexpr int cubes = 40, points_of_a_pair = 24;

/// Cubes in a row, every fifth of tetrahedra, which touch their neighbours at many points, some of them open.
class RowOfCubes : public testing::Test {
 protected:
  RowOfCubes() {
    for (int body = 0; body + 1 < cubes; ++body)
      for (int i = 0; i < points_of_a_pair; ++i) touch(body, i);
    contacts_.sort_out();
    links_.connect(Arms::mean);
    shear_.clear_strength();
    pass_.set({&normal_, &shear_});
    bodies_.add_couplings(couplings_);
    pattern_ = BlockPattern(bodies_.nodes.movable, couplings_);
  }
  static BlockSystem row() {
    std::vector<Block> list;
    for (int i = 0; i < cubes; ++i)
      list.push_back(test::box_block("B" + std::to_string(i), Vec3(i, 0, 0), Vec3(i + 1, 1, 1),
                                     i % 5 == 4 ? BodyKind::tetrahedra : BodyKind::rigid));
    return test::block_system(list);
  }
  void touch(int body, int i) {
    ContactPoint point;
    point.key = contacts_.points.size();
    point.bodies[0] = body, point.bodies[1] = body + 1;
    point.normal = Vec3(-1, 0.1 * (i % 3), 0.05 * i).normalized();
    point.gap = i % 4 == 0 ? 1e-3 : -1e-5 * i;
    point.size = 1;
    point.normal_stiffness = 1e9, point.shear_stiffness = 4e8;
    point.friction = 0.5;
    point.stencil_begin = static_cast<int>(contacts_.nodes.size());
    std::vector<int> of_point, of_node;
    for (const auto& [of, weight] : {std::pair{body, 1.0}, std::pair{body + 1, -1.0}}) {
      contacts_.nodes.push_back(bodies_.bodies[of].first_node + i % 8);
      contacts_.weights.push_back(weight);
      bodies_.dof_blocks_of(contacts_.nodes.back(), of_node);
      of_point.insert(of_point.end(), of_node.begin(), of_node.end());
    }
    for (const int a : of_point)
      for (const int b : of_point) couplings_.emplace_back(a, b);
    point.stencil_end = static_cast<int>(contacts_.nodes.size());
    contacts_.points.push_back(point);
  }
  Increment increment() const {
    Increment d(bodies_.unknowns());
    for (Eigen::Index k = 0; k < d.size(); ++k) d[k] = 1e-4 * std::sin(3.0 * static_cast<double>(k));
    return d;
  }
  std::vector<Eigen::VectorXd> gradients() {
    std::vector<Eigen::VectorXd> sums(2, Eigen::VectorXd::Zero(d_.size()));
    pass_.add_gradients(d_, Arms::mean, true, sums);
    return sums;
  }
  struct Tangents {
    Eigen::VectorXd symmetric, unsymmetric;  // times a vector, N
  };
  Tangents times(const SymmetricBlocks& matrix, const UnsymmetricBlocks& beside) const {
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(d_.size(), -1, 2);
    Tangents product{{}, Eigen::VectorXd::Zero(d_.size())};
    matrix.multiply(x, product.symmetric);
    UnsymmetricBlocks::add_product(beside.pairs(), x, product.unsymmetric);
    return product;
  }
  Tangents tangents() {
    SymmetricBlocks matrix;
    UnsymmetricBlocks beside;
    matrix.set_pattern(pattern_);
    beside.set_pattern(pattern_);
    pass_.add_tangents(d_, Arms::mean, matrix, &beside);
    return times(matrix, beside);
  }
  const Project project_ = test::rock_project(30, {{"slide", StageKind::dynamic, 0.01, 20, {}}});
  const BlockSystem system_ = row();
  BodySet bodies_{project_, system_};
  ContactSet contacts_;
  ContactLinks links_{bodies_, contacts_};
  NormalContact normal_{links_, NormalContact::Points::loose};
  ShearContact shear_{links_};
  ContactPass pass_;
  std::vector<std::pair<int, int>> couplings_;
  BlockPattern pattern_;
  const Increment d_ = increment();
};

TEST_F(RowOfCubes, HasTheGradientOfEachLaw) {
  const std::vector<Eigen::VectorXd> sums = gradients();
  shear_.update_strength(d_);
  const ContactEffect* const laws[] = {&normal_, &shear_};
  for (int k = 0; k < 2; ++k) {
    Eigen::VectorXd alone = Eigen::VectorXd::Zero(d_.size());
    laws[k]->add_gradient(d_, Arms::mean, alone);
    EXPECT_GT(alone.norm(), 0);
    EXPECT_LT((sums[k] - alone).norm(), 1e-13 * alone.norm()) << k;
  }
}

TEST_F(RowOfCubes, HasTheTangentOfAllLaws) {
  for (ContactEffect* law : {static_cast<ContactEffect*>(&normal_), static_cast<ContactEffect*>(&shear_)})
    law->count_as_closed(0.01);
  gradients();  // takes strengths
  const Tangents together = tangents();
  SymmetricBlocks matrix;
  UnsymmetricBlocks beside;
  matrix.set_pattern(pattern_);
  beside.set_pattern(pattern_);
  for (const ContactEffect* law : {static_cast<ContactEffect*>(&normal_), static_cast<ContactEffect*>(&shear_)}) {
    law->add_hessian(d_, matrix);
    law->add_unsymmetric(d_, Arms::mean, beside);
  }
  const Tangents alone = times(matrix, beside);
  EXPECT_GT(alone.unsymmetric.norm(), 0);
  EXPECT_LT((together.symmetric - alone.symmetric).norm(), 1e-13 * alone.symmetric.norm());
  EXPECT_LT((together.unsymmetric - alone.unsymmetric).norm(), 1e-12 * alone.unsymmetric.norm());
}

TEST_F(RowOfCubes, HasTheSameBitsOnAnyNumberOfCores) {
  const std::vector<Eigen::VectorXd> on_one = gradients();
  const Tangents tangents_on_one = tangents();
  for (const int threads : {2, 3}) {
    const ThreadLimit limit(threads);
    const std::vector<Eigen::VectorXd> on_several = gradients();
    EXPECT_EQ(on_several, on_one) << threads;
    const Tangents tangents_on_several = tangents();
    EXPECT_EQ(tangents_on_several.symmetric, tangents_on_one.symmetric) << threads;
    EXPECT_EQ(tangents_on_several.unsymmetric, tangents_on_one.unsymmetric) << threads;
  }
}

TEST_F(RowOfCubes, LooksAtPickedBodiesAlone) {
  const std::vector<Eigen::VectorXd> all = gradients();
  PickedBodies picked;
  picked.has.assign(bodies_.bodies.size(), 0);
  picked.has[7] = 1;
  normal_.look_at(&picked);
  shear_.look_at(&picked);
  EXPECT_EQ(normal_.points().size(), 2u * points_of_a_pair);
  const std::vector<Eigen::VectorXd> alone = gradients();
  const int block = bodies_.nodes.dof_block[bodies_.rigid[bodies_.bodies[7].rigid].centre];
  EXPECT_EQ(alone[0].segment<3>(3 * block), all[0].segment<3>(3 * block));
  EXPECT_LT(alone[0].norm(), all[0].norm());
  normal_.look_at(nullptr);
  shear_.look_at(nullptr);
  EXPECT_EQ(gradients(), all);
}

}  // namespace
}  // namespace talus
