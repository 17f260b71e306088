/* run.c - a run: a state carried through time by a method, to exactly the times that are asked for.
   SPDX-License-Identifier: GPL-3.0-or-later

   The state lives in long double between calls, so nothing is rounded to double on the way. After
   each step q is projected onto |q| = 1: the exact flow stays there, the distance is of the order
   of the local error, so the projection keeps the order of the method (Hairer, Lubich, Wanner,
   Geometric Numerical Integration, IV.4) and |q| has nothing to drift with. A call works on a copy
   of the state; a failure leaves the run where it was. */
#include <stdlib.h>

#include "acts/acts.h"
#include "free_top/free_top.h"
#include "corner.h"
#include "implicit.h"

struct ph_run {
  ph_top top;
  ph_options options;
  stepper stepper;
  implicit *implicit; /* PH_IMPLICIT, and PH_TAYLOR once it has met something stiff; or NULL */
  int stiff;          /* it goes on by that */
  corners corners;    /* of steps that choose their length */
  ph_free_top exact;  /* PH_EXACT: the motion from x at start */
  double start;
  double t;
  ph_wide x[PH_STATES];
  ph_wide h; /* what the step control would take next, > 0; 0: not yet known */
  long steps, implicit_steps;
};

ph_options ph_options_default(void) {
  return (ph_options){.method = PH_TAYLOR, .tolerance = 1e-18, .max_steps = 100000000};
}

/* The bounds: below 1e-19 a tolerance asks for more than 64 bits can say, above 0.1 for nothing. */
static int options_check(const ph_options *o) {
  if (!isfinite(o->step) || !isfinite(o->tolerance))
    return PH_EFINITE;
  if (o->method < PH_RK4 || o->method > PH_IMPLICIT || (o->method == PH_RK4 && o->step == 0))
    return PH_EMETHOD;
  if (o->step < 0)
    return PH_ESTEP;
  if (o->step == 0 && !(o->tolerance >= 1e-19 && o->tolerance <= 0.1))
    return PH_ETOLERANCE;
  if (o->order != 0 && (o->order < 2 || o->order > TAYLOR_MAX))
    return PH_ETOLERANCE;
  return o->max_steps > 0 ? PH_OK : PH_ESTEPS;
}

int ph_run_new(ph_run **run, const ph_top *top, const ph_options *options, double t0,
               const double x0[]) {
  const gsl_odeiv2_step_type *const gsl[] = {
      [PH_RK4] = NULL,
      [PH_RK4_GSL] = gsl_odeiv2_step_rk4,
      [PH_RKF45] = gsl_odeiv2_step_rkf45,
      [PH_RK8PD] = gsl_odeiv2_step_rk8pd,
      [PH_TAYLOR] = NULL,
      [PH_EXACT] = NULL,
      [PH_IMPLICIT] = NULL,
  };
  ph_wide q[4];
  int status = options_check(options);
  if (!status && (!isfinite(t0) || !wide_finite(ph_top_states(top), x0)))
    status = PH_EFINITE;
  if (!status)
    status = wide_load_unit(x0, q);
  ph_free_top exact;
  if (!status && options->method == PH_EXACT)
    status = ph_free_top_solve(&exact, top, x0);
  if (status)
    return status;
  ph_run *r = calloc(1, sizeof *r);
  if (!r)
    return PH_EMEMORY;
  r->top = *top;
  r->options = *options;
  if (options->method == PH_EXACT)
    r->exact = exact;
  r->start = t0;
  r->t = t0;
  wide_load(ph_top_states(top), x0, r->x);
  for (int i = 0; i < 4; i++)
    r->x[i] = q[i];
  r->stepper.top = &r->top;
  r->stepper.unseen = acts_unseen(&r->top);
  if (options->step == 0) {
    status = corners_new(&r->corners, &r->top);
    r->top.branch = r->corners.branch;
  }
  if (gsl[options->method]) {
    r->stepper.gsl = gsl_odeiv2_step_alloc(gsl[options->method], (size_t)ph_top_states(top));
    if (!r->stepper.gsl)
      status = PH_EMEMORY;
  }
  if (options->method == PH_IMPLICIT && !status) {
    r->stiff = 1;
    status = implicit_new(&r->implicit, ph_top_states(top), options->tolerance);
  }
  if (status) {
    ph_run_free(r);
    return status;
  }
  *run = r;
  return PH_OK;
}

void ph_run_free(ph_run *run) {
  if (!run)
    return;
  corners_free(&run->corners);
  if (run->stepper.gsl)
    gsl_odeiv2_step_free(run->stepper.gsl);
  free(run->implicit);
  free(run);
}

static void project(const ph_run *run, ph_wide x[]) {
  if (run->options.free_norm)
    return;
  const ph_wide n = wide_quat_norm(x);
  for (int i = 0; i < 4; i++)
    x[i] /= n;
}

static int stopped(const ph_run *run) {
  return run->options.stop && run->options.stop(run->options.context);
}

