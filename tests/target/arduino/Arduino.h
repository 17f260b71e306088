/* Arduino.h - as much of an Arduino core as the examples of `gen --project arduino` use: Serial,
   setup, loop. SPDX-License-Identifier: GPL-3.0-or-later

   Written for the tests: on an AVR Serial is the first UART, elsewhere standard output. Numbers
   are printed in float on both, so that equal bits give equal text. */
#ifndef ARDUINO_SHIM_H
#define ARDUINO_SHIM_H

#include <stdint.h>

void setup();
void loop();

class Shim {
public:
  void begin(long) {
  }
  operator bool() const {
    return true;
  }
  void print(char c);
  void print(const char *text);
  void print(float value, int digits = 2);
  void println(const char *text = "");
};

extern Shim Serial;

#endif
