/* simavr.c - runs a program on an atmega2560 in simavr: its characters, its status.
   SPDX-License-Identifier: GPL-3.0-or-later

     simavr FILE.elf

   The part's external memory interface is filled: data memory reaches to 0xFFFF. What the program
   writes to GPIOR0 (data address 0x3E) is printed; a byte written to GPIOR1 (0x4A) ends it with
   that status. Status 97: the processor stopped or crashed. */
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>
#include <simavr/sim_io.h>
#include <stdio.h>
#include <string.h>

static int status = -1;

static void character(struct avr_t *avr, avr_io_addr_t at, uint8_t value, void *data) {
  (void)avr, (void)at, (void)data;
  putchar(value);
}

static void end(struct avr_t *avr, avr_io_addr_t at, uint8_t value, void *data) {
  (void)avr, (void)at, (void)data;
  status = value;
}

static void quiet(struct avr_t *avr, const int level, const char *format, va_list list) {
  (void)avr, (void)level, (void)format, (void)list;
}

int main(int argc, char **argv) {
  static elf_firmware_t firmware;
  avr_t *avr = avr_make_mcu_by_name("atmega2560");
  avr_global_logger_set(quiet);
  if (argc != 2 || !avr || elf_read_firmware(argv[1], &firmware))
    return 2;
  avr->ramend = 0xFFFF;
  avr_init(avr);
  avr->frequency = 16000000;
  avr_load_firmware(avr, &firmware);
  avr_register_io_write(avr, 0x3E, character, NULL);
  avr_register_io_write(avr, 0x4A, end, NULL);
  while (status < 0) {
    const int state = avr_run(avr);
    if (state == cpu_Done || state == cpu_Crashed)
      return 97;
  }
  return status;
}
