/* Every input rule at every entry point of C, findings as data, and overlapping memory. */
#include "check.h"

/* A rod on a ball joint. */
static const char BALL[] =
    "<robot name=\"ball\"><link name=\"ground\"/><link name=\"rod\"><inertial><origin xyz=\"0.3 0 0\"/><mass value=\"2\"/>"
    "<inertia ixx=\"0.01\" iyy=\"0.07\" izz=\"0.08\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>"
    "<joint name=\"ball\" type=\"spherical\"><parent link=\"ground\"/><child link=\"rod\"/></joint></robot>";

typedef struct {
  percuss_model *model;
  percuss_system *system;
  percuss_assembly *assembly;
  percuss_workspace *workspace;
  percuss_batch *batch;
  percuss_contact contact;
  size_t positions;
} Subject;

static Subject subject(const char *text, const char *link, double x, double y, double z, int base)
{
  Subject s;
  memset(&s, 0, sizeof s);
  s.model = loaded(text);
  percuss_conditions *conditions = NULL;
  OK(percuss_conditions_new(&conditions));
  OK(percuss_conditions_base(conditions, base));
  OK(percuss_system_new(s.model, conditions, &s.system));
  OK(percuss_conditions_free(&conditions));
  OK(percuss_assembly_new(s.system, NULL, &s.assembly));
  OK(percuss_workspace_new(s.assembly, &s.workspace));
  OK(percuss_contact_init(&s.contact));
  OK(percuss_model_find_link(s.model, link, &s.contact.link));
  s.contact.point[0] = x;
  s.contact.point[1] = y;
  s.contact.point[2] = z;
  s.contact.normal[1] = 1.0;
  OK(percuss_batch_new(s.assembly, &s.contact, 1, &s.batch));
  OK(percuss_model_counts(s.model, NULL, NULL, &s.positions, NULL));
  return s;
}

static void dispose(Subject *s)
{
  OK(percuss_batch_free(&s->batch));
  OK(percuss_workspace_free(&s->workspace));
  OK(percuss_assembly_free(&s->assembly));
  OK(percuss_system_free(&s->system));
  OK(percuss_model_free(&s->model));
}

static int cases = 0;

/* The workspace refuses a row of positions with a message, the batch with a remark. */
static void refused_row(Subject *s, const double *row, percuss_status status, const char *words, uint32_t reason)
{
  percuss_outcome outcome = 77;
  double mass = -1.0;
  uint32_t remarks = 0;
  FAILS(percuss_workspace_effective_mass(s->workspace, row, s->positions, &s->contact, &outcome, &mass, &remarks), status,
        words);
  CHECK(outcome == 77 && mass == -1.0);
  OK(percuss_batch_run(s->batch, row, s->positions, PERCUSS_ROW_MAJOR, s->positions, 1, &outcome, &mass, NULL, &remarks,
                       NULL, NULL));
  CHECK(outcome == PERCUSS_NO_ANSWER && isnan(mass) && remarks == reason);
  cases += 2;
}

static void answered_row(Subject *s, const double *row)
{
  percuss_outcome outcome;
  double mass, of_batch;
  uint32_t remarks = 77;
  OK(percuss_workspace_effective_mass(s->workspace, row, s->positions, &s->contact, &outcome, &mass, &remarks));
  CHECK(outcome == PERCUSS_FINITE && remarks == 0);
  OK(percuss_batch_run(s->batch, row, s->positions, PERCUSS_ROW_MAJOR, s->positions, 1, &outcome, &of_batch, NULL, &remarks,
                       NULL, NULL));
  CHECK(outcome == PERCUSS_FINITE && near_to(of_batch, mass, 1e-12) && remarks == 0);
}

