/* A multibody program with its own time loop. Its mechanism, an arm with two links in a vertical plane, falls until
 * its tip meets the floor. At the touch the program gets the effective mass from percuss and the damper for the
 * restitution of its handbook; then it integrates through the impact and compares the rebound.
 *
 * Compile: cc -std=c11 rebound.c $(pkg-config --cflags --libs percuss) -lm */
#include <percuss.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Masses (kg), lengths, centres of mass (m), moments of inertia about them (kg m^2). */
static const double M1 = 3.0, L1 = 0.5, C1 = 0.25, I1 = 0.06;
static const double M2 = 2.0, L2 = 0.4, C2 = 0.15, I2 = 0.03;
static const double GRAVITY = 9.81, FLOOR = -0.6;
/* Two floors, N/m, and the permitted relative error of the rebound. m is the effective mass at one instant; during
 * the impact (a fraction of a millisecond), gravity and the rotation of the arm change the speed by a relative 1e-4.
 * The change is inversely proportional to the square root of the stiffness: a tenth on the second floor. */
static const struct {
  double stiffness, tolerance;
} FLOORS[] = {{1e8, 1e-3}, {1e10, 1e-4}};

/* The same arm as URDF for percuss: x along the links, hinges about z, y upwards. */
static const char ARM[] =
    "<robot name=\"arm\"><link name=\"ground\"/>"
    "<link name=\"upper\"><inertial><origin xyz=\"0.25 0 0\"/><mass value=\"3\"/>"
    "<inertia ixx=\"0.01\" iyy=\"0.06\" izz=\"0.06\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>"
    "<link name=\"lower\"><inertial><origin xyz=\"0.15 0 0\"/><mass value=\"2\"/>"
    "<inertia ixx=\"0.01\" iyy=\"0.03\" izz=\"0.03\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>"
    "<joint name=\"shoulder\" type=\"continuous\"><parent link=\"ground\"/><child link=\"upper\"/>"
    "<axis xyz=\"0 0 1\"/></joint>"
    "<joint name=\"elbow\" type=\"continuous\"><parent link=\"upper\"/><child link=\"lower\"/>"
    "<origin xyz=\"0.5 0 0\"/><axis xyz=\"0 0 1\"/></joint></robot>";

static void check(percuss_status status)
{
  if (status != PERCUSS_OK) {
    fprintf(stderr, "percuss: %s\n", percuss_error_message());
    exit(1);
  }
}

/* Angles and rates: q1, q2, their derivatives. */
typedef struct {
  double q[2], v[2];
} State;

/* The contact: active or not, and its damper. */
typedef struct {
  int active;
  double stiffness, damping;
} Floor;

static double height(const State *s) { return L1 * sin(s->q[0]) + L2 * sin(s->q[0] + s->q[1]); }

/* The rate of the penetration at unit rates: 1x2. The penetration grows as the tip moves down. */
static void contact_row(const State *s, double row[2])
{
  row[1] = -L2 * cos(s->q[0] + s->q[1]);
  row[0] = -L1 * cos(s->q[0]) + row[1];
}

static double closing_speed(const State *s)
{
  double row[2];
  contact_row(s, row);
  return row[0] * s->v[0] + row[1] * s->v[1];
}

/* Contact force of the floor, N. */
static double force(const State *s, const Floor *on)
{
  const double push = on->stiffness * (FLOOR - height(s)) + on->damping * closing_speed(s);
  return on->active && push > 0.0 ? push : 0.0;
}

static void mass_matrix(const State *s, double m[4])
{
  const double coupling = M2 * L1 * C2 * cos(s->q[1]);
  m[3] = I2 + M2 * C2 * C2;
  m[1] = m[2] = m[3] + coupling;
  m[0] = I1 + M1 * C1 * C1 + m[3] + M2 * L1 * L1 + 2.0 * coupling;
}

/* The accelerations under gravity and the contact force of the floor. */
static void accelerations(const State *s, const Floor *on, double a[2])
{
  double m[4], row[2];
  mass_matrix(s, m);
  contact_row(s, row);
  const double h = M2 * L1 * C2 * sin(s->q[1]), push = force(s, on), both = s->q[0] + s->q[1];
  const double t1 = h * (2.0 * s->v[0] * s->v[1] + s->v[1] * s->v[1]) -
                    GRAVITY * ((M1 * C1 + M2 * L1) * cos(s->q[0]) + M2 * C2 * cos(both)) - row[0] * push;
  const double t2 = -h * s->v[0] * s->v[0] - GRAVITY * M2 * C2 * cos(both) - row[1] * push;
  const double determinant = m[0] * m[3] - m[1] * m[2];
  a[0] = (m[3] * t1 - m[1] * t2) / determinant;
  a[1] = (m[0] * t2 - m[2] * t1) / determinant;
}

/* One step of the Runge-Kutta method of order four. */
static State stepped(const State *from, const Floor *on, double dt)
{
  static const double parts[4] = {0.0, 0.5, 0.5, 1.0}, weights[4] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
  State sum = *from, at = *from;
  double v[2] = {0.0, 0.0}, a[2] = {0.0, 0.0};
  for (int stage = 0; stage < 4; stage++) {
    for (int k = 0; k < 2; k++) {
      at.q[k] = from->q[k] + parts[stage] * dt * v[k];
      at.v[k] = from->v[k] + parts[stage] * dt * a[k];
    }
    accelerations(&at, on, a);
    for (int k = 0; k < 2; k++) {
      v[k] = at.v[k];
      sum.q[k] += weights[stage] * dt * v[k];
      sum.v[k] += weights[stage] * dt * a[k];
    }
  }
  return sum;
}

