/* bench.h - how long something takes, and what others take for it: what this folder's files share.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef POLHODE_BENCH_H
#define POLHODE_BENCH_H

#include "plugin/object.h"

/* ---- time.c ---- */

/* Does it n times over, each time from the same start; 0, or what went wrong (positive). */
typedef int bench_work(void *what, long n);

struct bench_result {
  double median, least, most; /* seconds for doing it once */
  long repeats;               /* samples that were taken */
};

enum { BENCH_INTERRUPTED = -1, BENCH_MAX_REPEATS = 999 };

/* Up to `repeats` samples, fewer (one at least) after `limit` seconds; 0, what `work` said, or
   BENCH_INTERRUPTED. Nothing of Lua is called. */
int bench_measure(bench_work *work, void *what, long repeats, double limit, struct bench_result *r);
/* Seconds that a waiting user would count. */
double bench_now(void);
/* Push {median =, least =, most =, repeats =} with all times divided by `part`. */
void bench_push(lua_State *L, const struct bench_result *r, double part);

/* Work with a fixed step may be longer than anyone would wait: of `whole` steps the number that
   `some` of can be done n times within the limit. `march` does that many steps from the start. */
typedef int bench_march(void *what, long steps);
int bench_part(bench_march *march, void *what, long whole, double limit, long *some);

/* The request for a measurement, from the table at index 2. */
struct bench_request {
  double x0[MAX_STATES], u[MAX_STATES];
  double to, limit;
  long repeats;
};
void bench_read(lua_State *L, const struct plugin *p, struct bench_request *r);
/* How many steps of h lead over a span, as a whole number; raises an error beyond 1e15. */
long bench_steps(lua_State *L, double span, double h);

/* ---- emitted.c ---- */

int plugin_march(lua_State *L);
int plugin_time(lua_State *L);
int plugin_time_closed(lua_State *L);

/* ---- peers.c ---- */

/* What an integrator is given. */
struct peer_problem {
  const struct polhode_plugin *code;
  struct polhode_place *place;
  double setting; /* step or tolerance */
  double span;    /* of time, for the first step */
};

enum { PEER_DONE, PEER_MORE, PEER_FAILED };

/* An integrator of another hand. One with a fixed step has `march`, else `go`. */
struct peer {
  const char *name;
  const void *kind; /* the peer's own */
  /* NULL: no memory */
  void *(*open)(const struct peer *self, const struct peer_problem *p);
  void (*close)(void *it);
  /* anew from x at t; not 0: cannot */
  int (*start)(void *it, double t, const double x[]);
  /* n steps of h from t: 0, or not 0 */
  int (*march)(void *it, double t, double x[], double h, long n);
  /* on to t1 in about `most` steps at most: PEER_DONE; PEER_MORE: *t and x say how far */
  int (*go)(void *it, double *t, double x[], double t1, long most);
  long (*steps)(void *it); /* since start */
};

int plugin_peer(lua_State *L);
int plugin_time_peer(lua_State *L);

/* ---- sundials.c ---- */

/* Ended by one without a name; empty where SUNDIALS was not there at build. */
extern const struct peer bench_sundials[];

#endif
