// Impacts in Bullet's rigid bodies, with hinges as constraints (btSequentialImpulseConstraintSolver).
//
//   bullet_cpp STIFFNESS DAMPING TIME_STEP SPEED MASS INERTIA RADIUS CENTRE LEVER GAP..
//   INERTIA about the centre of mass; LEVER 0: a ball that nothing holds. For each GAP: rebound over SPEED, penetration.
#include <algorithm>
#include <btBulletDynamicsCommon.h>
#include <cstdio>
#include <cstdlib>

int main(int count, char **words) {
  if (count < 11) return 2;
  double n[9];
  for (int i = 0; i < 9; i++) n[i] = std::atof(words[i + 1]);
  const auto [stiffness, damping, h, v, mass, inertia, radius, centre, lever] = n;
  const bool held = lever > 0;
  for (int at = 10; at < count; at++) {
    const double gap = std::atof(words[at]);
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase pairs;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world(&dispatcher, &pairs, &solver, &configuration);
    world.setGravity(btVector3(0, 0, 0));
    world.getSolverInfo().m_linearSlop = 0.0;

    btStaticPlaneShape plane(btVector3(0, 0, 1), -radius - gap);
    btRigidBody floor(0, nullptr, &plane, btVector3(0, 0, 0));
    btSphereShape sphere(radius);
    btCompoundShape shape;
    const btVector3 point(lever - centre, 0, 0);
    shape.addChildShape(btTransform(btQuaternion::getIdentity(), point), &sphere);
    btRigidBody struck(mass, nullptr, &shape, btVector3(inertia, inertia, inertia));
    struck.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(centre, 0, 0)));
    struck.setInterpolationWorldTransform(struck.getWorldTransform());
    struck.setActivationState(DISABLE_DEACTIVATION);
    for (btRigidBody *body : {&floor, &struck}) {
      body->setContactStiffnessAndDamping(stiffness, damping);
      body->setRestitution(0.0);
      body->setFriction(0.0);
      body->setDamping(0.0, 0.0);
      world.addRigidBody(body);
    }
    btHingeConstraint hinge(struck, btVector3(-centre, 0, 0), btVector3(0, 1, 0));
    if (held) world.addConstraint(&hinge);
    struck.setLinearVelocity(btVector3(0, 0, held ? -v / lever * centre : -v));
    if (held) struck.setAngularVelocity(btVector3(0, v / lever, 0));

    double depth = 0, rate = 0;
    bool touched = false, back = false;
    for (int i = 0; i < 200000 && !back; i++) {
      world.stepSimulation(h, 0);
      const double height = struck.getWorldTransform()(point).z() + gap;
      rate = held ? -struck.getAngularVelocity().y() * lever : struck.getLinearVelocity().z();
      depth = std::max(depth, -height);
      touched |= height < 0;
      back = touched && height > 0 && rate > 0;
    }
    std::printf("%.17g %.17g\n", rate / v, depth);
    if (held) world.removeConstraint(&hinge);
    world.removeRigidBody(&struck);
    world.removeRigidBody(&floor);
  }
}
