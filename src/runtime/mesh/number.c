/* number.c - decimal text to the nearest double, fast.
   SPDX-License-Identifier: GPL-3.0-or-later

   Up to 19 digits make an integer w < 2^64 that long double holds exactly, and so it does 10^k for
   k <= 27 (5^27 < 2^63). One multiplication or division gives r, the true value rounded to long
   double. Rounding is monotone and the midpoints of doubles are long doubles: if r is no midpoint,
   r and the true value lie on the same side of every midpoint, so (double)r is the nearest double
   (W. D. Clinger, How to read floating point numbers accurately, PLDI 1990, section 3, with the
   extended format). If r is a midpoint, or the digits are too many, strtod decides. */
#include "mesh.h"

#include <ctype.h>
#include <locale.h>
#include <stdlib.h>
#include <string.h>

enum { DIGITS = 19, POWERS = 27, LONGEST = 1100 };

static const ph_wide power[POWERS + 1] = {1e0L,  1e1L,  1e2L,  1e3L,  1e4L,  1e5L,  1e6L,
                                          1e7L,  1e8L,  1e9L,  1e10L, 1e11L, 1e12L, 1e13L,
                                          1e14L, 1e15L, 1e16L, 1e17L, 1e18L, 1e19L, 1e20L,
                                          1e21L, 1e22L, 1e23L, 1e24L, 1e25L, 1e26L, 1e27L};

/* Is r halfway between two doubles? d is r rounded; its mirror image about r is then a double. */
static int midpoint(ph_wide r, double d) {
  const ph_wide step = 2 * (r - (ph_wide)d);
  const ph_wide mirror = (ph_wide)d + step;
  return step != 0 && mirror == (ph_wide)(double)mirror;
}

/* [s, end) has the form of a number; strtod wants the point of the locale. */
static int slow(const char *s, const char *end, double *value) {
  char text[LONGEST + 16];
  const char *point = localeconv()->decimal_point;
  const size_t width = strlen(point);
  size_t n = 0;
  if (end - s > LONGEST || width > 8)
    return 0;
  for (; s < end; s++) {
    if (*s == '.') {
      memcpy(text + n, point, width);
      n += width;
    } else {
      text[n++] = *s;
    }
  }
  text[n] = '\0';
  *value = strtod(text, NULL);
  return 1;
}

static char *special(char *s, int negative, double *value) {
  char *end = s;
  while (isalpha((unsigned char)*end))
    end++;
  if (mesh_word_is(s, end, "inf") || mesh_word_is(s, end, "infinity"))
    *value = negative ? -HUGE_VAL : HUGE_VAL;
  else if (mesh_word_is(s, end, "nan"))
    *value = nan("");
  else
    return NULL;
  if (*end == '(') /* nan(ind) */
    end = mesh_word(end);
  return end;
}

char *mesh_number(char *s, double *value) {
  char *const start = s;
  uint64_t w = 0;
  int digits = 0, significant = 0, exponent = 0;
  const int negative = *s == '-';
  if (*s == '-' || *s == '+')
    s++;
  for (; *s >= '0' && *s <= '9'; s++, digits++) {
    w = w * 10 + (uint64_t)(*s - '0'); /* wraps beyond 19 digits, and is not used then */
    significant += w != 0 || significant > 0;
  }
  if (*s == '.') {
    s++;
    char *const fraction = s;
    for (; *s >= '0' && *s <= '9'; s++, digits++) {
      w = w * 10 + (uint64_t)(*s - '0');
      significant += w != 0 || significant > 0;
    }
    exponent = s - fraction > LONGEST ? -LONGEST : (int)(fraction - s);
  }
  if (digits == 0)
    return special(s, negative, value);
  if (*s == 'e' || *s == 'E') {
    char *e = s + 1;
    const int down = *e == '-';
    int n = 0;
    if (*e == '-' || *e == '+')
      e++;
    if (*e >= '0' && *e <= '9') {
      for (; *e >= '0' && *e <= '9'; e++)
        n = n < 100000 ? n * 10 + (*e - '0') : n;
      exponent += down ? -n : n;
      s = e;
    }
  }
  if (significant <= DIGITS && exponent >= -POWERS && exponent <= POWERS) {
    const ph_wide r = exponent < 0 ? (ph_wide)w / power[-exponent] : (ph_wide)w * power[exponent];
    const double d = (double)r;
    if (!midpoint(r, d)) {
      *value = negative ? -d : d;
      return s;
    }
  }
  return slow(start, s, value) ? s : NULL;
}
