/* sweep_seal.c -- whose result a finished file is, so that --resume takes no other for it.
 * template: templates/sweep/sweep_seal.c.  SPDX-License-Identifier: MIT-0
 *
 * Beside FILE stands FILE.study: the study's fingerprint and command, and the size and checksum of FILE. */
#include "sweep.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

enum { NAME = 4096 };

static int path_of(char out[NAME], const char *file, const char *end)
{
  const int n = snprintf(out, NAME, "%s%s", file, end);

  if (n > 0 && n < NAME) return 0;
  sweep_say("%s: %s", file, strerror(ENAMETOOLONG));
  return -1;
}

/* The size and checksum of a file; 0, or -1 after a message. */
static int measured(const char *file, unsigned long long *size, unsigned long long *sum)
{
  unsigned char data[1 << 16]; /* whole words, of which a checksum is made */
  FILE *f = fopen(file, "rb");
  size_t n;
  int wrong;

  *size = *sum = 0;
  if (f == NULL) {
    sweep_say("%s: %s", file, strerror(errno));
    return -1;
  }
  while ((n = fread(data, 1, sizeof data, f)) > 0) {
    *sum = sweep_checksum((uint64_t)*sum, data, n);
    *size += n;
  }
  wrong = ferror(f);
  fclose(f);
  if (wrong) sweep_say("%s: cannot be read", file);
  return wrong ? -1 : 0;
}

int sweep_seal_write(const sweep_study *s, const char *file)
{
  char path[NAME], draft[NAME];
  unsigned long long size, sum;
  FILE *f;
  int wrong;

  if (path_of(path, file, ".study") != 0 || path_of(draft, file, ".study.new") != 0) return -1;
  if (measured(file, &size, &sum) != 0) return -1;
  f = fopen(draft, "w");
  if (f == NULL) {
    sweep_say("%s: %s", draft, strerror(errno));
    return -1;
  }
  fprintf(f, "fingerprint %s\nbytes %llu\nchecksum %016llx\nby %s\ncommand %s\n", s->fingerprint, size, sum, s->version,
    s->command);
  wrong = ferror(f);
  wrong = fclose(f) != 0 || wrong;
  if (wrong || rename(draft, path) != 0) {
    sweep_say("%s: %s", path, strerror(errno));
    remove(draft);
    return -1;
  }
  return 0;
}

/* What stands behind `word` at the beginning of a line. */
static int line_of(FILE *f, const char *word, char out[NAME])
{
  char line[NAME + 64];
  const size_t n = strlen(word);

  out[0] = 0;
  rewind(f);
  while (fgets(line, sizeof line, f) != NULL) {
    if (strncmp(line, word, n) == 0 && line[n] == ' ') {
      snprintf(out, NAME, "%s", line + n + 1);
      out[strcspn(out, "\n")] = 0;
      return 1;
    }
  }
  return 0;
}

void sweep_another(const sweep_study *s, const char *where, FILE *f)
{
  char command[NAME], version[NAME];

  line_of(f, "command", command);
  line_of(f, "by", version);
  sweep_say("%s is of another study:\n  there  %s (%s)\n  now    %s (%s)%s", where, command[0] != 0 ? command : "unknown",
    version[0] != 0 ? version : "unknown", s->command, s->version,
    strcmp(command, s->command) == 0 && strcmp(version, s->version) == 0 ? "\n  the scene was another" : "");
}

int sweep_seal_check(const sweep_study *s, const char *file)
{
  char path[NAME], print[NAME], bytes[NAME], check[NAME], want[NAME];
  unsigned long long size, sum;
  int whole, mine;
  FILE *f;

  if (path_of(path, file, ".study") != 0) return -1;
  f = fopen(path, "r");
  if (f == NULL) {
    sweep_say("%s is there, and no %s that says of which study: nothing can be resumed (remove it, or write to another "
      "file)", file, path);
    return -1;
  }
  whole = line_of(f, "fingerprint", print) && line_of(f, "bytes", bytes) && line_of(f, "checksum", check);
  mine = strcmp(print, s->fingerprint) == 0;
  if (whole && !mine) sweep_another(s, file, f);
  fclose(f);
  if (whole && !mine) return -1;
  if (measured(file, &size, &sum) != 0) return -1;
  snprintf(want, sizeof want, "%llu", size);
  whole = whole && strcmp(want, bytes) == 0;
  snprintf(want, sizeof want, "%016llx", sum);
  if (whole && strcmp(want, check) == 0) return 0;
  sweep_say("%s is not what the sweep wrote: by %s it was changed since (remove it, and the sweep begins anew)", file,
    path);
  return -1;
}
