/* hard_peers.c - who survives the hard cases: GSL, SUNDIALS, the code of textbooks, and polhode.
   SPDX-License-Identifier: GPL-3.0-or-later

     hard_peers ORACLES SCRATCH    prints a page of Markdown

   All integrators get the same equations (hard_cases.c), the relative tolerance 1e-12, absolute
   ones of 1e-12 of the largest rate and of |q| = 1, a first step that changes the state by a
   thousandth, and 3e6 calls or 3 s. Errors are those that the oracles in MPFR find (tests/oracle),
   or follow from a formula; of q and -q the nearer counts. */
#include "clock.h"
#include "hard_peers.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "errormap.h"
#include "harddamped.h"
#include "hardtop.h"
#include "polhode.h"

enum { FINE, GIVES_UP, SPENT, SECONDS = 3 };

static const char *oracles, *scratch;

/* ---- what textbooks write ---- */

static int hand_rk4(const struct peer *self, struct peer_run *r, double x[NX]) {
  double size = 0, a[NX], b[NX], c[NX], d[NX], y[NX];
  (void)self;
  hard_rates(0, x, a, r);
  for (int i = 4; i < NX; i++)
    size = fmax(size, fmax(fabs(x[i]), fabs(a[i]) / (1 + fabs(x[i]))));
  const double wish = ceil(r->m->t * size / 0.005), most = BUDGET / 4 - 1;
  const long n = (long)fmax(1000, fmin(wish, most));
  const double h = r->m->t / (double)n;
  for (long s = 0; s < n; s++) {
    const double t = (double)s * h;
    hard_rates(t, x, a, r);
    for (int i = 0; i < NX; i++)
      y[i] = x[i] + h / 2 * a[i];
    hard_rates(t + h / 2, y, b, r);
    for (int i = 0; i < NX; i++)
      y[i] = x[i] + h / 2 * b[i];
    hard_rates(t + h / 2, y, c, r);
    for (int i = 0; i < NX; i++)
      y[i] = x[i] + h * c[i];
    hard_rates(t + h, y, d, r);
    for (int i = 0; i < NX; i++)
      x[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
  }
  return wish > most ? SPENT : FINE;
}

/* Angles phi, theta, psi about z, x, z (Goldstein 4.9): theta = 0 divides by zero. */
static void angles_rates(double t, const double e[6], double de[6], struct peer_run *r) {
  double x[NX], dx[NX];
  const double th = e[1] / 2, su = (e[0] + e[2]) / 2, di = (e[0] - e[2]) / 2;
  x[0] = cos(th) * cos(su);
  x[1] = sin(th) * cos(di);
  x[2] = sin(th) * sin(di);
  x[3] = cos(th) * sin(su);
  memcpy(x + 4, e + 3, 3 * sizeof e[0]);
  hard_rates(t, x, dx, r);
  const double s = sin(e[2]), c = cos(e[2]);
  de[0] = (e[3] * s + e[4] * c) / sin(e[1]);
  de[1] = e[3] * c - e[4] * s;
  de[2] = e[5] - de[0] * cos(e[1]);
  memcpy(de + 3, dx + 4, 3 * sizeof e[0]);
}

static int hand_angles(const struct peer *self, struct peer_run *r, double x[NX]) {
  double e[6], a[6], b[6], c[6], d[6], y[6], size = 0;
  (void)self;
  e[1] = 2 * atan2(hypot(x[1], x[2]), hypot(x[0], x[3]));
  const double su = atan2(x[3], x[0]), di = atan2(x[2], x[1]);
  e[0] = su + di;
  e[2] = su - di;
  for (int i = 4; i < NX; i++)
    size = fmax(size, fabs(e[i - 1] = x[i]));
  const double wish = ceil(r->m->t * size / 0.005), most = BUDGET / 4 - 1;
  const long n = (long)fmax(1000, fmin(wish, most));
  const double h = r->m->t / (double)n;
  for (long s = 0; s < n; s++) {
    const double t = (double)s * h;
    angles_rates(t, e, a, r);
    for (int i = 0; i < 6; i++)
      y[i] = e[i] + h / 2 * a[i];
    angles_rates(t + h / 2, y, b, r);
    for (int i = 0; i < 6; i++)
      y[i] = e[i] + h / 2 * b[i];
    angles_rates(t + h / 2, y, c, r);
    for (int i = 0; i < 6; i++)
      y[i] = e[i] + h * c[i];
    angles_rates(t + h, y, d, r);
    for (int i = 0; i < 6; i++)
      e[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
  }
  const double th = e[1] / 2, sum = (e[0] + e[2]) / 2, dif = (e[0] - e[2]) / 2;
  x[0] = cos(th) * cos(sum);
  x[1] = sin(th) * cos(dif);
  x[2] = sin(th) * sin(dif);
  x[3] = cos(th) * sin(sum);
  memcpy(x + 4, e + 3, 3 * sizeof e[0]);
  return wish > most ? SPENT : FINE;
}

/* ---- polhode ---- */

static long double burnt(void *context, long double t, const long double x[]) {
  const struct motion *m = context;
  (void)x;
  return -(long double)m->I[0] * t / m->burn;
}

static int library(const struct peer *self, struct peer_run *r, double x[NX]) {
  const struct motion *m = r->m;
  static const double down[3] = {0, 0, -1}, stop[6] = {0, 1, 1, 1, 1.0000000000000002, 0};
  const double tensor[6] = {m->I[0], m->I[1], m->I[2], 0, 0, 0},
               C[9] = {m->c, 0, 0, 0, m->c, 0, 0, 0, m->c};
  ph_varying torque[3] = {{0}}, part[6] = {{0}}, rate[6] = {{0}};
  const double mass = m->oracle == HEAVY ? 0.01 : 1,
               com[3] = {0, 0, m->oracle == HEAVY ? m->load[2] : 0};
  ph_top top;
  ph_options options = ph_options_default();
  ph_run *run = NULL;
  (void)self;
  int status = ph_top_init_tensor(&top, mass, com, tensor);
  if (status == 0 && m->oracle == HEAVY)
    status = ph_top_gravity(&top, 100, down);
  if (status == 0 && m->c > 0)
    status = ph_top_damping(&top, C);
  if (status == 0 && m->T > 0)
    status = ph_top_friction(&top, m->T, m->s);
  if (status == 0 && m->off > 0) {
    torque[2] = (ph_varying){.rows = 3, .table = stop};
    status = ph_top_varying(&top, 0, torque);
  }
  if (status == 0 && m->burn > 0) {
    for (int i = 0; i < 3; i++) {
      part[i] = (ph_varying){.f = burnt, .context = (void *)m};
      rate[i].value = -m->I[i] / m->burn;
    }
    status = ph_top_parts(&top, part, rate);
  }
  if (m->oracle == FREE)
    options.method = PH_EXACT;
  options.max_steps = BUDGET / 100; /* an expansion costs a hundred evaluations */
  if (status == 0)
    status = ph_run_new(&run, &top, &options, 0, x);
  if (status == 0)
    status = ph_run_to(run, m->t, NULL, x);
  if (run != NULL)
    r->calls = ph_run_evaluations(run);
  ph_run_free(run);
  return status == 0 ? FINE : status == PH_ESTEPS ? SPENT : GIVES_UP;
}

static int emitted(const struct peer *self, struct peer_run *r, double x[NX]) {
  const struct motion *m = r->m;
  (void)self;
  if (m->oracle == FREE) {
    errormap_model model;
    errormap_orbit orbit;
    if (errormap_init(&model, m->I) != 0 || errormap_solve(&orbit, &model, x) != 0)
      return GIVES_UP;
    errormap_at(&orbit, m->t, x);
  } else if (m->oracle == HEAVY) {
    const double p[2] = {m->I[0], m->I[2]};
    hardtop_model model;
    hardtop_orbit orbit;
    if (hardtop_init(&model, p) != 0 || hardtop_solve(&orbit, &model, x) != 0)
      return GIVES_UP;
    hardtop_at(&orbit, m->t, x);
  } else if (m->c > 0) {
    const double p[1] = {m->I[0]};
    harddamped_model model;
    harddamped_orbit orbit;
    if (harddamped_init(&model, p) != 0 || harddamped_solve(&orbit, &model, x) != 0)
      return GIVES_UP;
    harddamped_at(&orbit, m->t, x);
  } else {
    return -1; /* no closed form: its steppers are those of docs/methods.md */
  }
  return FINE;
}

static const struct peer own[] = {{"polhode, emitted", emitted, NULL},
                                  {"polhode, library", library, NULL},
                                  {"RK4, quaternion", hand_rk4, NULL},
                                  {"RK4, Euler angles", hand_angles, NULL},
                                  {NULL, NULL, NULL}};
static const struct peer *const lists[] = {own, hard_gsl, hard_sundials};

/* ---- judging ---- */

static void line(FILE *f, const struct motion *m, const double x[NX], double sign) {
  for (int i = 0; i < 3; i++)
    fprintf(f, "%a ", m->I[i]);
  for (int i = 0; i < 3; i++)
    fprintf(f, "%a ", m->oracle == HEAVY ? m->load[i] : 0.0);
  fprintf(f, "%a %a %a %a %a %a %a %a", m->w[0], m->w[1], m->w[2], m->q[0], m->q[1], m->q[2],
          m->q[3], m->t);
  fprintf(f, " %a %a %a %a %a %a %a\n", x[4], x[5], x[6], sign * x[0], sign * x[1], sign * x[2],
          sign * x[3]);
}

static double asked(const struct motion *m, const double x[NX]) {
  char command[1024];
  double least = HUGE_VAL, rates, attitude;
  FILE *f = fopen(scratch, "w");
  if (f == NULL)
    return NAN;
  line(f, m, x, 1);
  line(f, m, x, -1);
  fclose(f);
  snprintf(command, sizeof command, "%s/%s %s -e < %s", oracles,
           m->oracle == HEAVY ? "heavy_top" : "free_top", m->oracle == HEAVY ? "-b 400" : "-b 2560",
           scratch);
  f = popen(command, "r");
  char text[1024];
  while (f != NULL && fgets(text, sizeof text, f) != NULL)
    if (sscanf(text, "%lf %lf", &rates, &attitude) == 2)
      least = fmin(least, fmax(rates, attitude));
  if (f != NULL)
    pclose(f);
  return least;
}

/* Rates and the angle about z are known. */
static double known(const struct motion *m, const double x[NX]) {
  double wz = m->wz, turn = m->turn, plus = 0, minus = 0, rates = 0;
  if (m->burn > 0) {
    wz = (double)(m->w[2] / (1 - (long double)m->t / m->burn));
    turn = (double)(-m->w[2] * m->burn * log1pl(-(long double)m->t / m->burn));
  }
  const double want[NX] = {cos(turn / 2), 0, 0, sin(turn / 2), 0, 0, wz},
               scale = fmax(fabs(wz), fabs(m->w[2]));
  for (int i = 0; i < NX; i++) {
    if (i < 4) {
      plus = hypot(plus, x[i] - want[i]);
      minus = hypot(minus, x[i] + want[i]);
    } else {
      rates = fmax(rates, fabs(x[i] - want[i]) / scale);
    }
  }
  return fmax(fmin(plus, minus), rates);
}

static void number(double x) {
  if (x >= 1e-3 && x < 10)
    printf("%.2g", x);
  else
    printf("%.0e", x);
}

/* What an integrator did, in a process of its own: some do not end, whatever the equations say. */
struct outcome {
  int status;
  long calls;
  double took, x[NX];
};

static struct outcome tried(const struct peer *p, const struct motion *m) {
  struct outcome o = {.status = SPENT};
  int ends[2];
  if (pipe(ends) != 0)
    return o;
  fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    const struct rlimit most = {SECONDS, SECONDS};
    struct peer_run r = {m, 0};
    setrlimit(RLIMIT_CPU, &most);
    memcpy(o.x, m->q, sizeof m->q);
    memcpy(o.x + 4, m->w, sizeof m->w);
    const double start = now();
    o.status = p->go(p, &r, o.x);
    o.took = now() - start;
    o.calls = r.calls;
    _exit(write(ends[1], &o, sizeof o) != sizeof o);
  }
  close(ends[1]);
  if (child < 0 || read(ends[0], &o, sizeof o) != sizeof o)
    o.status = SPENT;
  close(ends[0]);
  waitpid(child, NULL, 0);
  return o;
}

static void cell(const struct peer *p, const struct motion *m, int *survived) {
  const struct outcome o = tried(p, m);
  const double *x = o.x, took = o.took;
  const int status = o.status;
  int finite = 1;
  for (int i = 0; i < NX; i++)
    finite = finite && isfinite(x[i]);
  if (status == -1) {
    printf(" - |");
    return;
  }
  if (status == SPENT && p->go != hand_rk4 && p->go != hand_angles) {
    printf(" never ends |");
    return;
  }
  if (status == GIVES_UP) {
    printf(" gives up |");
    return;
  }
  if (!finite) {
    printf(" NaN |");
    return;
  }
  const double e = m->oracle == ANALYTIC ? known(m, x) : asked(m, x);
  printf(e <= m->bound ? " **" : " wrong by ");
  number(e);
  printf(e <= m->bound ? "**, " : ", ");
  if (o.calls > 0)
    printf("%ld calls, ", o.calls);
  printf(took < 1e-4 ? "%.1g ms |" : "%.2g ms |", 1e3 * took);
  *survived += e <= m->bound;
}

int main(int argc, char **argv) {
  int count = 0, survived[32] = {0};
  if (argc == 1) { /* the short part */
    hard_numbers();
    return 0;
  }
  if (argc != 3)
    return 2;
  oracles = argv[1];
  scratch = argv[2];
  printf("| case | why it is hard |");
  for (size_t l = 0; l < 3; l++)
    for (const struct peer *p = lists[l]; p->name != NULL; p++, count++)
      printf(" %s |", p->name);
  printf("\n|---|---|");
  for (int i = 0; i < count; i++)
    printf("---|");
  printf("\n");
  for (int c = 0; c < hard_motion_count; c++) {
    printf("| %s | %s |", hard_motions[c].name, hard_motions[c].hard);
    int i = 0;
    for (size_t l = 0; l < 3; l++)
      for (const struct peer *p = lists[l]; p->name != NULL; p++, i++) {
        cell(p, &hard_motions[c], &survived[i]);
        fflush(stdout);
      }
    printf("\n");
  }
  printf("| **right** | of %d |", hard_motion_count);
  for (int i = 0; i < count; i++)
    printf(" **%d** |", survived[i]);
  printf("\n\n");
  hard_numbers();
  return 0;
}
