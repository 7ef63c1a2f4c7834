/* Every function, as in an application: load, set conditions, assemble, pose, m, response, workspace, batch, laws,
   matrices. */
#include "check.h"

#include <float.h>

static void the_model(void)
{
  percuss_model *model = loaded(PENDULUM);
  size_t links, joints, positions, velocities, index;
  OK(percuss_model_counts(model, &links, &joints, &positions, &velocities));
  CHECK(links == 2 && joints == 1 && positions == 1 && velocities == 1);
  OK(percuss_model_counts(model, &links, NULL, NULL, NULL));
  OK(percuss_model_find_link(model, "rod", &index));
  CHECK(index == 1);
  const char *name = NULL;
  OK(percuss_model_link_name(model, 1, &name));
  CHECK(strcmp(name, "rod") == 0);
  OK(percuss_model_find_joint(model, "hinge", &index));
  percuss_joint joint;
  OK(percuss_model_joint(model, index, &joint));
  CHECK(strcmp(joint.name, "hinge") == 0 && joint.kind == PERCUSS_CONTINUOUS && !joint.has_limits);
  CHECK(joint.positions == 1 && joint.velocities == 1 && joint.first_position == 0 && joint.parent == 0);
  CHECK(joint.child == 1 && isnan(joint.lower));
  FAILS(percuss_model_find_link(model, "rodd", &index), PERCUSS_ERROR_NAME, "rod");
  FAILS(percuss_model_joint(model, 1, &joint), PERCUSS_ERROR_NAME, "joint");
  OK(percuss_model_free(&model));
  CHECK(model == NULL);
  OK(percuss_model_free(&model));
  /* Named contacts. */
  const char stopped[] = "<robot name=\"door\"><link name=\"wall\"/><link name=\"leaf\"><inertial><mass value=\"12\"/>"
                         "<inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>"
                         "<joint name=\"hinge\" type=\"revolute\"><parent link=\"wall\"/><child link=\"leaf\"/>"
                         "<axis xyz=\"0 0 1\"/><limit lower=\"-0.5\" upper=\"1.5\" effort=\"0\" velocity=\"0\"/></joint>"
                         "<contact name=\"door_stop\" type=\"stop\"><body link=\"leaf\" xyz=\"0.7 0 0\"/>"
                         "<other link=\"wall\"/><normal xyz=\"0 1 0\"/><gap value=\"0.02\"/></contact></robot>";
  model = loaded(stopped);
  percuss_contact contact;
  double gap = -1.0;
  OK(percuss_model_find_contact(model, "door_stop", &contact, &gap));
  CHECK(gap == 0.02 && contact.link == 1 && contact.against == 0 && contact.point[0] == 0.7);
  CHECK(contact.normal_given == PERCUSS_NORMAL_AGAINST && contact.normal[1] == 1.0);
  OK(percuss_model_find_contact(model, "door_stop", &contact, NULL));
  FAILS(percuss_model_find_contact(model, "doorstop", &contact, &gap), PERCUSS_ERROR_NAME, "door_stop");
  OK(percuss_model_free(&model));
  /* Named poses, in a model of another format. */
  const char keyed[] = "<mujoco><compiler angle=\"radian\"/><worldbody><body name=\"bar\"><joint name=\"hinge\" axis=\"0 0 1\"/>"
                       "<joint name=\"slide\" type=\"slide\" axis=\"1 0 0\"/><inertial pos=\"1 0 0\" mass=\"2\" "
                       "diaginertia=\"1 1 1\"/></body></worldbody><keyframe><key name=\"home\" qpos=\"0.3 -0.2\"/>"
                       "<key name=\"away\" qpos=\"1 2\"/></keyframe></mujoco>";
  model = loaded(keyed);
  size_t poses;
  const char *pose_name;
  double at_home[2] = {9.0, 9.0};
  OK(percuss_model_pose_count(model, &poses));
  OK(percuss_model_pose_name(model, 0, &pose_name));
  CHECK(poses == 2 && strcmp(pose_name, "home") == 0);
  OK(percuss_model_pose_positions(model, "home", at_home, 2));
  CHECK(at_home[0] == 0.3 && at_home[1] == -0.2);
  FAILS(percuss_model_pose_positions(model, "house", at_home, 2), PERCUSS_ERROR_NAME, "home, away");
  FAILS(percuss_model_pose_positions(model, "home", at_home, 1), PERCUSS_ERROR_LENGTH, "positions");
  FAILS(percuss_model_pose_name(model, 2, &pose_name), PERCUSS_ERROR_NAME, "named pose");
  CHECK(pose_name == NULL);
  OK(percuss_model_free(&model));
  /* Findings about a file. */
  const char odd[] = "<robot name=\"odd\"><link name=\"a\"/><unknown_thing/></robot>";
  model = loaded(odd);
  size_t count;
  OK(percuss_model_diagnostic_count(model, &count));
  CHECK(count >= 1);
  percuss_diagnostic diagnostic;
  OK(percuss_model_diagnostic(model, 0, &diagnostic));
  CHECK(diagnostic.line == 1 && strlen(diagnostic.message) > 0 && strlen(diagnostic.code) > 0);
  CHECK(strcmp(diagnostic.path, "text.urdf") == 0);
  OK(percuss_model_free(&model));
}

