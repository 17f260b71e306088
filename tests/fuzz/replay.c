/* replay.c - feeds files to a fuzz target, without libFuzzer.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 *     TARGET FILE...      the name of each file goes to standard output before it is fed
 */
#include "fuzz.h"

static uint8_t *read_file(const char *path, size_t *size) {
  FILE *file = fopen(path, "rb");
  if (file == NULL || fseek(file, 0, SEEK_END) != 0) {
    fprintf(stderr, "cannot read %s\n", path);
    exit(2);
  }
  *size = (size_t)ftell(file);
  rewind(file);
  uint8_t *data = malloc(*size > 0 ? *size : 1); /* exactly: a sanitizer sees the byte beyond */
  if (data == NULL || fread(data, 1, *size, file) != *size) {
    fprintf(stderr, "cannot read %s\n", path);
    exit(2);
  }
  fclose(file);
  return data;
}

int main(int argc, char **argv) {
  for (int i = 1; i < argc; i++) {
    size_t size;
    uint8_t *data = read_file(argv[i], &size);
    printf("%s\n", argv[i]);
    fflush(stdout);
    LLVMFuzzerTestOneInput(data, size);
    free(data);
  }
  return 0;
}
