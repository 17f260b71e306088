/* config.h -- what the project chooses.
 *
 * Yours: written once by `polhode gen --project firmware`, never again.  ${license}
 * Each can be given to the compiler instead (-DAPP_GYRO=0 ...).  A number of derived.h that is defined here, above its
 * #include, stands in place of the computed one: `#define APP_RATE_VARIANCE 1e-6f`.
 */
#ifndef APP_CONFIG_HEADER
#define APP_CONFIG_HEADER

#ifndef APP_GYRO
#define APP_GYRO 1 /* 1: propagation and gyro updates; 0: propagation alone, no covariance */
#endif
#ifndef APP_WATCHDOG
#define APP_WATCHDOG 1 /* 0: without checks, for the smallest parts */
#endif
#ifndef APP_PACED
#define APP_PACED 1 /* 1: SysTick sets the rate; 0: as fast as it can, for emulators */
#endif
#ifndef APP_CYCLES
#define APP_CYCLES 0 /* cycles until the program ends; 0: never */
#endif
#ifndef APP_TELEMETRY
#define APP_TELEMETRY APP_SAMPLE_EVERY /* cycles between two telemetry lines */
#endif
#ifndef APP_CLOCK
#define APP_CLOCK 25000000 /* Hz that SysTick counts: the processor's clock, here of the board mps2-an386 */
#endif
#ifndef APP_INJECT
#define APP_INJECT 0 /* negative controls, inject.c: 1 a bit of q, 2 a NaN, 3 a gyro that is stuck, 4 a trap */
#endif
#ifndef APP_INJECT_AT
#define APP_INJECT_AT 100 /* the cycle of 1, 2 and 4 */
#endif

#include "derived.h"

#endif
