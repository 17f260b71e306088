/* sweep_blocks.c -- how the members are divided into blocks.
 * template: templates/sweep/sweep_blocks.c.  SPDX-License-Identifier: MIT-0
 *
 * A block is what one thread computes and logs at a time.  Most blocks have the size that was asked for.  Towards the end
 * they become smaller, so that nobody waits long for the thread that has the last one: a size is halved when each worker
 * has fewer than SHARE blocks of it left.  Which members are in which block is decided before the first is computed, so
 * that one counter hands them out.  The result does not depend on it. */
#include "sweep.h"

/* The model of tests/sweep/handout.t: a larger share or smaller blocks ask the counter more than they save. */
enum { SHARE = 6, HALVINGS = SWEEP_LEVELS - 1 };

void sweep_divide(sweep_layout *d, uint64_t members, uint64_t block, uint64_t workers, int lanes)
{
  const uint64_t lane = (uint64_t)lanes, share = SHARE*workers;
  uint64_t left = members, size = block, b = 0;
  int i;

  d->members = members;
  d->most = block;
  d->levels = 0;
  for (i = 0; i <= HALVINGS && left > 0; i++) {
    const uint64_t half = size/2 >= lane ? size/2/lane*lane : 0; /* whole lanes: a part of one costs as much */
    const int last = half == 0 || half == size || i == HALVINGS;
    uint64_t count = left/size + (left%size != 0);

    if (!last) count = left/size > share ? left/size - share : 0;
    if (count > 0) {
      d->level[d->levels].block = b;
      d->level[d->levels].member = members - left;
      d->level[d->levels++].size = size;
      b += count;
      left = last ? 0 : left - count*size;
    }
    if (last) break;
    size = half;
  }
  d->blocks = b;
}

uint64_t sweep_block(const sweep_layout *d, uint64_t b, uint64_t *first)
{
  int i = d->levels - 1;
  uint64_t size, left;

  while (i > 0 && d->level[i].block > b) i--;
  size = d->level[i].size;
  *first = d->level[i].member + (b - d->level[i].block)*size;
  left = d->members - *first;
  return left < size ? left : size;
}
