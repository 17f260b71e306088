/* control.c -- the control law.
 *
 * Yours: written once by `polhode gen --project firmware`, never again.  ${license}
 */
#include "control.h"

void control(uint32_t cycle, const app_real x[], app_real u[])
{
  int i;

  (void)cycle;
  (void)x;
  for (i = 0; i < APP_NU; i++) u[i] = 0;
}
