/* fuzz.h - what the fuzz targets share.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A target is a function LLVMFuzzerTestOneInput.  Under clang it is linked with libFuzzer, in the
 * test replay.t with replay.c, which feeds it files.
 */
#ifndef FUZZ_H
#define FUZZ_H

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* What must not be: printed, then the end of the process, which keeps the input. */
static inline void fuzz_finding(const char *format, ...) {
  va_list args;
  va_start(args, format);
  fputs("FINDING: ", stderr);
  vfprintf(stderr, format, args);
  fputc('\n', stderr);
  va_end(args);
  abort();
}

/* A defect that replay.t plants to see that the harness sees it; NULL as a rule. */
static inline int fuzz_planted(const char *name) {
  const char *plant = getenv("FUZZ_PLANT");
  return plant != NULL && strcmp(plant, name) == 0;
}

/* A file of tests/fuzz. */
static inline const char *fuzz_path(const char *name) {
  static char path[4096];
  const char *dir = getenv("FUZZ_DIR");
  snprintf(path, sizeof path, "%s/%s", dir != NULL ? dir : "tests/fuzz", name);
  return path;
}

#endif
