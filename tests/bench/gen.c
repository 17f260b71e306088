/* gen.c - how long `polhode gen` takes for each body, as whole processes.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Arguments: the program, an output directory, then the scenes.  Median of REPEATS runs after one
 * that warms up.
 */
#include "clock.h"
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>

enum { REPEATS = 11 };

extern char **environ;

static int generate(const char *program, const char *dir, const char *scene) {
  char *argv[] = {strdup(program), strdup("gen"), strdup(scene), strdup("-o"), strdup(dir), NULL};
  pid_t pid;
  int status = -1;
  if (posix_spawn(&pid, program, NULL, NULL, argv, environ) == 0)
    waitpid(pid, &status, 0);
  for (int i = 0; i < 5; i++)
    free(argv[i]);
  return status;
}

int main(int argc, char **argv) {
  if (argc < 4)
    return 2;
  printf("polhode gen, whole process, median of %d runs (ms)\n", (int)REPEATS);
  for (int i = 3; i < argc; i++) {
    double time[REPEATS];
    for (int k = -1; k < REPEATS; k++) {
      const double start = now();
      if (generate(argv[1], argv[2], argv[i]) != 0) {
        printf("  %s: failed\n", argv[i]);
        return 1;
      }
      if (k >= 0)
        time[k] = (now() - start) * 1e3;
    }
    qsort(time, REPEATS, sizeof time[0], ascending);
    printf("  %-28s %6.1f\n", argv[i], time[REPEATS / 2]);
  }
  return 0;
}
