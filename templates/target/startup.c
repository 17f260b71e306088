/* startup.c - from reset to main on a Cortex-M, and back to the machine that runs QEMU.
   SPDX-License-Identifier: GPL-3.0-or-later

   The core loads the first two words of memory into the stack pointer and the program counter
   (ARMv7-M, B1.5.5). main's result becomes QEMU's exit status by semihosting: SYS_EXIT_EXTENDED
   with ADP_Stopped_ApplicationExit. Any fault ends with status 99. */
#include <stdint.h>

extern uint32_t data_load[], data_start[], data_end[], bss_start[], bss_end[], stack_top[];
int main(void);
void reset(void);
void finish(int status);

void finish(int status) {
  const uint32_t block[2] = {0x20026, (uint32_t)status};
  register uint32_t r0 __asm__("r0") = 0x20;
  register const uint32_t *r1 __asm__("r1") = block;
  __asm__ volatile("bkpt 0xAB" : : "r"(r0), "r"(r1) : "memory");
  for (;;)
    ;
}

static void fault(void) {
  finish(99);
}

void reset(void) {
#if defined __ARM_FP
  *(volatile uint32_t *)0xE000ED88 |= 0xFU << 20; /* CPACR: the floating-point unit on */
  __asm__ volatile("dsb\n\tisb");
#endif
  for (uint32_t *to = data_start, *from = data_load; to < data_end;)
    *to++ = *from++;
  for (uint32_t *to = bss_start; to < bss_end;)
    *to++ = 0;
  finish(main());
}

__attribute__((section(".vectors"), used)) static const struct {
  uint32_t *stack;
  void (*handler[15])(void);
} vectors = {stack_top,
             {reset, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault,
              fault, fault, fault}};
