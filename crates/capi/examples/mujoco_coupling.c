/* Coupling to MuJoCo while it simulates: an arm of three hinges falls on a floor; at the touch percuss computes the effective mass
   from MuJoCo's positions, the damper of a wanted restitution follows from it, and its force enters each stage of MuJoCo's
   integrator. The measured rebound is compared with the wanted one, and with that of a damper for the mass of the tool alone.

     cc mujoco_coupling.c $(pkg-config --cflags --libs percuss) -I MUJOCO/include -L MUJOCO -lmujoco -lm

   tests/external/capi.sh runs it where MuJoCo is installed. */
#include <mujoco/mujoco.h>
#include <percuss.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* One text for both programs. Gravity is on; contacts of MuJoCo are off, since the floor is the callback below. */
static const char ARM[] =
    "<mujoco model=\"arm\"><option timestep=\"2e-6\" integrator=\"RK4\"><flag contact=\"disable\"/></option><worldbody>"
    "<body name=\"upper\" pos=\"0 0 1\"><inertial pos=\"0.25 0 0\" mass=\"3\" diaginertia=\"0.01 0.08 0.08\"/>"
    "<joint name=\"shoulder\" axis=\"0 1 0\"/>"
    "<body name=\"lower\" pos=\"0.5 0 0\"><inertial pos=\"0.2 0.01 0\" mass=\"2\" diaginertia=\"0.006 0.04 0.04\"/>"
    "<joint name=\"elbow\" axis=\"0 1 0\" armature=\"0.02\"/>"
    "<body name=\"tool\" pos=\"0.4 0 0\"><inertial pos=\"0.05 0 0.02\" mass=\"0.6\" diaginertia=\"0.001 0.002 0.002\"/>"
    "<joint name=\"wrist\" axis=\"0 1 0\" armature=\"0.01\"/></body></body></body></worldbody></mujoco>";

static const double TIP[3] = {0.12, 0.0, -0.02};
static const double TOOL_MASS = 0.6;

/* The floor under the tip: a spring and a damper, which act while the tip is below it and press only. */
typedef struct {
  int tool, active;
  double height, stiffness, damping, force;
} Floor;

static Floor ground;

static void check(percuss_status status)
{
  if (status != PERCUSS_OK) {
    fprintf(stderr, "percuss: %s\n", percuss_error_message());
    exit(1);
  }
}

static void tip_of(const mjModel *m, const mjData *d, mjtNum point[3], mjtNum *speed)
{
  mjtNum jacobian[3 * 3];
  mju_mulMatVec3(point, d->xmat + 9 * ground.tool, TIP);
  mju_addTo3(point, d->xpos + 3 * ground.tool);
  mj_jac(m, d, jacobian, NULL, point, ground.tool);
  *speed = 0.0;
  for (int k = 0; k < 3; k++) *speed += jacobian[2 * 3 + k] * d->qvel[k];
}

/* Called by MuJoCo in each stage of its integrator, with positions and velocities known. */
static void floor_force(const mjModel *m, mjData *d)
{
  mjtNum point[3], speed;
  if (!ground.active) return;
  tip_of(m, d, point, &speed);
  const double depth = ground.height - point[2];
  ground.force = 0.0;
  if (depth <= 0.0) return;
  const double force = ground.stiffness * depth - ground.damping * speed;
  ground.force = force > 0.0 ? force : 0.0;
  const mjtNum push[3] = {0.0, 0.0, ground.force};
  mj_applyFT(m, d, push, NULL, point, ground.tool, d->qfrc_passive);
}

/* Simulates from the touch to the end of the contact; the rebound speed over the approach speed. */
static double rebound(const mjModel *m, mjData *d, const mjtNum state[6], double stiffness, double damping)
{
  mjtNum point[3], approach, speed;
  mju_copy(d->qpos, state, 3);
  mju_copy(d->qvel, state + 3, 3);
  mj_forward(m, d);
  tip_of(m, d, point, &approach);
  ground.height = point[2];
  ground.stiffness = stiffness;
  ground.damping = damping;
  ground.active = 1;
  for (int i = 0; i < 2000000; i++) {
    mj_step(m, d);
    mj_forward(m, d);
    tip_of(m, d, point, &speed);
    if (speed > 0.0 && ground.force == 0.0) break;
  }
  ground.active = 0;
  return -speed / approach;
}