static void rows_of_positions(void)
{
  Subject ball = subject(BALL, "rod", 0.5, 0.0, 0.0, PERCUSS_BASE_FIXED);
  double row[4] = {1.0, 0.0, 0.0, 0.0};
  answered_row(&ball, row);
  const double norms[] = {0.0, 0.5, 0.98, 1.02, 3.0};
  for (size_t i = 0; i < COUNT(norms); i++) {
    row[0] = norms[i];
    refused_row(&ball, row, PERCUSS_ERROR_ARGUMENT, "unit quaternion", PERCUSS_REMARK_NOT_UNIT_QUATERNION);
  }
  row[0] = 1.005;
  answered_row(&ball, row);
  const double bad[] = {NAN, INFINITY, -INFINITY, 1e101};
  for (size_t i = 0; i < COUNT(bad); i++) {
    row[1] = bad[i];
    refused_row(&ball, row, PERCUSS_ERROR_ARGUMENT, "position 1", PERCUSS_REMARK_NOT_FINITE);
  }
  /* Empty or null positions are refused; formerly the result of the previous row was returned. */
  percuss_outcome outcome;
  double mass;
  FAILS(percuss_workspace_effective_mass(ball.workspace, NULL, 0, &ball.contact, &outcome, &mass, NULL),
        PERCUSS_ERROR_LENGTH, "0 positions");
  FAILS(percuss_workspace_effective_mass(ball.workspace, NULL, 4, &ball.contact, &outcome, &mass, NULL),
        PERCUSS_ERROR_NULL, "positions");
  FAILS(percuss_workspace_effective_mass(ball.workspace, row, 0, &ball.contact, &outcome, &mass, NULL),
        PERCUSS_ERROR_LENGTH, "0 positions");
  cases += 3;
  dispose(&ball);
  /* Open loops. */
  Subject bars = subject(FOUR_BAR, "coupler", 0.35, 0.1, 0.0, PERCUSS_BASE_FIXED);
  percuss_configuration *configuration = NULL;
  percuss_pose *pose = NULL;
  double closed[3], crank = 0.2;
  OK(percuss_configuration_new(bars.model, &configuration));
  OK(percuss_configuration_set(configuration, "crank_hinge", &crank, 1));
  OK(percuss_assembly_pose(bars.assembly, configuration, &pose));
  OK(percuss_pose_positions(pose, closed, 3));
  percuss_outcome found;
  OK(percuss_workspace_effective_mass(bars.workspace, closed, 3, &bars.contact, &found, &mass, NULL));
  CHECK(found == PERCUSS_FINITE);
  const double by[] = {1e-5, 1e-3, 0.1, 1.0};
  for (size_t i = 0; i < COUNT(by); i++) {
    double open[3] = {closed[0] + by[i], closed[1], closed[2]};
    percuss_status status =
        percuss_workspace_effective_mass(bars.workspace, open, 3, &bars.contact, &found, &mass, NULL);
    CHECK(status == PERCUSS_ERROR_ASSEMBLY && strstr(percuss_error_message(), "pin") != NULL);
    CHECK(strstr(percuss_error_message(), "is open by") != NULL);
    uint32_t remarks = 0;
    OK(percuss_batch_run(bars.batch, open, 3, PERCUSS_ROW_MAJOR, 3, 1, &found, &mass, NULL, &remarks, NULL, NULL));
    CHECK(found == PERCUSS_NO_ANSWER && isnan(mass) && remarks == PERCUSS_REMARK_OPEN_LOOPS);
    cases += 2;
  }
  OK(percuss_pose_free(&pose));
  OK(percuss_configuration_free(&configuration));
  dispose(&bars);
}

/* The pose, the workspace, the batch and the row j refuse an invalid contact. */
static void refused_contact(Subject *s, percuss_pose *pose, const percuss_contact *contact, percuss_status status,
                            const char *words)
{
  percuss_mass mass;
  percuss_outcome outcome;
  double value, row[4] = {1.0, 0.0, 0.0, 0.0}, j[3];
  percuss_batch *batch = NULL;
  percuss_response *response = NULL;
  FAILS(percuss_pose_effective_mass(pose, contact, PERCUSS_ROUTE_AUTO, &mass), status, words);
  FAILS(percuss_pose_respond(pose, contact, PERCUSS_ROUTE_AUTO, &response), status, words);
  FAILS(percuss_pose_contact_row(pose, contact, j, 3), status, words);
  FAILS(percuss_workspace_effective_mass(s->workspace, row, 4, contact, &outcome, &value, NULL), status, words);
  FAILS(percuss_workspace_effective_mass_again(s->workspace, contact, &outcome, &value, NULL), status, words);
  FAILS(percuss_batch_new(s->assembly, contact, 1, &batch), status, words);
  FAILS(percuss_workspace_batch(s->workspace, contact, 1, &batch), status, words);
  CHECK(response == NULL && batch == NULL);
  cases += 7;
}

