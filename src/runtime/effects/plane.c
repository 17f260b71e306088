/* plane.c - a body on a plane: Newton and Euler with the contact force as an unknown.
   SPDX-License-Identifier: GPL-3.0-or-later

   In inertial axes, with d from the centre of mass to the contact point, d' its rate, U the
   velocity of the plane's point under it, a and A the accelerations sought, F the contact force:
     m A - F = m g      I a - d x F = b      A + a x d + w x d' = U'     (rolling: all of it)
   without rolling F = N G, G = n and the friction, and the third along n alone. One linear system
   as it stands, by elimination with pivots. Resistance to spinning and rolling is a torque N T
   beside d x F. The contact point is acts/surface.c's. */
#include "acts/acts.h"

#include <string.h>

/* The contact in a state; vectors in inertial axes but r and its rate. */
typedef struct contact {
  ph_wide q[4], n[3], e1[3], e2[3], w[3]; /* q unit */
  ph_wide d[3], change[3];                /* and d' */
  ph_wide com[3], V[3], U[3], slip[3];
  ph_wide G[3]; /* F = N G; rolling: unknown */
  ph_wide T[3];
} contact;

static void directions(const ph_plane *p, contact *c) {
  wide_load(3, p->normal, c->n);
  wide_load(3, p->e1, c->e1);
  const ph_wide length = wide_norm(c->n);
  for (int i = 0; i < 3; i++)
    c->n[i] /= length;
  const ph_wide along = wide_dot(c->n, c->e1);
  for (int i = 0; i < 3; i++)
    c->e1[i] -= along * c->n[i];
  const ph_wide left = wide_norm(c->e1);
  for (int i = 0; i < 3; i++)
    c->e1[i] /= left;
  wide_cross(c->n, c->e1, c->e2);
}

static ph_wide resistance(const ph_resistance *f, ph_wide rate) {
  const ph_wide size = f->smoothing > 0 ? hypotl(rate, (ph_wide)f->smoothing) : 1;
  return (ph_wide)f->coefficient / size;
}

/* T, from the turning beside the plane: its parts along n and across. */
static void resist(const ph_plane *p, contact *c) {
  ph_wide across[3];
  const ph_wide along = wide_dot(c->n, c->w), spin = along - (ph_wide)p->rate;
  for (int i = 0; i < 3; i++)
    across[i] = c->w[i] - along * c->n[i];
  const ph_wide turning = resistance(&p->spinning, spin) * spin;
  const ph_wide rolling = resistance(&p->rolling, wide_norm(across));
  for (int i = 0; i < 3; i++)
    c->T[i] = -turning * c->n[i] - rolling * across[i];
}

static int touch(const effect_at *e, contact *c) {
  const ph_plane *p = &e->act->of.plane;
  const ph_wide *own = e->x + e->place, length = wide_quat_norm(e->x);
  ph_wide g[3], g_rate[3], r[3], rate[3], u[3], turning[3];
  directions(p, c);
  for (int i = 0; i < 4; i++)
    c->q[i] = e->x[i] / length;
  wide_sandwich(c->q, e->x + 4, 1, c->w);
  wide_sandwich(c->q, c->n, 0, g);
  wide_cross(g, e->x + 4, g_rate);
  if (!acts_surface(p, g, g_rate, r, rate))
    return PH_ECONTACT;
  wide_sandwich(c->q, r, 1, c->d);
  wide_sandwich(c->q, rate, 1, c->change);
  wide_cross(c->w, c->d, turning);
  const int moves = p->placed, rolls = p->law == PH_ROLLING;
  const ph_wide height = -wide_dot(c->n, c->d), rise = -wide_dot(c->n, turning);
  for (int i = 0; i < 3; i++) {
    c->change[i] += turning[i];
    c->com[i] = height * c->n[i] + (moves ? own[0] * c->e1[i] + own[1] * c->e2[i] : 0);
    u[i] = c->com[i] + c->d[i]; /* the contact point */
  }
  wide_cross(c->n, u, c->U);
  for (int i = 0; i < 3; i++) {
    c->U[i] *= (ph_wide)p->rate;
    c->V[i] = rolls ? c->U[i] - turning[i]
                    : rise * c->n[i] + (moves ? own[2] * c->e1[i] + own[3] * c->e2[i] : 0);
    c->slip[i] = rolls ? 0 : c->V[i] + turning[i] - c->U[i];
  }
  ph_wide share = 0;
  if (p->law == PH_VISCOUS)
    share = (ph_wide)p->friction;
  else if (p->law == PH_COULOMB)
    share = (ph_wide)p->friction / hypotl(wide_norm(c->slip), (ph_wide)p->smoothing);
  for (int i = 0; i < 3; i++)
    c->G[i] = c->n[i] - share * c->slip[i];
  resist(p, c);
  return PH_OK;
}

