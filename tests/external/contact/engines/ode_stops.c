/* Joints that run into their stops in Open Dynamics Engine: bodies and joints in the x-y plane.

   ode_stops SOLVER ITERATIONS STOP_ERP STOP_CFM BOUNCE TIME_STEP SPEED BODIES JOINTS LIMITED END BODY.. JOINT.. GAP..
   SOLVER: step, or quick with ITERATIONS iterations. LIMITED: number of the joint; END: 1 its upper stop, -1 its
   lower stop.
   BODY: MASS INERTIA X Y VX VY RATE, the velocities at SPEED. JOINT: SLIDES BODY BODY X Y (-1: the ground), a hinge
   along z at X Y, or a slider along X Y; positive motion is that of the first body relative to the second.
   Output: a line per GAP (rad or m, at the start) with return speed over SPEED, deepest penetration. */
#include <ode/ode.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FIRST = 12, OF_BODY = 7, OF_JOINT = 5, MOST = 16 };

static dReal position(dJointID joint, int slides) {
  return slides ? dJointGetSliderPosition(joint) : dJointGetHingeAngle(joint);
}

static dReal rate(dJointID joint, int slides) {
  return slides ? dJointGetSliderPositionRate(joint) : dJointGetHingeAngleRate(joint);
}

static void set(dJointID joint, int slides, int name, double value) {
  slides ? dJointSetSliderParam(joint, name, value) : dJointSetHingeParam(joint, name, value);
}

int main(int count, char **words) {
  if (count <= FIRST) return 2;
  int quick = !strcmp(words[1], "quick"), bodies = atoi(words[8]), joints = atoi(words[9]), limited = atoi(words[10]);
  double erp = atof(words[3]), cfm = atof(words[4]), bounce = atof(words[5]), h = atof(words[6]), v = atof(words[7]);
  double end = atof(words[11]);
  int first = FIRST + OF_BODY * bodies + OF_JOINT * joints;
  if (bodies > MOST || joints > MOST || limited >= joints || count < first) return 2;
  dInitODE();
  for (int at = first; at < count; at++) {
    double gap = atof(words[at]), depth = 0;
    dWorldID world = dWorldCreate();
    if (quick) dWorldSetQuickStepNumIterations(world, atoi(words[2]));
    dBodyID made[MOST];
    char **word = words + FIRST;
    for (int i = 0; i < bodies; i++, word += OF_BODY) {
      double n[OF_BODY];
      for (int j = 0; j < OF_BODY; j++) n[j] = atof(word[j]);
      dMass m;
      dMassSetParameters(&m, n[0], 0, 0, 0, n[1], n[1], n[1], 0, 0, 0);
      made[i] = dBodyCreate(world);
      dBodySetMass(made[i], &m);
      dBodySetPosition(made[i], n[2], n[3], 0);
      dBodySetLinearVel(made[i], n[4], n[5], 0);
      dBodySetAngularVel(made[i], 0, 0, n[6]);
    }
    dJointID joint = 0;
    int slides = 0;
    for (int i = 0; i < joints; i++, word += OF_JOINT) {
      int sliding = atoi(word[0]), a = atoi(word[1]), b = atoi(word[2]);
      double x = atof(word[3]), y = atof(word[4]);
      dJointID next = sliding ? dJointCreateSlider(world, 0) : dJointCreateHinge(world, 0);
      dJointAttach(next, made[a], b < 0 ? 0 : made[b]);
      if (sliding) {
        dJointSetSliderAxis(next, x, y, 0);
      } else {
        dJointSetHingeAnchor(next, x, y, 0);
        dJointSetHingeAxis(next, 0, 0, 1);
      }
      if (i == limited) joint = next, slides = sliding;
    }
    /* The present position is 0. */
    set(joint, slides, end > 0 ? dParamHiStop : dParamLoStop, end * gap);
    set(joint, slides, dParamStopERP, erp);
    set(joint, slides, dParamStopCFM, cfm);
    set(joint, slides, dParamBounce, bounce);
    double speed = 0;
    int touched = 0;
    for (long i = 0; i < 3000000; i++) {
      double past = end * position(joint, slides) - gap;
      quick ? dWorldQuickStep(world, h) : dWorldStep(world, h);
      speed = -end * rate(joint, slides);
      if (past > depth) depth = past;
      if (touched && past < 0 && speed > 0) break;
      touched |= past > 0;
    }
    printf("%.17g %.17g\n", speed / v, depth);
    dWorldDestroy(world);
  }
  dCloseODE();
  return 0;
}
