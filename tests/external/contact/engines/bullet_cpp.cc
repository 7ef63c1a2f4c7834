// Impacts in Bullet's rigid bodies, with hinges as constraints (btSequentialImpulseConstraintSolver).
//
//   bullet_cpp STIFFNESS DAMPING TIME_STEP SPEED SCENE NUMBERS.. GAP..
//   SCENE and NUMBERS:
//     ball MASS RADIUS
//     pendulum MASS CENTRE OFFSET INERTIA_ABOUT_CENTRE LEVER RADIUS
//     two_bodies, of the pendulum the same, SHARE MASS RADIUS (the pendulum's part of SPEED; of a free ball below it)
//     linkage BODIES HINGES RADIUS X Y, of each body MASS INERTIA X Y VX VY RATE (the second is struck), of each hinge BODY BODY X Y (-1:
//       the ground)
//   For each GAP (m, at the start) a line: speed of rebound over SPEED, deepest penetration.
#include <algorithm>
#include <btBulletDynamicsCommon.h>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

enum { STRUCK = 1 };
// Steps that are waited for the end of an impact.
const int LONGEST = 200000;

int main(int count, char **words) {
  if (count < 7) return 2;
  double s[4];
  for (int i = 0; i < 4; i++) s[i] = std::atof(words[i + 1]);
  const auto [stiffness, damping, h, v] = s;
  const std::string scene = words[5];
  std::vector<double> given;
  for (int i = 6; i < count; i++) given.push_back(std::atof(words[i]));
  const double *n = given.data();
  const bool linkage = scene == "linkage";
  const int bodies_of = linkage ? (int)n[0] : 0, hinges_of = linkage ? (int)n[1] : 0;
  const std::size_t numbers = scene == "ball" ? 2 : scene == "pendulum" ? 6 : scene == "two_bodies" ? 9 : 5 + 7 * bodies_of + 4 * hinges_of;
  for (std::size_t at = numbers; at < given.size(); at++) {
    const double gap = given[at];
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase pairs;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world(&dispatcher, &pairs, &solver, &configuration);
    world.setGravity(btVector3(0, 0, 0));
    world.getSolverInfo().m_linearSlop = 0.0;

    std::vector<std::unique_ptr<btRigidBody>> bodies;
    std::vector<std::unique_ptr<btTypedConstraint>> hinges;
    btCompoundShape nothing;
    auto body = [&](double mass, double inertia, btVector3 centre, btCollisionShape *shape) {
      auto made = std::make_unique<btRigidBody>(mass, nullptr, shape, btVector3(inertia, inertia, inertia));
      made->setWorldTransform(btTransform(btQuaternion::getIdentity(), centre));
      made->setInterpolationWorldTransform(made->getWorldTransform());
      made->setActivationState(DISABLE_DEACTIVATION);
      made->setContactStiffnessAndDamping(stiffness, damping);
      made->setRestitution(0.0);
      made->setFriction(0.0);
      made->setDamping(0.0, 0.0);
      world.addRigidBody(made.get());
      bodies.push_back(std::move(made));
      return bodies.back().get();
    };
    auto hinge = [&](btRigidBody *a, btRigidBody *b, btVector3 place, btVector3 axis) {
      auto from = [&](btRigidBody *of) { return place - of->getWorldTransform().getOrigin(); };
      auto made = b ? std::make_unique<btHingeConstraint>(*a, *b, from(a), from(b), axis, axis)
                    : std::make_unique<btHingeConstraint>(*a, from(a), axis);
      world.addConstraint(made.get(), true);
      hinges.push_back(std::move(made));
    };

    const bool two = scene == "two_bodies", turns = two || scene == "pendulum";
    const double radius = linkage ? n[2] : turns ? n[5] : n[1];
    const btVector3 normal = linkage ? btVector3(0, 1, 0) : btVector3(0, 0, 1);
    const double contact = linkage ? n[4] : 0.0;
    btStaticPlaneShape plane(normal, contact - radius - gap);
    if (!two) body(0, 0, btVector3(0, 0, 0), &plane);
    btSphereShape sphere(radius);
    btCompoundShape shape;
    btRigidBody *struck, *other = nullptr;
    btSphereShape ball(two ? n[8] : 1);
    btVector3 point(0, 0, 0);
    if (scene == "ball") {
      shape.addChildShape(btTransform::getIdentity(), &sphere);
      struck = body(n[0], 0.4 * n[0] * n[1] * n[1], point, &shape);
      struck->setLinearVelocity(btVector3(0, 0, -v));
    } else if (turns) {
      const double centre = n[1], offset = n[2], lever = n[4], turn = (two ? n[6] : 1) * v / lever;
      point = btVector3(lever - centre, 0, -offset);
      shape.addChildShape(btTransform(btQuaternion::getIdentity(), point), &sphere);
      struck = body(n[0], n[3], btVector3(centre, 0, offset), &shape);
      hinge(struck, nullptr, btVector3(0, 0, 0), btVector3(0, 1, 0));
      struck->setLinearVelocity(btVector3(turn * offset, 0, -turn * centre));
      struck->setAngularVelocity(btVector3(0, turn, 0));
      if (two) {
        other = body(n[7], 0.4 * n[7] * n[8] * n[8], btVector3(lever, 0, -radius - gap - n[8]), &ball);
        other->setLinearVelocity(btVector3(0, 0, (1 - n[6]) * v));
      }
    } else {
      const double *b = n + 5, *j = b + 7 * bodies_of;
      point = btVector3(n[3], n[4], 0) - btVector3(b[7 * STRUCK + 2], b[7 * STRUCK + 3], 0);
      shape.addChildShape(btTransform(btQuaternion::getIdentity(), point), &sphere);
      std::vector<btRigidBody *> made(bodies_of);
      for (int i = 0; i < bodies_of; i++, b += 7) {
        made[i] = body(b[0], b[1], btVector3(b[2], b[3], 0), i == STRUCK ? &shape : &nothing);
        made[i]->setLinearVelocity(btVector3(b[4], b[5], 0));
        made[i]->setAngularVelocity(btVector3(0, 0, b[6]));
      }
      for (int i = 0; i < hinges_of; i++, j += 4)
        hinge(made[(int)j[0]], j[1] < 0 ? nullptr : made[(int)j[1]], btVector3(j[2], j[3], 0), btVector3(0, 0, 1));
      struck = made[STRUCK];
    }

    double depth = 0, rate = 0;
    bool touched = false, back = false;
    for (int i = 0; i < LONGEST && !back; i++) {
      world.stepSimulation(h, 0);
      const btTransform &pose = struck->getWorldTransform();
      double height = pose(point).dot(normal) - contact + gap;
      rate = struck->getVelocityInLocalPoint(pose.getBasis() * point).dot(normal);
      if (other) {
        height = pose(point).z() - other->getWorldTransform().getOrigin().z() - radius - n[8];
        rate -= other->getLinearVelocity().z();
      }
      depth = std::max(depth, -height);
      touched |= height < 0;
      back = touched && height > 0 && rate > 0;
    }
    std::printf("%.17g %.17g\n", back ? rate / v : NAN, depth);
    for (auto &each : hinges) world.removeConstraint(each.get());
    for (auto &each : bodies) world.removeRigidBody(each.get());
  }
}
