/* sha256.c - the hash that names a scene, the files it reads and the files that are made from it.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * NIST FIPS 180-4: functions 4.1.2, constants 4.2.2, padding 5.1.1, first value 5.3.3, a
 * block 6.2.2. The constants are the first 32 bits of the fractional parts of the square roots
 * (first value) and cube roots (rounds) of the first primes.
 */
#include "host.h"

#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { BLOCK = 64, DIGEST = 8 }; /* bytes, words */

struct sha256 {
  uint32_t h[DIGEST];
  uint64_t size; /* bytes so far */
  unsigned char block[BLOCK];
};

static const uint32_t rounds[64] = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2,
};

static uint32_t rotr(uint32_t x, int n) {
  return x >> n | x << (32 - n);
}

static void one_block(struct sha256 *s) {
  uint32_t w[64], v[DIGEST];
  for (int t = 0; t < 16; t++) {
    const unsigned char *b = s->block + 4 * t;
    w[t] = (uint32_t)b[0] << 24 | (uint32_t)b[1] << 16 | (uint32_t)b[2] << 8 | b[3];
  }
  for (int t = 16; t < 64; t++) {
    const uint32_t a = w[t - 15], b = w[t - 2];
    w[t] = (rotr(b, 17) ^ rotr(b, 19) ^ b >> 10) + w[t - 7] + (rotr(a, 7) ^ rotr(a, 18) ^ a >> 3) +
           w[t - 16];
  }
  memcpy(v, s->h, sizeof v);
  for (int t = 0; t < 64; t++) {
    const uint32_t e = v[4], a = v[0];
    const uint32_t t1 = v[7] + (rotr(e, 6) ^ rotr(e, 11) ^ rotr(e, 25)) +
                        ((e & v[5]) ^ (~e & v[6])) + rounds[t] + w[t];
    const uint32_t t2 =
        (rotr(a, 2) ^ rotr(a, 13) ^ rotr(a, 22)) + ((a & v[1]) ^ (a & v[2]) ^ (v[1] & v[2]));
    memmove(v + 1, v, 7 * sizeof *v);
    v[4] += t1;
    v[0] = t1 + t2;
  }
  for (int i = 0; i < DIGEST; i++)
    s->h[i] += v[i];
}

static void begin(struct sha256 *s) {
  static const uint32_t first[DIGEST] = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                         0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  memcpy(s->h, first, sizeof first);
  s->size = 0;
}

static void add(struct sha256 *s, const void *text, size_t size) {
  const unsigned char *p = text;
  while (size > 0) {
    const size_t at = (size_t)(s->size % BLOCK), room = BLOCK - at;
    const size_t n = size < room ? size : room;
    memcpy(s->block + at, p, n);
    s->size += n;
    if (n == room)
      one_block(s);
    p += n;
    size -= n;
  }
}

/* Push the digest as 64 hexadecimal digits. */
static void push_digest(lua_State *L, struct sha256 *s) {
  static const unsigned char bit[BLOCK] = {0x80}; /* a one, then zeros up to the length */
  const uint64_t bits = 8 * s->size;
  unsigned char length[8];
  char out[8 * DIGEST + 1];
  for (int i = 0; i < 8; i++)
    length[i] = (unsigned char)(bits >> (56 - 8 * i));
  add(s, bit, 1 + (size_t)((BLOCK + 55 - s->size % BLOCK) % BLOCK));
  add(s, length, sizeof length);
  for (int i = 0; i < DIGEST; i++)
    snprintf(out + 8 * i, 9, "%08lx", (unsigned long)s->h[i]);
  lua_pushlstring(L, out, 8 * DIGEST);
}

/* The bytes of the regular file at path; an error's text, or NULL. */
static const char *add_file(struct sha256 *s, const char *path) {
  unsigned char text[1 << 14];
  struct stat info;
  ssize_t n;
  const int fd = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC); /* a fifo must not block the open */
  if (fd < 0)
    return strerror(errno);
  if (fstat(fd, &info) != 0 || !S_ISREG(info.st_mode)) {
    close(fd);
    return "it is not a regular file";
  }
  while ((n = read(fd, text, sizeof text)) > 0 || (n < 0 && errno == EINTR))
    if (n > 0)
      add(s, text, (size_t)n);
  const int error = errno;
  close(fd);
  return n < 0 ? strerror(error) : NULL;
}

int host_sha256(lua_State *L) {
  struct sha256 s;
  size_t size;
  const char *text = luaL_checklstring(L, 1, &size);
  begin(&s);
  add(&s, text, size);
  for (int i = 2; i <= lua_gettop(L); i++) {
    const char *path = luaL_checkstring(L, i), *why = add_file(&s, path);
    if (why != NULL) {
      lua_pushnil(L);
      lua_pushfstring(L, "cannot read %s: %s", path, why);
      return 2;
    }
  }
  push_digest(L, &s);
  return 1;
}
