/* Models from descriptions compared with the same models from URDF; contact maps compared with single contacts; states of poses. */
#include "check.h"

static const char *const NOTHING = NULL;

static void add_joint(percuss_builder *builder, const char *name, const char *parent, const char *child, double x, double turn)
{
  percuss_joint_description joint;
  OK(percuss_joint_description_init(&joint));
  joint.name = name;
  joint.parent = parent;
  joint.child = child;
  joint.kind = PERCUSS_CONTINUOUS;
  joint.position[0] = x;
  joint.quaternion[0] = cos(0.5 * turn);
  joint.quaternion[3] = sin(0.5 * turn);
  joint.axis[0] = 0.0;
  joint.axis[2] = 2.0;
  OK(percuss_builder_joint(builder, &joint));
}

static percuss_builder *four_bar(void)
{
  percuss_builder *builder = NULL;
  OK(percuss_builder_new("four_bar", &builder));
  const double crank[3] = {0.1, 0, 0}, coupler[3] = {0.35, 0, 0}, rocker[3] = {0.25, 0, 0};
  const double small[6] = {0.001, 0, 0, 0.004, 0, 0.004}, large[6] = {0.001, 0, 0, 0.08, 0, 0.08};
  const double middle[6] = {0.001, 0, 0, 0.03, 0, 0.03};
  /* Joints may come before their links. */
  add_joint(builder, "crank_hinge", "ground", "crank", 0.0, 0.0);
  OK(percuss_builder_link(builder, "ground", 0.0, NULL, NULL));
  OK(percuss_builder_link(builder, "crank", 1.0, crank, small));
  OK(percuss_builder_link(builder, "coupler", 2.0, coupler, large));
  OK(percuss_builder_link(builder, "rocker", 1.5, rocker, middle));
  add_joint(builder, "coupler_hinge", "crank", "coupler", 0.2, 0.7);
  add_joint(builder, "rocker_hinge", "ground", "rocker", 0.6, 1.4);
  percuss_closure_description pin;
  OK(percuss_closure_description_init(&pin));
  pin.name = "pin";
  pin.predecessor = "coupler";
  pin.successor = "rocker";
  pin.predecessor_position[0] = 0.7;
  pin.successor_position[0] = 0.5;
  pin.axis[0] = 0.0;
  pin.axis[2] = 1.0;
  OK(percuss_builder_closure(builder, &pin));
  return builder;
}

static percuss_pose *pose_of(const percuss_model *model, const char *driver, double angle)
{
  percuss_system *system = NULL;
  percuss_configuration *configuration = NULL;
  percuss_pose *pose = NULL;
  OK(percuss_system_new(model, NULL, &system));
  OK(percuss_configuration_new(model, &configuration));
  OK(percuss_configuration_set(configuration, driver, &angle, 1));
  OK(percuss_pose_new(system, configuration, &pose));
  OK(percuss_configuration_free(&configuration));
  OK(percuss_system_free(&system));
  return pose;
}

static double mass_at(const percuss_model *model, const percuss_pose *pose, const char *link, const double *point, const double *normal,
                      double *error)
{
  percuss_contact contact;
  percuss_mass mass;
  OK(percuss_contact_init(&contact));
  OK(percuss_model_find_link(model, link, &contact.link));
  memcpy(contact.point, point, sizeof contact.point);
  memcpy(contact.normal, normal, sizeof contact.normal);
  OK(percuss_pose_effective_mass(pose, &contact, PERCUSS_ROUTE_AUTO, &mass));
  CHECK(mass.outcome == PERCUSS_FINITE);
  *error = mass.error;
  return mass.effective_mass;
}

static void the_four_bar(void)
{
  percuss_builder *builder = four_bar();
  percuss_model *built = NULL, *read = loaded(FOUR_BAR);
  OK(percuss_builder_model(builder, &built));
  const double point[3] = {0.35, 0.1, 0}, normal[3] = {0, 1, 0};
  for (int k = 0; k < 8; k++) {
    percuss_pose *first = pose_of(built, "crank_hinge", 0.1 * k), *second = pose_of(read, "crank_hinge", 0.1 * k);
    double e, f;
    const double a = mass_at(built, first, "coupler", point, normal, &e), b = mass_at(read, second, "coupler", point, normal, &f);
    /* The quaternions of the frames are rounded differently. */
    CHECK(fabs(a - b) <= e + f + 1e-12 * b);
    percuss_pose_state state;
    OK(percuss_pose_describe(first, &state));
    CHECK(state.degrees_of_freedom == 1 && state.rank == 2 && state.is_singular == 0 && state.rank_is_clear == 1);
    /* The loop is open as drawn. */
    CHECK(state.remarks == PERCUSS_REMARK_DRAWN_OPEN && state.rank_gap > 1e3);
    CHECK(state.closure_residual >= 0.0 && state.closure_residual < 1e-13);
    OK(percuss_pose_free(&first));
    OK(percuss_pose_free(&second));
  }
  /* The builder stays usable: a link without a joint to the others is a second root. */
  OK(percuss_builder_link(builder, "loose", 1.0, NULL, NULL));
  percuss_model *broken = NULL;
  FAILS(percuss_builder_model(builder, &broken), PERCUSS_ERROR_LOAD, "loose");
  CHECK(broken == NULL);
  OK(percuss_builder_free(&builder));
  OK(percuss_builder_free(&builder));
  OK(percuss_model_free(&built));
  OK(percuss_model_free(&read));
}

