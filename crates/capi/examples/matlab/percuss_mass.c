/* MATLAB and Octave function over the C interface:
 *
 *   m = percuss_mass(model, link, point, normal, q)
 *
 * m (N x 1): effective mass of a contact, kg, at the rows of q (N x p: positions of all joints in the order of the file, rad and m);
 * NaN unless finite. model: path of a file. point: m, normal: out of the link, both in the frame of the link.
 *
 * Octave: mkoctfile --mex percuss_mass.c -lpercuss      MATLAB: mex percuss_mass.c -lpercuss */
#include <mex.h>
#include <percuss.h>

#include <stdio.h>
#include <string.h>

/* Objects of one call; freed before an error leaves the function, because mexErrMsgIdAndTxt does not return. */
typedef struct {
  percuss_model *model;
  percuss_system *system;
  percuss_assembly *assembly;
  percuss_batch *batch;
} Objects;

static void free_all(Objects *o)
{
  percuss_batch_free(&o->batch);
  percuss_assembly_free(&o->assembly);
  percuss_system_free(&o->system);
  percuss_model_free(&o->model);
}

static void check(Objects *o, percuss_status status)
{
  char message[1024];
  if (status == PERCUSS_OK) return;
  snprintf(message, sizeof message, "%s", percuss_error_message());
  free_all(o);
  mexErrMsgIdAndTxt("percuss:error", "%s", message);
}

static void vector(const mxArray *given, const char *what, double to[3])
{
  if (!mxIsDouble(given) || mxIsComplex(given) || mxGetNumberOfElements(given) != 3)
    mexErrMsgIdAndTxt("percuss:input", "%s: expected 3 real numbers", what);
  memcpy(to, mxGetPr(given), 3 * sizeof *to);
}

void mexFunction(int outputs, mxArray *output[], int inputs, const mxArray *input[])
{
  char path[4096], link[1024];
  Objects o = {0};
  percuss_contact contact;
  size_t links, joints, positions, velocities;
  (void)outputs;
  if (inputs != 5) mexErrMsgIdAndTxt("percuss:input", "expected percuss_mass(model, link, point, normal, q)");
  if (mxGetString(input[0], path, sizeof path) != 0 || mxGetString(input[1], link, sizeof link) != 0)
    mexErrMsgIdAndTxt("percuss:input", "model and link: expected text");
  if (!mxIsDouble(input[4]) || mxIsComplex(input[4])) mexErrMsgIdAndTxt("percuss:input", "q: expected real numbers");
  check(&o, percuss_contact_init(&contact));
  vector(input[2], "point", contact.point);
  vector(input[3], "normal", contact.normal);
  contact.normal_given = PERCUSS_NORMAL_LINK;
  check(&o, percuss_model_load_file(path, &o.model));
  check(&o, percuss_model_find_link(o.model, link, &contact.link));
  check(&o, percuss_model_counts(o.model, &links, &joints, &positions, &velocities));
  const size_t rows = mxGetM(input[4]);
  if (mxGetN(input[4]) != positions) {
    free_all(&o);
    mexErrMsgIdAndTxt("percuss:input", "q has %d columns; the model has %d positions", (int)mxGetN(input[4]), (int)positions);
  }
  check(&o, percuss_system_new(o.model, NULL, &o.system));
  check(&o, percuss_assembly_new(o.system, NULL, &o.assembly));
  check(&o, percuss_batch_new(o.assembly, &contact, 1, &o.batch));
  output[0] = mxCreateDoubleMatrix(rows, 1, mxREAL);
  percuss_outcome *outcomes = mxCalloc(rows > 0 ? rows : 1, sizeof *outcomes);
  /* Matrices of MATLAB are stored by columns: the fastest layout. */
  const percuss_status status = percuss_batch_run(o.batch, mxGetPr(input[4]), rows * positions, PERCUSS_COLUMN_MAJOR, rows, rows,
                                                  outcomes, mxGetPr(output[0]), NULL, NULL, NULL, NULL);
  mxFree(outcomes);
  check(&o, status);
  free_all(&o);
}
