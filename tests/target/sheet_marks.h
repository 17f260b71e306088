/* sheet_marks.h - another marks.h: what runs between begin() and end(), counted by the processor
   and by paint. SPDX-License-Identifier: GPL-3.0-or-later

   One line a call on the machine's console: instructions retired (RV32: minstret, exact with QEMU's
   -icount; elsewhere 0), and bytes of stack that were written below that of begin() itself, so what
   the call used is at least that. */
#ifndef MARKS_H
#define MARKS_H
#include <stdint.h>

enum { PAINTED = 6000, COLOUR = 0xA5 };

static volatile uint8_t *floor_;
static uint32_t from_;

static uint32_t retired(void) {
#if defined __riscv
  uint32_t n;
  __asm__ volatile(".option push\n\t.option arch, +zicsr\n\tcsrr %0, minstret\n\t.option pop"
                   : "=r"(n)
                   :
                   : "memory");
  return n;
#else
  return 0;
#endif
}

static void put(char c) {
#if defined __riscv
  *(volatile uint8_t *)0x10000000 = (uint8_t)c;
#else
  register uint32_t r0 __asm__("r0") = 3; /* SYS_WRITEC */
  register const char *r1 __asm__("r1") = &c;
  __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
#endif
}

static void line(uint32_t count, uint32_t stack) {
  for (int i = 28; i >= 0; i -= 4)
    put("0123456789abcdef"[count >> i & 15]);
  put(' ');
  for (int i = 28; i >= 0; i -= 4)
    put("0123456789abcdef"[stack >> i & 15]);
  put('\n');
}

void begin(void);
void end(void);

__attribute__((noinline)) void begin(void) {
  volatile uint8_t here;
  floor_ = &here - PAINTED;
  for (int i = 0; i < PAINTED - 64; i++) /* not what begin itself stands on */
    floor_[i] = COLOUR;
  from_ = retired();
}

__attribute__((noinline)) void end(void) {
  const uint32_t count = retired() - from_;
  uint32_t clean = 0;
  while (clean < PAINTED - 64 && floor_[clean] == COLOUR)
    clean++;
  line(count, clean == PAINTED - 64 ? 0 : PAINTED - clean);
}

#define FINISH(status) (status)
#endif
