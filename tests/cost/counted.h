/* counted.h - a number that counts what is done with it; in the place of NAME_real in emitted code,
   read as C++. SPDX-License-Identifier: GPL-3.0-or-later

   NATIVE is double or float. Operations of two constants never meet this type, so they are free. */
#ifndef COUNTED_H
#define COUNTED_H
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

struct tally {
  long add, mul, div, sqrt, fma, call;
};
static struct tally counts;

struct counted {
  NATIVE v;
  counted() = default; /* trivial: it stands in unions */
  counted(double x) : v((NATIVE)x) {
  }
  counted(const counted &) = default;
  counted(const volatile counted &x) : v(x.v) {
  }
  counted &operator=(const counted &) = default;
  counted &operator=(const volatile counted &x) {
    v = x.v;
    return *this;
  }
  explicit operator int() const {
    return (int)v;
  }
  explicit operator int64_t() const {
    return (int64_t)v;
  }
  explicit operator uint64_t() const {
    return (uint64_t)v;
  }
  explicit operator uint32_t() const {
    return (uint32_t)v;
  }
  explicit operator double() const {
    return v;
  }
};

static inline counted operator+(counted a, counted b) {
  counts.add++;
  return a.v + b.v;
}
static inline counted operator-(counted a, counted b) {
  counts.add++;
  return a.v - b.v;
}
static inline counted operator*(counted a, counted b) {
  counts.mul++;
  return a.v * b.v;
}
static inline counted operator/(counted a, counted b) {
  counts.div++;
  return a.v / b.v;
}
static inline counted &operator+=(counted &a, counted b) {
  return a = a + b;
}
static inline counted &operator-=(counted &a, counted b) {
  return a = a - b;
}
static inline counted &operator*=(counted &a, counted b) {
  return a = a * b;
}
static inline counted &operator/=(counted &a, counted b) {
  return a = a / b;
}
static inline counted operator-(counted a) {
  return -a.v;
}
static inline bool operator<(counted a, counted b) {
  return a.v < b.v;
}
static inline bool operator>(counted a, counted b) {
  return a.v > b.v;
}
static inline bool operator<=(counted a, counted b) {
  return a.v <= b.v;
}
static inline bool operator>=(counted a, counted b) {
  return a.v >= b.v;
}
static inline bool operator==(counted a, counted b) {
  return a.v == b.v;
}
static inline bool operator!=(counted a, counted b) {
  return a.v != b.v;
}

#define COUNT_ONE(name, kind)                                                                      \
  static inline counted name(counted x) {                                                          \
    counts.kind++;                                                                                 \
    return (NATIVE)::name((NATIVE)x.v);                                                            \
  }
#define COUNT(name, kind) COUNT_ONE(name, kind) COUNT_ONE(name##f, kind)
COUNT(sqrt, sqrt)
COUNT(sin, call)
COUNT(cos, call)
COUNT(tan, call)
COUNT(sinh, call)
COUNT(cosh, call)
COUNT(tanh, call)
COUNT(exp, call)
COUNT(log, call)
COUNT(floor, call)
COUNT(asin, call)
COUNT(acos, call)
COUNT(atan, call)

static inline counted fabs(counted x) {
  return x.v < 0 ? -x.v : x.v;
}
static inline counted fabsf(counted x) {
  return fabs(x);
}
static inline counted frexp(counted x, int *e) {
  counts.call++;
  return (NATIVE)::frexp((double)x.v, e);
}
static inline counted frexpf(counted x, int *e) {
  return frexp(x, e);
}
static inline counted ldexp(counted x, int e) {
  counts.call++;
  return (NATIVE)::ldexp((double)x.v, e);
}
static inline counted ldexpf(counted x, int e) {
  return ldexp(x, e);
}
static inline counted fma(counted a, counted b, counted c) {
  counts.fma++;
  return (NATIVE)::fma((double)a.v, (double)b.v, (double)c.v);
}
static inline counted fmaf(counted a, counted b, counted c) {
  return fma(a, b, c);
}

/* What `what` costs, as a line of numbers. */
#define SHOW(name, what)                                                                           \
  do {                                                                                             \
    counts = (struct tally){0, 0, 0, 0, 0, 0};                                                     \
    what;                                                                                          \
    printf("%s %ld %ld %ld %ld %ld %ld\n", name, counts.add, counts.mul, counts.div, counts.sqrt,  \
           counts.fma, counts.call);                                                               \
  } while (0)
#endif
