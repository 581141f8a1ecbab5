// Every effect's gradient and Hessian against finite differences of its energy and gradient.
#include <gmock/gmock.h>

#include "effects/body_force.hpp"
#include "effects/displacement_constraint.hpp"
#include "effects/elasticity.hpp"
#include "effects/inertia.hpp"
#include "effects/initial_stress.hpp"
#include "effects/normal_contact.hpp"
#include "effects/point_load.hpp"
#include "effects/shear_contact.hpp"
#include "support/finite_differences.hpp"
#include "support/small_scenes.hpp"

namespace talus {
namespace {

class Derivatives : public testing::Test {
 protected:
  Derivatives() : set_(project(), system()), d_(set_.unknowns()) {
    for (int i = 0; i < d_.size(); ++i) d_[i] = 1e-3 * std::sin(7.0 * i + 1);  // no symmetry, reproducible
    for (std::size_t i = 0; i < set_.nodes.velocity.size(); ++i)
      set_.nodes.velocity[i] = Vec3(0.1 * double(i), 0.2, -0.3);
    for (std::size_t e = 0; e < set_.stress.size(); ++e) set_.stress[e] << 1e5, -2e5, 3e5, 4e4, 5e4 * double(e), -6e4;
  }
  static Project project() {
    Project project;
    project.materials = {{"rock", 2600, 5e9, 0.24}};
    return project;
  }
  static BlockSystem system() {
    BlockSystem system;
    system.blocks = {test::box_block("lower", Vec3(0, 0, 0), Vec3(2, 1.5, 1)),
                     test::box_block("upper", Vec3(0.2, 0.1, 1), Vec3(1.2, 1.3, 2.1))};
    return system;
  }
  /// A point of the upper block's bottom against one of the lower block's top.
  ContactSet contact(double gap) const {
    ContactSet contacts;
    ContactPoint point{};
    point.normal = Vec3(0.1, -0.2, 1).normalized();
    point.gap = gap;
    point.normal_stiffness = 3e9;
    point.shear_stiffness = 1.2e9;
    point.friction = 0.5;
    point.stencil_end = 4;
    contacts.points = {point};
    contacts.nodes = {8, 4, 5, 6};
    contacts.weights = {1, -0.5, -0.2, -0.3};
    return contacts;
  }
  MaterialPoint inside() const { return material_point(system(), "upper", Vec3(0.6, 0.5, 1.4), 0, "/loads/0"); }

  BodySet set_;
  Increment d_;
};

TEST_F(Derivatives, elasticity) { test::expect_derivatives(Elasticity(set_), d_, 1e-4, 1e-8); }

TEST_F(Derivatives, initial_stress) { test::expect_derivatives(InitialStress(set_), d_, 1e-4, 1e-8); }

TEST_F(Derivatives, inertia) {
  Inertia inertia(set_);
  inertia.begin_step({0, 0.01, 1});
  test::expect_derivatives(inertia, d_, 1e-4, 1e-8);
}

TEST_F(Derivatives, body_force) { test::expect_derivatives(BodyForce(set_, Vec3(1, -2, -9.81)), d_, 1e-4, 1e-8); }

TEST_F(Derivatives, point_load) {
  test::expect_derivatives(PointLoads(set_, {{inside(), Vec3(1e4, 2e4, -3e4)}}), d_, 1e-4, 1e-8);
}

TEST_F(Derivatives, displacement_constraint_with_a_free_component) {
  test::expect_derivatives(DisplacementConstraints(set_, {{inside(), {{0.01, std::nullopt, -0.02}}, 1e9}}), d_, 1e-4,
                           1e-8);
}

TEST_F(Derivatives, normal_contact_in_penetration) {
  const ContactSet contacts = contact(-0.01);
  test::expect_derivatives(NormalContact(set_, contacts), d_, 1e-4, 1e-8);
}

TEST_F(Derivatives, normal_contact_of_a_bond_in_tension_and_at_its_strength) {
  ContactSet contacts = contact(0.01);
  contacts.points[0].bonded = true;
  contacts.points[0].tension = 1e9;
  test::expect_derivatives(NormalContact(set_, contacts), d_, 1e-4, 1e-8);
  contacts.points[0].tension = 1e6;
  test::expect_derivatives(NormalContact(set_, contacts), d_, 1e-4, 1e-8);
}

TEST_F(Derivatives, open_contact_exerts_nothing) {
  const ContactSet contacts = contact(0.02);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(d_.size());
  NormalContact(set_, contacts).add_gradient(d_, gradient);
  EXPECT_EQ(gradient.norm(), 0);
}

TEST_F(Derivatives, shear_contact_sticking) {
  ContactSet contacts = contact(-0.05);
  contacts.points[0].shear_start = Vec3(1e5, 0, 0) - contacts.points[0].normal * 1e5 * contacts.points[0].normal.x();
  ShearContact shear(set_, contacts);
  shear.update_strength(d_);
  ASSERT_LT(shear.force(0, d_).norm(), shear.strength(0));
  test::expect_derivatives(shear, d_, 1e-5, 1e-7);
}

TEST_F(Derivatives, shear_contact_sliding) {
  const ContactSet contacts = contact(-0.001);
  ShearContact shear(set_, contacts);
  shear.update_strength(d_);
  ASSERT_GT(shear.strength(0), 0);
  ASSERT_NEAR(shear.force(0, d_).norm(), shear.strength(0), 1e-9 * shear.strength(0));
  test::expect_derivatives(shear, d_, 1e-6, 1e-6);
}

}  // namespace
}  // namespace talus