/* Falls until the tip touches the floor. */
static State fallen(State s)
{
  const Floor none = {0, 0.0, 0.0};
  double dt = 1e-4;
  for (long i = 0; i < 1000000; i++) {
    const State next = stepped(&s, &none, dt);
    if (height(&next) >= FLOOR) {
      s = next;
    } else if (dt > 1e-14) {
      dt *= 0.5;
    } else {
      return s;
    }
  }
  fprintf(stderr, "the tip never meets the floor\n");
  exit(1);
}

/* Integrates through the impact with this damper; returns the rebound speed over the approach speed. */
static double rebound(State s, double stiffness, double damping, double dt)
{
  const Floor on = {1, stiffness, damping};
  const double approach = closing_speed(&s);
  for (long i = 0; i < 1000000; i++) {
    s = stepped(&s, &on, dt);
    if (closing_speed(&s) < 0.0 && force(&s, &on) == 0.0) break;
  }
  return -closing_speed(&s) / approach;
}

int main(void)
{
  percuss_model *model = NULL;
  percuss_system *system = NULL;
  percuss_assembly *assembly = NULL;
  percuss_workspace *workspace = NULL;
  check(percuss_model_load_memory("arm.urdf", ARM, strlen(ARM), &model));
  check(percuss_system_new(model, NULL, &system));
  check(percuss_assembly_new(system, NULL, &assembly));
  check(percuss_workspace_new(assembly, &workspace));
  percuss_contact contact;
  check(percuss_contact_init(&contact));
  check(percuss_model_find_link(model, "lower", &contact.link));
  contact.point[0] = L2;
  /* Out of the arm, into the floor. */
  contact.normal_given = PERCUSS_NORMAL_WORLD;
  contact.normal[1] = -1.0;
  contact.normal[2] = 0.0;

  static const State starts[] = {{{0.2, -0.4}, {0.0, 0.0}}, {{-0.3, 0.5}, {-1.0, 2.0}}, {{0.5, -1.2}, {0.0, -3.0}}};
  static const double wanted[] = {0.2, 0.5, 0.8};
  int failed = 0;
  for (size_t i = 0; i < sizeof starts / sizeof *starts; i++) {
    const State touch = fallen(starts[i]);
    const double speed = closing_speed(&touch);
    /* Two methods: the percuss model, and the program's own matrices. The results agree to rounding. */
    percuss_outcome outcome;
    double mass;
    check(percuss_workspace_effective_mass(workspace, touch.q, 2, &contact, &outcome, &mass, NULL));
    double m[4], row[2];
    mass_matrix(&touch, m);
    contact_row(&touch, row);
    const percuss_matrix own = {m, 4, 2, 2, 2, PERCUSS_ROW_MAJOR, 0};
    percuss_mass dense;
    check(percuss_effective_mass(&own, row, 2, NULL, NULL, &dense, NULL, NULL, NULL));
    if (outcome != PERCUSS_FINITE || fabs(dense.effective_mass - mass) > 1e-12 * mass) {
      fprintf(stderr, "%.17g kg by the model, %.17g kg by the matrices\n", mass, dense.effective_mass);
      return 1;
    }
    for (size_t k = 0; k < sizeof wanted / sizeof *wanted; k++) {
      for (size_t f = 0; f < sizeof FLOORS / sizeof *FLOORS; f++) {
        const double stiffness = FLOORS[f].stiffness, tolerance = FLOORS[f].tolerance;
        const percuss_law law = PERCUSS_LAW_KELVIN_VOIGT;
        const percuss_spring spring = {mass, stiffness, 1.0};
        percuss_damper damper, naive;
        percuss_impact impact;
        check(percuss_law_damper(law, &spring, wanted[k], speed, PERCUSS_FORCE_VANISHES, &damper));
        check(percuss_damper_impact(&damper, &spring, speed, &impact));
        const double dt = impact.duration / 2000.0, e = rebound(touch, stiffness, damper.coefficient, dt);
        /* For comparison: the damper designed for the mass of the contact link alone. */
        const percuss_spring link = {M2, stiffness, 1.0};
        check(percuss_law_damper(law, &link, wanted[k], speed, PERCUSS_FORCE_VANISHES, &naive));
        const double other = rebound(touch, stiffness, naive.coefficient, dt);
        printf("%.6f kg, %.3f m/s, %.0e N/m: wanted e = %.1f, rebounds with %.6f (tolerance %.0e); made for the link's mass: "
               "%.3f\n",
               mass, speed, stiffness, wanted[k], e, tolerance, other);
        if (!(fabs(e - wanted[k]) <= tolerance)) failed = 1;
        /* The test must fail for a wrong mass. */
        if (!(fabs(other - wanted[k]) > 20.0 * tolerance)) failed = 1;
      }
    }
  }
  check(percuss_workspace_free(&workspace));
  check(percuss_assembly_free(&assembly));
  check(percuss_system_free(&system));
  check(percuss_model_free(&model));
  puts(failed ? "a rebound is off" : "all rebounds as asked");
  return failed;
}
