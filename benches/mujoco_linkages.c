// m̄ of an exported contact with MuJoCo: mujoco_linkages MODEL.xml NAME. At the first keyframe, the equality constraints hold exactly:
// 1/m̄ is the last diagonal entry of the Cholesky factor of W = [K; j] M⁻¹ [K; j]ᵀ, squared, with the rows K of the constraints and
// j of the contact. Prints `mujoco NAME VELOCITIES NANOSECONDS MASS ROWS`: thread CPU time, the minimum of 25 runs. The first position
// changes by 1e-9 from call to call.
#include <math.h>
#include <mujoco/mujoco.h>
#include <stdio.h>
#include <time.h>

enum { RUNS = 25, CALLS = 4000, LIMIT = 160 };

static double nanoseconds(void) {
  struct timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return t.tv_sec * 1e9 + t.tv_nsec;
}

static double rows[LIMIT * LIMIT], solved[LIMIT * LIMIT], factor[LIMIT * LIMIT];

// m̄, kg. A row with a pivot of rounding size is redundant and omitted.
static double mass(const mjModel *m, mjData *d, int on, int against, const double *point, const double *normal, int *count) {
  mj_kinematics(m, d);
  mj_comPos(m, d);
  mj_tendon(m, d);
  mj_makeM(m, d);
  mj_factorM(m, d);
  mj_makeConstraint(m, d);
  int n = m->nv, k = d->ne;
  double jacobian[3 * LIMIT], other[3 * LIMIT], at[3], world[3], axis[3];
  if (mj_isSparse(m) || k + 1 > LIMIT || n > LIMIT) return NAN;
  for (int x = 0; x < k * n; x++) rows[x] = d->efc_J[x];
  const double *frame = d->xmat + 9 * on, *face = d->xmat + 9 * against;
  for (int r = 0; r < 3; r++) {
    at[r] = d->xpos[3 * on + r], axis[r] = 0;
    for (int c = 0; c < 3; c++) at[r] += frame[3 * r + c] * point[c], axis[r] += face[3 * r + c] * normal[c];
  }
  for (int r = 0; r < 3; r++) world[r] = at[r];
  mj_jac(m, d, jacobian, 0, world, on);
  if (against) mj_jac(m, d, other, 0, world, against);
  for (int x = 0; x < n; x++) {
    double entry = 0;
    for (int r = 0; r < 3; r++) entry += axis[r] * (jacobian[r * n + x] - (against ? other[r * n + x] : 0));
    rows[k * n + x] = entry;
  }
  mj_solveM(m, d, solved, rows, k + 1);
  double pivot = 0;
  for (int x = 0; x <= k; x++)
    for (int y = 0; y <= x; y++) {
      double w = 0;
      for (int z = 0; z < n; z++) w += rows[x * n + z] * solved[y * n + z];
      double size = fabs(w);
      for (int z = 0; z < y; z++) w -= factor[x * (k + 1) + z] * factor[y * (k + 1) + z];
      if (x == y) pivot = w, factor[x * (k + 1) + y] = w > 1e-9 * size ? sqrt(w) : INFINITY;
      else factor[x * (k + 1) + y] = w / factor[y * (k + 1) + y];
    }
  *count = k;
  return 1 / pivot;
}

int main(int count, char **words) {
  char error[1000];
  mjModel *m = count == 3 ? mj_loadXML(words[1], 0, error, sizeof error) : 0;
  if (!m) return fprintf(stderr, "%s\n", count == 3 ? error : "mujoco_linkages MODEL.xml NAME"), 1;
  m->opt.jacobian = mjJAC_DENSE;
  mjData *d = mj_makeData(m);
  int point = mj_name2id(m, mjOBJ_GEOM, "impact/point"), face = mj_name2id(m, mjOBJ_GEOM, "impact/face");
  if (point < 0 || face < 0 || m->nkey < 1) return fprintf(stderr, "%s: no exported contact\n", words[1]), 1;
  // Normal of the face in the frame of its body.
  double turn[9], normal[3];
  mju_quat2Mat(turn, m->geom_quat + 4 * face);
  for (int r = 0; r < 3; r++) normal[r] = turn[3 * r + 2];
  double least = INFINITY, first = 0;
  int constraints = 0;
  for (int run = 0; run < RUNS; run++) {
    double start = nanoseconds();
    for (int i = 0; i < CALLS; i++) {
      mju_copy(d->qpos, m->key_qpos, m->nq);
      d->qpos[0] += 1e-9 * i;
      double answer = mass(m, d, m->geom_bodyid[point], m->geom_bodyid[face], m->geom_pos + 3 * point, normal, &constraints);
      if (i == 0) first = answer;
    }
    least = fmin(least, (nanoseconds() - start) / CALLS);
  }
  printf("mujoco %s %d %.0f %.17g %d\n", words[2], (int)m->nv, least, first, constraints);
}