static percuss_contact contact_of(const percuss_model *model, const char *link, double x, double y, double z)
{
  percuss_contact contact;
  OK(percuss_contact_init(&contact));
  OK(percuss_model_find_link(model, link, &contact.link));
  contact.normal[2] = 1.0;
  contact.point[0] = x;
  contact.point[1] = y;
  contact.point[2] = z;
  return contact;
}

static void the_pendulum(void)
{
  percuss_model *model = loaded(PENDULUM);
  percuss_system *system = NULL;
  percuss_assembly *assembly = NULL;
  percuss_configuration *configuration = NULL;
  percuss_pose *pose = NULL;
  percuss_response *response = NULL;
  OK(percuss_system_new(model, NULL, &system));
  OK(percuss_assembly_new(system, NULL, &assembly));
  OK(percuss_configuration_new(model, &configuration));
  percuss_contact contact = contact_of(model, "rod", 0.0, 0.0, -0.8);
  contact.normal[0] = 1.0;
  contact.normal[2] = 0.0;
  /* Objects made from the model stay valid. */
  OK(percuss_model_free(&model));
  const double angle = 0.3;
  OK(percuss_configuration_set(configuration, "hinge", &angle, 1));
  OK(percuss_pose_new(system, configuration, &pose));
  percuss_mass mass;
  OK(percuss_pose_effective_mass(pose, &contact, PERCUSS_ROUTE_AUTO, &mass));
  CHECK(mass.outcome == PERCUSS_FINITE && mass.degrees_of_freedom == 1 && mass.error > 0.0);
  CHECK(fabs(mass.effective_mass - 0.78125) <= mass.error && mass.error < 1e-12);
  OK(percuss_pose_respond(pose, &contact, PERCUSS_ROUTE_DENSE, &response));
  percuss_mass again;
  OK(percuss_response_mass(response, &again));
  CHECK(again.route == PERCUSS_ROUTE_DENSE && near_to(again.effective_mass, 0.78125, 1e-14));
  /* The point moves 0.8 m per radian; the normal is +x, the hinge's axis +y, the point below: closing speed -0.8 per
     radian. */
  double velocity, shares[2], rotors[1], twist[6];
  OK(percuss_response_velocities(response, &velocity, 1));
  CHECK(near_to(velocity, -1.0 / 0.8, 1e-14));
  OK(percuss_response_contributions(response, shares, 2, rotors, 1));
  CHECK(shares[0] == 0.0 && near_to(shares[1], 1.0, 1e-14) && rotors[0] == 0.0);
  OK(percuss_response_base_velocity(response, twist));
  CHECK(twist[0] == 0.0 && twist[5] == 0.0);
  /* m = 0.78125 kg, c = 2 m/s, e = 0.5: p = 1.5 m c, loss 0.75 m c²/2; the hinge turns back with half its rate. */
  percuss_rigid_impact impact;
  double before = -2.0 / 0.8, after, reaction[6];
  OK(percuss_pose_impact(pose, &contact, 2.0, 0.5, NULL, &after, 1, reaction, 6, &impact));
  CHECK(near_to(impact.impulse, 1.5 * 0.78125 * 2.0, 1e-14) && impact.residual < 1e-13);
  CHECK(near_to(impact.energy_loss, 0.5 * 0.75 * 0.78125 * 4.0, 1e-14) && near_to(after, 1.0 / 0.8, 1e-14));
  /* No moment about the axis; all components of a tree are determinate. */
  CHECK(fabs(reaction[5]) < 1e-14 && reaction[0] == reaction[0] && reaction[3] == reaction[3]);
  OK(percuss_pose_impact(pose, &contact, 2.0, 0.5, &before, &after, 1, NULL, 0, &impact));
  CHECK(near_to(after, 1.0 / 0.8, 1e-14));
  CHECK(percuss_pose_impact(pose, &contact, 1.0, 0.5, &before, NULL, 1, NULL, 0, &impact) == PERCUSS_ERROR_ARGUMENT);
  CHECK(percuss_pose_impact(pose, &contact, 2.0, 1.5, NULL, NULL, 0, NULL, 0, &impact) == PERCUSS_ERROR_ARGUMENT);
  CHECK(percuss_pose_impact(pose, &contact, 2.0, 0.5, NULL, NULL, 0, reaction, 5, &impact) == PERCUSS_ERROR_LENGTH);
  OK(percuss_response_against_mass(response, 0.78125, &again));
  CHECK(near_to(again.effective_mass, 0.78125 / 2.0, 1e-14));
  /* Along the rod the mechanism is immovable. */
  contact.normal[0] = 0.0;
  contact.normal[2] = 1.0;
  OK(percuss_pose_effective_mass(pose, &contact, PERCUSS_ROUTE_AUTO, &mass));
  CHECK(mass.outcome == PERCUSS_IMMOVABLE && isnan(mass.effective_mass) && isnan(mass.error));
  OK(percuss_response_free(&response));
  OK(percuss_pose_free(&pose));
  OK(percuss_configuration_free(&configuration));
  OK(percuss_assembly_free(&assembly));
  OK(percuss_system_free(&system));
}

