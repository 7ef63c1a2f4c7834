/* Poses at the touch of a stop, with the remarks about open gaps and positions in degrees; positions of MuJoCo; requests. */
#include "check.h"

/* Positions of MuJoCo: the frame of the free body is that of qpos in the world, and a hinge has turned by qpos minus ref. */
static void positions_of_mujoco(void)
{
  const char text[] = "<mujoco><compiler angle=\"degree\"/><worldbody><body name=\"ball\" pos=\"1 2 3\" euler=\"10 20 30\"><freejoint/>"
                      "<inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"1 1 1\"/></body><body name=\"arm\"><joint name=\"hinge\" "
                      "axis=\"0 0 1\" ref=\"30\"/><inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"1 1 1\"/></body></worldbody></mujoco>";
  const double degree = acos(-1.0) / 180.0, qpos[8] = {-4.0, 5.0, 0.5, 0.5, -0.5, 0.5, 0.5, 75.0 * degree};
  /* Rotation of the quaternion (1, -1, 1, 1)/2, row by row: by 120 degrees about (-1, 1, 1). */
  const double turned[9] = {0, -1, 0, 0, 0, 1, -1, 0, 0};
  double q[8], rotation[9], origin[3], wrong[8];
  percuss_model *model = loaded(text);
  percuss_system *system = NULL;
  percuss_configuration *configuration = NULL;
  percuss_pose *pose = NULL;
  size_t ball, arm;
  OK(percuss_model_find_link(model, "ball", &ball));
  OK(percuss_model_find_link(model, "arm", &arm));
  OK(percuss_model_positions_of_qpos(model, qpos, 8, q, 8));
  OK(percuss_system_new(model, NULL, &system));
  OK(percuss_configuration_new(model, &configuration));
  OK(percuss_configuration_set_positions(configuration, q, 8));
  OK(percuss_pose_new(system, configuration, &pose));
  OK(percuss_pose_link_frame(pose, ball, rotation, origin));
  for (int k = 0; k < 9; k++) CHECK(fabs(rotation[k] - turned[k]) < 1e-14);
  for (int k = 0; k < 3; k++) CHECK(fabs(origin[k] - qpos[k]) < 1e-14);
  OK(percuss_pose_link_frame(pose, arm, rotation, origin));
  CHECK(fabs(atan2(rotation[3], rotation[0]) - 45.0 * degree) < 1e-14);
  FAILS(percuss_model_positions_of_qpos(model, qpos, 7, q, 8), PERCUSS_ERROR_LENGTH, "8");
  FAILS(percuss_model_positions_of_qpos(model, qpos, 8, q, 7), PERCUSS_ERROR_LENGTH, "8");
  FAILS(percuss_model_positions_of_qpos(model, q, 8, q, 8), PERCUSS_ERROR_OVERLAP, "qpos");
  for (int k = 0; k < 8; k++) wrong[k] = 0.0;
  FAILS(percuss_model_positions_of_qpos(model, wrong, 8, q, 8), PERCUSS_ERROR_ARGUMENT, "quaternion");
  wrong[0] = NAN;
  FAILS(percuss_model_positions_of_qpos(model, wrong, 8, q, 8), PERCUSS_ERROR_ARGUMENT, "qpos[0]");
  OK(percuss_pose_free(&pose));
  OK(percuss_configuration_free(&configuration));
  OK(percuss_system_free(&system));
  OK(percuss_model_free(&model));
  model = loaded(PENDULUM);
  FAILS(percuss_model_positions_of_qpos(model, qpos, 1, q, 1), PERCUSS_ERROR_ARGUMENT, "MJCF");
  OK(percuss_model_free(&model));
}

