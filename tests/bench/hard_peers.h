/* hard_peers.h - hard motions for other people's integrators: what a case is.
   SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HARD_PEERS_H
#define HARD_PEERS_H

enum { NX = 7, BUDGET = 3000000 };

/* I w' = (I w) x w + R(q)^T ez x load - c w - T w/sqrt(|w|^2 + s^2) + torque (until `off`), q' = q
   (0, w)/2; with burn > 0 the moments are I (1 - t/burn), and I' w joins the left side. */
struct motion {
  const char *name, *hard; /* what it is, why it is hard */
  double I[3], load[3], c, T, s, torque[3], off, burn;
  double w[3], q[4], t;
  enum { FREE, HEAVY, ANALYTIC } oracle;
  double wz, turn; /* ANALYTIC: the rate about z and the angle turned about it */
  double bound;
};

/* What a right-hand side is given, and how often it was called. */
struct peer_run {
  const struct motion *m;
  long calls;
};

extern const struct motion hard_motions[];
extern const int hard_motion_count;

/* The textbook's equations in double; 1 when the budget is spent. */
int hard_rates(double t, const double x[], double dx[], void *run);

struct peer {
  const char *name;
  /* The state at t, in place; 0, 1: the integrator gives up, 2: the budget of calls is spent. */
  int (*go)(const struct peer *self, struct peer_run *r, double x[NX]);
  const void *kind;
};
extern const struct peer hard_gsl[], hard_sundials[];

/* Tables of what is not a motion: axes, elliptic functions, moments. */
void hard_numbers(void);

#endif
