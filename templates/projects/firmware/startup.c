/* startup.c -- from reset to main on a Cortex-M4F, and what faults report.
 *
 * Yours: written once by `polhode gen --project firmware`, never again.  ${license}
 * ARMv7-M Architecture Reference Manual: reset and vector table B1.5, exception frame B1.5.6, CPACR B3.2.20, fault status
 * registers B3.2.15.
 */
#include "startup.h"

#include "port.h"
#include "telemetry.h"

#define CPACR (*(volatile uint32_t *)0xE000ED88U)
#define CFSR (*(volatile uint32_t *)0xE000ED28U)
#define HFSR (*(volatile uint32_t *)0xE000ED2CU)

void reset_handler(void)
{
  const uint32_t *from = data_load;
  uint32_t *to;

  CPACR |= 0xFU << 20; /* the floating-point unit on, before any of its instructions */
  __asm__ volatile("dsb\n\tisb");
  for (to = data_start; to < data_end;) *to++ = *from++;
  for (to = bss_start; to < bss_end;) *to++ = 0;
  for (to = bss_end; to < stack_free;) *to++ = STACK_PAINT;
  port_exit(main());
}

/* Faults end here: F, program counter, link register, configurable and hard fault status; then the program ends. */
void fault_report(const uint32_t *frame)
{
  uint32_t words[4];

  words[0] = frame[6];
  words[1] = frame[5];
  words[2] = CFSR;
  words[3] = HFSR;
  port_safe(); /* first: without a debugger what follows is one more fault */
  telemetry_trap(words, 4);
  port_exit(99);
}

/* The frame that the processor pushed lies where the stack pointer is. */
__attribute__((naked)) static void fault_handler(void)
{
  __asm__ volatile("mrs r0, msp\n\tb fault_report");
}

/* An interrupt that nobody asked for is a fault, too. */
__attribute__((section(".vectors"), used)) static const struct {
  uint32_t *stack;
  void (*handler[15])(void);
} vectors = {
  stack_top,
  { reset_handler, fault_handler /* NMI */, fault_handler /* hard */, fault_handler /* memory */, fault_handler /* bus */,
    fault_handler /* usage */, 0, 0, 0, 0, fault_handler /* SVC */, fault_handler /* debug */, 0,
    fault_handler /* PendSV */, systick_handler }
};
