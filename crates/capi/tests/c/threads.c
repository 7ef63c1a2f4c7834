/* Threads: immutable objects are shared, each thread has its own workspace; two threads in one workspace get an
   error. */
#define _POSIX_C_SOURCE 200809L
#include "check.h"

#include <pthread.h>
#include <signal.h>
#include <stdatomic.h>
#include <sys/wait.h>
#include <unistd.h>

enum { THREADS = 2, CALLS = 2000 };

static percuss_assembly *assembly;
static percuss_workspace *shared;
static percuss_batch *batch;
static percuss_contact contact;
static atomic_int busy, answered, started;

static void check_mass(percuss_status status, percuss_outcome outcome, double mass)
{
  CHECK(status == PERCUSS_OK && outcome == PERCUSS_FINITE && near_to(mass, 0.78125, 1e-13));
}

static void *own_workspace(void *argument)
{
  (void)argument;
  percuss_workspace *workspace = NULL;
  percuss_outcome outcome = -1;
  double mass = 0.0;
  OK(percuss_workspace_new(assembly, &workspace));
  for (int i = 0; i < CALLS; i++) {
    const double angle = 0.001 * i;
    percuss_status status =
        percuss_workspace_effective_mass(workspace, &angle, 1, &contact, &outcome, &mass, NULL);
    check_mass(status, outcome, mass);
    OK(percuss_batch_run(batch, &angle, 1, PERCUSS_ROW_MAJOR, 1, 1, &outcome, &mass, NULL, NULL, NULL, NULL));
    check_mass(PERCUSS_OK, outcome, mass);
  }
  /* Messages are kept per thread: this thread has no failure. */
  CHECK(strcmp(percuss_error_message(), "") == 0);
  OK(percuss_workspace_free(&workspace));
  return NULL;
}

static void *shared_workspace(void *argument)
{
  (void)argument;
  atomic_fetch_add(&started, 1);
  while (atomic_load(&started) < THREADS) { }
  /* Until the two calls coincide: at most some thousand calls on two processors. */
  for (long i = 0; i < 20000000L && atomic_load(&busy) == 0; i++) {
    percuss_outcome outcome = -1;
    double mass = 0.0;
    const double angle = 0.001 * (double)(i % 1000);
    percuss_status status = percuss_workspace_effective_mass(shared, &angle, 1, &contact, &outcome, &mass, NULL);
    if (status == PERCUSS_ERROR_BUSY) {
      CHECK(strstr(percuss_error_message(), "another thread") != NULL);
      atomic_fetch_add(&busy, 1);
    } else {
      check_mass(status, outcome, mass);
      atomic_fetch_add(&answered, 1);
    }
  }
  return NULL;
}

static void both(void *(*work)(void *))
{
  pthread_t threads[THREADS];
  for (int i = 0; i < THREADS; i++) CHECK(pthread_create(&threads[i], NULL, work, NULL) == 0);
  for (int i = 0; i < THREADS; i++) CHECK(pthread_join(threads[i], NULL) == 0);
}

/* During a callback of the batch, calls on immutable objects and on a workspace are allowed. */
static int while_running(size_t done, void *user)
{
  (void)done;
  percuss_outcome outcome = -1;
  double mass = 0.0;
  const double angle = 0.1;
  percuss_status status = percuss_workspace_effective_mass(shared, &angle, 1, &contact, &outcome, &mass, NULL);
  check_mass(status, outcome, mass);
  *(int *)user += 1;
  return 0;
}

/* A forked process has none of its parent's threads: a threaded batch returns an error there instead of waiting for
   them. */
static void forked(void)
{
  percuss_batch *threaded = NULL;
  const double angles[3] = {0.1, 0.2, 0.3};
  percuss_outcome outcomes[3];
  double masses[3];
  OK(percuss_batch_new(assembly, &contact, THREADS, &threaded));
  OK(percuss_batch_run(threaded, angles, 3, PERCUSS_ROW_MAJOR, 1, 3, outcomes, masses, NULL, NULL, NULL, NULL));
  int told[2];
  CHECK(pipe(told) == 0);
  const pid_t child = fork();
  CHECK(child >= 0);
  if (child == 0) {
    percuss_status status =
        percuss_batch_run(threaded, angles, 3, PERCUSS_ROW_MAJOR, 1, 3, outcomes, masses, NULL, NULL, NULL, NULL);
    int wrong = status != PERCUSS_ERROR_HANDLE || strstr(percuss_error_message(), "after fork") == NULL;
    /* The batch without threads works in the forked process. */
    status = percuss_batch_run(batch, angles, 3, PERCUSS_ROW_MAJOR, 1, 3, outcomes, masses, NULL, NULL, NULL, NULL);
    const char right = !wrong && status == PERCUSS_OK ? 'y' : 'n';
    (void)!write(told[1], &right, 1);
    /* Killed at once: resources of the parent's threads are lost here, and leak checks must not report them. */
    kill(getpid(), SIGKILL);
  }
  char right = 0;
  int ended = 0;
  CHECK(close(told[1]) == 0 && read(told[0], &right, 1) == 1 && right == 'y');
  CHECK(waitpid(child, &ended, 0) == child && WIFSIGNALED(ended) && close(told[0]) == 0);
  OK(percuss_batch_free(&threaded));
}

int main(void)
{
  percuss_model *model = loaded(PENDULUM);
  percuss_system *system = NULL;
  OK(percuss_system_new(model, NULL, &system));
  OK(percuss_assembly_new(system, NULL, &assembly));
  OK(percuss_contact_init(&contact));
  contact.link = 1;
  contact.point[2] = -0.8;
  contact.normal[0] = 1.0;
  contact.normal[2] = 0.0;
  OK(percuss_batch_new(assembly, &contact, 1, &batch));
  OK(percuss_workspace_new(assembly, &shared));
  both(own_workspace);
  both(shared_workspace);
  CHECK(atomic_load(&answered) > 0);
  CHECK(atomic_load(&busy) > 0);
  int calls = 0;
  const double angles[3] = {0.1, 0.2, 0.3};
  percuss_outcome outcomes[3];
  double masses[3];
  OK(percuss_batch_run(batch, angles, 3, PERCUSS_ROW_MAJOR, 1, 3, outcomes, masses, NULL, NULL, while_running, &calls));
  CHECK(calls == 1);
  forked();
  OK(percuss_workspace_free(&shared));
  OK(percuss_batch_free(&batch));
  OK(percuss_assembly_free(&assembly));
  OK(percuss_system_free(&system));
  OK(percuss_model_free(&model));
  puts("two threads");
  return 0;
}
