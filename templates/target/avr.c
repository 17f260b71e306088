/* avr.c - runs a program in simavr and prints the cycles between two functions.
   SPDX-License-Identifier: GPL-3.0-or-later

     avr FILE.elf BEGIN END FINISH      addresses of functions in bytes

   One line a time that `end` was entered: cycles since `begin` was. Ends where `finish` is entered;
   the status is 0 if its argument (r24) is. */
#include <simavr/sim_avr.h>
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
  avr_init(avr);
  avr->frequency = 16000000;
  avr_load_firmware(avr, &firmware);
  while (avr->pc != finish) {
    if (avr->pc == begin)
      start = avr->cycle;
    if (avr->pc == end)
      printf("%llu\n", (unsigned long long)(avr->cycle - start));
    const int state = avr_run(avr);
    if (state == cpu_Done || state == cpu_Crashed)
      return 3;
  }
  return avr->data[24] != 0;
}