/* Column j of the matrix of v -> a x v. */
static void cross_column(const ph_wide a[3], int j, ph_wide out[3]) {
  const ph_wide e[3] = {j == 0, j == 1, j == 2};
  wide_cross(a, e, out);
}

/* A and a in y[0..2], y[3..5]; F from y[6] on: three components, or N. b in inertial axes. */
static int accelerations(const effect_at *e, const contact *c, const ph_wide b[3], ph_wide y[]) {
  static const int at[3][3] = {{XX, XY, XZ}, {XY, YY, YZ}, {XZ, YZ, ZZ}};
  const ph_plane *p = &e->act->of.plane;
  const int rolls = p->law == PH_ROLLING;
  ph_wide M[ACTS_ROWS][ACTS_ROWS] = {{0}}, R[9], I[6], column[3], bend[3], u[3];
  const ph_wide mass = (ph_wide)e->top->mass;
  wide_quat_matrix(c->q, R);
  wide_congruence(R, e->top->wide_inertia, I);
  wide_cross(c->w, c->change, bend);
  for (int i = 0; i < 3; i++)
    u[i] = c->V[i] + c->change[i];
  wide_cross(c->n, u, u); /* U' = rate n x P' */
  for (int i = 0; i < 3; i++) {
    M[i][i] = mass;
    y[i] = mass * (ph_wide)p->gravity[i];
    y[3 + i] = b[i];
    for (int j = 0; j < 3; j++)
      M[3 + i][3 + j] = I[at[i][j]];
  }
  if (rolls) {
    for (int j = 0; j < 3; j++) {
      M[j][6 + j] = -1;
      cross_column(c->d, j, column);
      for (int i = 0; i < 3; i++) {
        M[3 + i][6 + j] = -column[i] - c->T[i] * c->n[j]; /* N = n.F */
        M[6 + i][3 + j] = -column[i];
      }
      M[6 + j][j] = 1;
      y[6 + j] = (ph_wide)p->rate * u[j] - bend[j];
    }
    return acts_eliminate(9, M, y);
  }
  wide_cross(c->d, c->G, column);
  for (int i = 0; i < 3; i++) {
    M[i][6] = -c->G[i];
    M[3 + i][6] = -column[i] - c->T[i];
    M[6][i] = c->n[i];
  }
  wide_cross(c->d, c->n, column); /* n.(a x d) = a.(d x n) */
  for (int i = 0; i < 3; i++)
    M[6][3 + i] = column[i];
  y[6] = -wide_dot(c->n, bend);
  return acts_eliminate(7, M, y);
}

static int constrain(const effect_at *e, const ph_wide b[3], ph_wide dx[]) {
  const ph_plane *p = &e->act->of.plane;
  contact c;
  ph_wide y[ACTS_ROWS], torque[3];
  const int status = touch(e, &c);
  if (status)
    return status;
  wide_sandwich(c.q, b, 1, torque);
  if (!accelerations(e, &c, torque, y))
    return PH_EROD;
  wide_sandwich(c.q, y + 3, 0, dx + 4);
  ph_wide *own = dx + e->place;
  if (p->placed) {
    own[0] = wide_dot(c.e1, c.V);
    own[1] = wide_dot(c.e2, c.V);
  }
  if (p->placed && p->law != PH_ROLLING) {
    own[2] = wide_dot(c.e1, y);
    own[3] = wide_dot(c.e2, y);
  }
  return PH_OK;
}

