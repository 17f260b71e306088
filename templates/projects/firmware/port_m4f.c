/* port_m4f.c -- the machine is a Cortex-M4F under a debugger or an emulator that serves semihosting.
 *
 * Yours: written once by `polhode gen --project firmware`, never again.  ${license}
 * SysTick: ARMv7-M Architecture Reference Manual, B3.3.  Semihosting: Arm, "Semihosting for AArch32 and AArch64".
 */
#include "port.h"

#include "config.h"
#include "startup.h"

#if APP_PACED
#define SYST_CSR (*(volatile uint32_t *)0xE000E010U)
#define SYST_RVR (*(volatile uint32_t *)0xE000E014U)
#define SYST_CVR (*(volatile uint32_t *)0xE000E018U)

static volatile uint32_t ticks; /* periods of SysTick since port_start; wraps */
static uint32_t due;            /* when the next cycle begins */
#endif

static void semihosting(uint32_t operation, const void *argument)
{
  register uint32_t r0 __asm__("r0") = operation;
  register const void *r1 __asm__("r1") = argument;

  __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
}

void systick_handler(void)
{
#if APP_PACED
  ticks++;
#endif
}

void port_start(void)
{
#if APP_PACED
  ticks = due = 0;
  SYST_RVR = APP_RELOAD;
  SYST_CVR = 0;
  SYST_CSR = 7; /* the processor's clock, interrupt, on */
#endif
}

int port_wait(void)
{
#if APP_PACED
  due += APP_TICKS;
  if (due - ticks - 1U >= 0x80000000U) { /* due has been */
    due = ticks;
    return 0;
  }
  for (;;) { /* no tick may come between the look and the sleep; one that waits ends the sleep all the same */
    __asm__ volatile("cpsid i" : : : "memory");
    if (due - ticks - 1U >= 0x80000000U) break;
    __asm__ volatile("wfi\n\tcpsie i\n\tisb" : : : "memory");
  }
  __asm__ volatile("cpsie i" : : : "memory");
#endif
  return 1;
}

void port_write(const char *s)
{
  semihosting(0x04, s); /* SYS_WRITE0 */
}

uint32_t port_stack_used(void)
{
  const uint32_t *p = bss_end;

  while (p < stack_top && *p == STACK_PAINT) p++;
  return (uint32_t)(stack_top - p)*4U;
}

void port_safe(void)
{
}

void port_exit(int status)
{
  uint32_t block[2];

  block[0] = 0x20026; /* ADP_Stopped_ApplicationExit */
  block[1] = (uint32_t)status;
  semihosting(0x20, block); /* SYS_EXIT_EXTENDED */
  for (;;) __asm__ volatile("wfi");
}
