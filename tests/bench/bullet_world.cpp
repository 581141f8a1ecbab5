#include "bench/bullet_world.hpp"

#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <set>
#include <vector>

#include "base/units.hpp"

namespace talus {
namespace {

btVector3 of(const Vec3& v) {
  return btVector3(static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z()));
}

/// m: Bullet's own 0.04 would hold blocks of a metre apart by a twentieth.
constexpr btScalar hull_margin = btScalar(1e-3);

}  // namespace

struct BulletWorld::Parts {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
  std::vector<std::unique_ptr<btConvexHullShape>> shapes;
  std::vector<std::unique_ptr<btMotionState>> states;
  std::vector<std::unique_ptr<btRigidBody>> bodies;

  void add(const Block& block, double density, double friction, bool sleeps) {
    std::set<int> corners;
    for (const SurfaceTriangle& triangle : block.surface) corners.insert(triangle.nodes.begin(), triangle.nodes.end());
    Vec3 centre = Vec3::Zero();
    for (const int corner : corners) centre += block.mesh.nodes[static_cast<std::size_t>(corner)];
    centre /= static_cast<double>(corners.size());
    auto& shape = *shapes.emplace_back(std::make_unique<btConvexHullShape>());
    for (const int corner : corners)
      shape.addPoint(of(block.mesh.nodes[static_cast<std::size_t>(corner)] - centre), false);
    shape.recalcLocalAabb();
    shape.setMargin(hull_margin);
    const auto mass = static_cast<btScalar>(block.body == BodyKind::fixed ? 0 : density * block.volume);
    btVector3 inertia(0, 0, 0);
    if (mass > 0) shape.calculateLocalInertia(mass, inertia);
    btTransform place = btTransform::getIdentity();
    place.setOrigin(of(centre));
    auto& state = *states.emplace_back(std::make_unique<btDefaultMotionState>(place));
    auto& body = *bodies.emplace_back(
        std::make_unique<btRigidBody>(btRigidBody::btRigidBodyConstructionInfo(mass, &state, &shape, inertia)));
    body.setFriction(static_cast<btScalar>(std::sqrt(friction)));  // of two bodies the product counts
    body.setRestitution(0);
    if (!sleeps) body.setActivationState(DISABLE_DEACTIVATION);
    world.addRigidBody(&body);
  }

  ~Parts() {
    for (const auto& body : bodies) world.removeRigidBody(body.get());
  }
};

BulletWorld::BulletWorld(const Project& project, const BlockSystem& system, bool sleeps)
    : parts_(std::make_unique<Parts>()) {
  parts_->world.setGravity(of(project.gravity));
  const double friction = std::tan(radians(project.joints.front().friction_angle));
  for (const Block& block : system.blocks)
    parts_->add(block, project.materials[static_cast<std::size_t>(block.material)].density, friction, sleeps);
}

BulletWorld::~BulletWorld() = default;

void BulletWorld::step(double length) { parts_->world.stepSimulation(static_cast<btScalar>(length), 0); }

}  // namespace talus
