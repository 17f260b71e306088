/* hash.h - names of an emitted scene, and a hash of the bits of numbers.
   SPDX-License-Identifier: GPL-3.0-or-later

   SCENE, UPPER, SCENE_H: as in bits.c. FNV-1a of 64 bits over the numbers in their order, each from
   its highest byte to its lowest. All NaNs count as one: which of them an operation gives is the
   machine's affair. Zeros have their sign. */
#ifndef HASH_H
#define HASH_H

#include SCENE_H
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#define JOIN_(a, b) a##_##b
#define JOIN(a, b)  JOIN_(a, b)
#define FN(name)    JOIN(SCENE, name)
typedef FN(real) real;
enum { NX = JOIN(UPPER, NX), NU = JOIN(UPPER, NU) };

static uint64_t hash;

static void byte(unsigned int b) {
  hash = (hash ^ (b & 0xFF)) * UINT64_C(0x100000001B3);
}

static void number(real v) {
  if (v != v)
    v = 0, byte('N');
  if (sizeof v == 4) {
    uint32_t w;
    memcpy(&w, &v, 4);
    for (int i = 24; i >= 0; i -= 8)
      byte((unsigned int)(w >> i & 0xFF));
  } else {
    uint64_t w;
    memcpy(&w, &v, sizeof v);
    for (int i = 56; i >= 0; i -= 8)
      byte((unsigned int)(w >> i & 0xFF));
  }
}

static void numbers(const real v[], int n) {
  for (int i = 0; i < n; i++)
    number(v[i]);
}

static void whole(int v) {
  byte((unsigned int)v >> 8);
  byte((unsigned int)v);
}

static void start(void) {
  hash = UINT64_C(0xCBF29CE484222325);
}

static void item(const char *name) {
  printf("%s %08lx%08lx\n", name, (unsigned long)(hash >> 32), (unsigned long)(hash & 0xFFFFFFFF));
  start();
}

#endif
