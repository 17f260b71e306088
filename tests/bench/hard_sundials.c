/* hard_sundials.c - SUNDIALS 6 on the hard cases, where it is installed.
   SPDX-License-Identifier: GPL-3.0-or-later */
#include "hard_peers.h"

#include <stddef.h>

#if defined POLHODE_SUNDIALS

#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <math.h>
#include <nvector/nvector_serial.h>
#include <string.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

static int rates(realtype t, N_Vector x, N_Vector dx, void *run) {
  return hard_rates(t, NV_DATA_S(x), NV_DATA_S(dx), run) != 0 ? -1 : 0;
}

static void silent(int code, const char *module, const char *function, char *message, void *user) {
  (void)code, (void)module, (void)function, (void)message, (void)user;
}

static void tolerances(N_Vector v, const double x[NX]) {
  double w = 0;
  for (int i = 4; i < NX; i++)
    w = fmax(w, fabs(x[i]));
  for (int i = 0; i < NX; i++)
    NV_DATA_S(v)[i] = i < 4 || w == 0 ? 1e-12 : fmax(1e-12 * w, 1e-307);
}

static int adams_or_bdf(const struct peer *self, struct peer_run *r, double x[NX]) {
  const int method = *(const int *)self->kind;
  SUNContext context;
  SUNContext_Create(NULL, &context);
  N_Vector y = N_VMake_Serial(NX, x, context), bound = N_VNew_Serial(NX, context);
  SUNMatrix matrix = SUNDenseMatrix(NX, NX, context);
  SUNLinearSolver linear = SUNLinSol_Dense(y, matrix, context);
  SUNNonlinearSolver fixed = SUNNonlinSol_FixedPoint(y, 0, context);
  void *c = CVodeCreate(method, context);
  double t = 0;
  tolerances(bound, x);
  int status = CVodeInit(c, rates, 0, y);
  CVodeSetErrHandlerFn(c, silent, NULL);
  if (status == 0)
    status = CVodeSVtolerances(c, 1e-12, bound);
  CVodeSetUserData(c, r);
  CVodeSetMaxNumSteps(c, BUDGET);
  CVodeSetStopTime(c, r->m->t);
  if (status == 0)
    status = method == CV_ADAMS ? CVodeSetNonlinearSolver(c, fixed)
                                : CVodeSetLinearSolver(c, linear, matrix);
  if (status == 0)
    status = CVode(c, r->m->t, y, &t, CV_NORMAL);
  CVodeFree(&c);
  SUNNonlinSolFree(fixed);
  SUNLinSolFree(linear);
  SUNMatDestroy(matrix);
  N_VDestroy(bound);
  N_VDestroy(y);
  SUNContext_Free(&context);
  return r->calls > BUDGET ? 2 : status < 0;
}

static int explicit8(const struct peer *self, struct peer_run *r, double x[NX]) {
  SUNContext context;
  SUNContext_Create(NULL, &context);
  N_Vector y = N_VMake_Serial(NX, x, context), bound = N_VNew_Serial(NX, context);
  void *a = ERKStepCreate(rates, 0, y, context);
  double t = 0;
  tolerances(bound, x);
  ERKStepSetErrHandlerFn(a, silent, NULL);
  int status = ERKStepSVtolerances(a, 1e-12, bound);
  ERKStepSetOrder(a, *(const int *)self->kind);
  ERKStepSetUserData(a, r);
  ERKStepSetMaxNumSteps(a, BUDGET);
  ERKStepSetStopTime(a, r->m->t);
  if (status == 0)
    status = ERKStepEvolve(a, r->m->t, y, &t, ARK_NORMAL);
  ERKStepFree(&a);
  N_VDestroy(bound);
  N_VDestroy(y);
  SUNContext_Free(&context);
  return r->calls > BUDGET ? 2 : status < 0;
}

static const int adams = CV_ADAMS, bdf = CV_BDF, eight = 8;
const struct peer hard_sundials[] = {{"CVODE Adams", adams_or_bdf, &adams},
                                     {"CVODE BDF", adams_or_bdf, &bdf},
                                     {"ARKODE ERK8", explicit8, &eight},
                                     {NULL, NULL, NULL}};

#else

const struct peer hard_sundials[] = {{NULL, NULL, NULL}};

#endif