static void conditions(void)
{
  percuss_model *model = loaded(PENDULUM);
  percuss_conditions *given = NULL;
  percuss_system *system = NULL;
  percuss_configuration *configuration = NULL;
  percuss_pose *pose = NULL;
  percuss_mass mass;
  OK(percuss_configuration_new(model, &configuration));
  percuss_contact contact = contact_of(model, "rod", 0.0, 0.0, -0.8);
  contact.normal[0] = 1.0;
  contact.normal[2] = 0.0;
  /* A rotor of 0.32 kg m^2 adds 0.32/0.8^2 = 0.5 kg. */
  const double armature = 0.32;
  OK(percuss_conditions_new(&given));
  OK(percuss_conditions_armature(given, "hinge", &armature, 1));
  OK(percuss_system_new(model, given, &system));
  OK(percuss_pose_new(system, configuration, &pose));
  OK(percuss_pose_effective_mass(pose, &contact, PERCUSS_ROUTE_AUTO, &mass));
  CHECK(near_to(mass.effective_mass, 1.28125, 1e-14));
  OK(percuss_pose_free(&pose));
  OK(percuss_system_free(&system));
  /* Locked, nothing moves. */
  OK(percuss_conditions_lock(given, "hinge"));
  OK(percuss_system_new(model, given, &system));
  size_t coordinates;
  OK(percuss_system_coordinates(system, &coordinates));
  CHECK(coordinates == 0);
  OK(percuss_pose_new(system, configuration, &pose));
  OK(percuss_pose_effective_mass(pose, &contact, PERCUSS_ROUTE_AUTO, &mass));
  CHECK(mass.outcome == PERCUSS_IMMOVABLE);
  OK(percuss_pose_free(&pose));
  OK(percuss_system_free(&system));
  OK(percuss_conditions_free(&given));
  /* Free, with its base held at a point along x. */
  const double origin[3] = {0.0, 0.0, 0.0}, along[3] = {1.0, 0.0, 0.0}, quaternion[4] = {1.0, 0.0, 0.0, 0.0};
  OK(percuss_conditions_new(&given));
  OK(percuss_conditions_base(given, PERCUSS_BASE_FLOATING));
  OK(percuss_conditions_hold(given, "ground", origin, along));
  OK(percuss_system_new(model, given, &system));
  OK(percuss_system_coordinates(system, &coordinates));
  CHECK(coordinates == 7);
  OK(percuss_configuration_set_base(configuration, along, quaternion));
  OK(percuss_pose_new(system, configuration, &pose));
  size_t rows;
  OK(percuss_pose_constraint_rows(pose, &rows));
  CHECK(rows == 1);
  OK(percuss_pose_free(&pose));
  OK(percuss_system_free(&system));
  OK(percuss_conditions_hold(given, "ground", origin, NULL));
  OK(percuss_conditions_free(&given));
  given = NULL;
  OK(percuss_conditions_new(&given));
  OK(percuss_conditions_lock(given, "hing"));
  FAILS(percuss_system_new(model, given, &system), PERCUSS_ERROR_CONDITIONS, "hing");
  CHECK(system == NULL);
  OK(percuss_conditions_free(&given));
  OK(percuss_configuration_free(&configuration));
  OK(percuss_model_free(&model));
}