/* F = m (A - g): A by the contact's own acceleration, from the w' that the motion has. */
static int contact_of(const effect_at *e, const ph_wide rate[], ph_contact *out) {
  const ph_plane *p = &e->act->of.plane;
  const int rolls = p->law == PH_ROLLING;
  const ph_wide mass = (ph_wide)e->top->mass;
  contact c;
  ph_wide spin[3], bend[3], part[3], P[3], F[3];
  const int status = touch(e, &c);
  if (status)
    return status;
  wide_sandwich(c.q, rate + 4, 1, spin);
  wide_cross(c.w, c.change, bend);
  for (int i = 0; i < 3; i++)
    P[i] = c.V[i] + c.change[i];
  wide_cross(c.n, P, P);
  wide_cross(spin, c.d, part);
  const ph_wide rise = -wide_dot(c.n, part) - wide_dot(c.n, bend);
  for (int i = 0; i < 3; i++) {
    const ph_wide g = (ph_wide)p->gravity[i];
    F[i] = rolls ? (ph_wide)p->rate * P[i] - bend[i] - part[i] - g : g;
  }
  const ph_wide along = rolls ? wide_dot(c.n, F) : rise - wide_dot(c.n, F);
  for (int i = 0; i < 3; i++) {
    out->force[i] = (double)(mass * (rolls ? F[i] : along * c.G[i]));
    out->com[i] = (double)c.com[i];
    out->velocity[i] = (double)c.V[i];
    out->point[i] = (double)(c.com[i] + c.d[i]);
    out->slip[i] = (double)c.slip[i];
  }
  out->reaction = (double)(mass * along);
  return PH_OK;
}

static int reach_of(const effect_at *e, ph_wide *arm, ph_wide *pull) {
  const ph_plane *p = &e->act->of.plane;
  contact c;
  ph_wide g[3];
  wide_load(3, p->gravity, g);
  const int status = touch(e, &c);
  if (status)
    return status;
  const ph_wide turning = wide_norm(c.w) + fabsl((ph_wide)p->rate);
  *arm = wide_norm(c.d);
  *pull = wide_norm(g) + turning * (turning * (*arm + wide_norm(c.com)) + wide_norm(c.change));
  return PH_OK;
}

static ph_wide kinetic(const effect_at *e) {
  contact c;
  return touch(e, &c) ? 0 : (ph_wide)e->top->mass * wide_dot(c.V, c.V) / 2;
}

static ph_wide potential(const effect_at *e) {
  contact c;
  ph_wide g[3];
  wide_load(3, e->act->of.plane.gravity, g);
  return touch(e, &c) ? 0 : -(ph_wide)e->top->mass * wide_dot(c.com, g);
}

/* ---- terms ---- */

/* The contact in double's state; 0: there is none. */
static int seen(const effect_terms *e, contact *c) {
  ph_wide x[PH_STATES];
  wide_load(ph_top_states(e->top), e->x, x);
  const effect_at at = {e->top, e->act, (ph_wide)e->t, x, e->place, 0};
  return touch(&at, c) == PH_OK;
}

/* The largest term of the arm, and of its rate. */
static double reach(const effect_terms *e, double *rate) {
  const ph_plane *p = &e->act->of.plane;
  contact c;
  const double fixed = p->rim + 2 * effect_norm(p->centre);
  if (!seen(e, &c)) {
    *rate = 0;
    return fixed;
  }
  *rate = (double)wide_norm(c.change);
  const double half = p->surface == PH_ELLIPSOID ? effect_norm(p->half_axes) : 0;
  return effect_larger(half, (double)wide_norm(c.d)) + fixed;
}

/* The largest acceleration among the terms of the centre of mass. */
static double largest(const effect_terms *e) {
  const ph_plane *p = &e->act->of.plane;
  double rate;
  const double arm = reach(e, &rate);
  const double w = effect_norm(e->x + 4) + fabs(p->rate);
  const double place = p->placed ? hypot(e->x[e->place], e->x[e->place + 1]) : 0;
  return effect_larger(effect_norm(p->gravity), w * (w * (arm + place) + rate));
}

/* I^-1 v in place of v, body axes; 0: of a rod. */
static int undone(const ph_top *top, ph_wide v[ACTS_ROWS]) {
  static const int at[3][3] = {{XX, XY, XZ}, {XY, YY, YZ}, {XZ, YZ, ZZ}};
  ph_wide M[ACTS_ROWS][ACTS_ROWS];
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      M[i][j] = top->wide_inertia[at[i][j]];
  return acts_eliminate(3, M, v);
}

/* How far one rounding of the contact's terms may be magnified in w': the friction's share of N,
   and what is lost where friction nearly undoes the support, 1/m + n.(I^-1 (d x G) x d) -> 0. */