static void the_map(void)
{
  enum { COUNT_OF_CONTACTS = 200 };
  percuss_model *model = loaded(FOUR_BAR);
  percuss_pose *pose = pose_of(model, "crank_hinge", 0.4);
  static double points[3 * COUNT_OF_CONTACTS], normals[3 * COUNT_OF_CONTACTS], masses[COUNT_OF_CONTACTS], errors[COUNT_OF_CONTACTS];
  static percuss_outcome outcomes[COUNT_OF_CONTACTS];
  size_t coupler;
  OK(percuss_model_find_link(model, "coupler", &coupler));
  for (int k = 0; k < COUNT_OF_CONTACTS; k++) {
    points[3 * k] = 0.003 * k;
    points[3 * k + 1] = 0.1 * sin(k);
    normals[3 * k] = cos(0.7 * k);
    normals[3 * k + 1] = 2.0 * sin(0.7 * k);
  }
  /* Across the plane nothing moves. */
  normals[0] = normals[1] = 0.0;
  normals[2] = 1.0;
  OK(percuss_pose_contact_map(pose, coupler, PERCUSS_GROUND, points, normals, COUNT_OF_CONTACTS, outcomes, masses, errors));
  CHECK(outcomes[0] == PERCUSS_IMMOVABLE && isnan(masses[0]) && isnan(errors[0]));
  for (int k = 1; k < COUNT_OF_CONTACTS; k++) {
    double error;
    const double expected = mass_at(model, pose, "coupler", points + 3 * k, normals + 3 * k, &error);
    CHECK(outcomes[k] == PERCUSS_FINITE && fabs(masses[k] - expected) <= errors[k] + error);
    CHECK(errors[k] <= 1e-6 * masses[k]);
  }
  /* Against another link, and without errors. */
  size_t rocker;
  OK(percuss_model_find_link(model, "rocker", &rocker));
  OK(percuss_pose_contact_map(pose, coupler, rocker, points + 3, normals + 3, 1, outcomes, masses, NULL));
  CHECK(outcomes[0] == PERCUSS_FINITE && masses[0] > 0.0);
  OK(percuss_pose_contact_map(pose, coupler, PERCUSS_GROUND, NULL, NULL, 0, NULL, NULL, NULL));
  FAILS(percuss_pose_contact_map(pose, 99, PERCUSS_GROUND, points, normals, 1, outcomes, masses, NULL), PERCUSS_ERROR_NAME, "99");
  FAILS(percuss_pose_contact_map(pose, coupler, 98, points, normals, 1, outcomes, masses, NULL), PERCUSS_ERROR_NAME, "98");
  FAILS(percuss_pose_contact_map(pose, coupler, PERCUSS_GROUND, NULL, normals, 1, outcomes, masses, NULL), PERCUSS_ERROR_NULL, "points");
  FAILS(percuss_pose_contact_map(pose, coupler, PERCUSS_GROUND, points, normals, 1, outcomes, points, NULL), PERCUSS_ERROR_OVERLAP,
        "effective_masses");
  FAILS(percuss_pose_contact_map(pose, coupler, PERCUSS_GROUND, points, normals, SIZE_MAX, outcomes, masses, NULL), PERCUSS_ERROR_LENGTH,
        "count");
  points[4] = NAN;
  FAILS(percuss_pose_contact_map(pose, coupler, PERCUSS_GROUND, points, normals, 2, outcomes, masses, NULL), PERCUSS_ERROR_ARGUMENT,
        "points[1][1]");
  points[4] = 0.0;
  normals[3] = normals[4] = 0.0;
  FAILS(percuss_pose_contact_map(pose, coupler, PERCUSS_GROUND, points, normals, 2, outcomes, masses, NULL), PERCUSS_ERROR_ARGUMENT,
        "normals[1]");
  OK(percuss_pose_free(&pose));
  OK(percuss_model_free(&model));
}