int main(void)
{
  char error[1000] = "";
  mjVFS files;
  mj_defaultVFS(&files);
  if (mj_addBufferVFS(&files, "arm.xml", ARM, (int)strlen(ARM)) != 0) return 1;
  mjModel *m = mj_loadXML("arm.xml", &files, error, sizeof error);
  mj_deleteVFS(&files);
  if (m == NULL) {
    fprintf(stderr, "MuJoCo: %s\n", error);
    return 1;
  }
  mjData *d = mj_makeData(m);
  ground.tool = mj_name2id(m, mjOBJ_BODY, "tool");
  mjcb_passive = floor_force;

  percuss_model *model = NULL;
  percuss_system *system = NULL;
  percuss_assembly *assembly = NULL;
  percuss_workspace *workspace = NULL;
  check(percuss_model_load_memory("arm.xml", ARM, strlen(ARM), &model));
  check(percuss_system_new(model, NULL, &system));
  check(percuss_assembly_new(system, NULL, &assembly));
  check(percuss_workspace_new(assembly, &workspace));
  percuss_contact contact;
  check(percuss_contact_init(&contact));
  check(percuss_model_find_link(model, "tool", &contact.link));
  memcpy(contact.point, TIP, sizeof TIP);
  contact.normal_given = PERCUSS_NORMAL_WORLD;
  contact.normal[2] = -1.0;

  /* Positions and velocities at the touch: the tip goes down. */
  static const mjtNum states[2][6] = {{0.5, 0.4, 0.2, 1.0, 0.5, -0.5}, {0.2, 1.2, -0.8, 0.3, 2.0, 1.0}};
  static const double wanted[2] = {0.3, 0.7};
  /* The motion of the arm during the impact, and gravity, change the rebound by the ratio of their times: with the stiffness. */
  const double stiffness = 5e7, tolerance = 5e-3;
  int failed = 0;
  for (size_t i = 0; i < 2; i++) {
    double q[3], velocities[3], speed_by_percuss = 0.0;
    /* MuJoCo's positions include ref, and its free joints have poses in the world: positions of percuss are 0 as drawn. */
    check(percuss_model_positions_of_qpos(model, states[i], 3, q, 3));
    percuss_workspace_response response;
    check(percuss_workspace_respond(workspace, q, 3, &contact, &response, velocities, 3));
    const double mass = response.effective_mass;
    mju_copy(d->qpos, states[i], 3);
    mju_copy(d->qvel, states[i] + 3, 3);
    mj_forward(m, d);
    mjtNum point[3], speed;
    tip_of(m, d, point, &speed);
    /* M v* = m j: the closing speed of MuJoCo's velocities, by percuss's response. */
    mjtNum momentum[3];
    mj_mulM(m, d, momentum, d->qvel);
    for (int k = 0; k < 3; k++) speed_by_percuss += velocities[k] * momentum[k] / mass;
    if (response.outcome != PERCUSS_FINITE || fabs(speed_by_percuss + speed) > 1e-9 * fabs(speed)) {
      fprintf(stderr, "closing speed %.12g m/s by MuJoCo, %.12g m/s by percuss\n", -speed, speed_by_percuss);
      return 1;
    }
    for (size_t k = 0; k < 2; k++) {
      const percuss_law law = PERCUSS_LAW_KELVIN_VOIGT;
      const percuss_spring spring = {mass, stiffness, 1.0}, tool = {TOOL_MASS, stiffness, 1.0};
      percuss_damper damper, naive;
      check(percuss_law_damper(law, &spring, wanted[k], -speed, PERCUSS_FORCE_VANISHES, &damper));
      check(percuss_law_damper(law, &tool, wanted[k], -speed, PERCUSS_FORCE_VANISHES, &naive));
      const double e = rebound(m, d, states[i], stiffness, damper.coefficient);
      const double other = rebound(m, d, states[i], stiffness, naive.coefficient);
      printf("%.6f kg, %.3f m/s: wanted e = %.1f, MuJoCo rebounds with %.5f; made for the tool's mass: %.3f\n", mass, -speed,
             wanted[k], e, other);
      if (!(fabs(e - wanted[k]) <= tolerance)) failed = 1;
      /* The comparison must fail for a wrong mass. */
      if (!(fabs(other - wanted[k]) > 4.0 * tolerance)) failed = 1;
    }
  }
  check(percuss_workspace_free(&workspace));
  check(percuss_assembly_free(&assembly));
  check(percuss_system_free(&system));
  check(percuss_model_free(&model));
  mj_deleteData(d);
  mj_deleteModel(m);
  puts(failed ? "a rebound is off" : "all rebounds as asked");
  return failed;
}
