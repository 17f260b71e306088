/* library.c - asks the general library for what is said in the arguments.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * An argument is a word and numbers; the answer is a line of hexadecimal numbers, the status first.
 */
#include "polhode.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MOST 64

static double in[MOST], out[MOST];

static int principal(void) {
  ph_axes axes;
  const int status = ph_principal(in, &axes);
  if (status == PH_OK) {
    memcpy(out, axes.moment, sizeof axes.moment);
    memcpy(out + 3, axes.axis, sizeof axes.axis);
  }
  return status;
}
static int from_matrix(void) {
  return ph_quat_from_matrix(in, out);
}
static int to_matrix(void) {
  return ph_quat_to_matrix(in, out);
}
static int from_ypr(void) {
  return ph_quat_from_ypr(in, out);
}
static int to_ypr(void) {
  return ph_quat_to_ypr(in, out);
}
static int from_axis(void) {
  return ph_quat_from_axis(in, in[3], out);
}
static int rotate(void) {
  return ph_quat_rotate(in, in + 4, out);
}
static int turn(void) {
  return ph_tensor_turn(in, in + 6, out);
}
/* tensor, mass, centre, new origin */
static int shift(void) {
  return ph_tensor_shift(in, in[6], in + 7, in + 10, out);
}
static int rate(void) {
  return ph_frame_rate_inertial(in, in + 3, in + 6, out);
}
static int acceleration(void) {
  ph_acceleration a;
  const int status = ph_frame_acceleration(in, in + 3, in + 6, in + 9, in + 12, &a);
  if (status == PH_OK) {
    memcpy(out, a.coriolis, sizeof a.coriolis);
    memcpy(out + 3, a.euler, sizeof a.euler);
    memcpy(out + 6, a.centripetal, sizeof a.centripetal);
    memcpy(out + 9, a.total, sizeof a.total);
  }
  return status;
}
/* tensor about the origin, w */
static int energy(void) {
  return ph_tensor_energy(in, in + 6, out);
}
/* number of particles, w, masses and places; energy by the definition */
static int particles(void) {
  double m[8], r[24];
  const int n = (int)in[0];
  if (n < 1 || n > 8)
    return PH_ECOUNT;
  for (int i = 0; i < n; i++) {
    m[i] = in[4 + 4 * i];
    memcpy(r + 3 * i, in + 5 + 4 * i, 3 * sizeof r[0]);
  }
  return ph_particles_energy(n, m, r, in + 1, out);
}
/* mass, tensor about the centre, state; the angular momentum */
static int momentum(void) {
  ph_top top;
  const int status = ph_top_init_tensor(&top, in[0], NULL, in + 1);
  return status ? status : ph_top_momentum(&top, in + 7, out);
}
/* mass, centre, tensor about the origin of coordinates: the body's tensor about its centre */
static int about_origin(void) {
  ph_body b;
  const int status = ph_body_tensor_origin(&b, in[0], in + 1, in + 4);
  if (status == PH_OK)
    memcpy(out, b.tensor, sizeof b.tensor);
  return status;
}
/* mass, tensor about the centre: can it be? */
static int check(void) {
  static const double here[3] = {0, 0, 0};
  ph_body b;
  return ph_body_tensor(&b, in[0], here, in + 1);
}

static const struct {
  const char *word;
  int given, answered, (*run)(void);
} commands[] = {
    {"of", 6, 12, principal},       {"from_matrix", 9, 4, from_matrix},
    {"to_matrix", 4, 9, to_matrix}, {"from_ypr", 3, 4, from_ypr},
    {"to_ypr", 4, 3, to_ypr},       {"from_axis", 4, 4, from_axis},
    {"rotate", 7, 3, rotate},       {"turn", 10, 6, turn},
    {"shift", 13, 6, shift},        {"rate", 9, 3, rate},
    {"energy", 9, 1, energy},       {"acceleration", 15, 12, acceleration},
    {"momentum", 14, 3, momentum},  {"about_origin", 10, 6, about_origin},
    {"check", 7, 0, check},         {"particles", 36, 1, particles},
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
    char *text = argv[i] + length;
    for (int j = 0; j < commands[k].given; j++)
      in[j] = strtod(text, &text);
    memset(out, 0, sizeof out);
    printf("%d ", commands[k].run());
    for (int j = 0; j < commands[k].answered; j++)
      printf("%a ", out[j]);
    printf("\n");
  }
  return 0;
}
