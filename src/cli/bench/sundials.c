/* sundials.c - the integrators of SUNDIALS 6 on the emitted right-hand side, where they are
 * installed.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Optional at build, used by `polhode bench` only: the Makefile defines POLHODE_SUNDIALS where the
 * headers are of version 6 and its numbers are doubles.  Settings as the manual has them for a
 * small system that is not stiff: Adams with the fixed-point solver, without a matrix; BDF with
 * Newton's method and the dense Jacobian of differences that CVODE makes itself; ARKODE's explicit
 * methods with the tables that it has for the orders 5 and 8.  A time asked for is interpolated at,
 * as usual.
 */
#include "bench.h"

#if defined POLHODE_SUNDIALS

#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <stdlib.h>
#include <string.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

struct sun {
  SUNContext context;
  N_Vector x;
  void *memory; /* CVODE's or ARKODE's */
  SUNNonlinearSolver solver;
  SUNMatrix matrix;
  SUNLinearSolver linear;
  const struct polhode_plugin *code;
  struct polhode_place *place;
};

static int rates(realtype t, N_Vector x, N_Vector dx, void *user) {
  const struct sun *s = user;
  return s->code->peer_rhs(t, NV_DATA_S(x), NV_DATA_S(dx), s->place);
}

/* Messages are for a terminal; what they say comes back as a status too. */
static void silent(int code, const char *module, const char *function, char *message, void *user) {
  (void)code;
  (void)module;
  (void)function;
  (void)message;
  (void)user;
}

static struct sun *new_sun(const struct peer_problem *p) {
  struct sun *s = calloc(1, sizeof *s);
  if (s == NULL || SUNContext_Create(NULL, &s->context) != 0) {
    free(s);
    return NULL;
  }
  s->code = p->code;
  s->place = p->place;
  s->x = N_VNew_Serial(p->code->nx, s->context);
  if (s->x != NULL)
    N_VConst(1, s->x);
  return s;
}

static void free_sun(struct sun *s) {
  if (s->linear != NULL)
    SUNLinSolFree(s->linear);
  if (s->matrix != NULL)
    SUNMatDestroy(s->matrix);
  if (s->solver != NULL)
    SUNNonlinSolFree(s->solver);
  if (s->x != NULL)
    N_VDestroy(s->x);
  SUNContext_Free(&s->context);
  free(s);
}

static double *state(const struct sun *s) {
  return NV_DATA_S(s->x);
}

/* ---- CVODE ---- */

static void cvode_close(void *it) {
  struct sun *s = it;
  CVodeFree(&s->memory);
  free_sun(s);
}

static int cvode_solvers(struct sun *s, int method) {
  if (method == CV_ADAMS) {
    s->solver = SUNNonlinSol_FixedPoint(s->x, 0, s->context);
    return s->solver != NULL && CVodeSetNonlinearSolver(s->memory, s->solver) == CV_SUCCESS;
  }
  const sunindextype n = s->code->nx;
  s->matrix = SUNDenseMatrix(n, n, s->context);
  s->linear = s->matrix != NULL ? SUNLinSol_Dense(s->x, s->matrix, s->context) : NULL;
  return s->linear != NULL && CVodeSetLinearSolver(s->memory, s->linear, s->matrix) == CV_SUCCESS;
}

static void *cvode_open(const struct peer *self, const struct peer_problem *p) {
  const int method = *(const int *)self->kind;
  struct sun *s = new_sun(p);
  if (s == NULL)
    return NULL;
  s->memory = s->x != NULL ? CVodeCreate(method, s->context) : NULL;
  if (s->memory != NULL && CVodeSetErrHandlerFn(s->memory, silent, NULL) == CV_SUCCESS &&
      CVodeInit(s->memory, rates, 0, s->x) == CV_SUCCESS &&
      CVodeSStolerances(s->memory, p->setting, p->setting) == CV_SUCCESS &&
      CVodeSetUserData(s->memory, s) == CV_SUCCESS && cvode_solvers(s, method))
    return s;
  cvode_close(s);
  return NULL;
}

static int cvode_start(void *it, double t, const double x[]) {
  const struct sun *s = it;
  memcpy(state(s), x, (size_t)s->code->nx * sizeof x[0]);
  return CVodeReInit(s->memory, t, s->x) != CV_SUCCESS;
}

static int cvode_go(void *it, double *t, double x[], double t1, long most) {
  const struct sun *s = it;
  CVodeSetMaxNumSteps(s->memory, most);
  const int status = CVode(s->memory, t1, s->x, t, CV_NORMAL);
  memcpy(x, state(s), (size_t)s->code->nx * sizeof x[0]);
  return status >= 0 ? PEER_DONE : status == CV_TOO_MUCH_WORK ? PEER_MORE : PEER_FAILED;
}

static long cvode_steps(void *it) {
  const struct sun *s = it;
  long steps = 0;
  CVodeGetNumSteps(s->memory, &steps);
  return steps;
}

/* ---- ARKODE, explicit ---- */

static void arkode_close(void *it) {
  struct sun *s = it;
  ERKStepFree(&s->memory);
  free_sun(s);
}

static void *arkode_open(const struct peer *self, const struct peer_problem *p) {
  struct sun *s = new_sun(p);
  if (s == NULL)
    return NULL;
  s->memory = s->x != NULL ? ERKStepCreate(rates, 0, s->x, s->context) : NULL;
  if (s->memory != NULL && ERKStepSetErrHandlerFn(s->memory, silent, NULL) == ARK_SUCCESS &&
      ERKStepSStolerances(s->memory, p->setting, p->setting) == ARK_SUCCESS &&
      ERKStepSetOrder(s->memory, *(const int *)self->kind) == ARK_SUCCESS &&
      ERKStepSetUserData(s->memory, s) == ARK_SUCCESS)
    return s;
  arkode_close(s);
  return NULL;
}

static int arkode_start(void *it, double t, const double x[]) {
  const struct sun *s = it;
  memcpy(state(s), x, (size_t)s->code->nx * sizeof x[0]);
  return ERKStepReInit(s->memory, rates, t, s->x) != ARK_SUCCESS;
}

static int arkode_go(void *it, double *t, double x[], double t1, long most) {
  const struct sun *s = it;
  ERKStepSetMaxNumSteps(s->memory, most);
  const int status = ERKStepEvolve(s->memory, t1, s->x, t, ARK_NORMAL);
  memcpy(x, state(s), (size_t)s->code->nx * sizeof x[0]);
  return status >= 0 ? PEER_DONE : status == ARK_TOO_MUCH_WORK ? PEER_MORE : PEER_FAILED;
}

static long arkode_steps(void *it) {
  const struct sun *s = it;
  long steps = 0;
  ERKStepGetNumSteps(s->memory, &steps);
  return steps;
}

/* ---- the list ---- */

static const int adams = CV_ADAMS, bdf = CV_BDF, five = 5, eight = 8;

#define CVODE(NAME, KIND)                                                                          \
  { NAME, &KIND, cvode_open, cvode_close, cvode_start, NULL, cvode_go, cvode_steps }
#define ARKODE(NAME, KIND)                                                                         \
  { NAME, &KIND, arkode_open, arkode_close, arkode_start, NULL, arkode_go, arkode_steps }

const struct peer bench_sundials[] = {
    CVODE("CVODE Adams", adams),
    CVODE("CVODE BDF", bdf),
    ARKODE("ARKODE ERK5", five),
    ARKODE("ARKODE ERK8", eight),
    {NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL},
};

#else

const struct peer bench_sundials[] = {{NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL}};

#endif