/* The four-bar: pose, workspace, batch and the dense entry agree. */
static int stop_at_once(size_t done, void *user)
{
  *(size_t *)user = done;
  return 1;
}

static void the_four_bar(void)
{
  enum { POSES = 20, MANY = 40000 };
  percuss_model *model = loaded(FOUR_BAR);
  percuss_system *system = NULL;
  percuss_assembly *assembly = NULL;
  percuss_configuration *configuration = NULL;
  percuss_pose *pose = NULL, *next = NULL;
  percuss_workspace *workspace = NULL;
  percuss_batch *batch = NULL, *threaded = NULL;
  OK(percuss_system_new(model, NULL, &system));
  OK(percuss_configuration_new(model, &configuration));
  const double guess[2] = {0.0, 0.0};
  OK(percuss_configuration_guess(configuration, "coupler_hinge", &guess[0], 1));
  OK(percuss_configuration_guess(configuration, "rocker_hinge", &guess[1], 1));
  OK(percuss_assembly_new(system, configuration, &assembly));
  size_t freedoms, redundant, n, rows;
  OK(percuss_assembly_mobility(assembly, &freedoms, &redundant));
  CHECK(freedoms == 1 && redundant == 3);
  OK(percuss_system_coordinates(system, &n));
  CHECK(n == 3);
  percuss_contact contact = contact_of(model, "coupler", 0.35, 0.1, 0.0);
  contact.normal[1] = 1.0;
  contact.normal[2] = 0.0;
  OK(percuss_workspace_new(assembly, &workspace));
  OK(percuss_batch_new(assembly, &contact, 1, &batch));
  OK(percuss_batch_new(assembly, &contact, 2, &threaded));
  double positions[POSES * 3], expected[POSES];
  for (int i = 0; i < POSES; i++) {
    const double crank = 0.05 + 0.02 * i;
    OK(percuss_configuration_reset(configuration));
    OK(percuss_configuration_set(configuration, "crank_hinge", &crank, 1));
    if (pose == NULL) {
      OK(percuss_assembly_pose(assembly, configuration, &next));
    } else {
      OK(percuss_pose_follow(pose, configuration, &next));
    }
    OK(percuss_pose_free(&pose));
    pose = next;
    OK(percuss_pose_positions(pose, &positions[3 * i], 3));
    percuss_mass mass;
    OK(percuss_pose_effective_mass(pose, &contact, PERCUSS_ROUTE_AUTO, &mass));
    CHECK(mass.outcome == PERCUSS_FINITE && mass.degrees_of_freedom == 1);
    expected[i] = mass.effective_mass;
    percuss_outcome outcome;
    double value;
    OK(percuss_workspace_effective_mass(workspace, &positions[3 * i], 3, &contact, &outcome, &value, NULL));
    CHECK(outcome == PERCUSS_FINITE && near_to(value, mass.effective_mass, 1e-10));
    OK(percuss_workspace_effective_mass_again(workspace, &contact, &outcome, &value, NULL));
    CHECK(outcome == PERCUSS_FINITE && near_to(value, mass.effective_mass, 1e-10));
    /* The dense entry, from the pose's own matrices: in both layouts, with leading dimensions that leave gaps. */
    double m[5 * 3], a[5 * 6], j[3], v[3];
    unsigned char extra[5];
    OK(percuss_pose_constraint_rows(pose, &rows));
    CHECK(rows == 5);
    OK(percuss_pose_contact_row(pose, &contact, j, 3));
    for (int layout = PERCUSS_ROW_MAJOR; layout <= PERCUSS_COLUMN_MAJOR; layout++) {
      const size_t of_m = 5, of_a = 6;
      for (size_t k = 0; k < COUNT(m); k++) m[k] = NAN;
      for (size_t k = 0; k < COUNT(a); k++) a[k] = NAN;
      OK(percuss_pose_mass_matrix(pose, m, COUNT(m), layout, of_m));
      OK(percuss_pose_constraint_matrix(pose, a, COUNT(a), layout, of_a));
      const percuss_matrix mm = {m, COUNT(m), 3, 3, of_m, layout, 0};
      const percuss_matrix aa = {a, COUNT(a), 5, 3, of_a, layout, 0};
      percuss_matrix_options options;
      OK(percuss_matrix_options_init(&options));
      options.accuracy = 1e-14;
      percuss_mass dense;
      percuss_rank rank;
      OK(percuss_effective_mass(&mm, j, 3, &aa, &options, &dense, v, &rank, extra));
      CHECK(dense.outcome == PERCUSS_FINITE && dense.degrees_of_freedom == 1);
      CHECK(fabs(dense.effective_mass - mass.effective_mass) <= dense.error + mass.error);
      CHECK(rank.rank == 2 && rank.redundant == 3 && rank.is_clear);
      int sum = 0;
      for (int r = 0; r < 5; r++) sum += extra[r];
      CHECK(sum == 3);
      CHECK(near_to(j[0] * v[0] + j[1] * v[1] + j[2] * v[2], 1.0, 1e-12));
    }
  }
  /* The batch by rows and by columns, with one thread and with two. */
  double *columns = malloc(3 * MANY * sizeof *columns), *masses = malloc(MANY * sizeof *masses);
  double *errors = malloc(MANY * sizeof *errors);
  percuss_outcome *outcomes = malloc(MANY * sizeof *outcomes);
  CHECK(columns && masses && errors && outcomes);
  for (size_t c = 0; c < MANY; c++)
    for (size_t q = 0; q < 3; q++) columns[q * MANY + c] = positions[3 * (c % POSES) + q];
  OK(percuss_batch_run(batch, positions, COUNT(positions), PERCUSS_ROW_MAJOR, 3, POSES, outcomes, masses, NULL, NULL, NULL,
                       NULL));
  for (int i = 0; i < POSES; i++) CHECK(outcomes[i] == PERCUSS_FINITE && near_to(masses[i], expected[i], 1e-10));
  OK(percuss_batch_run(threaded, columns, 3 * MANY, PERCUSS_COLUMN_MAJOR, MANY, MANY, outcomes, masses, errors, NULL, NULL,
                       NULL));
  for (size_t c = 0; c < MANY; c++) {
    CHECK(outcomes[c] == PERCUSS_FINITE && near_to(masses[c], expected[c % POSES], 1e-10));
    CHECK(isnan(errors[c]) || (errors[c] > 0.0 && errors[c] < 1e-6));
  }
  size_t done = 0;
  FAILS(percuss_batch_run(batch, columns, 3 * MANY, PERCUSS_COLUMN_MAJOR, MANY, MANY, outcomes, masses, errors, NULL,
                          stop_at_once, &done),
        PERCUSS_ERROR_STOPPED, "stopped");
  CHECK(done > 0 && done < MANY && outcomes[done - 1] == PERCUSS_FINITE && outcomes[done] == PERCUSS_NO_ANSWER);
  CHECK(isnan(masses[done]));
  /* A whole configuration. */
  OK(percuss_configuration_set_positions(configuration, positions, 3));
  OK(percuss_pose_free(&pose));
  OK(percuss_pose_new(system, configuration, &pose));
  free(columns);
  free(masses);
  free(errors);
  free(outcomes);
  OK(percuss_batch_free(&threaded));
  OK(percuss_batch_free(&batch));
  OK(percuss_workspace_free(&workspace));
  OK(percuss_pose_free(&pose));
  OK(percuss_configuration_free(&configuration));
  OK(percuss_assembly_free(&assembly));
  OK(percuss_system_free(&system));
  OK(percuss_model_free(&model));
}

