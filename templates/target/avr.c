/* avr.c - runs a program in simavr and prints cycles and stack between two functions.
   SPDX-License-Identifier: GPL-3.0-or-later

     avr FILE.elf BEGIN END FINISH      addresses of functions in bytes

   One line a time that `end` was entered: cycles since `begin` was, and the bytes of stack that
   were in use at most, below those at the call of `begin` (a return address has 3). Ends where
   `finish` is entered; the status is its argument (r24). Before them the version of simavr. The
   halves of the stack pointer are set one after the other, from `out SPH` to `out SPL`: what stands
   there between does not count. */
#include <simavr/sim_avr.h>
#include <simavr/sim_core_config.h>
#include <simavr/sim_elf.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int main(int argc, char **argv) {
  elf_firmware_t firmware;
  avr_t *avr = avr_make_mcu_by_name("atmega2560");
  if (argc != 5 || !avr)
    return 2;
  memset(&firmware, 0, sizeof firmware);
  if (elf_read_firmware(argv[1], &firmware))
    return 2;
  const avr_flashaddr_t begin = (avr_flashaddr_t)strtoul(argv[2], NULL, 0);
  const avr_flashaddr_t end = (avr_flashaddr_t)strtoul(argv[3], NULL, 0);
  const avr_flashaddr_t finish = (avr_flashaddr_t)strtoul(argv[4], NULL, 0);
  avr_cycle_count_t start = 0;
  unsigned top = 0, lowest = 0;
  int whole = 1;
  printf("simavr %s\n", CONFIG_SIMAVR_VERSION);
  avr_init(avr);
  avr->frequency = 16000000;
  avr_load_firmware(avr, &firmware);
  while (avr->pc != finish) {
    const unsigned stack = (unsigned)avr->data[R_SPL] | (unsigned)avr->data[R_SPH] << 8;
    const unsigned instruction = (unsigned)avr->flash[avr->pc] | (unsigned)avr->flash[avr->pc + 1]
                                                                     << 8;
    if (avr->pc == begin) {
      start = avr->cycle;
      top = lowest = stack + 3;
    }
    if (avr->pc == end)
      printf("%llu %u\n", (unsigned long long)(avr->cycle - start), top - lowest);
    if (whole && stack < lowest)
      lowest = stack;
    if ((instruction & 0xFE0F) == 0xBE0E || (instruction & 0xFE0F) == 0xBE0D)
      whole = (instruction & 1) != 0;
    const int state = avr_run(avr);
    if (state == cpu_Done || state == cpu_Crashed)
      return 3;
  }
  return avr->data[24];
}
