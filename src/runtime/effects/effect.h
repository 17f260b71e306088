/* effect.h - what a file of this folder says of its effect: the contract.
   SPDX-License-Identifier: GPL-3.0-or-later

   One file an effect, named as generator/effects/NAME.lua, with a const table effect_NAME and the
   calls of polhode.h that switch it on. The build finds the files (acts/named.c); no other file
   lists them. An effect is one of two kinds:
   - a top has one of it and keeps its numbers in ph_top itself: then `load` gives what is constant
     in the equations, whose Taylor series are formed (motion/motion.h, motion/move.h);
   - a top may have many: each is an act of top->acts, with numbers of its own in act->of.
   Of each function the effect has it or not (NULL). Functions about the motion compute in long
   double and ADD to what they are given. Terms bound what was added, in double, so that two honest
   roundings can be compared: they RAISE what they are given to the largest single term. */
#ifndef EFFECT_H
#define EFFECT_H

#include <stddef.h>

#include "motion/motion.h"
#include "numbers/wide.h"

/* ---- the motion ---- */

/* A top in a state; act: NULL where the numbers are in the top. */
typedef struct effect_at {
  const ph_top *top;
  const ph_act *act;
  ph_wide t;
  const ph_wide *x;
  int place; /* of the act's own states in x */
  int side;  /* number of its first side */
} effect_at;

/* A wheel: an inner body of revolution that turns about an axis of the body. */
typedef struct effect_spinner {
  ph_wide axis[3], J; /* unit vector */
  int included;       /* is J in the body's tensor, the wheel being locked there? */
} effect_spinner;

/* ---- largest terms ---- */

typedef struct effect_terms {
  const ph_top *top;
  const ph_act *act;
  double t;
  const double *x;
  const double *u;      /* inputs, or NULL */
  const double *dx;     /* the rates of x, or NULL */
  const double *spread; /* moduli of the tensor's nine entries, as they are rounded */
  int place;
  /* the size of a ph_varying that is a function of the caller's, or NULL */
  double (*size)(const ph_varying *v, double t, const double x[], int n);
} effect_terms;

/* ---- reading ---- */

/* A field of a scene's effect goes to the place `at` of the structure that `add` gets, which is
   zero before. */
typedef struct effect_field {
  const char *name;
  enum {
    EFFECT_NUMBERS, /* n doubles: a number, or a list if n > 1; `standard` if there is no field */
    EFFECT_FLAG,    /* int: true or false */
    EFFECT_GIVEN,   /* int: is the field there? */
    EFFECT_VARYING, /* n of ph_varying: one, or a list if n > 1; zero if there is no field */
    EFFECT_JET,     /* ph_support: a function of a vector; zero if there is no field */
    EFFECT_LENGTH,  /* int: how long the list is */
    EFFECT_LIST     /* effect_list: numbers, as many as there are; they live as long as the scene */
  } type;
  int n;
  size_t at;
  const double *standard; /* NULL: the field must be there */
} effect_field;

typedef struct effect_list {
  int n;
  const double *v;
} effect_list;

/* ---- the table ---- */

typedef struct ph_effect_table effect_table;
struct ph_effect_table {
  const char *name; /* as in Lua, without "effect." */
  unsigned kind;    /* bit of ph_top.effects that switches its acts */

  /* reading: ended by a field without name; size of the structure; how many inputs it uses */
  const effect_field *fields;
  size_t size;
  int (*add)(ph_top *top, const void *given);
  int inputs;

  void (*load)(const ph_top *top, const double u[3], motion_loads *loads);

