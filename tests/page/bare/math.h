/* math.h -- what emitted self-tests call of it, each one instruction of WebAssembly.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef POLHODE_BARE_MATH_H
#define POLHODE_BARE_MATH_H

static inline double fabs(double x) {
  return __builtin_fabs(x);
}
static inline float fabsf(float x) {
  return __builtin_fabsf(x);
}
static inline double sqrt(double x) {
  return __builtin_sqrt(x);
}
static inline float sqrtf(float x) {
  return __builtin_sqrtf(x);
}

#endif
