/* blocks.c - how templates/sweep/sweep_blocks.c divides members: MEMBERS BLOCK WORKERS LANES.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A line for each size of block: the size, how many there are, the first member.  For handout.t. */
#include "sweep.h"

#include <stdio.h>
#include <stdlib.h>

int main(int argc, char **argv) {
  sweep_layout d;
  if (argc != 5)
    return 2;
  sweep_divide(&d, strtoull(argv[1], NULL, 10), strtoull(argv[2], NULL, 10),
               strtoull(argv[3], NULL, 10), atoi(argv[4]));
  for (int i = 0; i < d.levels; i++) {
    uint64_t first;
    const uint64_t next = i + 1 < d.levels ? d.level[i + 1].block : d.blocks;
    (void)sweep_block(&d, d.level[i].block, &first); /* also says where the level begins */
    printf("%llu %llu %llu\n", (unsigned long long)d.level[i].size,
           (unsigned long long)(next - d.level[i].block), (unsigned long long)first);
  }
  return 0;
}