  /* torque about the origin, body axes, and a bound of its terms; force on the centre of mass,
     inertial axes; rates of own states into own[]; potential, J */
  void (*torque)(const effect_at *e, ph_wide N[3], ph_wide *size);
  void (*force)(const effect_at *e, ph_wide F[3]);
  void (*rates)(const effect_at *e, ph_wide own[]);
  ph_wide (*potential)(const effect_at *e);
  /* what it adds to the tensor, and the rate of that */
  void (*tensor)(const effect_at *e, ph_wide D[6]);
  void (*tensor_rate)(const effect_at *e, ph_wide D[6]);
  /* it constrains the body: w' and its own rates, from the b of I w' = b (motion/motion.h); a
     status. It then has no torque, force and rates. And the kinetic energy and forces that
     follow */
  int (*constrain)(const effect_at *e, const ph_wide b[3], ph_wide dx[]);
  ph_wide (*kinetic)(const effect_at *e);
  int (*contact)(const effect_at *e, const ph_wide rate[],
                 ph_contact *out); /* rate: of the state */
  /* the way from the centre of mass to where it holds the body, m, and the largest of the terms of
     the accelerations there, m/s^2; a status */
  int (*reach)(const effect_at *e, ph_wide *arm, ph_wide *pull);
  /* rate at which the body's axes turn beside w */
  void (*slip)(const effect_at *e, ph_wide slip[3]);
  /* it is a wheel, whose first own state is its speed beside the body; the motor's torque */
  void (*wheel)(const ph_act *act, effect_spinner *out);
  ph_wide (*motor)(const effect_at *e);
  /* its values that vary, one after the other; how many */
  const ph_varying *(*varying)(const ph_act *act, int *n);
  /* number i of act->sides, 0 where it is rounding; NULL: those of its values that vary */
  ph_wide (*side)(const effect_at *e, int i);

  /* terms: of the torque; of the rates, as long as the state, those of w being known; of the
     energy; of the momentum */
  void (*term_torque)(const effect_terms *e, double term[3]);
  void (*term_rates)(const effect_terms *e, double scale[]);
  void (*term_energy)(const effect_terms *e, double *scale);
  void (*term_momentum)(const effect_terms *e, double *scale);
};

/* ---- acts/named.c: all effects, in the order of their names, ended by NULL ---- */

extern const effect_table *const effect_all[];
/* NULL: there is none of that name. */
const effect_table *effect_named(const char *name);

/* ---- acts/largest.c: the terms of all effects of a top; act, place and t as there ---- */

void effect_term_torque(const effect_terms *all, double term[3]);
void effect_term_rates(const effect_terms *all, double scale[]);
void effect_term_energy(const effect_terms *all, double *scale);
void effect_term_momentum(const effect_terms *all, double *scale);
/* What moving parts add to the tensor; 0: none move. */
int effect_tensor(const effect_terms *all, double D[6]);
/* Takes from the tensor the wheels that it includes: what is left is what the rates carry. */
void effect_carried(const ph_top *top, double tensor[6]);

static inline double effect_larger(double a, double b) {
  return a > b ? a : b; /* NaN in b is passed over: the rates themselves show it */
}

static inline void effect_raise(double *scale, double b) {
  *scale = effect_larger(*scale, b);
}

static inline double effect_norm(const double v[3]) {
  return hypot(hypot(v[0], v[1]), v[2]);
}

/* |q|^2, by which the terms of a turned vector exceed it. */
static inline double effect_q2(const effect_terms *e) {
  return e->x[0] * e->x[0] + e->x[1] * e->x[1] + e->x[2] * e->x[2] + e->x[3] * e->x[3];
}

/* The sign of the act's side i, which has the value g: a step of a run holds to one. */
static inline int effect_sign(const effect_at *e, int i, ph_wide g) {
  const int held = e->top->branch ? e->top->branch[e->side + i] : 0;
  return held ? held : (g > 0) - (g < 0);
}

/* The size of a value that varies. */
double effect_size(const effect_terms *e, const ph_varying *v);
/* |L| of all that turns, by its largest terms. */
double effect_whole(const effect_terms *e);
/* The largest entry of the tensor and of what moving parts add to it. */
double effect_moment(const effect_terms *e);

#endif
