/* Misuse returns an error code and a message, never a crash: null, wrong lengths, wrong handles, values out of
   range. */
#include "check.h"

static void nulls(void)
{
  percuss_model *model = loaded(PENDULUM);
  percuss_system *system = NULL;
  percuss_assembly *assembly = NULL;
  percuss_configuration *configuration = NULL;
  percuss_conditions *conditions = NULL;
  percuss_pose *pose = NULL;
  percuss_workspace *workspace = NULL;
  percuss_batch *batch = NULL;
  percuss_response *response = NULL;
  percuss_contact contact;
  percuss_mass mass;
  percuss_outcome outcome;
  const double angle = 0.0;
  double value = 0.0;
  size_t count;
  OK(percuss_contact_init(&contact));
  contact.link = 1;
  contact.normal[2] = 1.0;
  OK(percuss_system_new(model, NULL, &system));
  OK(percuss_assembly_new(system, NULL, &assembly));
  OK(percuss_configuration_new(model, &configuration));
  OK(percuss_conditions_new(&conditions));
  OK(percuss_pose_new(system, configuration, &pose));
  OK(percuss_workspace_new(assembly, &workspace));
  OK(percuss_batch_new(assembly, &contact, 1, &batch));
  OK(percuss_pose_respond(pose, &contact, PERCUSS_ROUTE_AUTO, &response));

  const percuss_status null = PERCUSS_ERROR_NULL;
  percuss_model *no_model = NULL;
  FAILS(percuss_model_load_file(NULL, &no_model), null, "path");
  FAILS(percuss_model_load_file("x.urdf", NULL), null, "handle");
  FAILS(percuss_model_load_memory(NULL, "", 0, &no_model), null, "name");
  FAILS(percuss_model_load_memory("x", NULL, 7, &no_model), null, "bytes");
  FAILS(percuss_model_free(NULL), null, "handle");
  FAILS(percuss_model_counts(NULL, &count, NULL, NULL, NULL), null, "percuss_model");
  FAILS(percuss_model_find_link(model, NULL, &count), null, "name");
  FAILS(percuss_model_find_link(model, "rod", NULL), null, "index");
  FAILS(percuss_model_link_name(model, 0, NULL), null, "name");
  FAILS(percuss_model_joint(model, 0, NULL), null, "joint");
  FAILS(percuss_model_diagnostic_count(model, NULL), null, "count");
  FAILS(percuss_model_diagnostic(model, 0, NULL), null, "diagnostic");
  FAILS(percuss_pose_diagnostic_count(NULL, &count), null, "percuss_pose");
  FAILS(percuss_contact_init(NULL), null, "contact");
  OK(percuss_system_free(&system));
  FAILS(percuss_system_new(NULL, NULL, &system), null, "percuss_model");
  CHECK(system == NULL);
  OK(percuss_system_new(model, NULL, &system));
  FAILS(percuss_system_new(model, NULL, NULL), null, "handle");
  FAILS(percuss_system_coordinates(system, NULL), null, "coordinates");
  FAILS(percuss_conditions_lock(conditions, NULL), null, "joint");
  FAILS(percuss_conditions_lock(NULL, "hinge"), null, "percuss_conditions");
  FAILS(percuss_conditions_armature(conditions, "hinge", NULL, 1), null, "values");
  FAILS(percuss_conditions_hold(conditions, "rod", NULL, NULL), null, "point");
  FAILS(percuss_configuration_set(configuration, "hinge", NULL, 1), null, "values");
  FAILS(percuss_configuration_set_positions(configuration, NULL, 1), null, "positions");
  FAILS(percuss_configuration_set_base(configuration, NULL, &value), null, "position");
  FAILS(percuss_pose_new(system, NULL, &(percuss_pose *){NULL}), null, "configuration");
  FAILS(percuss_pose_positions(pose, NULL, 1), null, "positions");
  FAILS(percuss_pose_effective_mass(pose, NULL, 0, &mass), null, "contact");
  FAILS(percuss_pose_effective_mass(pose, &contact, 0, NULL), null, "mass");
  FAILS(percuss_pose_effective_mass(NULL, &contact, 0, &mass), null, "percuss_pose");
  FAILS(percuss_pose_mass_matrix(pose, NULL, 1, PERCUSS_ROW_MAJOR, 1), null, "values");
  FAILS(percuss_pose_contact_row(pose, &contact, NULL, 1), null, "values");
  FAILS(percuss_response_mass(response, NULL), null, "mass");
  FAILS(percuss_response_velocities(response, NULL, 1), null, "velocities");
  FAILS(percuss_response_base_velocity(response, NULL), null, "twist");
  FAILS(percuss_workspace_effective_mass(workspace, &angle, 1, NULL, &outcome, &value, NULL), null, "contact");
  FAILS(percuss_workspace_effective_mass(workspace, &angle, 1, &contact, NULL, &value, NULL), null, "outcome");
  FAILS(percuss_workspace_effective_mass(workspace, &angle, 1, &contact, &outcome, NULL, NULL), null, "effective_mass");
  FAILS(percuss_batch_run(batch, NULL, 1, PERCUSS_ROW_MAJOR, 1, 1, &outcome, &value, NULL, NULL, NULL, NULL), null,
        "positions");
  FAILS(percuss_batch_run(batch, &angle, 1, PERCUSS_ROW_MAJOR, 1, 1, NULL, &value, NULL, NULL, NULL, NULL), null,
        "outcomes");
  FAILS(percuss_law_name(0, NULL), null, "name");
  FAILS(percuss_law_find(NULL, NULL), null, "name");
  FAILS(percuss_law_damper(0, NULL, 0.5, 1.0, 0, NULL), null, "spring");
  FAILS(percuss_damper_restitution(NULL, NULL, 1.0, &value), null, "spring");
  FAILS(percuss_damper_impact(NULL, NULL, 1.0, NULL), null, "spring");
  FAILS(percuss_matrix_options_init(NULL), null, "options");
  FAILS(percuss_effective_mass(NULL, &value, 1, NULL, NULL, &mass, NULL, NULL, NULL), null, "mass");

  /* A handle of another type. */
  const percuss_status handle = PERCUSS_ERROR_HANDLE;
  FAILS(percuss_system_coordinates((const percuss_system *)(const void *)model, &count), handle, "percuss_system");
  FAILS(percuss_pose_positions((const percuss_pose *)(const void *)response, &value, 1), handle, "percuss_pose");
  percuss_system *wrong = (percuss_system *)(void *)model;
  FAILS(percuss_system_free(&wrong), handle, "percuss_system");
  /* A misaligned handle. */
  FAILS(percuss_system_coordinates((const percuss_system *)(const void *)((const char *)system + 1), &count), null,
        "aligned");

  /* Lengths. */
  const percuss_status length = PERCUSS_ERROR_LENGTH;
  double values[4] = {0.0, 0.0, 0.0, 0.0};
  FAILS(percuss_configuration_set(configuration, "hinge", values, 2), PERCUSS_ERROR_CONDITIONS, "2 values");
  FAILS(percuss_configuration_set(configuration, "hinge", values, 0), PERCUSS_ERROR_CONDITIONS, "0 values");
  FAILS(percuss_configuration_set_positions(configuration, values, 2), PERCUSS_ERROR_CONDITIONS, "2 positions");
  FAILS(percuss_pose_positions(pose, values, 0), length, "expected 1");
  FAILS(percuss_pose_positions(pose, values, 2), length, "expected 1");
  FAILS(percuss_pose_mass_matrix(pose, values, 0, PERCUSS_ROW_MAJOR, 1), length, "room for 0");
  FAILS(percuss_pose_mass_matrix(pose, values, 1, PERCUSS_ROW_MAJOR, 0), length, "leading dimension");
  FAILS(percuss_pose_contact_row(pose, &contact, values, 2), length, "expected 1");
  FAILS(percuss_response_velocities(response, values, 2), length, "expected 1");
  FAILS(percuss_workspace_effective_mass(workspace, values, 2, &contact, &outcome, &value, NULL), length, "positions");
  FAILS(percuss_batch_run(batch, values, 1, PERCUSS_ROW_MAJOR, 0, 1, &outcome, &value, NULL, NULL, NULL, NULL), length,
        "stride");
  FAILS(percuss_batch_run(batch, values, 0, PERCUSS_ROW_MAJOR, 1, 1, &outcome, &value, NULL, NULL, NULL, NULL), length,
        "positions");
  FAILS(percuss_batch_run(batch, values, 4, PERCUSS_ROW_MAJOR, (size_t)-1, 2, (percuss_outcome[2]){0},
                          (double[2]){0}, NULL, NULL, NULL, NULL),
        length, "positions");
  OK(percuss_batch_run(batch, NULL, 0, PERCUSS_ROW_MAJOR, 1, 0, NULL, NULL, NULL, NULL, NULL, NULL));
  percuss_matrix one = {values, 4, 2, 2, 1, PERCUSS_COLUMN_MAJOR, 0};
  FAILS(percuss_effective_mass(&one, values, 2, NULL, NULL, &mass, NULL, NULL, NULL), length, "leading dimension");
  one.leading_dimension = 3;
  FAILS(percuss_effective_mass(&one, values, 2, NULL, NULL, &mass, NULL, NULL, NULL), length, "of 4");
  one.leading_dimension = 2;
  FAILS(percuss_effective_mass(&one, values, 3, NULL, NULL, &mass, NULL, NULL, NULL), length, "expected 2");
  one.length = (size_t)-1;
  FAILS(percuss_effective_mass(&one, values, 2, NULL, NULL, &mass, NULL, NULL, NULL), length, "any memory");

  /* Values. */
  const percuss_status argument = PERCUSS_ERROR_ARGUMENT;
  FAILS(percuss_conditions_base(conditions, 2), argument, "base is 2");
  FAILS(percuss_pose_effective_mass(pose, &contact, 3, &mass), argument, "route is 3");
  FAILS(percuss_pose_mass_matrix(pose, values, 1, 2, 1), argument, "layout is 2");
  FAILS(percuss_batch_new(assembly, &contact, 5000, &(percuss_batch *){NULL}), argument, "5000");
  const double nan = NAN;
  FAILS(percuss_configuration_set(configuration, "hinge", &nan, 1), PERCUSS_ERROR_CONDITIONS, "finite");
  FAILS(percuss_workspace_effective_mass(workspace, &nan, 1, &contact, &outcome, &value, NULL), argument, "position 0");
  OK(percuss_batch_run(batch, &nan, 1, PERCUSS_ROW_MAJOR, 1, 1, &outcome, &value, NULL, NULL, NULL, NULL));
  CHECK(outcome == PERCUSS_NO_ANSWER && isnan(value));
  const double quaternion[4] = {2.0, 0.0, 0.0, 0.0};
  FAILS(percuss_configuration_set_base(configuration, values, quaternion), argument, "norm 2");
  contact.normal_given = 9;
  FAILS(percuss_pose_effective_mass(pose, &contact, 0, &mass), argument, "normal_given");
  contact.normal_given = PERCUSS_NORMAL_TOWARD;
  contact.toward = 9;
  FAILS(percuss_pose_effective_mass(pose, &contact, 0, &mass), PERCUSS_ERROR_NAME, "link number 9");
  OK(percuss_contact_init(&contact));
  contact.normal[2] = 1.0;
  contact.link = 2;
  FAILS(percuss_pose_effective_mass(pose, &contact, 0, &mass), PERCUSS_ERROR_NAME, "link number 2");
  contact.link = 1;
  contact.against = 1;
  FAILS(percuss_pose_effective_mass(pose, &contact, 0, &mass), PERCUSS_ERROR_CONTACT, "itself");
  contact.against = PERCUSS_GROUND;
  contact.point[1] = nan;
  FAILS(percuss_pose_effective_mass(pose, &contact, 0, &mass), PERCUSS_ERROR_CONTACT, "point");
  double bad[4] = {1.0, 0.5, 0.0, 1.0};
  const percuss_matrix skew = {bad, 4, 2, 2, 2, PERCUSS_ROW_MAJOR, 0};
  FAILS(percuss_effective_mass(&skew, values, 2, NULL, NULL, &mass, NULL, NULL, NULL), PERCUSS_ERROR_MATRIX,
        "mirror");
  bad[2] = nan;
  FAILS(percuss_effective_mass(&skew, values, 2, NULL, NULL, &mass, NULL, NULL, NULL), argument, "NaN");
  bad[1] = bad[2] = 3.0;
  FAILS(percuss_effective_mass(&skew, values, 2, NULL, NULL, &mass, NULL, NULL, NULL), PERCUSS_ERROR_MATRIX,
        "indefinite");

  /* Files and texts. */
  FAILS(percuss_model_load_file("there/is/no/such.urdf", &no_model), PERCUSS_ERROR_LOAD, "there/is/no/such.urdf");
  CHECK(no_model == NULL);
  FAILS(percuss_model_load_file("-", &no_model), PERCUSS_ERROR_LOAD, "name of a file");
  FAILS(percuss_model_load_memory("x.urdf", "<robot", 6, &no_model), PERCUSS_ERROR_LOAD, "x.urdf:1");
  FAILS(percuss_model_load_memory("x.urdf", "\xff\xfe", 2, &no_model), PERCUSS_ERROR_TEXT, "byte 0");
  FAILS(percuss_model_find_link(model, "\xff", &count), PERCUSS_ERROR_TEXT, "UTF-8");

  /* A configuration of another model; a message stays until the next failure. */
  percuss_model *other = loaded(FOUR_BAR);
  percuss_configuration *foreign = NULL;
  OK(percuss_configuration_new(other, &foreign));
  percuss_pose *no_pose = NULL;
  FAILS(percuss_pose_new(system, foreign, &no_pose), PERCUSS_ERROR_CONDITIONS, "four_bar");
  CHECK(no_pose == NULL);
  OK(percuss_configuration_free(&foreign));
  OK(percuss_model_free(&other));
  CHECK(strstr(percuss_error_message(), "four_bar") != NULL);

  /* Freed handles are null, and a null handle is an error. */
  OK(percuss_response_free(&response));
  FAILS(percuss_response_mass(response, &mass), null, "percuss_response");
  OK(percuss_batch_free(&batch));
  OK(percuss_workspace_free(&workspace));
  FAILS(percuss_workspace_effective_mass(workspace, values, 1, &contact, &outcome, &value, NULL), null, "workspace");
  OK(percuss_pose_free(&pose));
  OK(percuss_conditions_free(&conditions));
  OK(percuss_configuration_free(&configuration));
  OK(percuss_assembly_free(&assembly));
  OK(percuss_system_free(&system));
  OK(percuss_model_free(&model));
}

int main(void)
{
  nulls();
  puts("every misuse was noticed");
  return 0;
}
