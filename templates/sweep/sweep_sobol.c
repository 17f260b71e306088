/* sweep_sobol.c -- points of Sobol's sequence, any of them at once.
 * template: templates/sweep/sweep_sobol.c.  SPDX-License-Identifier: MIT-0 AND BSD-3-Clause
 *
 * The table of primitive polynomials and initial direction numbers is from the file new-joe-kuo-6.21201 of S. Joe and
 * F. Y. Kuo: Constructing Sobol sequences with better two-dimensional projections, SIAM J. Sci. Comput. 30 (2008)
 * 2635-2654.  Its notice:
 *
 * Copyright (c) 2008, Frances Y. Kuo and Stephen Joe.  All rights reserved.
 *
 * Redistribution and use in source and binary forms, with or without modification, are permitted provided that the
 * following conditions are met:
 *
 * - Redistributions of source code must retain the above copyright notice, this list of conditions and the following
 *   disclaimer.
 * - Redistributions in binary form must reproduce the above copyright notice, this list of conditions and the following
 *   disclaimer in the documentation and/or other materials provided with the distribution.
 * - Neither the names of the copyright holders nor the names of the University of New South Wales and the University of
 *   Waikato and its contributors may be used to endorse or promote products derived from this software without specific
 *   prior written permission.
 *
 * THIS SOFTWARE IS PROVIDED BY THE COPYRIGHT HOLDERS "AS IS" AND ANY EXPRESS OR IMPLIED WARRANTIES, INCLUDING, BUT NOT
 * LIMITED TO, THE IMPLIED WARRANTIES OF MERCHANTABILITY AND FITNESS FOR A PARTICULAR PURPOSE ARE DISCLAIMED.  IN NO
 * EVENT SHALL THE COPYRIGHT HOLDERS BE LIABLE FOR ANY DIRECT, INDIRECT, INCIDENTAL, SPECIAL, EXEMPLARY, OR CONSEQUENTIAL
 * DAMAGES (INCLUDING, BUT NOT LIMITED TO, PROCUREMENT OF SUBSTITUTE GOODS OR SERVICES; LOSS OF USE, DATA, OR PROFITS; OR
 * BUSINESS INTERRUPTION) HOWEVER CAUSED AND ON ANY THEORY OF LIABILITY, WHETHER IN CONTRACT, STRICT LIABILITY, OR TORT
 * (INCLUDING NEGLIGENCE OR OTHERWISE) ARISING IN ANY WAY OUT OF THE USE OF THIS SOFTWARE, EVEN IF ADVISED OF THE
 * POSSIBILITY OF SUCH DAMAGE. */
#include "sweep.h"

/* Degree, inner coefficients, and initial numbers m of the dimensions from the second on. */
static const struct {
  unsigned char degree, inner, m[7];
} TABLE[SWEEP_SOBOL_MOST - 1] = {
  {1, 0, {1}}, {2, 1, {1, 3}}, {3, 1, {1, 3, 1}}, {3, 2, {1, 1, 1}}, {4, 1, {1, 1, 3, 3}}, {4, 4, {1, 3, 5, 13}},
  {5, 2, {1, 1, 5, 5, 17}}, {5, 4, {1, 1, 5, 5, 5}}, {5, 7, {1, 1, 7, 11, 19}}, {5, 11, {1, 1, 5, 1, 1}},
  {5, 13, {1, 1, 1, 3, 11}}, {5, 14, {1, 3, 5, 5, 31}}, {6, 1, {1, 3, 3, 9, 7, 49}}, {6, 13, {1, 1, 1, 15, 21, 21}},
  {6, 16, {1, 3, 1, 13, 27, 49}}, {6, 19, {1, 1, 1, 15, 7, 5}}, {6, 22, {1, 3, 1, 15, 13, 25}},
  {6, 25, {1, 1, 5, 5, 19, 61}}, {7, 1, {1, 3, 7, 11, 23, 15, 103}}, {7, 4, {1, 3, 7, 13, 13, 15, 69}},
};

/* Point i in natural order, dimension 0, 1 ..: the exclusive or of the direction numbers at the set bits of i, which
 * counts modulo 2^32. */
uint32_t sweep_sobol(uint64_t i, int dimension)
{
  uint32_t v[32], x = 0;
  int k, j;

  for (k = 0; k < 32; k++) {
    int s;

    if (dimension == 0) {
      v[k] = (uint32_t)1 << (31 - k);
      continue;
    }
    s = TABLE[dimension - 1].degree;
    if (k < s) {
      v[k] = (uint32_t)TABLE[dimension - 1].m[k] << (31 - k);
      continue;
    }
    v[k] = v[k - s] ^ v[k - s] >> s;
    for (j = 1; j < s; j++) {
      if (TABLE[dimension - 1].inner >> (s - 1 - j) & 1) v[k] ^= v[k - j];
    }
  }
  for (k = 0; k < 32; k++) {
    if (i >> k & 1) x ^= v[k];
  }
  return x;
}
