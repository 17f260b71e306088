/* marks.h - marks for counting, the same on all processors: what runs between begin() and end().
   SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MARKS_H
#define MARKS_H

void begin(void);
void end(void);

/* not inlined, and alive: they are found by their addresses */
__attribute__((noinline)) void begin(void) {
  __asm__ volatile("nop" ::: "memory");
}
__attribute__((noinline)) void end(void) {
  __asm__ volatile("nop" ::: "memory");
}

#if defined __AVR__
void finish(int status); /* where avr.c stops */
__attribute__((noinline)) void finish(int status) {
  __asm__ volatile("nop" : : "r"(status));
}
#define FINISH(status) (finish(status), 0)
#else
#define FINISH(status) (status)
#endif
#endif