static double share(const effect_terms *e, double arm) {
  const ph_plane *p = &e->act->of.plane;
  ph_wide lever[3], turned[ACTS_ROWS];
  contact c;
  if (!seen(e, &c))
    return 1;
  if (p->law == PH_ROLLING)
    return 1 + (double)wide_norm(c.T) / arm;
  wide_cross(c.d, c.G, lever);
  for (int i = 0; i < 3; i++)
    lever[i] += c.T[i];
  wide_sandwich(c.q, lever, 0, turned);
  if (!undone(e->top, turned))
    return 1;
  wide_sandwich(c.q, turned, 1, turned);
  wide_cross(turned, c.d, lever);
  const ph_wide mass = (ph_wide)e->top->mass, down = mass * wide_dot(c.n, lever);
  const ph_wide size = (wide_norm(c.G) + wide_norm(c.T) / (ph_wide)arm) *
                       (1 + mass * wide_norm(turned) * wide_norm(c.d));
  return (double)(size / fabsl(1 + down));
}

static void term_torque(const effect_terms *e, double term[3]) {
  double rate;
  const double arm = reach(e, &rate), m = e->top->mass;
  double size = m * arm * largest(e) * share(e, arm);
  /* rolling: m r x (w' x r), which may be as large beside the torque that is left */
  if (e->act->of.plane.law == PH_ROLLING && e->dx)
    effect_raise(&size, m * arm * arm * effect_norm(e->dx + 4));
  for (int i = 0; i < 3; i++)
    effect_raise(&term[i], size);
}

static void term_rates(const effect_terms *e, double scale[]) {
  const ph_plane *p = &e->act->of.plane;
  const double *own = e->x + e->place, w = effect_norm(e->x + 4) + fabs(p->rate);
  double rate;
  const double arm = reach(e, &rate);
  for (int i = 0; i < e->act->states; i++)
    if (i > 1)
      effect_raise(&scale[e->place + i], largest(e) * share(e, arm));
    else
      effect_raise(&scale[e->place + i],
                   e->act->states == 4 ? fabs(own[2 + i]) : w * (arm + fabs(own[1 - i])));
}

static void term_energy(const effect_terms *e, double *scale) {
  const ph_plane *p = &e->act->of.plane;
  double rate;
  const double w = effect_norm(e->x + 4) + fabs(p->rate), m = e->top->mass;
  const double place = p->placed ? hypot(e->x[e->place], e->x[e->place + 1]) : 0;
  const double size = reach(e, &rate) + place;
  effect_raise(scale, m * effect_norm(p->gravity) * size);
  effect_raise(scale, m * w * w * size * size);
  if (e->act->states == 4)
    effect_raise(scale, m * pow(hypot(e->x[e->place + 2], e->x[e->place + 3]), 2));
}

/* ---- reading ---- */

struct given {
  double surface, law, placed, half_axes[3], axes[4], rim, centre[3], normal[3], e1[3], rate,
      gravity[3], friction, smoothing, spinning[2], rolling[2];
  ph_support support;
};

static const effect_field fields[] = {
    {"surface", EFFECT_NUMBERS, 1, offsetof(struct given, surface), NULL},
    {"support", EFFECT_JET, 1, offsetof(struct given, support), NULL},
    {"law", EFFECT_NUMBERS, 1, offsetof(struct given, law), NULL},
    {"placed", EFFECT_NUMBERS, 1, offsetof(struct given, placed), NULL},
    {"half_axes", EFFECT_NUMBERS, 3, offsetof(struct given, half_axes), NULL},
    {"axes", EFFECT_NUMBERS, 4, offsetof(struct given, axes), NULL},
    {"rim", EFFECT_NUMBERS, 1, offsetof(struct given, rim), NULL},
    {"centre", EFFECT_NUMBERS, 3, offsetof(struct given, centre), NULL},
    {"normal", EFFECT_NUMBERS, 3, offsetof(struct given, normal), NULL},
    {"e1", EFFECT_NUMBERS, 3, offsetof(struct given, e1), NULL},
    {"rate", EFFECT_NUMBERS, 1, offsetof(struct given, rate), NULL},
    {"gravity", EFFECT_NUMBERS, 3, offsetof(struct given, gravity), NULL},
    {"friction", EFFECT_NUMBERS, 1, offsetof(struct given, friction), NULL},
    {"smoothing", EFFECT_NUMBERS, 1, offsetof(struct given, smoothing), NULL},
    {"spinning", EFFECT_NUMBERS, 2, offsetof(struct given, spinning), NULL},
    {"rolling", EFFECT_NUMBERS, 2, offsetof(struct given, rolling), NULL},
    {0}};

