/* engine_move.c - translation and the turning frame: from Lua to the library, and their largest
 * terms.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "engine.h"

#include <math.h>

static const double none[3] = {0, 0, 0};

int engine_read_translation(struct engine_scene *s) {
  double gravity[3], stiffness[3];
  engine_get(s->L, -1, "gravity", 3, gravity, NULL);
  engine_get(s->L, -1, "stiffness", 3, stiffness, none);
  int status = ph_top_translation(&s->top, gravity);
  if (status == PH_OK)
    status = ph_top_restoring(&s->top, stiffness);
  if (status == PH_OK)
    status = ph_top_drag(&s->top, engine_number(s->L, "linear"), engine_number(s->L, "drag"));
  return status;
}

int engine_read_frame(struct engine_scene *s) {
  double rate[3], rate_dot[3];
  engine_get(s->L, -1, "rate", 3, rate, NULL);
  engine_get(s->L, -1, "rate_dot", 3, rate_dot, none);
  lua_getfield(s->L, -1, "centrifugal");
  const int centrifugal = lua_toboolean(s->L, -1);
  lua_getfield(s->L, -2, "moves");
  const int moves = lua_toboolean(s->L, -1);
  lua_pop(s->L, 2);
  int status = ph_top_frame(&s->top, rate, rate_dot, centrifugal);
  if (status == PH_OK && moves && !(s->top.effects & PH_TRANSLATION))
    status = ph_top_translation(&s->top, none);
  return status;
}

static double larger(double a, double b) {
  return a > b ? a : b; /* NaN in b is passed over: the rates themselves show it */
}

/* |Omega|, component by component, at time t. */
static void turning(const ph_top *top, double t, double Omega[3], double change[3]) {
  for (int i = 0; i < 3; i++) {
    change[i] = top->effects & PH_FRAME ? fabs(top->move.rate_dot[i]) : 0;
    Omega[i] = top->effects & PH_FRAME ? larger(fabs(top->move.rate[i]), change[i] * fabs(t)) : 0;
  }
}

void engine_move_scale(const ph_top *top, double t, const double x[], double scale[]) {
  /* which q multiplies x, y, z of Omega in row i of (0, Omega) q / 2 */
  static const int row[4][3] = {{1, 2, 3}, {0, 3, 2}, {3, 0, 1}, {2, 1, 0}};
  const ph_move *m = &top->move;
  double Omega[3], change[3], u[3];
  turning(top, t, Omega, change);
  for (int i = 0; i < 4; i++)
    for (int k = 0; k < 3; k++)
      scale[i] = larger(scale[i], fabs(0.5 * x[row[i][k]]) * Omega[k]);
  if (!(top->effects & PH_TRANSLATION))
    return;
  const double *r = x + 7, *v = x + 10, speed = hypot(hypot(v[0], v[1]), v[2]);
  for (int i = 0; i < 3; i++) { /* terms of 2 v + Omega x r */
    const int a = (i + 1) % 3, b = (i + 2) % 3;
    u[i] = larger(2 * fabs(v[i]), larger(Omega[a] * fabs(r[b]), Omega[b] * fabs(r[a])));
  }
  for (int i = 0; i < 3; i++) {
    const int a = (i + 1) % 3, b = (i + 2) % 3;
    double s = fabs(m->gravity[i]);
    if (top->effects & PH_RESTORING)
      s = larger(s, fabs(m->stiffness[i] * r[i]) / top->mass);
    if (top->effects & PH_DRAG)
      s = larger(s, larger(m->linear, m->drag * speed) * fabs(v[i]) / top->mass);
    s = larger(s, larger(Omega[a] * u[b], Omega[b] * u[a]));
    s = larger(s, larger(change[a] * fabs(r[b]), change[b] * fabs(r[a])));
    scale[7 + i] = fabs(v[i]);
    scale[10 + i] = s;
  }
}

double engine_move_energy(const ph_top *top, const double x[], const double spread[9]) {
  const ph_move *m = &top->move;
  double Omega[3], change[3], scale = 0;
  turning(top, 0, Omega, change);
  for (int i = 0; i < 9; i++) /* Omega . (q L q*): turned vectors are as large as they were */
    scale = larger(scale,
                   larger(larger(Omega[0], Omega[1]), Omega[2]) * spread[i] * fabs(x[4 + i % 3]));
  if (!(top->effects & PH_TRANSLATION))
    return scale;
  const double *r = x + 7, *v = x + 10;
  for (int i = 0; i < 3; i++) {
    const int a = (i + 1) % 3, b = (i + 2) % 3;
    const double u = larger(Omega[a] * fabs(r[b]), Omega[b] * fabs(r[a]));
    scale = larger(scale, top->mass * larger(v[i] * v[i] / 2, u * u));
    scale = larger(scale, top->mass * fabs(m->gravity[i] * r[i]));
    if (top->effects & PH_RESTORING)
      scale = larger(scale, fabs(m->stiffness[i]) * r[i] * r[i] / 2);
  }
  return scale;
}
