/* MuJoCo's own contacts with a wanted restitution: when MuJoCo detects a contact, percuss computes the effective mass at its point and
   normal, the damper follows from it, and both become the solref of the geoms. An arm falls on a floor; the measured rebound is compared
   with the wanted one, and with that of a solref for the mass of the tool alone.

     cc mujoco_contacts.c $(pkg-config --cflags --libs percuss) -I MUJOCO/include -L MUJOCO -lmujoco -lm

   tests/external/capi.sh runs it where MuJoCo is installed. Contacts without friction (condim 1), one at a time. */
#include <mujoco/mujoco.h>
#include <percuss.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The impedance d is constant: the same number twice in solimp. */
static const double IMPEDANCE = 0.9;
static const char ARM[] =
    "<mujoco model=\"arm\"><option timestep=\"2e-6\" tolerance=\"0\"/><default><geom condim=\"1\" solimp=\"0.9 0.9 0.001\"/></default>"
    "<worldbody><geom type=\"plane\" size=\"3 3 1\"/><body name=\"upper\" pos=\"0 0 0.4\">"
    "<inertial pos=\"0.25 0 0\" mass=\"3\" diaginertia=\"0.01 0.08 0.08\"/><joint name=\"shoulder\" axis=\"0 1 0\"/>"
    "<body name=\"lower\" pos=\"0.5 0 0\"><inertial pos=\"0.2 0.01 0\" mass=\"2\" diaginertia=\"0.006 0.04 0.04\"/>"
    "<joint name=\"elbow\" axis=\"0 1 0\" armature=\"0.02\"/>"
    "<body name=\"tool\" pos=\"0.4 0 0\"><inertial pos=\"0.05 0 0.02\" mass=\"0.6\" diaginertia=\"0.001 0.002 0.002\"/>"
    "<joint name=\"wrist\" axis=\"0 1 0\" armature=\"0.01\"/><geom type=\"sphere\" size=\"0.03\" pos=\"0.12 0 -0.02\"/>"
    "</body></body></body></worldbody></mujoco>";
static const double TOOL_MASS = 0.6;

static void check(percuss_status status)
{
  if (status != PERCUSS_OK) {
    fprintf(stderr, "percuss: %s\n", percuss_error_message());
    exit(1);
  }
}

/* The contact of MuJoCo in percuss: mjContact.frame starts with the normal from geom1 to geom2; percuss's points out of the contact link,
   the body of geom2, into the other side. */
static percuss_contact contact_of(const percuss_model *model, const mjModel *m, const mjData *d, const mjContact *own)
{
  percuss_contact contact;
  const int other = m->geom_bodyid[own->geom[0]], body = m->geom_bodyid[own->geom[1]];
  mjtNum arm[3], point[3];
  check(percuss_contact_init(&contact));
  check(percuss_model_find_link(model, mj_id2name(m, mjOBJ_BODY, body), &contact.link));
  /* Body 0 is the world, the ground of percuss. */
  if (other != 0) check(percuss_model_find_link(model, mj_id2name(m, mjOBJ_BODY, other), &contact.against));
  mju_sub3(arm, own->pos, d->xpos + 3 * body);
  mju_mulMatTVec3(point, d->xmat + 9 * body, arm);
  for (int k = 0; k < 3; k++) {
    contact.point[k] = point[k];
    contact.normal[k] = -own->frame[k];
  }
  contact.normal_given = PERCUSS_NORMAL_WORLD;
  return contact;
}

/* MuJoCo's force is (aref − a0)/(1/m + R), R = (1 − d)/d of its approximation of 1/m. solref scales the force by d/(1/m + R) further. */
static void set_solref(mjModel *m, const mjContact *own, double stiffness, double damping, double mass, double approximation)
{
  const double factor = IMPEDANCE / mass + (1.0 - IMPEDANCE) * approximation;
  for (int side = 0; side < 2; side++) {
    m->geom_solref[mjNREF * own->geom[side]] = -stiffness * factor;
    m->geom_solref[mjNREF * own->geom[side] + 1] = -damping * factor;
  }
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
  percuss_model *model = NULL;
  percuss_system *system = NULL;
  percuss_assembly *assembly = NULL;
  percuss_workspace *workspace = NULL;
  check(percuss_model_load_memory("arm.xml", ARM, strlen(ARM), &model));
  check(percuss_system_new(model, NULL, &system));
  check(percuss_assembly_new(system, NULL, &assembly));
  check(percuss_workspace_new(assembly, &workspace));

  static const mjtNum states[2][6] = {{0.35, 0.3, 0.2, 1.0, 0.5, -0.5}, {0.2, 0.6, 0.3, 0.3, 2.0, 1.0}};
  static const double wanted[2] = {0.3, 0.7};
  /* The motion of the arm during the impact, and gravity, change the rebound by the ratio of their times. */
  const double stiffness = 5e7, tolerance = 5e-3;
  int failed = 0;
  for (int run = 0; run < 8; run++) {
    const mjtNum *state = states[run % 2];
    const double e = wanted[run / 2 % 2];
    const int is_naive = run >= 4;
    mjtNum approach = 0.0, force[6], speed[6];
    double mass = 0.0, rebound = NAN;
    mj_resetData(m, d);
    mju_copy(d->qpos, state, 3);
    mju_copy(d->qvel, state + 3, 3);
    /* The arm is lowered until its ball is 0.1 mm above the floor. */
    mj_forward(m, d);
    m->body_pos[3 * 1 + 2] -= d->geom_xpos[3 * 1 + 2] - m->geom_size[3 * 1] - 1e-4;
    for (int step = 0; step < 2000000; step++) {
      mj_forward(m, d);
      if (d->ncon > 0 && approach == 0.0) {
        const mjContact own = d->contact[0];
        const percuss_contact contact = contact_of(model, m, d, &own);
        const double approximation = d->efc_diagA[own.efc_address];
        double q[3];
        percuss_outcome outcome;
        check(percuss_model_positions_of_qpos(model, d->qpos, 3, q, 3));
        check(percuss_workspace_effective_mass(workspace, q, 3, &contact, &outcome, &mass, NULL));
        if (outcome != PERCUSS_FINITE) return 1;
        approach = d->efc_vel[own.efc_address];
        const percuss_spring spring = {is_naive ? TOOL_MASS : mass, stiffness, 1.0};
        percuss_damper damper;
        check(percuss_law_damper(PERCUSS_LAW_KELVIN_VOIGT, &spring, e, -approach, PERCUSS_FORCE_VANISHES, &damper));
        set_solref(m, &own, stiffness, damper.coefficient, mass, approximation);
        mj_forward(m, d);
      }
      if (d->ncon > 0 && approach != 0.0) {
        mj_contactForce(m, d, 0, force);
        speed[0] = d->efc_vel[d->contact[0].efc_address];
        if (force[0] == 0.0 && speed[0] > 0.0) {
          rebound = -speed[0] / approach;
          break;
        }
      }
      mj_step(m, d);
    }
    printf("%.6f kg, %.3f m/s: wanted e = %.1f, MuJoCo rebounds with %.5f%s\n", mass, -approach, e, rebound,
           is_naive ? ", made for the tool's mass" : "");
    /* The comparison must fail for a wrong mass. */
    const int is_met = fabs(rebound - e) <= tolerance;
    if (is_naive ? fabs(rebound - e) <= 4.0 * tolerance : !is_met) failed = 1;
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