static void laws(void)
{
  const double steps[] = {0.1, 0.5, 0.9};
  const char *name = NULL;
  percuss_law law;
  CHECK(percuss_law_count() == 15);
  for (percuss_law number = 0; number < (percuss_law)percuss_law_count(); number++) {
    OK(percuss_law_name(number, &name));
    OK(percuss_law_find(name, &law));
    CHECK(law == number);
  }
  FAILS(percuss_law_name(15, &name), PERCUSS_ERROR_NAME, "15");
  FAILS(percuss_law_find("hunt-crosley", &law), PERCUSS_ERROR_NAME, "hunt-crossley");
  const percuss_spring spring = {2.281, 1e5, 1.0};
  for (size_t i = 0; i < COUNT(steps); i++) {
    for (law = PERCUSS_LAW_KELVIN_VOIGT; law <= PERCUSS_LAW_HUNT_CROSSLEY; law++) {
      percuss_damper damper;
      percuss_impact impact;
      double e;
      OK(percuss_law_damper(law, &spring, steps[i], 0.4, PERCUSS_FORCE_VANISHES, &damper));
      OK(percuss_damper_restitution(&damper, &spring, 0.4, &e));
      CHECK(near_to(e, steps[i], 1e-12));
      OK(percuss_damper_impact(&damper, &spring, 0.4, &impact));
      CHECK(near_to(impact.rebound_speed, 0.4 * steps[i], 1e-12));
      CHECK(near_to(impact.energy_lost, 0.5 * 2.281 * 0.16 * (1.0 - steps[i] * steps[i]), 1e-12));
    }
  }
  percuss_damper damper;
  FAILS(percuss_law_damper(PERCUSS_LAW_HUNT_CROSSLEY, &spring, 0.5, 0.0, 0, &damper), PERCUSS_ERROR_LAW, "speed");
  OK(percuss_law_damper(PERCUSS_LAW_KELVIN_VOIGT, &spring, 0.5, 0.0, PERCUSS_GAP_CLOSES, &damper));
  /* exp(-pi z/sqrt(1 - z^2)) = 0.5. */
  CHECK(near_to(damper.ratio, 0.215454, 1e-5));
}