static void contacts(void)
{
  Subject ball = subject(BALL, "rod", 0.5, 0.0, 0.0, PERCUSS_BASE_FIXED);
  percuss_configuration *configuration = NULL;
  percuss_pose *pose = NULL;
  OK(percuss_configuration_new(ball.model, &configuration));
  OK(percuss_pose_new(ball.system, configuration, &pose));
  const percuss_status contact = PERCUSS_ERROR_CONTACT;
  percuss_contact c;
  OK(percuss_contact_init(&c));
  CHECK(c.link == PERCUSS_NO_LINK && c.against == PERCUSS_GROUND && c.toward == PERCUSS_NO_LINK);
  c.normal[0] = 1.0;
  refused_contact(&ball, pose, &c, contact, "link is not set");
  OK(percuss_contact_init(&c));
  c.link = ball.contact.link;
  refused_contact(&ball, pose, &c, contact, "length");
  c = ball.contact;
  c.normal[1] = 1e-12;
  refused_contact(&ball, pose, &c, contact, "length");
  c.normal[1] = NAN;
  refused_contact(&ball, pose, &c, contact, "normal");
  c = ball.contact;
  c.point[2] = INFINITY;
  refused_contact(&ball, pose, &c, contact, "point");
  c = ball.contact;
  c.link = 9;
  refused_contact(&ball, pose, &c, PERCUSS_ERROR_NAME, "link number 9");
  c = ball.contact;
  c.against = 9;
  refused_contact(&ball, pose, &c, PERCUSS_ERROR_NAME, "link number 9");
  c = ball.contact;
  c.normal_given = PERCUSS_NORMAL_TOWARD;
  refused_contact(&ball, pose, &c, contact, "toward is not set");
  c.normal_given = 9;
  refused_contact(&ball, pose, &c, PERCUSS_ERROR_ARGUMENT, "expected 0 to 8");
  c.normal_given = -1;
  refused_contact(&ball, pose, &c, PERCUSS_ERROR_ARGUMENT, "expected 0 to 8");
  /* Axes of moments: at the zero pose, the contact row over the angular velocity of the ball is the unit axis in every frame. */
  for (percuss_normal frame = PERCUSS_AXIS_LINK; frame <= PERCUSS_AXIS_AGAINST; frame++) {
    c = ball.contact;
    c.normal_given = frame;
    c.normal[0] = 0.0;
    c.normal[1] = 3.0;
    c.normal[2] = 4.0;
    double j[3], value, at_zero[4] = {1.0, 0.0, 0.0, 0.0};
    percuss_mass mass;
    percuss_outcome outcome;
    OK(percuss_pose_contact_row(pose, &c, j, 3));
    CHECK(fabs(j[0]) < 1e-15 && fabs(j[1] - 0.6) < 1e-15 && fabs(j[2] - 0.8) < 1e-15);
    OK(percuss_pose_effective_mass(pose, &c, PERCUSS_ROUTE_AUTO, &mass));
    OK(percuss_workspace_effective_mass(ball.workspace, at_zero, 4, &c, &outcome, &value, NULL));
    CHECK(outcome == mass.outcome);
    CHECK(outcome != PERCUSS_FINITE || fabs(value / mass.effective_mass - 1.0) < 1e-12);
    c.normal[1] = c.normal[2] = 0.0;
    refused_contact(&ball, pose, &c, contact, "the axis has length");
  }
  /* Configurations and bases. */
  const double zero[4] = {0.0, 0.0, 0.0, 0.0}, two[4] = {2.0, 0.0, 0.0, 0.0}, none[4] = {NAN, 0.0, 0.0, 0.0};
  const double origin[3] = {0.0, 0.0, 0.0}, far[3] = {1e101, 0.0, 0.0}, unit[4] = {1.0, 0.0, 0.0, 0.0};
  const double *quaternions[] = {zero, two, none};
  for (int i = 0; i < 3; i++) {
    OK(percuss_configuration_reset(configuration));
    CHECK(percuss_configuration_set(configuration, "ball", quaternions[i], 4) == PERCUSS_ERROR_CONDITIONS);
    CHECK(percuss_configuration_guess(configuration, "ball", quaternions[i], 4) == PERCUSS_ERROR_CONDITIONS);
    CHECK(percuss_configuration_set_positions(configuration, quaternions[i], 4) == PERCUSS_ERROR_CONDITIONS);
    CHECK(percuss_configuration_set_base(configuration, origin, quaternions[i]) == PERCUSS_ERROR_ARGUMENT);
    CHECK(percuss_workspace_set_base(ball.workspace, origin, quaternions[i]) == PERCUSS_ERROR_ARGUMENT);
    cases += 5;
  }
  CHECK(percuss_configuration_set_base(configuration, far, unit) == PERCUSS_ERROR_ARGUMENT);
  CHECK(percuss_workspace_set_base(ball.workspace, far, unit) == PERCUSS_ERROR_ARGUMENT);
  cases += 2;
  /* Laws: invalid speeds. */
  const percuss_spring spring = {2.0, 1e5, 1.5};
  percuss_damper damper;
  percuss_impact impact;
  double e;
  const double speeds[] = {NAN, -1.0, INFINITY, -INFINITY};
  for (int law = 0; law < (int)percuss_law_count(); law++) {
    for (size_t i = 0; i < COUNT(speeds); i++) {
      CHECK(percuss_law_damper(law, &spring, 0.6, speeds[i], PERCUSS_FORCE_VANISHES, &damper) == PERCUSS_ERROR_LAW);
      cases++;
    }
  }
  OK(percuss_law_damper(PERCUSS_LAW_HUNT_CROSSLEY, &spring, 0.6, 1.0, PERCUSS_FORCE_VANISHES, &damper));
  for (size_t i = 0; i < COUNT(speeds); i++) {
    CHECK(percuss_damper_restitution(&damper, &spring, speeds[i], &e) == PERCUSS_ERROR_LAW);
    CHECK(percuss_damper_impact(&damper, &spring, speeds[i], &impact) == PERCUSS_ERROR_LAW);
    cases += 2;
  }
  OK(percuss_pose_free(&pose));
  OK(percuss_configuration_free(&configuration));
  dispose(&ball);
}

