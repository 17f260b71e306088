/* console.c - what printf needs on a small processor, and how much stack a program took.
   SPDX-License-Identifier: GPL-3.0-or-later

   Linked with --wrap=main, so that the program itself stays as it was emitted: memory between the
   data and the stack is painted, main is called, and a last line says `# stack: N bytes`. A stack
   that has met the data makes the status 98. Cortex-M: newlib, semihosting's SYS_WRITE0 (Arm IHI
   0100); RV32: picolibc, the 16550 of QEMU's board `virt`; AVR: avr-libc, two general purpose
   registers that simavr.c listens to: GPIOR0 takes characters, GPIOR1 the status. */
#include <stdint.h>
#include <stdio.h>

int __real_main(void);
int __wrap_main(void);

#if defined __arm__

#include <stddef.h>

void *_sbrk(ptrdiff_t more);
int _write(int file, const char *text, int n);
int _fstat(int file, void *status);
int _isatty(int file);

extern char bss_end[];
#define DATA_END bss_end
static char heap[2048]; /* numbers printed with %g; the tests themselves have no heap */
static size_t used;

void *_sbrk(ptrdiff_t more) {
  char *const at = heap + used;
  if (more < 0 || (size_t)more > sizeof heap - used)
    return (void *)-1;
  used += (size_t)more;
  return at;
}

static void write0(const char *text) {
  register uint32_t r0 __asm__("r0") = 4;
  register const char *r1 __asm__("r1") = text;
  __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
}

int _write(int file, const char *text, int n) {
  char piece[33];
  (void)file;
  for (int i = 0; i < n;) {
    int k = 0;
    while (k < 32 && i < n)
      piece[k++] = text[i++];
    piece[k] = 0;
    write0(piece);
  }
  return n;
}

static void open_console(void) {
  static char line[128];
  setvbuf(stdout, line, _IOLBF, sizeof line);
}

#elif defined __riscv

extern char bss_end[];
#define DATA_END bss_end
static int put(char c, FILE *file) {
  (void)file;
  *(volatile uint8_t *)0x10000000 = (uint8_t)c;
  return c;
}
static FILE console = FDEV_SETUP_STREAM(put, NULL, NULL, _FDEV_SETUP_WRITE);
FILE *const stdout = &console;

static void open_console(void) {
}

#elif defined __AVR__

#include <avr/io.h>

extern char __heap_start[];
#define DATA_END __heap_start
static int put(char c, FILE *file) {
  (void)file;
  GPIOR0 = (uint8_t)c;
  return 0;
}
static FILE console = FDEV_SETUP_STREAM(put, NULL, _FDEV_SETUP_WRITE);

static void open_console(void) {
  stdout = &console;
}

#endif

#define PAINT 0xA5
#define MOST  0x8000 /* bytes that are painted */

/* below this function's own frame, whose size is not known here */
#define MARGIN 256

int __wrap_main(void) {
  char *const top = (char *)__builtin_frame_address(0) - MARGIN;
  char *const bottom = (uintptr_t)top - (uintptr_t)DATA_END > MOST ? top - MOST : DATA_END;
  char *low = bottom;
  int status;

  open_console();
  for (volatile char *p = bottom; p < top;)
    *p++ = (char)PAINT;
  status = __real_main();
  while (low < top && *(volatile char *)low == (char)PAINT)
    low++;
  printf("# stack: %ld bytes\n", (long)(top + MARGIN - low));
  fflush(stdout);
  if (low == bottom)
    status = 98;
#if defined __AVR__
  GPIOR1 = (uint8_t)status;
#endif
  return status;
}
