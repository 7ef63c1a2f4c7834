/* A caller with traps on division by zero, invalid operations and overflow: no call raises a signal, the numbers are
   the same, and the caller's environment is restored. Linux with glibc. */
#define _GNU_SOURCE
#include "check.h"

#include <fenv.h>

/* A chain of hinges and slides about all axes; every third link is massless if `massless`. */
static void chain(char *text, size_t size, int links, int massless)
{
  size_t at = (size_t)snprintf(text, size, "<robot name=\"chain\"><link name=\"l0\"/>");
  for (int i = 1; i <= links; i++) {
    const char *inertial =
        "<inertial><origin xyz=\"0.1 0 0.02\"/><mass value=\"2\"/><inertia ixx=\"0.01\" iyy=\"0.02\" izz=\"0.025\" "
        "ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial>";
    const char *limits = "<limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/>";
    const int slides = i % 4 == 3;
    at += (size_t)snprintf(text + at, size - at,
                           "<link name=\"l%d\">%s</link><joint name=\"j%d\" type=\"%s\"><parent link=\"l%d\"/>"
                           "<child link=\"l%d\"/><origin xyz=\"0.2 0 0.1\"/><axis xyz=\"%d %d %d\"/>%s</joint>",
                           i, massless && i % 3 == 1 ? "" : inertial, i, slides ? "prismatic" : "continuous", i - 1, i,
                           i % 3 == 0, i % 3 == 1, i % 3 == 2, slides ? limits : "");
  }
  snprintf(text + at, size - at, "</robot>");
}

static int calls = 0;

typedef struct {
  percuss_outcome outcomes[96];
  double masses[96], one;
  percuss_outcome outcome;
  percuss_mass mass;
  double e;
} Answers;

static void ask(const char *text, Answers *answers)
{
  percuss_model *model = loaded(text);
  percuss_system *system = NULL;
  percuss_assembly *assembly = NULL;
  percuss_workspace *workspace = NULL;
  percuss_configuration *configuration = NULL;
  percuss_pose *pose = NULL;
  percuss_response *response = NULL;
  percuss_batch *batch = NULL, *threaded = NULL;
  percuss_contact contact;
  size_t links, positions;
  OK(percuss_model_counts(model, &links, NULL, &positions, NULL));
  OK(percuss_system_new(model, NULL, &system));
  OK(percuss_assembly_new(system, NULL, &assembly));
  OK(percuss_configuration_new(model, &configuration));
  OK(percuss_pose_new(system, configuration, &pose));
  OK(percuss_workspace_new(assembly, &workspace));
  double closed[32], rows[96 * 32];
  CHECK(positions <= 32);
  OK(percuss_pose_positions(pose, closed, positions));
  OK(percuss_contact_init(&contact));
  contact.link = links - 1;
  contact.point[0] = 0.1;
  /* Finite, immovable and massless directions, and rows that are valid, open and not numbers. */
  const double normals[3][3] = {{0.3, -0.5, 0.8}, {0.0, 1.0, 0.0}, {1.0, 0.0, 0.0}};
  for (int k = 0; k < 3; k++) {
    memcpy(contact.normal, normals[k], sizeof contact.normal);
    OK(percuss_batch_new(assembly, &contact, 1, &batch));
    OK(percuss_batch_new(assembly, &contact, 2, &threaded));
    for (size_t c = 0; c < 91; c++)
      for (size_t q = 0; q < positions; q++)
        rows[c * positions + q] = c % 7 == 3 ? NAN : c % 7 == 5 ? 1e300 : c % 7 == 6 ? 0.125 * (double)c : closed[q];
    OK(percuss_batch_run(batch, rows, 91 * positions, PERCUSS_ROW_MAJOR, positions, 91, answers->outcomes, answers->masses,
                         NULL, NULL, NULL, NULL));
    OK(percuss_batch_run(threaded, rows, 91 * positions, PERCUSS_ROW_MAJOR, positions, 91, answers->outcomes,
                         answers->masses, NULL, NULL, NULL, NULL));
    OK(percuss_workspace_effective_mass(workspace, closed, positions, &contact, &answers->outcome, &answers->one, NULL));
    for (int route = PERCUSS_ROUTE_AUTO; route <= PERCUSS_ROUTE_ARTICULATED; route++) {
      OK(percuss_pose_effective_mass(pose, &contact, route, &answers->mass));
      OK(percuss_pose_respond(pose, &contact, route, &response));
      OK(percuss_response_free(&response));
      calls += 2;
    }
    OK(percuss_batch_free(&batch));
    OK(percuss_batch_free(&threaded));
    calls += 3;
  }
  const percuss_spring spring = {2.0, 1e5, 1.5};
  percuss_damper damper;
  for (int law = 0; law < (int)percuss_law_count(); law++) {
    const double restitutions[] = {0.0, 0.01, 0.5, 0.99, 1.0};
    for (size_t i = 0; i < COUNT(restitutions); i++) {
      if (percuss_law_damper(law, &spring, restitutions[i], 1.0, PERCUSS_FORCE_VANISHES, &damper) == PERCUSS_OK)
        (void)percuss_damper_restitution(&damper, &spring, 1.0, &answers->e);
      calls++;
    }
  }
  OK(percuss_workspace_free(&workspace));
  OK(percuss_pose_free(&pose));
  OK(percuss_configuration_free(&configuration));
  OK(percuss_assembly_free(&assembly));
  OK(percuss_system_free(&system));
  OK(percuss_model_free(&model));
}

/* Compares the results, except the bits of NaN, which have no meaning. */
static void same(const Answers *a, const Answers *b)
{
  for (int i = 0; i < 91; i++) {
    CHECK(a->outcomes[i] == b->outcomes[i]);
    CHECK(isnan(a->masses[i]) ? isnan(b->masses[i]) : a->masses[i] == b->masses[i]);
  }
  CHECK(a->outcome == b->outcome && (isnan(a->one) ? isnan(b->one) : a->one == b->one));
}

int main(void)
{
  static char chains[6][20000];
  const char *texts[8] = {PENDULUM, FOUR_BAR};
  for (int i = 0; i < 6; i++) {
    chain(chains[i], sizeof chains[i], 1 + 2 * i, i % 2);
    texts[2 + i] = chains[i];
  }
  for (int i = 0; i < 8; i++) {
    Answers plain, trapped;
    memset(&plain, 0, sizeof plain);
    memset(&trapped, 0, sizeof trapped);
    ask(texts[i], &plain);
    /* Flags that are already set raise no trap. */
    CHECK(feclearexcept(FE_ALL_EXCEPT) == 0);
    CHECK(feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW) != -1);
    const int enabled = fegetexcept();
    ask(texts[i], &trapped);
    CHECK(fegetexcept() == enabled && fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW) == 0);
    fedisableexcept(FE_ALL_EXCEPT);
    same(&plain, &trapped);
    /* Another rounding mode of the caller is kept, and changes no result. */
    CHECK(fesetround(FE_UPWARD) == 0);
    ask(texts[i], &trapped);
    CHECK(fegetround() == FE_UPWARD && fesetround(FE_TONEAREST) == 0);
    same(&plain, &trapped);
  }
  printf("%d calls without a trap\n", calls);
  return 0;
}