/* Order for a tolerance: the cheapest one by Jorba and Zou (2005), -ln(tolerance)/2, and two
 * more. */
static int taylor_order(const ph_options *o) {
  if (o->step > 0)
    return o->order ? o->order : TAYLOR_DEFAULT;
  const int order = (int)ceill(-logl((ph_wide)o->tolerance) / 2) + 2;
  return order < 4 ? 4 : order;
}

static int go_fixed(ph_run *run, ph_wide span, ph_wide x[], long *steps) {
  /* As many steps as fit; a ratio that is an integer up to its rounding in double, and up to that
   * of the times between which the span lies, counts as that integer. */
  const ph_wide ratio = fabsl(span) / (ph_wide)run->options.step;
  const ph_wide ends = fabsl((ph_wide)run->t) + fabsl((ph_wide)run->t + span);
  const ph_wide rounding = 8 * ratio + 2 * ends / (ph_wide)run->options.step;
  const ph_wide count = ceill(ratio - (ph_wide)DBL_EPSILON * rounding);
  if (count > run->options.max_steps)
    return PH_ESTEPS;
  const long n = (long)count;
  ph_wide h = span / (ph_wide)(n > 0 ? n : 1), error;
  for (long k = 0; k < n; k++) {
    int status;
    if (stopped(run))
      return PH_ESTEPS;
    run->stepper.t = (ph_wide)run->t + (ph_wide)k * h;
    if (run->options.method == PH_RK4)
      status = step_rk4(&run->stepper, x, h, x);
    else if (run->options.method == PH_IMPLICIT)
      status = step_implicit(&run->stepper, run->implicit, x, 0, &h, &error, x);
    else if (run->options.method == PH_TAYLOR && acts_any(&run->top))
      status = step_extrapolate(&run->stepper, x, 0, &h, &error, x);
    else if (run->options.method == PH_TAYLOR)
      status = step_taylor(&run->stepper, x, taylor_order(&run->options), 0, &h, x);
    else
      status = step_gsl(&run->stepper, x, h, x, &error);
    if (!status && !wide_fits(ph_top_states(&run->top), x))
      status = PH_ERANGE;
    if (status)
      return status;
    project(run, x);
  }
  *steps = n;
  return PH_OK;
}

/* New length of step from an error e relative to the tolerance: the usual power law with a safety
   factor of 0.9, within a fifth and five times. */
static ph_wide rescale(ph_wide h, ph_wide e, unsigned order) {
  const ph_wide factor = e > 0 ? 0.9L * powl(e, -1.0L / order) : 5;
  return h * fminl(5, fmaxl(0.2L, factor));
}

/* Is the length of a step this file's to choose? A Taylor step finds its own from its terms. */
static int chosen_here(const ph_run *run) {
  return run->stepper.gsl || run->stiff || acts_any(&run->top);
}

/* The length to try: what is left of the span, or no more than `longest`; no crumb is left for the
 * last step, and no step crosses a corner of a table. */
static ph_wide trial_length(const ph_run *run, ph_wide left, ph_wide longest) {
  if (!chosen_here(run))
    return left;
  const ph_wide h = fabsl(left) <= longest      ? left
                    : fabsl(left) > 2 * longest ? copysignl(longest, left)
                                                : left / 2;
  return acts_until(&run->top, run->stepper.t, h);
}

/* A trial from x to y. *h: the length asked for, and what came of it; *error: to be compared with
 * the tolerance; *next: the length that should be tried after this one. */
static int trial(ph_run *run, const ph_wide x[], ph_wide *h, ph_wide y[], ph_wide *error,
                 ph_wide *next) {
  const ph_wide tolerance = (ph_wide)run->options.tolerance, start = run->stepper.t;
  int status;
  *error = 0, *next = 0;
  if (run->stepper.gsl)
    status = step_gsl(&run->stepper, x, *h, y, error);
  else if (run->stiff)
    status = step_implicit(&run->stepper, run->implicit, x, tolerance, h, next, y);
  else if (acts_any(&run->top))
    status = step_extrapolate(&run->stepper, x, tolerance, h, next, y);
  else
    status = step_taylor(&run->stepper, x, taylor_order(&run->options), tolerance, h, y);
  /* a trial step of GSL that is far too long may overflow: a shorter one is tried, until time
   * stands still */
  if (status == PH_ERANGE && run->stepper.gsl && start + *h != start) {
    *error = HUGE_VALL;
    status = PH_OK;
  }
  if (!status && run->stepper.gsl)
    *next = rescale(fabsl(*h), *error / tolerance, gsl_odeiv2_step_order(run->stepper.gsl));
  return status;
}

/* Takes the implicit method where something decays so fast that steps of explicit ones are short
   because of it, and leaves it again where nothing does: after the step h, number n of a call. */
