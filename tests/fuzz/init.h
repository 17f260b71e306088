/* init.h - what init.c asks of each emitted scene.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef FUZZ_INIT_H
#define FUZZ_INIT_H

#include "fuzz.h"

struct bytes {
  const uint8_t *at;
  size_t left;
};

static inline uint8_t bytes_take(struct bytes *b) {
  if (b->left == 0)
    return 0;
  b->left--;
  return *b->at++;
}

typedef void init_case(struct bytes *b);

#endif
