/* A controller of fixed period. In each period the crank of a four-bar linkage moves, the loop is closed, and the program computes the effective
 * mass of a contact on the coupler, its error and the response of all joints. The control loop allocates no memory. At the end the
 * program states the computing times and the periods in which the answer came too late.
 *
 * Compile: cc -std=c11 real_time.c $(pkg-config --cflags --libs percuss) -lm
 * Run: real_time MODEL [PERIODS [PERIOD_IN_MICROSECONDS]], with models/four_bar.urdf of percuss. */
#define _GNU_SOURCE
#include <percuss.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <time.h>

enum { MOST_POSITIONS = 64, MOST_PERIODS = 1000000 };
/* The first periods fill caches and the tables of the dynamic linker. */
static const int WARM_UP = 10;

#ifdef COUNT_ALLOCATIONS
/* Linked with --wrap: counts the calls of the program and of the static library. */
static volatile long allocations = 0;
void *__real_malloc(size_t size);
void *__real_calloc(size_t count, size_t size);
void *__real_realloc(void *old, size_t size);
int __real_posix_memalign(void **to, size_t alignment, size_t size);
void *__wrap_malloc(size_t size) { allocations++; return __real_malloc(size); }
void *__wrap_calloc(size_t count, size_t size) { allocations++; return __real_calloc(count, size); }
void *__wrap_realloc(void *old, size_t size) { allocations++; return __real_realloc(old, size); }
int __wrap_posix_memalign(void **to, size_t alignment, size_t size) { allocations++; return __real_posix_memalign(to, alignment, size); }
#else
static const long allocations = -1;
#endif

static void check(percuss_status status)
{
  if (status != PERCUSS_OK) {
    fprintf(stderr, "percuss: %s\n", percuss_error_message());
    exit(1);
  }
}

static double microseconds(const struct timespec *t) { return 1e6 * (double)t->tv_sec + 1e-3 * (double)t->tv_nsec; }

static int by_size(const void *a, const void *b)
{
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* Objects and buffers of the control loop, created before its first period. */
typedef struct {
  percuss_path *path;
  percuss_workspace *workspace;
  percuss_contact contact;
  size_t positions, velocities;
  double q[MOST_POSITIONS], response[MOST_POSITIONS];
} Controller;

/* The work of one period: the crank is at an angle, rad. Returns the effective mass, kg. */
static double step(Controller *c, double angle, double *error)
{
  size_t done = 0;
  check(percuss_path_follow(c->path, &angle, 1, 1, c->q, c->positions, NULL, NULL, NULL, &done));
  if (done != 1) {
    fprintf(stderr, "the path ends at %g rad\n", angle);
    exit(1);
  }
  percuss_workspace_response found;
  check(percuss_workspace_respond(c->workspace, c->q, c->positions, &c->contact, &found, c->response, c->velocities));
  *error = found.error;
  return found.effective_mass;
}

int main(int argc, char **argv)
{
  if (argc < 2) {
    fprintf(stderr, "real_time MODEL [PERIODS [PERIOD_IN_MICROSECONDS]]\n");
    return 2;
  }
  const long periods = argc > 2 ? strtol(argv[2], NULL, 10) : 2000;
  const double period = argc > 3 ? strtod(argv[3], NULL) : 1000.0;
  if (periods < 1 || periods > MOST_PERIODS || !(period >= 1.0 && period <= 1e6)) {
    fprintf(stderr, "expected 1 to %d periods of 1 to 1e6 microseconds\n", MOST_PERIODS);
    return 2;
  }
  percuss_model *model = NULL;
  percuss_system *system = NULL;
  percuss_assembly *assembly = NULL;
  percuss_pose *pose = NULL;
  Controller c = {0};
  percuss_configuration *zero = NULL;
  size_t links, joints, crank;
  check(percuss_model_load_file(argv[1], &model));
  check(percuss_system_new(model, NULL, &system));
  check(percuss_assembly_new(system, NULL, &assembly));
  check(percuss_configuration_new(model, &zero));
  check(percuss_assembly_pose(assembly, zero, &pose));
  check(percuss_workspace_new(assembly, &c.workspace));
  check(percuss_model_counts(model, &links, &joints, &c.positions, &c.velocities));
  check(percuss_model_find_joint(model, "crank_hinge", &crank));
  if (c.positions > MOST_POSITIONS || c.velocities > MOST_POSITIONS) return 1;
  check(percuss_contact_init(&c.contact));
  check(percuss_model_find_link(model, "coupler", &c.contact.link));
  c.contact.point[0] = 0.35;
  c.contact.point[1] = 0.1;
  c.contact.normal[1] = 1.0;
  c.contact.normal_given = PERCUSS_NORMAL_LINK;
  check(percuss_path_new(pose, &c.contact, &crank, 1, &c.path));

  /* Locks all pages in memory. Without the permission the loop runs too, but page faults may delay it. */
  if (mlockall(MCL_CURRENT | MCL_FUTURE) != 0) fprintf(stderr, "memory is not locked: page faults may delay a period\n");
  double *times = calloc((size_t)periods, sizeof *times);
  if (times == NULL) return 1;
  double error = 0.0, least = INFINITY, most = 0.0;
  for (int k = 0; k < WARM_UP; k++) step(&c, 0.0, &error);
  const long before = allocations;
  long late = 0;
  struct timespec wake, start, end;
  clock_gettime(CLOCK_MONOTONIC, &wake);
  for (long k = 0; k < periods; k++) {
    wake.tv_nsec += (long)(1e3 * period);
    wake.tv_sec += wake.tv_nsec / 1000000000;
    wake.tv_nsec %= 1000000000;
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &wake, NULL) != 0) {
    }
    clock_gettime(CLOCK_MONOTONIC, &start);
    /* The crank oscillates with an amplitude of 0.2 rad and a cycle of 1000 periods. */
    const double mass = step(&c, 0.2 * sin(6.283185307179586 * (double)k / 1000.0), &error);
    clock_gettime(CLOCK_MONOTONIC, &end);
    times[k] = microseconds(&end) - microseconds(&start);
    /* The answer is needed before the next period begins. */
    late += microseconds(&end) - microseconds(&wake) > period;
    if (!(error <= 1e-9 * mass)) {
      fprintf(stderr, "period %ld: %g kg with an error of %g kg\n", k, mass, error);
      return 1;
    }
    least = fmin(least, mass);
    most = fmax(most, mass);
  }
  const long allocated = allocations - before;
  qsort(times, (size_t)periods, sizeof *times, by_size);
  printf("%ld periods of %g us: m from %.6f to %.6f kg\n", periods, period, least, most);
  printf("computing time: median %.2f us, 99.9 %% %.2f us, largest %.2f us; %ld answers after their deadline\n",
         times[periods / 2], times[(periods - 1) * 999 / 1000], times[periods - 1], late);
  if (before >= 0) printf("allocations in the loop: %ld\n", allocated);
  free(times);
  check(percuss_path_free(&c.path));
  check(percuss_workspace_free(&c.workspace));
  check(percuss_pose_free(&pose));
  check(percuss_configuration_free(&zero));
  check(percuss_assembly_free(&assembly));
  check(percuss_system_free(&system));
  check(percuss_model_free(&model));
  return allocated != 0 && before >= 0;
}
