/* Impacts in Open Dynamics Engine, shapes and collisions by ODE too.

   ode SOLVER ITERATIONS SOFT_ERP SOFT_CFM TIME_STEP SPEED SCENE NUMBERS.. GAP..
   SOLVER step, or quick with that many iterations. SCENE and NUMBERS:
     ball MASS RADIUS
     pendulum MASS CENTRE OFFSET INERTIA_ABOUT_CENTRE LEVER RADIUS
     two_bodies, of the pendulum the same, SHARE MASS RADIUS (the pendulum's part of SPEED; of a free ball below it)
     linkage BODIES HINGES RADIUS X Y, of each body MASS INERTIA X Y VX VY RATE (the second is struck), of each hinge BODY BODY X Y (-1: the
       ground)
   For each GAP (m, at the start) a line: speed of rebound over SPEED, deepest penetration. */
#include <math.h>
#include <ode/ode.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { STRUCK = 1, BODIES = 8, MOST = 128 };

static dWorldID world;
static dSpaceID space;
static dJointGroupID contacts;
static double erp, cfm, depth;

static void near_callback(void *data, dGeomID a, dGeomID b) {
  dContact contact[4];
  int n = dCollide(a, b, 4, &contact[0].geom, sizeof(dContact));
  for (int i = 0; i < n; i++) {
    memset(&contact[i].surface, 0, sizeof contact[i].surface);
    contact[i].surface.mode = dContactSoftERP | dContactSoftCFM;
    contact[i].surface.soft_erp = erp;
    contact[i].surface.soft_cfm = cfm;
    contact[i].surface.mu = 0.0;
    if (contact[i].geom.depth > depth) depth = contact[i].geom.depth;
    dJointAttach(dJointCreateContact(world, contacts, &contact[i]), dGeomGetBody(a), dGeomGetBody(b));
  }
}

/* A body with its centre of mass at (x, y, z), inertia about it the same for all axes. */
static dBodyID body(double mass, double inertia, double x, double y, double z) {
  dBodyID made = dBodyCreate(world);
  dMass m;
  dMassSetParameters(&m, mass, 0, 0, 0, inertia, inertia, inertia, 0, 0, 0);
  dBodySetMass(made, &m);
  dBodySetPosition(made, x, y, z);
  return made;
}

static void sphere(dBodyID of, double radius, double x, double y, double z) {
  dGeomID geom = dCreateSphere(space, radius);
  dGeomSetBody(geom, of);
  dGeomSetOffsetWorldPosition(geom, x, y, z);
}

static void hinge(dBodyID a, dBodyID b, double x, double y, double z, double ax, double ay, double az) {
  dJointID joint = dJointCreateHinge(world, 0);
  dJointAttach(joint, a, b);
  dJointSetHingeAnchor(joint, x, y, z);
  dJointSetHingeAxis(joint, ax, ay, az);
}

int main(int count, char **words) {
  if (count < 9) return 2;
  int quick = !strcmp(words[1], "quick");
  erp = atof(words[3]), cfm = atof(words[4]);
  double h = atof(words[5]), v = atof(words[6]);
  const char *scene = words[7];
  int two = !strcmp(scene, "two_bodies"), turns = two || !strcmp(scene, "pendulum");
  int linkage = !strcmp(scene, "linkage"), bodies = linkage ? atoi(words[8]) : 0, hinges = linkage ? atoi(words[9]) : 0;
  int first = 8 + (!strcmp(scene, "ball") ? 2 : two ? 9 : turns ? 6 : 5 + 7 * bodies + 4 * hinges);
  if (bodies > BODIES || first - 8 > MOST) return 2;
  dInitODE();
  for (int at = first; at < count; at++) {
    double gap = atof(words[at]), n[MOST] = {0};
    for (int i = 8; i < first; i++) n[i - 8] = atof(words[i]);
    world = dWorldCreate(), space = dSimpleSpaceCreate(0), contacts = dJointGroupCreate(0);
    if (quick) dWorldSetQuickStepNumIterations(world, atoi(words[2]));
    depth = 0;
    dBodyID struck, other = 0;
    int own_joints = 0;
    dVector3 point, up = {0, 0, 0};
    if (!strcmp(scene, "ball")) {
      struck = body(n[0], 0.4 * n[0] * n[1] * n[1], 0, 0, gap);
      sphere(struck, n[1], 0, 0, gap);
      dCreatePlane(space, 0, 0, 1, -n[1]);
      dBodySetLinearVel(struck, 0, 0, -v);
      point[0] = point[1] = point[2] = 0, up[2] = 1;
    } else if (turns) {
      double lever = n[4], radius = n[5], rate = (two ? n[6] : 1) * v / lever;
      struck = body(n[0], n[3], n[1], 0, n[2]);
      sphere(struck, radius, lever, 0, 0);
      hinge(struck, 0, 0, 0, 0, 0, -1, 0);
      if (two) {
        other = body(n[7], 0.4 * n[7] * n[8] * n[8], lever, 0, -radius - gap - n[8]);
        sphere(other, n[8], lever, 0, -radius - gap - n[8]);
        dBodySetLinearVel(other, 0, 0, (1 - n[6]) * v);
      } else {
        dCreatePlane(space, 0, 0, 1, -radius - gap);
      }
      dBodySetAngularVel(struck, 0, rate, 0);
      dBodySetLinearVel(struck, rate * n[2], 0, -rate * n[1]);
      point[0] = lever - n[1], point[1] = 0, point[2] = -n[2], up[2] = 1, own_joints = 1;
    } else {
      double *l = n + 2, *b = l + 3, *j = b + 7 * bodies;
      dBodyID made[BODIES];
      for (int i = 0; i < bodies; i++, b += 7) {
        made[i] = body(b[0], b[1], b[2], b[3], 0);
        dBodySetLinearVel(made[i], b[4], b[5], 0), dBodySetAngularVel(made[i], 0, 0, b[6]);
      }
      for (int i = 0; i < hinges; i++, j += 4) hinge(made[(int)j[0]], j[1] < 0 ? 0 : made[(int)j[1]], j[2], j[3], 0, 0, 0, 1);
      struck = made[STRUCK];
      sphere(struck, l[0], l[1], l[2], 0);
      dCreatePlane(space, 0, 1, 0, l[2] - l[0] - gap);
      const dReal *centre = dBodyGetPosition(struck);
      point[0] = l[1] - centre[0], point[1] = l[2] - centre[1], point[2] = 0, up[1] = 1, own_joints = dBodyGetNumJoints(struck);
    }
    double speed = 0;
    int touched = 0;
    for (long i = 0; i < 3000000; i++) {
      dSpaceCollide(space, 0, near_callback);
      int touching = dBodyGetNumJoints(struck) > own_joints;
      quick ? dWorldQuickStep(world, h) : dWorldStep(world, h);
      dJointGroupEmpty(contacts);
      dVector3 at_point;
      dBodyGetRelPointVel(struck, point[0], point[1], point[2], at_point);
      speed = at_point[0] * up[0] + at_point[1] * up[1] + at_point[2] * up[2];
      if (other) speed -= dBodyGetLinearVel(other)[2];
      if (touched && !touching && speed > 0) break;
      touched |= touching;
    }
    printf("%.17g %.17g\n", speed / v, depth);
    dJointGroupDestroy(contacts), dSpaceDestroy(space), dWorldDestroy(world);
  }
  dCloseODE();
  return 0;
}
