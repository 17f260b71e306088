/* riscv.c - from reset to main on RV32, and back to the machine that runs QEMU's board `virt`.
   SPDX-License-Identifier: GPL-3.0-or-later

   Memory is as the file has it, so nothing is copied. main's result becomes QEMU's exit status by
   the board's test device: 0x5555 ends with success, 0x3333 with the status above bit 16. */
#include <stdint.h>

int main(void);
void reset(void);
void finish(int status);

void finish(int status) {
  *(volatile uint32_t *)0x100000 = status ? (uint32_t)status << 16 | 0x3333U : 0x5555U;
  for (;;)
    ;
}

static void run(void) {
  finish(main());
}

__attribute__((naked, section(".reset"), used)) void reset(void) {
  __asm__ volatile("la sp, stack_top\n\t"
                   "la tp, thread\n\t"
#if defined __riscv_flen
                   "li t0, 0x2000\n\t" /* mstatus.FS: the floating-point unit on */
                   "csrs mstatus, t0\n\t"
#endif
                   "tail %0"
                   :
                   : "i"(run));
}