/* Limits, armature, a mimic, and the errors of descriptions. */
static void descriptions(void)
{
  percuss_builder *builder = NULL;
  OK(percuss_builder_new("arm", &builder));
  OK(percuss_builder_link(builder, "ground", 0.0, NULL, NULL));
  const double com[3] = {0.5, 0, 0};
  OK(percuss_builder_link(builder, "first", 2.0, com, NULL));
  OK(percuss_builder_link(builder, "second", 2.0, com, NULL));
  percuss_joint_description joint;
  OK(percuss_joint_description_init(&joint));
  joint.name = "shoulder";
  joint.parent = "ground";
  joint.child = "first";
  joint.axis[0] = 0.0;
  joint.axis[2] = 1.0;
  joint.lower = -1.0;
  FAILS(percuss_builder_joint(builder, &joint), PERCUSS_ERROR_ARGUMENT, "one limit");
  joint.upper = 2.0;
  joint.armature_count = 7;
  FAILS(percuss_builder_joint(builder, &joint), PERCUSS_ERROR_ARGUMENT, "armature_count");
  joint.armature_count = 1;
  joint.armature[0] = 0.25;
  joint.quaternion[0] = 2.0;
  FAILS(percuss_builder_joint(builder, &joint), PERCUSS_ERROR_ARGUMENT, "shoulder");
  joint.quaternion[0] = 1.0;
  joint.kind = 12;
  FAILS(percuss_builder_joint(builder, &joint), PERCUSS_ERROR_ARGUMENT, "kind");
  joint.kind = PERCUSS_REVOLUTE;
  OK(percuss_builder_joint(builder, &joint));
  joint.name = "elbow";
  joint.parent = "first";
  joint.child = "second";
  joint.position[0] = 1.0;
  joint.armature_count = 0;
  joint.mimics = "shoulder";
  joint.multiplier = -2.0;
  OK(percuss_builder_joint(builder, &joint));
  joint.name = NOTHING;
  FAILS(percuss_builder_joint(builder, &joint), PERCUSS_ERROR_NULL, "name");
  FAILS(percuss_builder_joint(builder, NULL), PERCUSS_ERROR_NULL, "description");
  percuss_model *model = NULL;
  OK(percuss_builder_model(builder, &model));
  percuss_joint read;
  size_t number;
  OK(percuss_model_find_joint(model, "shoulder", &number));
  OK(percuss_model_joint(model, number, &read));
  CHECK(read.has_limits == 1 && read.lower == -1.0 && read.upper == 2.0 && read.kind == PERCUSS_REVOLUTE);
  /* One coordinate q: elbow −2 q. At q = 0 the points of mass move at 0.5 and 1 − 0.5 = 0.5: m = (2 + 2) 0.25 + 0.25 = 1.25 kg·m². The tip
     of the second link moves at 1 − 1 = 0, its root at 1. */
  percuss_pose *pose = pose_of(model, "shoulder", 0.0);
  const double root[3] = {0, 0, 0}, normal[3] = {0, 1, 0};
  double error;
  CHECK(near_to(mass_at(model, pose, "second", root, normal, &error), 1.25, 1e-14));
  percuss_pose *outside = pose_of(model, "shoulder", 2.5);
  percuss_pose_state state;
  OK(percuss_pose_describe(outside, &state));
  CHECK(state.remarks & PERCUSS_REMARK_OUTSIDE_LIMITS && isnan(state.closure_residual) && isnan(state.rank_gap));
  OK(percuss_pose_free(&outside));
  OK(percuss_pose_free(&pose));
  OK(percuss_model_free(&model));
  /* A closure with an unknown link, and one of an unknown kind. */
  percuss_closure_description rod;
  OK(percuss_closure_description_init(&rod));
  rod.name = "rod";
  rod.kind = PERCUSS_CLOSURE_DISTANCE;
  rod.predecessor = "world";
  rod.successor = "no such link";
  OK(percuss_builder_closure(builder, &rod));
  FAILS(percuss_builder_model(builder, &model), PERCUSS_ERROR_LOAD, "no such link");
  rod.kind = -1;
  FAILS(percuss_builder_closure(builder, &rod), PERCUSS_ERROR_ARGUMENT, "kind");
  OK(percuss_builder_free(&builder));
  FAILS(percuss_builder_new("\xff", &builder), PERCUSS_ERROR_TEXT, "name");
  FAILS(percuss_builder_link(NULL, "a", 1.0, NULL, NULL), PERCUSS_ERROR_NULL, "percuss_builder");
  percuss_model *other = loaded(PENDULUM);
  FAILS(percuss_builder_link((percuss_builder *)other, "a", 1.0, NULL, NULL), PERCUSS_ERROR_HANDLE, "percuss_builder");
  OK(percuss_model_free(&other));
}

int main(void)
{
  the_four_bar();
  the_map();
  descriptions();
  puts("every built model agrees");
  return 0;
}
