/* mass.c - asks the emitted code of a scene called "body" for what is said in the arguments.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * An argument is a word and numbers, "init 0x1p+0 ..."; the answer is a line of hexadecimal
 * numbers.  The words are those of `commands` below; init comes first where a model is needed.
 * PARTICLES: the scene has body_particle_energy.
 */
#include "scene.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MOST 64

static body_model model;
static body_real in[MOST], out[MOST];

static void number(int count, const char *text) {
  char *end;
  for (int i = 0; i < count; i++) {
    in[i] = (body_real)strtod(text, &end);
    text = end;
  }
}

/* A status as the first number. */
static int with(int status, int count) {
  memmove(out + 1, out, (size_t)count * sizeof out[0]);
  out[0] = (body_real)status;
  return 1 + count;
}

/* Each returns how many numbers it left in out. */
static int init(void) {
  return with(body_init(&model, in), 0);
}
static int mass(void) {
  const body_real m = body_mass(&model, out + 1);
  out[0] = m;
  return 4;
}
static int inertia(void) {
  body_inertia(&model, out);
  return 6;
}
static int at(void) {
  body_inertia_at(&model, in, out);
  return 6;
}
static int principal(void) {
  return with(body_principal(&model, out, out + 3), 12);
}
static int of(void) {
  return with(body_principal_of(in, out, out + 3), 12);
}
static int rate(void) {
  body_rate(in, in + 3, in + 6, out);
  return 3;
}
static int acceleration(void) {
  body_acceleration(in, in + 3, in + 6, in + 9, in + 12, out, out + 3, out + 6, out + 9);
  return 12;
}
static int energy(void) {
  out[0] = body_energy(&model, in);
  return 1;
}
static int momentum(void) {
  body_momentum(&model, in, out);
  return 3;
}
static int momentum_body(void) {
  body_momentum_body(&model, in, out);
  return 3;
}
static int torque(void) {
  body_torque(&model, in, in + 3, out);
  return 3;
}
/* The rates' change: state, input torque. */
static int accelerated(void) {
  body_real dx[BODY_NX];
  body_rhs(&model, 0, in, in + BODY_NX, dx);
  memcpy(out, dx + BODY_WX, 3 * sizeof out[0]);
  return 3;
}
#ifdef PARTICLES
static int particles(void) {
  out[0] = body_particle_energy(&model, in);
  return 1;
}
#endif

static const struct {
  const char *word;
  int count, (*run)(void);
} commands[] = {
    {"init", BODY_NP, init},
    {"mass", 0, mass},
    {"inertia", 0, inertia},
    {"at", 3, at},
    {"principal", 0, principal},
    {"of", 6, of},
    {"rate", 9, rate},
    {"acceleration", 15, acceleration},
    {"energy", BODY_NX, energy},
    {"momentum", BODY_NX, momentum},
    {"momentum_body", BODY_NX, momentum_body},
    {"torque", 6, torque},
    {"accelerated", BODY_NX + 3, accelerated},
#ifdef PARTICLES
    {"particles", BODY_NX, particles},
#endif
};

int main(int argc, char **argv) {
  for (int i = 1; i < argc; i++) {
    const size_t length = strcspn(argv[i], " ");
    size_t k = 0;
    while (k < sizeof commands / sizeof commands[0] &&
           (strlen(commands[k].word) != length || strncmp(argv[i], commands[k].word, length) != 0))
      k++;
    if (k == sizeof commands / sizeof commands[0])
      return 2;
    number(commands[k].count, argv[i] + length);
    const int n = commands[k].run();
    for (int j = 0; j < n; j++)
      printf("%a ", (double)out[j]);
    printf("\n");
  }
  return 0;
}