static int judge(ph_run *run, const ph_wide x[], ph_wide h, long n) {
  /* decays in a step: the extrapolation is stable up to about 10; the implicit steps are shorter */
  const ph_wide stiff = 4, mild = 0.25L;
  enum { OFTEN = 16 };
  if (run->options.method != PH_TAYLOR || !acts_any(&run->top) || n % OFTEN != 0)
    return PH_OK;
  ph_wide rate;
  int status = step_decay(&run->stepper, x, h, &rate);
  if (status)
    return status;
  run->stiff = rate * h > (run->stiff ? mild : stiff);
  if (run->stiff && !run->implicit)
    status = implicit_new(&run->implicit, ph_top_states(&run->top), run->options.tolerance);
  return status;
}

/* A step of *h, or of less where that is too long. */
static int again(void *of, const ph_wide x[], ph_wide *h, ph_wide y[]) {
  ph_run *run = of;
  for (;;) {
    ph_wide error, next;
    const int status = trial(run, x, h, y, &error, &next);
    if (status || error <= (ph_wide)run->options.tolerance)
      return status;
    if (run->stepper.t + *h == run->stepper.t)
      return PH_ESTEP;
    *h = copysignl(next, *h);
  }
}

/* x goes over the span; *suggestion: the longest step worth trying, kept from run to run; 0: none
 * is known yet. */
static int go_adaptive(ph_run *run, ph_wide span, ph_wide x[], ph_wide *suggestion, long *steps) {
  const ph_wide start = (ph_wide)run->t;
  const int n = ph_top_states(&run->top);
  ph_wide done = 0, longest = *suggestion;
  run->stepper.t = start;
  if (chosen_here(run) &&
      !(longest > 0)) { /* a hundredth of a radian: the control finds its own within a few */
    ph_wide rate;
    const int status = step_rate(&run->stepper, x, &rate);
    if (status)
      return status;
    longest = rate > 0 ? 0.01L / rate : fabsl(span);
  }
  if (run->corners.n > 0)
    corners_begin(&run->corners, &run->stepper, span, x);
  long tries = 0;
  while (done != span) {
    const ph_wide left = span - done;
    ph_wide y[PH_STATES], error, next;
    run->stepper.t = start + done;
    ph_wide h = trial_length(run, left, longest);
    int status = corners_settle(&run->corners, &run->stepper, h, x);
    if (!status)
      status = trial(run, x, &h, y, &error, &next);
    if (!status && error <= (ph_wide)run->options.tolerance && run->corners.n > 0)
      status = corners_cut(&run->corners, &run->stepper, again, run, x, &h, &next, y);
    if (status)
      return status;
    if (++tries > run->options.max_steps || stopped(run))
      return PH_ESTEPS;
    if (h != left && start + done + h == start + done)
      return PH_ESTEP;
    if (error > (ph_wide)run->options.tolerance) {
      longest = next;
      continue;
    }
    project(run, y);
    for (int i = 0; i < n; i++)
      x[i] = y[i];
    done = h == left ? span : done + h;
    if (h != left || next > longest) /* a step cut short by the end says nothing of the next one */
      longest = next;
    (*steps)++;
    run->implicit_steps += run->stiff;
    run->stepper.t = start + done;
    const int unjudged = judge(run, x, h, *steps);
    if (unjudged)
      return unjudged;
  }
  *suggestion = longest;
  return PH_OK;
}

/* No steps: every time from the start. */
static int go_exact(ph_run *run, double t, double x[7]) {
  const int status = free_top_at(&run->exact, pair_difference(t, run->start), x);
  if (status)
    return status;
  wide_load(7, x, run->x);
  run->t = t;
  return PH_OK;
}

/* Of the methods of integration, the only writer of a run's state: all of it at once, after
 * everything has gone well. */
int ph_run_to(ph_run *run, double t, const double u[3], double x[]) {
  if (!isfinite(t) || (u && (run->top.effects & PH_CONTROL) && !wide_finite(3, u)))
    return PH_EFINITE;
  if (run->options.method == PH_EXACT)
    return go_exact(run, t, x);
  const int n = ph_top_states(&run->top);
  ph_wide state[PH_STATES], suggestion = run->h;
  const ph_wide span = (ph_wide)t - (ph_wide)run->t;
  long steps = 0;
  for (int i = 0; i < n; i++)
    state[i] = run->x[i];
  motion_load(&run->top, u, &run->stepper.loads);
  int status = run->options.step > 0 ? go_fixed(run, span, state, &steps)
                                     : go_adaptive(run, span, state, &suggestion, &steps);
  double out[PH_STATES];
  if (!status)
    status = wide_store(n, state, out);
  if (status)
    return status;
  for (int i = 0; i < n; i++) {
    run->x[i] = state[i];
    x[i] = out[i];
  }
  run->t = t;
  run->h = suggestion;
  run->steps += steps;
  return PH_OK;
}

double ph_run_time(const ph_run *run) {
  return run->t;
}

long ph_run_steps(const ph_run *run) {
  return run->steps;
}

long ph_run_implicit_steps(const ph_run *run) {
  return run->options.method == PH_IMPLICIT ? run->steps : run->implicit_steps;
}

long ph_run_evaluations(const ph_run *run) {
  return run->stepper.evaluations;
}
