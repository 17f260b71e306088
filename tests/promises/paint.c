/* paint.c - how deep the stack of each function goes on a Cortex-M: painted before, looked at
   after. SPDX-License-Identifier: GPL-3.0-or-later

   calls.h is made by tests/promises/calls.lua: functions call_0 .., each of which calls one emitted
   function on the scene's state, and their table. Printed by semihosting, one line each: number,
   bytes used. */
#include <stdint.h>

#include "calls.h"

#define PAINT 0x5AC3B17Eu

/* one character by semihosting: SYS_WRITEC */
static void put(char c) {
  register uint32_t r0 __asm__("r0") = 0x03;
  register const char *r1 __asm__("r1") = &c;
  __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
}

static void number(uint32_t n) {
  char digits[10];
  int k = 0;

  do
    digits[k++] = (char)('0' + n % 10);
  while (n /= 10);
  while (k > 0)
    put(digits[--k]);
}

/* From its own stack pointer down: what `call` and all below it write. Volatile, so that no loop
   becomes a function that would need the stack itself. */
__attribute__((noinline)) static uint32_t used(void (*call)(void)) {
  volatile uint32_t *top, *low, *p;

  __asm__ volatile("mov %0, sp" : "=r"(top));
  low = top - DEPTH / 4;
  for (p = low; p < top; p++)
    *p = PAINT;
  call();
  for (p = low; p < top && *p == PAINT; p++)
    ;
  return p == low ? DEPTH : (uint32_t)(top - p) * 4;
}

int main(void) {
  unsigned k;

  if (!prepare())
    return 1;
  for (k = 0; k < sizeof calls / sizeof calls[0]; k++) {
    uint32_t bytes;

    restore();
    bytes = used(calls[k]);
    number(k);
    put(' ');
    number(bytes);
    put('\n');
  }
  return 0;
}