/* Findings about the path to the touch: none for a short way; the gap that stays open. */
static void path_to_the_touch(percuss_model *model)
{
  percuss_system *system = NULL;
  const double closed = 0.0;
  percuss_configuration *configuration = NULL;
  percuss_pose *pose = NULL;
  percuss_contact stop;
  percuss_diagnostic diagnostic;
  size_t count = 7;
  OK(percuss_system_new(model, NULL, &system));
  OK(percuss_configuration_new(model, &configuration));
  OK(percuss_pose_touch(system, configuration, "door_stop", &pose, &stop));
  OK(percuss_pose_diagnostic_count(pose, &count));
  CHECK(count == 0);
  FAILS(percuss_pose_diagnostic(pose, 0, &diagnostic), PERCUSS_ERROR_NAME, "diagnostic");
  OK(percuss_pose_free(&pose));
  /* A door whose position is set stays open: the gap is stated. */
  OK(percuss_configuration_set(configuration, "hinge", &closed, 1));
  OK(percuss_pose_touch(system, configuration, "door_stop", &pose, &stop));
  OK(percuss_pose_diagnostic_count(pose, &count));
  int is_open = 0;
  for (size_t i = 0; i < count; i++) {
    OK(percuss_pose_diagnostic(pose, i, &diagnostic));
    is_open += strcmp(diagnostic.code, "open-gap") == 0 && strstr(diagnostic.message, "20.0000 mm open") != NULL;
  }
  CHECK(is_open == 1);
  OK(percuss_pose_free(&pose));
  OK(percuss_pose_new(system, configuration, &pose));
  OK(percuss_pose_diagnostic_count(pose, &count));
  CHECK(count == 0);
  OK(percuss_pose_free(&pose));
  OK(percuss_configuration_free(&configuration));
  OK(percuss_system_free(&system));
}

/* The stop of a door of 1 kg m2, 0.7 m from its hinge: it touches where sin(angle) = 0.02 / 0.7, at any other pose its gap is open. The
   limits of the hinge are -0.5 and 1.5. */
static void touch_of_a_door(percuss_model *model)
{
  const double opened[4] = {0.0, asin(0.02 / 0.7), 0.5, 20.0};
  const uint32_t expected[4] = {PERCUSS_REMARK_OPEN_GAP, 0, 0, PERCUSS_REMARK_OUTSIDE_LIMITS | PERCUSS_REMARK_MANY_TURNS};
  percuss_system *system = NULL;
  percuss_configuration *configuration = NULL;
  percuss_pose *pose = NULL;
  percuss_assembly *assembly = NULL;
  percuss_workspace *workspace = NULL;
  percuss_batch *batch = NULL;
  percuss_contact stop, of_joint;
  percuss_mass mass;
  percuss_outcome outcomes[4];
  double masses[4], errors[4], angle;
  uint32_t remarks[4];
  OK(percuss_system_new(model, NULL, &system));
  OK(percuss_configuration_new(model, &configuration));
  OK(percuss_pose_touch(system, configuration, "door_stop", &pose, &stop));
  OK(percuss_pose_positions(pose, &angle, 1));
  OK(percuss_pose_effective_mass(pose, &stop, PERCUSS_ROUTE_AUTO, &mass));
  CHECK(near_to(angle, opened[1], 1e-9) && near_to(mass.effective_mass, 1.0 / (0.49 - 0.0004), 1e-9) && mass.remarks == 0);
  OK(percuss_pose_free(&pose));
  OK(percuss_pose_touch(system, configuration, "hinge:upper", &pose, &of_joint));
  OK(percuss_pose_positions(pose, &angle, 1));
  OK(percuss_pose_effective_mass(pose, &of_joint, PERCUSS_ROUTE_AUTO, &mass));
  CHECK(angle == 1.5 && near_to(mass.effective_mass, 1.0, 1e-14) && mass.remarks == 0);
  OK(percuss_pose_free(&pose));
  path_to_the_touch(model);
  FAILS(percuss_pose_touch(system, configuration, "doorstop", &pose, &stop), PERCUSS_ERROR_NAME, "door_stop");
  FAILS(percuss_pose_touch(system, configuration, "hinge:uper", &pose, &stop), PERCUSS_ERROR_NAME, "upper");
  FAILS(percuss_pose_touch(system, configuration, "leaf:0,0,0:1,0,0", &pose, &stop), PERCUSS_ERROR_NAME, "no stop");
  CHECK(pose == NULL);
  /* The same remarks at a pose, in a workspace and in a batch; a pose at 0 has the gap of the model. */
  OK(percuss_assembly_new(system, NULL, &assembly));
  OK(percuss_workspace_new(assembly, &workspace));
  OK(percuss_batch_new(assembly, &stop, 1, &batch));
  OK(percuss_batch_run(batch, opened, 4, PERCUSS_ROW_MAJOR, 1, 4, outcomes, masses, errors, remarks, NULL, NULL));
  for (size_t i = 0; i < 4; i++) {
    uint32_t of_workspace;
    OK(percuss_configuration_reset(configuration));
    OK(percuss_configuration_set(configuration, "hinge", &opened[i], 1));
    OK(percuss_pose_new(system, configuration, &pose));
    OK(percuss_pose_effective_mass(pose, &stop, PERCUSS_ROUTE_AUTO, &mass));
    OK(percuss_pose_free(&pose));
    OK(percuss_workspace_effective_mass(workspace, &opened[i], 1, &stop, &outcomes[0], &masses[0], &of_workspace));
    CHECK(mass.remarks == expected[i] && remarks[i] == expected[i] && of_workspace == expected[i]);
  }
  OK(percuss_batch_free(&batch));
  OK(percuss_workspace_free(&workspace));
  OK(percuss_assembly_free(&assembly));
  OK(percuss_configuration_free(&configuration));
  OK(percuss_system_free(&system));
}