/* The column of this name. */
static size_t column_of(const percuss_kinematics *table, const char *name)
{
  size_t columns;
  OK(percuss_kinematics_counts(table, NULL, &columns));
  for (size_t i = 0; i < columns; i++) {
    percuss_column column;
    OK(percuss_kinematics_column(table, i, &column));
    if (strcmp(column.name, name) == 0) return i;
  }
  fprintf(stderr, "no column %s\n", name);
  exit(1);
}

/* Kinematics of a swing axle of 0.5 m: camber = -asin(h/0.5). */
static void suspensions(void)
{
  percuss_suspension *suspension = NULL;
  OK(percuss_suspension_load_memory("axle.toml", SWING_AXLE, strlen(SWING_AXLE), &suspension));
  const double travels[4] = {-0.1, 0.0, 0.1, 0.9};
  percuss_kinematics *table = NULL;
  OK(percuss_suspension_kinematics(suspension, PERCUSS_WHEEL_TRAVEL, travels, 4, NULL, &table));
  size_t rows, columns;
  OK(percuss_kinematics_counts(table, &rows, &columns));
  CHECK(rows == 4 && columns > 10);
  double *values = malloc(rows * columns * sizeof *values);
  CHECK(values != NULL);
  OK(percuss_kinematics_values(table, values, rows * columns));
  const size_t camber = column_of(table, "camber"), ratio = column_of(table, "motion_ratio_spring");
  for (size_t row = 0; row < 3; row++) {
    const char *problem = "unset";
    OK(percuss_kinematics_problem(table, row, &problem));
    CHECK(problem == NULL);
    CHECK(fabs(values[row * columns + camber] + asin(travels[row] / 0.5)) < 1e-12);
  }
  CHECK(near_to(values[columns + ratio], 0.5, 1e-12));
  /* A travel beyond the axle. */
  const char *problem = NULL;
  OK(percuss_kinematics_problem(table, 3, &problem));
  CHECK(problem != NULL && strlen(problem) > 0 && isnan(values[3 * columns + camber]));
  percuss_column column;
  OK(percuss_kinematics_column(table, camber, &column));
  CHECK(strcmp(column.unit, "rad") == 0 && column.missing == NULL);
  FAILS(percuss_kinematics_column(table, columns, &column), PERCUSS_ERROR_NAME, "column");
  FAILS(percuss_kinematics_problem(table, rows, &problem), PERCUSS_ERROR_NAME, "row");
  FAILS(percuss_kinematics_values(table, values, rows * columns - 1), PERCUSS_ERROR_LENGTH, "values");
  free(values);
  OK(percuss_kinematics_free(&table));
  CHECK(table == NULL);
  /* Data of the vehicle. */
  percuss_vehicle vehicle;
  OK(percuss_vehicle_init(&vehicle));
  CHECK(vehicle.heave == 0.0 && vehicle.axle == PERCUSS_AXLE_UNKNOWN && isnan(vehicle.wheelbase));
  vehicle.axle = PERCUSS_AXLE_REAR;
  vehicle.brake_bias = 1.5;
  FAILS(percuss_suspension_kinematics(suspension, PERCUSS_HEAVE, travels, 3, &vehicle, &table), PERCUSS_ERROR_ARGUMENT,
        "brake_bias");
  vehicle.brake_bias = 0.6;
  vehicle.heave = 0.01;
  FAILS(percuss_suspension_kinematics(suspension, PERCUSS_HEAVE, travels, 3, &vehicle, &table), PERCUSS_ERROR_ARGUMENT,
        "heave");
  vehicle.heave = 0.0;
  /* Motions per load: the sheet has no bushes. */
  vehicle.loads = PERCUSS_TRAVEL_HELD;
  FAILS(percuss_suspension_kinematics(suspension, PERCUSS_HEAVE, travels, 3, &vehicle, &table), PERCUSS_ERROR_ARGUMENT,
        "loads");
  vehicle.loads = PERCUSS_LOADS_SINGLE + PERCUSS_TRAVEL_HELD;
  OK(percuss_suspension_kinematics(suspension, PERCUSS_HEAVE, travels, 1, &vehicle, &table));
  OK(percuss_kinematics_column(table, column_of(table, "toe_per_lateral_force"), &column));
  CHECK(strcmp(column.unit, "rad/N") == 0 && strstr(column.missing, "no bush") != NULL);
  OK(percuss_kinematics_free(&table));
  FAILS(percuss_suspension_kinematics(suspension, PERCUSS_STEER, travels, 3, NULL, &table), PERCUSS_ERROR_ASSEMBLY,
        "no tie rod");
  FAILS(percuss_suspension_kinematics(suspension, 7, travels, 3, NULL, &table), PERCUSS_ERROR_ARGUMENT, "variable");
  FAILS(percuss_suspension_kinematics(suspension, PERCUSS_HEAVE, travels, 0, NULL, &table), PERCUSS_ERROR_LENGTH, "values");
  CHECK(table == NULL);
  /* The mechanism, with its named contacts: it stays when the suspension is freed. */
  percuss_model *model = NULL;
  OK(percuss_suspension_model(suspension, &model));
  OK(percuss_suspension_free(&suspension));
  percuss_contact contact;
  OK(percuss_model_find_contact(model, "spring", &contact, NULL));
  OK(percuss_model_free(&model));
  FAILS(percuss_suspension_load_memory("robot.urdf", PENDULUM, strlen(PENDULUM), &suspension), PERCUSS_ERROR_LOAD,
        "no sheet");
  FAILS(percuss_suspension_load_file("/nowhere/axle.toml", &suspension), PERCUSS_ERROR_LOAD, "axle.toml");
  CHECK(suspension == NULL);
}

