/* gyro.c -- the gyro: a table (readings.c) in place of the driver.
 *
 * Yours: written once by `polhode gen --project firmware`, never again.  ${license}
 * On a board gyro_read asks the sensor; nothing else changes.
 */
#include "gyro.h"

#include "config.h"

int gyro_read(uint32_t cycle, int16_t raw[3])
{
  const uint32_t k = cycle/APP_SAMPLE_EVERY;
#if APP_INJECT == 3
  static int16_t stuck[3];
  int i;
#endif

  if (k*APP_SAMPLE_EVERY != cycle || k == 0 || k > APP_SAMPLES) return 0;
  readings_take(k, raw);
#if APP_INJECT == 3
  for (i = 0; i < 3; i++) {
    if (k > APP_SAMPLES/2) {
      raw[i] = stuck[i];
    } else {
      stuck[i] = raw[i];
    }
  }
#endif
  return 1;
}

void gyro_rates(const int16_t raw[3], app_real w[3])
{
  int i;

  for (i = 0; i < 3; i++) w[i] = APP_GYRO_LSB*(app_real)raw[i];
}