static void overlaps(void)
{
  Subject ball = subject(BALL, "rod", 0.5, 0.0, 0.0, PERCUSS_BASE_FIXED);
  const percuss_status overlap = PERCUSS_ERROR_OVERLAP;
  double memory[16] = {1.0, 0.0, 0.0, 0.0, 1.0};
  percuss_outcome outcomes[4];
  uint32_t remarks[4];
  FAILS(percuss_batch_run(ball.batch, memory, 8, PERCUSS_ROW_MAJOR, 4, 2, outcomes, memory, NULL, NULL, NULL, NULL), overlap,
        "effective_masses overlaps positions");
  FAILS(percuss_batch_run(ball.batch, memory, 8, PERCUSS_ROW_MAJOR, 4, 2, outcomes, memory + 8, memory + 7, NULL, NULL,
                          NULL),
        overlap, "overlaps");
  FAILS(percuss_batch_run(ball.batch, memory, 8, PERCUSS_ROW_MAJOR, 4, 2, outcomes, memory + 8, memory + 9, NULL, NULL,
                          NULL),
        overlap, "effective_masses overlaps errors");
  FAILS(percuss_batch_run(ball.batch, memory, 8, PERCUSS_ROW_MAJOR, 4, 2, (percuss_outcome *)(void *)remarks, memory + 8,
                          NULL, remarks + 1, NULL, NULL),
        overlap, "outcomes overlaps remarks");
  OK(percuss_batch_run(ball.batch, memory, 8, PERCUSS_ROW_MAJOR, 4, 2, outcomes, memory + 8, memory + 10, remarks, NULL,
                       NULL));
  FAILS(percuss_workspace_effective_mass(ball.workspace, memory, 4, &ball.contact, outcomes, memory + 1, NULL), overlap,
        "effective_mass overlaps positions");
  FAILS(percuss_workspace_effective_mass(ball.workspace, memory, 4, &ball.contact, outcomes, &ball.contact.point[1], NULL),
        overlap, "effective_mass overlaps contact");
  const percuss_matrix mass = {memory, 1, 1, 1, 1, PERCUSS_ROW_MAJOR, 0};
  percuss_mass result;
  FAILS(percuss_effective_mass(&mass, memory + 4, 1, NULL, NULL, &result, memory, NULL, NULL), overlap,
        "velocities overlaps mass");
  FAILS(percuss_effective_mass(&mass, memory + 4, 1, NULL, NULL, &result, memory + 4, NULL, NULL), overlap,
        "velocities overlaps contact_row");
  OK(percuss_effective_mass(&mass, memory + 4, 1, NULL, NULL, &result, memory + 5, NULL, NULL));
  cases += 8;
  dispose(&ball);
}