static int add(ph_top *top, const void *given) {
  const struct given *g = given;
  ph_plane p = {.law = (int)g->law, .placed = g->placed != 0, .rim = g->rim, .rate = g->rate};
  memcpy(p.half_axes, g->half_axes, sizeof p.half_axes);
  memcpy(p.axes, g->axes, sizeof p.axes);
  memcpy(p.centre, g->centre, sizeof p.centre);
  memcpy(p.normal, g->normal, sizeof p.normal);
  memcpy(p.e1, g->e1, sizeof p.e1);
  memcpy(p.gravity, g->gravity, sizeof p.gravity);
  p.friction = g->friction;
  p.smoothing = g->smoothing;
  p.surface = (int)g->surface;
  p.spinning = (ph_resistance){g->spinning[0], g->spinning[1]};
  p.rolling = (ph_resistance){g->rolling[0], g->rolling[1]};
  p.support = g->support;
  return ph_top_plane(top, &p);
}

const effect_table effect_plane = {.name = "plane",
                                   .kind = PH_PLANE,
                                   .fields = fields,
                                   .size = sizeof(struct given),
                                   .add = add,
                                   .constrain = constrain,
                                   .contact = contact_of,
                                   .reach = reach_of,
                                   .kinetic = kinetic,
                                   .potential = potential,
                                   .term_torque = term_torque,
                                   .term_rates = term_rates,
                                   .term_energy = term_energy};

static int sound(const ph_plane *p) {
  const double numbers[8] = {p->rim,
                             p->rate,
                             p->friction,
                             p->smoothing,
                             p->spinning.coefficient,
                             p->spinning.smoothing,
                             p->rolling.coefficient,
                             p->rolling.smoothing};
  ph_wide q[4];
  if (!wide_finite(3, p->half_axes) || !wide_finite(3, p->centre) || !wide_finite(3, p->normal) ||
      !wide_finite(3, p->e1) || !wide_finite(3, p->gravity) || !wide_finite(8, numbers))
    return PH_EFINITE;
  const int status = wide_load_unit(p->axes, q);
  if (status)
    return status;
  if (p->law < PH_ROLLING || p->law > PH_COULOMB || p->surface < PH_ELLIPSOID ||
      p->surface > PH_SUPPORT || (p->surface == PH_SUPPORT && !p->support.jet))
    return PH_EBOUND;
  if (p->half_axes[0] < 0 || p->half_axes[1] < 0 || p->half_axes[2] < 0 || p->rim < 0)
    return PH_ELENGTH;
  const double sizes = p->half_axes[0] + p->half_axes[1] + p->half_axes[2];
  if (p->surface == PH_ELLIPSOID && !(p->rim + sizes > 0))
    return PH_ELENGTH;
  if (p->surface == PH_PARABOLOID && !(p->half_axes[0] > 0 && p->half_axes[1] > 0))
    return PH_ELENGTH;
  if (p->spinning.coefficient < 0 || p->spinning.smoothing < 0 || p->rolling.coefficient < 0 ||
      p->rolling.smoothing < 0)
    return PH_EPOSITIVE;
  if (p->friction < 0 || (p->law == PH_COULOMB && !(p->smoothing > 0)))
    return PH_EPOSITIVE;
  ph_wide n[3], e1[3], across[3];
  wide_load(3, p->normal, n);
  wide_load(3, p->e1, e1);
  wide_cross(n, e1, across);
  /* along the normal but for the roundings of its own numbers, e1 has no direction in the plane */
  const ph_wide most = wide_norm(n) * wide_norm(e1);
  return wide_norm(across) > DBL_EPSILON * most && isfinite(most) ? PH_OK : PH_EDIRECTION;
}

int ph_top_plane(ph_top *top, const ph_plane *plane) {
  const ph_wide moment = top->wide_inertia[XX] + top->wide_inertia[YY] + top->wide_inertia[ZZ];
  int status = sound(plane);
  if (status)
    return status;
  if (wide_norm(top->wide_com) > 64 * (ph_wide)DBL_EPSILON * sqrtl(moment / (ph_wide)top->mass))
    return PH_EBOUND;
  if (acts_coupled(top) || acts_constraint(top, 0, NULL).act)
    return PH_EMETHOD;
  const int placed = plane->placed || plane->law != PH_SMOOTH;
  const int states = !placed ? 0 : plane->law == PH_ROLLING ? 2 : 4;
  ph_act *act;
  status = acts_new(top, &effect_plane, states, 0, NULL, &act);
  if (status)
    return status;
  act->of.plane = *plane;
  act->of.plane.placed = placed;
  return PH_OK;
}