/* Options for matrices: defaults, noise of rows, an accuracy for each matrix. */
static void options_of_matrices(void)
{
  const double m[4] = {1.0, 0.0, 0.0, 3.0}, j[2] = {1.0, 1.0}, a[2] = {1e-15, 0.0};
  const percuss_matrix mass = {m, 4, 2, 2, 2, PERCUSS_ROW_MAJOR, 0}, rows = {a, 2, 1, 2, 2, PERCUSS_ROW_MAJOR, 0};
  percuss_matrix_options options;
  percuss_mass found;
  percuss_rank rank;
  OK(percuss_matrix_options_init(&options));
  CHECK(options.rank_floor == PERCUSS_DEFAULT && options.row_noise == PERCUSS_DEFAULT);
  CHECK(options.accuracy_of_mass == PERCUSS_DEFAULT && options.accuracy == DBL_EPSILON);
  /* A small row counts, unless it is declared as noise. */
  OK(percuss_effective_mass(&mass, j, 2, &rows, &options, &found, NULL, &rank, NULL));
  CHECK(near_to(found.effective_mass, 3.0, 1e-14) && rank.rank == 1);
  options.row_noise = 1e-12;
  OK(percuss_effective_mass(&mass, j, 2, &rows, &options, &found, NULL, &rank, NULL));
  CHECK(near_to(found.effective_mass, 0.75, 1e-14) && rank.rank == 0);
  options.row_noise = 0.0;
  OK(percuss_effective_mass(&mass, j, 2, &rows, &options, &found, NULL, &rank, NULL));
  CHECK(near_to(found.effective_mass, 3.0, 1e-14) && rank.rank == 1);
  /* The error follows the accuracy of the matrix that has it. */
  OK(percuss_matrix_options_init(&options));
  OK(percuss_effective_mass(&mass, j, 2, NULL, &options, &found, NULL, NULL, NULL));
  CHECK(found.error > 0.0 && found.error < 1e-14);
  options.accuracy_of_mass = 1e-6;
  OK(percuss_effective_mass(&mass, j, 2, NULL, &options, &found, NULL, NULL, NULL));
  CHECK(found.error > 1e-7 && found.error < 1e-5);
  options.accuracy = 1e-6;
  OK(percuss_effective_mass(&mass, j, 2, NULL, &options, &found, NULL, NULL, NULL));
  CHECK(found.error > 1e-6 && found.error < 1e-5);
  options.accuracy_of_mass = options.accuracy_of_constraints = options.accuracy_of_contact_row = 0.0;
  OK(percuss_effective_mass(&mass, j, 2, NULL, &options, &found, NULL, NULL, NULL));
  CHECK(found.error < 1e-14);
  /* Without a floor of its own, the rank of rows in single precision is decided by their accuracy. */
  const double single[4] = {1.0, 1.0, 1.0, 1.0 + 5e-8};
  const percuss_matrix alike = {single, 4, 2, 2, 2, PERCUSS_ROW_MAJOR, 0};
  OK(percuss_matrix_options_init(&options));
  options.accuracy_of_constraints = 6e-8;
  OK(percuss_effective_mass(&mass, (const double[2]){1.0, 2.0}, 2, &alike, &options, &found, NULL, &rank, NULL));
  CHECK(rank.rank == 1 && found.outcome == PERCUSS_FINITE);
  /* Values out of range. */
  double *const fields[] = {&options.rank_floor, &options.accuracy, &options.accuracy_of_mass,
                            &options.accuracy_of_constraints, &options.accuracy_of_contact_row, &options.row_noise};
  const char *const names[] = {"rank", "accuracy", "accuracy", "accuracy", "accuracy", "noise"};
  for (size_t k = 0; k < COUNT(fields); k++) {
    const double bad[] = {NAN, -0.5, 1e101};
    for (size_t b = 0; b < COUNT(bad); b++) {
      OK(percuss_matrix_options_init(&options));
      *fields[k] = bad[b];
      FAILS(percuss_effective_mass(&mass, j, 2, &rows, &options, &found, NULL, NULL, NULL), PERCUSS_ERROR_ARGUMENT,
            names[k]);
    }
  }
}

int main(void)
{
  CHECK(strcmp(percuss_version(), PERCUSS_VERSION) == 0);
  CHECK(strcmp(percuss_error_message(), "") == 0);
  the_model();
  the_pendulum();
  conditions();
  the_four_bar();
  options_of_matrices();
  laws();
  suspensions();
  puts("every function answered as it should");
  return 0;
}
