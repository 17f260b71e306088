/* confine.c - runs a program within bounds and says what it took.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 *     confine SECONDS OUT ERR program argument...
 * Prints "exit status", or "killed signal"; then processor seconds and the largest resident set in
 * MiB, both of the program and all that it waited for (wait4).  Beyond SECONDS of processor time
 * the kernel kills it; beyond 300 s by the clock so does an alarm.
 */
#define _DEFAULT_SOURCE
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

static void redirect(const char *path, int to) {
  const int fd = open(path, O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (fd < 0 || dup2(fd, to) < 0)
    _exit(126);
  close(fd);
}

int main(int argc, char **argv) {
  if (argc < 5)
    return 2;
  const rlim_t seconds = (rlim_t)atoi(argv[1]);
  const pid_t child = fork();
  if (child == 0) {
    const struct rlimit time = {seconds, seconds};
    setrlimit(RLIMIT_CPU, &time);
    redirect(argv[2], STDOUT_FILENO);
    redirect(argv[3], STDERR_FILENO);
    alarm(300);
    execvp(argv[4], argv + 4);
    _exit(127);
  }
  int status;
  struct rusage used;
  if (child < 0 || wait4(child, &status, 0, &used) != child)
    return 1;
  const double cpu = (double)(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
                     1e-6 * (double)(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
  printf("%s %d %.3f %.1f\n", WIFEXITED(status) ? "exit" : "killed",
         WIFEXITED(status) ? WEXITSTATUS(status) : WTERMSIG(status), cpu,
         (double)used.ru_maxrss / 1024);
  return 0;
}
