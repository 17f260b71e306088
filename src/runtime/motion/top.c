/* top.c - the model: a body about an origin, and the effects that are switched on.
   SPDX-License-Identifier: GPL-3.0-or-later

   ph_top_init prepares what every evaluation needs, once: the tensor in long double and its
   principal system, by which I w' = b is solved. A moment that the tensor's digits do not tell from
   zero becomes an exact zero here, so a rod is a rod however it is turned, and no later line needs
   a threshold for it. */
#include "mass/body.h"

#include <string.h>

/* Second moments of a tensor: tr(I)/2 1 - I. */
static void seconds(const ph_wide tensor[6], ph_wide second[6]) {
  const ph_wide half = (tensor[0] + tensor[1] + tensor[2]) / 2;
  for (int i = 0; i < 6; i++)
    second[i] = (i < 3 ? half : 0) - tensor[i];
}

/* second: about the origin; NULL: by the tensor. */
static int prepare(ph_top *top, ph_wide mass, const ph_wide com[3], const ph_wide tensor[6],
                   const ph_wide second[6]) {
  if (!wide_fits(3, com) || !wide_fits(6, tensor))
    return PH_ERANGE;
  memset(top, 0, sizeof *top);
  top->mass = (double)mass;
  for (int i = 0; i < 3; i++) {
    top->com[i] = (double)com[i];
    top->wide_com[i] = com[i];
  }
  for (int i = 0; i < 6; i++) {
    top->inertia[i] = (double)tensor[i];
    top->wide_inertia[i] = tensor[i];
  }
  wide_eigen(tensor, top->wide_moment, top->wide_axis);
  const int zeros = wide_nullity(tensor);
  for (int k = 0; k < zeros; k++)
    top->wide_moment[k] = 0;
  if (zeros > 0) { /* so that L and T too know nothing of a moment made of rounding */
    memset(top->wide_inertia, 0, sizeof top->wide_inertia);
    for (int k = zeros; k < 3; k++)
      wide_add_outer(top->wide_inertia, top->wide_moment[k], top->wide_axis[k]);
  }
  if (second && zeros == 0)
    memcpy(top->wide_second, second, sizeof top->wide_second);
  else
    seconds(top->wide_inertia, top->wide_second);
  return PH_OK;
}

int ph_top_init(ph_top *top, const ph_body *b, const double origin[3]) {
  const int status = ph_body_check(b);
  if (status)
    return status;
  if (origin && !wide_finite(3, origin))
    return PH_EFINITE;
  ph_wide com[3] = {0}, second[6] = {0}, tensor[6];
  for (int i = 0; origin && i < 3; i++)
    com[i] = ((ph_wide)b->com[i] - (ph_wide)origin[i]) + (ph_wide)b->com_tail[i];
  wide_add_outer(second, (ph_wide)b->mass, com);
  wide_inertia(second, tensor);
  for (int i = 0; i < 6; i++) {
    tensor[i] += (ph_wide)b->tensor[i];
    second[i] += (ph_wide)b->second[i];
  }
  return prepare(top, (ph_wide)b->mass, com, tensor, second);
}

int ph_top_init_tensor(ph_top *top, double mass, const double com[3], const double tensor[6]) {
  static const double zero[3] = {0, 0, 0};
  ph_body b; /* made only to be checked: about com, no moment may be negative */
  const int status =
      com ? ph_body_tensor_origin(&b, mass, com, tensor) : ph_body_tensor(&b, mass, zero, tensor);
  if (status)
    return status;
  ph_wide R[3], I[6];
  wide_load(3, com ? com : zero, R);
  wide_load(6, tensor, I);
  return prepare(top, (ph_wide)mass, R, I, NULL);
}

void ph_top_without(ph_top *top, unsigned effects) {
  top->effects &= ~effects;
}