/* The four-bar with its coupler's pin 30 mm off, and the four-bar with its rocker driven past its range. */
static void findings(void)
{
  char text[sizeof FOUR_BAR + 16];
  strcpy(text, FOUR_BAR);
  char *pin = strstr(text, "xyz=\"0.7 0 0\"");
  CHECK(pin != NULL);
  memcpy(pin, "xyz=\"0.73  0\"", 13);
  memcpy(pin, "xyz=\".73 0 0\"", 13);
  Subject open = subject(text, "coupler", 0.35, 0.1, 0.0, PERCUSS_BASE_FIXED);
  percuss_configuration *configuration = NULL;
  percuss_pose *pose = NULL;
  percuss_mass mass;
  percuss_outcome outcome;
  double positions[3], value;
  uint32_t remarks = 0;
  OK(percuss_configuration_new(open.model, &configuration));
  OK(percuss_pose_new(open.system, configuration, &pose));
  OK(percuss_pose_effective_mass(pose, &open.contact, PERCUSS_ROUTE_AUTO, &mass));
  CHECK((mass.remarks & PERCUSS_REMARK_DRAWN_OPEN) != 0);
  OK(percuss_pose_positions(pose, positions, 3));
  OK(percuss_workspace_effective_mass(open.workspace, positions, 3, &open.contact, &outcome, &value, &remarks));
  CHECK((remarks & PERCUSS_REMARK_DRAWN_OPEN) != 0);
  OK(percuss_batch_run(open.batch, positions, 3, PERCUSS_ROW_MAJOR, 3, 1, &outcome, &value, NULL, &remarks, NULL, NULL));
  CHECK((remarks & PERCUSS_REMARK_DRAWN_OPEN) != 0);
  OK(percuss_pose_free(&pose));
  OK(percuss_configuration_free(&configuration));
  dispose(&open);
  cases += 3;

  Subject bars = subject(FOUR_BAR, "coupler", 0.35, 0.1, 0.0, PERCUSS_BASE_FIXED);
  OK(percuss_configuration_new(bars.model, &configuration));
  /* The drawing mirrored in the line of the hinges: the rocker's pin is at (-0.1, 0.49) from its hinge in the closed
     pose. */
  const double mirrored = -2.95;
  int refused = 0;
  for (int i = 0; i < 8; i++) {
    const double target = mirrored + 0.03 * i;
    OK(percuss_configuration_reset(configuration));
    OK(percuss_configuration_set(configuration, "rocker_hinge", &target, 1));
    FAILS(percuss_pose_new(bars.system, configuration, &pose), PERCUSS_ERROR_ASSEMBLY, "another assembly mode");
    refused++;
    OK(percuss_configuration_allow_other_assembly(configuration));
    OK(percuss_pose_new(bars.system, configuration, &pose));
    OK(percuss_pose_effective_mass(pose, &bars.contact, PERCUSS_ROUTE_AUTO, &mass));
    CHECK((mass.remarks & PERCUSS_REMARK_OTHER_ASSEMBLY) != 0);
    OK(percuss_pose_free(&pose));
  }
  CHECK(refused == 8);
  cases += refused;
  OK(percuss_pose_free(&pose));
  OK(percuss_configuration_free(&configuration));
  dispose(&bars);

  /* Nearly immovable: along the rod, with a slight tilt. */
  Subject ball = subject(BALL, "rod", 0.5, 0.0, 0.0, PERCUSS_BASE_FIXED);
  const double row[4] = {1.0, 0.0, 0.0, 0.0};
  ball.contact.normal[0] = 1.0;
  ball.contact.normal[1] = 1e-8;
  OK(percuss_workspace_effective_mass(ball.workspace, row, 4, &ball.contact, &outcome, &value, &remarks));
  CHECK(outcome == PERCUSS_FINITE && value > 1e15 && remarks == PERCUSS_REMARK_NEARLY_IMMOVABLE);
  dispose(&ball);
  cases++;

  /* A normal in the world on a floating base: the base must be given. */
  Subject floating = subject(PENDULUM, "rod", 0.1, 0.0, -0.8, PERCUSS_BASE_FLOATING);
  const double angle = 0.3, place[3] = {5.0, 6.0, 7.0}, turned[4] = {0.5, 0.5, -0.5, 0.5};
  floating.contact.normal_given = PERCUSS_NORMAL_WORLD;
  OK(percuss_workspace_effective_mass(floating.workspace, &angle, 1, &floating.contact, &outcome, &value, &remarks));
  CHECK((remarks & PERCUSS_REMARK_BASE_NOT_GIVEN) != 0);
  OK(percuss_workspace_set_base(floating.workspace, place, turned));
  OK(percuss_workspace_effective_mass(floating.workspace, &angle, 1, &floating.contact, &outcome, &value, &remarks));
  CHECK((remarks & PERCUSS_REMARK_BASE_NOT_GIVEN) == 0);
  OK(percuss_configuration_new(floating.model, &configuration));
  OK(percuss_configuration_set(configuration, "hinge", &angle, 1));
  OK(percuss_pose_new(floating.system, configuration, &pose));
  OK(percuss_pose_effective_mass(pose, &floating.contact, PERCUSS_ROUTE_AUTO, &mass));
  CHECK((mass.remarks & PERCUSS_REMARK_BASE_NOT_GIVEN) != 0);
  OK(percuss_pose_free(&pose));
  OK(percuss_configuration_set_base(configuration, place, turned));
  OK(percuss_pose_new(floating.system, configuration, &pose));
  OK(percuss_pose_effective_mass(pose, &floating.contact, PERCUSS_ROUTE_AUTO, &mass));
  CHECK((mass.remarks & PERCUSS_REMARK_BASE_NOT_GIVEN) == 0);
  percuss_batch *batch = NULL;
  percuss_outcome of_batch;
  double in_batch;
  OK(percuss_workspace_batch(floating.workspace, &floating.contact, 1, &batch));
  OK(percuss_batch_run(batch, &angle, 1, PERCUSS_ROW_MAJOR, 1, 1, &of_batch, &in_batch, NULL, &remarks, NULL, NULL));
  CHECK(of_batch == outcome && (remarks & PERCUSS_REMARK_BASE_NOT_GIVEN) == 0);
  CHECK(of_batch != PERCUSS_FINITE || (near_to(in_batch, value, 1e-12) && near_to(mass.effective_mass, value, 1e-12)));
  OK(percuss_batch_free(&batch));
  OK(percuss_pose_free(&pose));
  OK(percuss_configuration_free(&configuration));
  dispose(&floating);
  cases += 5;
}

int main(void)
{
  rows_of_positions();
  contacts();
  overlaps();
  findings();
  printf("%d cases of rule and entry point\n", cases);
  return 0;
}
