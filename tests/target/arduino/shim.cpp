/* shim.cpp - Serial and main for sketches; SHIM_LOOPS calls of loop, then the end.
   SPDX-License-Identifier: GPL-3.0-or-later */
#include "Arduino.h"

#ifdef __AVR__
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>

static void put(char c) {
  while (!(UCSR0A & (1 << UDRE0)))
    ;
  UDR0 = (uint8_t)c;
}

static void finish() { /* what simavr takes for the end: asleep and deaf */
  while (!(UCSR0A & (1 << UDRE0)))
    ;
  cli();
  sleep_mode();
}
#else
#include <stdio.h>

static void put(char c) {
  putchar(c);
}

static void finish() {
}
#endif

Shim Serial;

void Shim::print(char c) {
  put(c);
}

void Shim::print(const char *text) {
  while (*text)
    put(*text++);
}

/* Digits are cut, not rounded: the same operations on the same bits everywhere. */
void Shim::print(float value, int digits) {
  if (value < 0) {
    put('-');
    value = -value;
  }
  const uint32_t whole = (uint32_t)value;
  char text[12];
  int n = 0;
  uint32_t rest = whole;
  do {
    text[n++] = (char)('0' + rest % 10);
    rest /= 10;
  } while (rest);
  while (n > 0)
    put(text[--n]);
  put('.');
  float part = value - (float)whole;
  for (int i = 0; i < digits; i++) {
    part *= 10.0F;
    const uint8_t digit = (uint8_t)part;
    put((char)('0' + digit));
    part -= (float)digit;
  }
}

void Shim::println(const char *text) {
  print(text);
  put('\n');
}

int main() {
#ifdef __AVR__
  UCSR0B = 1 << TXEN0;
#endif
  setup();
  for (int i = 0; i < SHIM_LOOPS; i++)
    loop();
  finish();
  return 0;
}
