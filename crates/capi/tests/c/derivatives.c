/* Gradients, inverse operational inertias, link frames, the response of a workspace, and contacts that differ from configuration to
   configuration: against closed forms of a pendulum, and against each other on a four-bar and an arm. */
#include "check.h"

enum { ROWS = 600 };

static percuss_contact contact_of(const percuss_model *model, const char *link, double x, double y, double z)
{
  percuss_contact contact;
  OK(percuss_contact_init(&contact));
  OK(percuss_model_find_link(model, link, &contact.link));
  contact.point[0] = x;
  contact.point[1] = y;
  contact.point[2] = z;
  return contact;
}

/* m = 0.5 / (0.8 cos q)^2 for a horizontal normal that is fixed in the world: dm/dq = 2 m tan q; v* = 1 / (-0.8 cos q). */
static void the_pendulum(void)
{
  percuss_model *model = loaded(PENDULUM);
  percuss_system *system = NULL;
  percuss_assembly *assembly = NULL;
  percuss_workspace *workspace = NULL;
  percuss_batch *batch = NULL;
  percuss_configuration *configuration = NULL;
  OK(percuss_system_new(model, NULL, &system));
  OK(percuss_assembly_new(system, NULL, &assembly));
  OK(percuss_workspace_new(assembly, &workspace));
  percuss_contact contact = contact_of(model, "rod", 0, 0, -0.8);
  contact.normal[0] = 1.0;
  contact.normal_given = PERCUSS_NORMAL_WORLD;
  OK(percuss_batch_new(assembly, &contact, 2, &batch));
  static double q[ROWS], masses[ROWS], errors[ROWS], gradients[ROWS], inverses[36 * ROWS];
  static percuss_outcome outcomes[ROWS];
  for (size_t i = 0; i < ROWS; i++) q[i] = -1.4 + 2.8 * (double)i / ROWS;
  OK(percuss_batch_derivatives(batch, q, ROWS, PERCUSS_ROW_MAJOR, 1, ROWS, NULL, 0, NULL, 0, outcomes, masses, errors,
                               gradients, inverses));
  for (size_t i = 0; i < ROWS; i++) {
    const double c = 0.8 * cos(q[i]), mass = 0.5 / (c * c);
    CHECK(outcomes[i] == PERCUSS_FINITE && near_to(masses[i], mass, 1e-13));
    /* Near the lower dead centre the gradient is a difference of terms of the size of m. */
    CHECK(fabs(gradients[i] - 2.0 * mass * tan(q[i])) <= 1e-12 * mass * (1.0 + fabs(tan(q[i]))));
    CHECK(near_to(1.0 / inverses[36 * i + 6 * 3 + 3], mass, 1e-12));
    CHECK(near_to(inverses[36 * i + 6 * 1 + 1], 2.0, 1e-13));
    percuss_workspace_response response;
    double velocity;
    OK(percuss_workspace_respond(workspace, &q[i], 1, &contact, &response, &velocity, 1));
    CHECK(response.outcome == PERCUSS_FINITE && near_to(response.effective_mass, mass, 1e-13));
    CHECK(response.error >= 0.0 && response.error < 1e-10 * mass && near_to(fabs(velocity), 1.0 / c, 1e-13));
    CHECK(response.base_velocity[0] == 0.0 && response.remarks == 0);
    OK(percuss_workspace_respond(workspace, NULL, 0, &contact, &response, &velocity, 1));
    CHECK(near_to(response.effective_mass, mass, 1e-13));
    double both[2];
    FAILS(percuss_workspace_respond(workspace, &q[i], 1, &contact, &response, both, 2), PERCUSS_ERROR_LENGTH, "velocities");
  }
  /* A contact for each configuration: points along the rod, normals at 30 degrees. */
  static double points[3 * ROWS], normals[3 * ROWS];
  for (size_t i = 0; i < ROWS; i++) {
    points[3 * i + 2] = -0.2 - 0.001 * (double)i;
    normals[3 * i] = 3.0 * cos(0.5);
    normals[3 * i + 2] = 3.0 * sin(0.5);
  }
  OK(percuss_batch_derivatives(batch, q, ROWS, PERCUSS_COLUMN_MAJOR, ROWS, ROWS, points, 3 * ROWS, normals, 3 * ROWS, outcomes,
                               masses, errors, gradients, NULL));
  for (size_t i = 0; i < ROWS; i++) {
    const double c = points[3 * i + 2] * cos(q[i] + 0.5), mass = 0.5 / (c * c);
    /* Where the gap hardly closes, 1/m is a difference of larger terms. */
    const double tolerance = 1e-12 / fabs(cos(q[i] + 0.5));
    CHECK(near_to(masses[i], mass, tolerance) && near_to(gradients[i], 2.0 * mass * tan(q[i] + 0.5), 10.0 * tolerance));
  }
  FAILS(percuss_batch_derivatives(batch, q, ROWS, PERCUSS_ROW_MAJOR, 1, ROWS, points, 3 * ROWS - 1, normals, 3, outcomes, masses,
                                  errors, NULL, NULL),
        PERCUSS_ERROR_LENGTH, "points");
  normals[3 * 7] = normals[3 * 7 + 2] = 0.0;
  FAILS(percuss_batch_derivatives(batch, q, ROWS, PERCUSS_ROW_MAJOR, 1, ROWS, points, 3 * ROWS, normals, 3 * ROWS, outcomes, masses,
                                  errors, NULL, NULL),
        PERCUSS_ERROR_CONTACT, "configuration 7");
  FAILS(percuss_batch_derivatives(batch, q, ROWS, PERCUSS_ROW_MAJOR, 1, ROWS, NULL, 0, NULL, 0, outcomes, masses, errors, q, NULL),
        PERCUSS_ERROR_OVERLAP, "gradients");

  OK(percuss_configuration_new(model, &configuration));
  OK(percuss_configuration_set(configuration, "hinge", &(double){0.3}, 1));
  percuss_pose *pose = NULL;
  OK(percuss_pose_new(system, configuration, &pose));
  double rotation[9], origin[3], gradient, mass;
  OK(percuss_pose_link_frame(pose, contact.link, rotation, origin));
  CHECK(near_to(rotation[0], cos(0.3), 1e-15) && near_to(rotation[2], sin(0.3), 1e-15) && rotation[4] == 1.0);
  CHECK(origin[0] == 0.0 && origin[1] == 0.0 && origin[2] == 0.0);
  FAILS(percuss_pose_link_frame(pose, 5, rotation, origin), PERCUSS_ERROR_NAME, "2 links");
  percuss_outcome outcome;
  OK(percuss_pose_gradient(pose, &contact, &gradient, 1, &outcome, &mass));
  CHECK(outcome == PERCUSS_FINITE && near_to(gradient, 2.0 * mass * tan(0.3), 1e-12));
  /* Along the rod nothing moves. */
  percuss_contact along = contact;
  along.normal_given = PERCUSS_NORMAL_LINK;
  along.normal[0] = 0.0;
  along.normal[2] = 1.0;
  OK(percuss_pose_gradient(pose, &along, &gradient, 1, &outcome, NULL));
  CHECK(outcome == PERCUSS_IMMOVABLE && isnan(gradient));
  OK(percuss_pose_free(&pose));
  OK(percuss_configuration_free(&configuration));
  OK(percuss_batch_free(&batch));
  OK(percuss_workspace_free(&workspace));
  OK(percuss_assembly_free(&assembly));
  OK(percuss_system_free(&system));
  OK(percuss_model_free(&model));
}