/* Requests: the point mass of a pendulum at 0.8 m, m = 0.78125 kg; its impulse at e = 0.5 and 2 m/s is 1.5 * 2 * m. */
static void requests(percuss_model *model)
{
  const char contact[] = "{\"contact\": {\"link\": \"rod\", \"point\": [0, 0, -0.8], \"normal\": [1, 0, 0]}, ";
  char request[400];
  percuss_report *report = NULL;
  const char *json = NULL, *found;
  snprintf(request, sizeof request, "%s\"impact\": {\"restitution\": 0.5, \"speed\": \"2 m/s\"}}", contact);
  OK(percuss_ask(model, request, &report));
  OK(percuss_report_json(report, &json));
  found = strstr(json, "\"effective_mass\":");
  CHECK(found && fabs(strtod(found + 17, NULL) - 0.78125) < 1e-12);
  found = strstr(json, "\"impulse\":");
  CHECK(found && fabs(strtod(found + 10, NULL) - 1.5 * 2.0 * 0.78125) < 1e-12);
  OK(percuss_report_free(&report));
  snprintf(request, sizeof request, "%s\"impact\": {\"restitution\": 0.5, \"speed\": 2, \"stiffness\": -5}}", contact);
  FAILS(percuss_ask(model, request, &report), PERCUSS_ERROR_ARGUMENT, "impact.stiffness");
  CHECK(report == NULL);
  snprintf(request, sizeof request, "%s\"impakt\": {}}", contact);
  FAILS(percuss_ask(model, request, &report), PERCUSS_ERROR_ARGUMENT, "impact");
  snprintf(request, sizeof request, "%s\"sweep\": {\"vary\": \"hinge=0:1:3\", \"output\": \"rows.csv\"}}", contact);
  FAILS(percuss_ask(model, request, &report), PERCUSS_ERROR_ARGUMENT, "sweep.output");
  FAILS(percuss_ask(model, "[1]", &report), PERCUSS_ERROR_ARGUMENT, "JSON object");
  FAILS(percuss_ask(model, "{", &report), PERCUSS_ERROR_ARGUMENT, "not JSON");
}

int main(void)
{
  const char stopped[] = "<robot name=\"door\"><link name=\"wall\"/><link name=\"leaf\"><inertial><mass value=\"12\"/>"
                         "<inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>"
                         "<joint name=\"hinge\" type=\"revolute\"><parent link=\"wall\"/><child link=\"leaf\"/>"
                         "<axis xyz=\"0 0 1\"/><limit lower=\"-0.5\" upper=\"1.5\" effort=\"0\" velocity=\"0\"/></joint>"
                         "<contact name=\"door_stop\" type=\"stop\"><body link=\"leaf\" xyz=\"0.7 0 0\"/>"
                         "<other link=\"wall\"/><normal xyz=\"0 1 0\"/><gap value=\"0.02\"/></contact></robot>";
  percuss_model *model = loaded(stopped);
  touch_of_a_door(model);
  OK(percuss_model_free(&model));
  positions_of_mujoco();
  OK(percuss_model_load_file("models/point_mass_pendulum.urdf", &model));
  requests(model);
  OK(percuss_model_free(&model));
  puts("every pose was reached");
  return 0;
}