/* The gradient of a linkage along its motion v* is the difference of m between poses beside it. */
static void the_four_bar(void)
{
  percuss_model *model = loaded(FOUR_BAR);
  percuss_system *system = NULL;
  percuss_assembly *assembly = NULL;
  percuss_workspace *workspace = NULL;
  percuss_configuration *configuration = NULL;
  OK(percuss_system_new(model, NULL, &system));
  OK(percuss_assembly_new(system, NULL, &assembly));
  OK(percuss_workspace_new(assembly, &workspace));
  OK(percuss_configuration_new(model, &configuration));
  percuss_contact contact = contact_of(model, "coupler", 0.35, 0.1, 0);
  contact.normal[1] = 1.0;
  const double angle = 0.3, step = 1e-5;
  double masses[3], gradient[3], velocities[3], positions[3], phi[36];
  percuss_outcome outcome;
  for (int k = 0; k < 3; k++) {
    const double value = angle + (k - 1) * step;
    percuss_pose *pose = NULL;
    OK(percuss_configuration_reset(configuration));
    OK(percuss_configuration_set(configuration, "crank_hinge", &value, 1));
    OK(percuss_assembly_pose(assembly, configuration, &pose));
    percuss_mass mass;
    OK(percuss_pose_effective_mass(pose, &contact, PERCUSS_ROUTE_AUTO, &mass));
    masses[k] = mass.effective_mass;
    if (k == 1) {
      OK(percuss_pose_gradient(pose, &contact, gradient, 3, &outcome, NULL));
      OK(percuss_pose_positions(pose, positions, 3));
      OK(percuss_pose_inverse_inertia(pose, &contact, phi));
      double rotation[9], origin[3], inverse = 0.0;
      OK(percuss_pose_link_frame(pose, contact.link, rotation, origin));
      for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) inverse += rotation[3 * i + 1] * phi[6 * (3 + i) + 3 + j] * rotation[3 * j + 1];
      }
      CHECK(near_to(1.0 / inverse, mass.effective_mass, 1e-9));
    }
    OK(percuss_pose_free(&pose));
  }
  percuss_workspace_response response;
  OK(percuss_workspace_respond(workspace, positions, 3, &contact, &response, velocities, 3));
  CHECK(near_to(response.effective_mass, masses[1], 1e-12) && response.error > 0.0);
  double rate = 0.0;
  for (int i = 0; i < 3; i++) rate += gradient[i] * velocities[i] / velocities[0];
  const double difference = (masses[2] - masses[0]) / (2.0 * step);
  /* Truncation step^2, rounding 1e-15 / step. */
  CHECK(fabs(rate - difference) <= 1e-8 * (fabs(difference) + masses[1]));

  /* A path of the crank: every row closes the loop as a pose does. */
  enum { STEPS = 100 };
  percuss_path *path = NULL;
  percuss_pose *start = NULL;
  size_t crank, done = 0;
  double angles[STEPS], all[3 * STEPS], path_masses[STEPS], path_errors[STEPS];
  uint32_t remarks[STEPS];
  OK(percuss_model_find_joint(model, "crank_hinge", &crank));
  OK(percuss_configuration_reset(configuration));
  OK(percuss_configuration_set(configuration, "crank_hinge", &angle, 1));
  OK(percuss_assembly_pose(assembly, configuration, &start));
  OK(percuss_path_new(start, &contact, &crank, 1, &path));
  for (int i = 0; i < STEPS; i++) angles[i] = angle + 0.005 * (i + 1);
  for (int i = 0; i < STEPS; i += 10) {
    OK(percuss_path_follow(path, angles + i, 10, 10, all + 3 * i, 30, path_masses + i, path_errors + i, remarks + i, &done));
    CHECK(done == 10);
  }
  for (int i = 0; i < STEPS; i += 9) {
    percuss_pose *pose = NULL;
    percuss_mass mass;
    double closed[3];
    OK(percuss_configuration_reset(configuration));
    OK(percuss_configuration_set(configuration, "crank_hinge", &angles[i], 1));
    OK(percuss_assembly_pose(assembly, configuration, &pose));
    OK(percuss_pose_positions(pose, closed, 3));
    OK(percuss_pose_effective_mass(pose, &contact, PERCUSS_ROUTE_AUTO, &mass));
    for (int k = 0; k < 3; k++) CHECK(fabs(all[3 * i + k] - closed[k]) <= 1e-12);
    CHECK(near_to(path_masses[i], mass.effective_mass, 1e-10) && path_errors[i] >= 0.0 && remarks[i] == mass.remarks);
    OK(percuss_workspace_respond(workspace, all + 3 * i, 3, &contact, &response, velocities, 3));
    CHECK(near_to(response.effective_mass, mass.effective_mass, 1e-10));
    OK(percuss_pose_free(&pose));
  }
  OK(percuss_path_restart(path, start));
  OK(percuss_path_follow(path, angles, 1, 1, all, 3, NULL, NULL, NULL, &done));
  CHECK(done == 1);
  FAILS(percuss_path_follow(path, angles, 2, 1, all, 3, NULL, NULL, NULL, &done), PERCUSS_ERROR_LENGTH, "values");
  crank = 7;
  percuss_path *none = NULL;
  FAILS(percuss_path_new(start, &contact, &crank, 1, &none), PERCUSS_ERROR_NAME, "3 joints");
  CHECK(none == NULL);
  OK(percuss_path_free(&path));
  CHECK(path == NULL);
  OK(percuss_pose_free(&start));
  OK(percuss_configuration_free(&configuration));
  OK(percuss_workspace_free(&workspace));
  OK(percuss_assembly_free(&assembly));
  OK(percuss_system_free(&system));
  OK(percuss_model_free(&model));
}

int main(void)
{
  the_pendulum();
  the_four_bar();
  puts("every derivative agrees");
  return 0;
}
