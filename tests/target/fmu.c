/* fmu.c - drives the binary of a unit for co-simulation as an importing tool does: dlopen, the
 * standard's functions. SPDX-License-Identifier: GPL-3.0-or-later
 *
 *     fmu BINARY < commands          compiled with -DVERSION=2 or 3
 *
 * Written from the standards, not from what is emitted.  One line of output for each line of input:
 * the status (0 OK, 3 Error), numbers in hexadecimal, and after a # the last message of the log
 * with its category.  Commands, I and S being numbers of instances and of saved states: new I TOKEN
 * LOGGING           start I TIME STOP ("-": none)      ready I (end of initialization) set I VR
 * VALUE                get I VR...                        step I TIME SIZE save I S   load I S free
 * I S   bytes I S (serialize) unbytes I S SIZE (deserialize, SIZE 0: all) along I UNKNOWN KNOWN log
 * I ON CATEGORY                  end I   reset I   drop I other I NAME                  a function
 * (c, vr, n = 1, value, 1) by its name
 */
#include <dlfcn.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifndef VERSION
#define VERSION 3
#endif
#define MANY 4

static void *library;
static void *instance[MANY], *saved[MANY];
static char bytes[1 << 16];
static size_t size;
static char message[512];

/* A function of the library by its name without fmi2 or fmi3. */
typedef void (*any_function)(void);
static any_function function(const char *name) {
  char full[80];
  snprintf(full, sizeof full, "fmi%d%s", VERSION, name);
  any_function f;
  *(void **)&f = dlsym(library, full); /* as POSIX shows it */
  if (f == NULL) {
    fprintf(stderr, "no %s\n", full);
    exit(2);
  }
  return f;
}

#define AS(type, name) ((type)function(name))

#if VERSION == 2
typedef int boolean;
static void logged(void *environment, const char *name, int status, const char *category,
                   const char *text, ...) {
  /* the text is a format; of a unit of ours it is %s with one argument */
  __builtin_va_list list;
  __builtin_va_start(list, text);
  int n = snprintf(message, sizeof message, "%s %d %s: ", category, status, name);
  vsnprintf(message + n, sizeof message - (size_t)n, text, list);
  __builtin_va_end(list);
  (void)environment;
}

struct callbacks {
  void (*log)(void *, const char *, int, const char *, const char *, ...);
  void *(*allocate)(size_t, size_t);
  void (*release)(void *);
  void (*finished)(void *, int);
  void *environment;
};

static void *new_instance(const char *token, int logging) {
  typedef void *make(const char *, int, const char *, const char *, const struct callbacks *, int,
                     int);
  const struct callbacks callbacks = {logged, NULL, NULL, NULL, NULL};
  return AS(make *, "Instantiate")("100%d unit", 1, token, "file:///nowhere", &callbacks, 0,
                                   logging);
}

static int start(void *c, double time, double stop, int stops) {
  typedef int setup(void *, int, double, double, int, double);
  const int status = AS(setup *, "SetupExperiment")(c, 0, 0, time, stops, stop);
  return status != 0 ? status : AS(int (*)(void *), "EnterInitializationMode")(c);
}

static int get(void *c, unsigned vr, double *value) {
  typedef int getter(void *, const unsigned *, size_t, double *);
  return AS(getter *, "GetReal")(c, &vr, 1, value);
}

static int set(void *c, unsigned vr, double value) {
  typedef int setter(void *, const unsigned *, size_t, const double *);
  return AS(setter *, "SetReal")(c, &vr, 1, &value);
}

static int step(void *c, double time, double by) {
  typedef int stepper(void *, double, double, int);
  return AS(stepper *, "DoStep")(c, time, by, 1);
}

static int along(void *c, unsigned unknown, unsigned known, double *value) {
  typedef int derivative(void *, const unsigned *, size_t, const unsigned *, size_t, const double *,
                         double *);
  const double one = 1;
  return AS(derivative *, "GetDirectionalDerivative")(c, &unknown, 1, &known, 1, &one, value);
}

#define STATE(verb) verb "FMUstate"
#define DESERIALIZE "DeSerializeFMUstate"
#else
typedef bool boolean;
static void logged(void *environment, int status, const char *category, const char *text) {
  (void)environment;
  snprintf(message, sizeof message, "%s %d %s", category, status, text);
}

static void *new_instance(const char *token, int logging) {
  typedef void *make(const char *, const char *, const char *, bool, bool, bool, bool,
                     const uint32_t *, size_t, void *,
                     void (*)(void *, int, const char *, const char *), void *);
  return AS(make *, "InstantiateCoSimulation")("unit", token, NULL, false, logging != 0, false,
                                               false, NULL, 0, NULL, logged, NULL);
}

static int start(void *c, double time, double stop, int stops) {
  typedef int enter(void *, bool, double, double, bool, double);
  return AS(enter *, "EnterInitializationMode")(c, false, 0, time, stops != 0, stop);
}

static int get(void *c, unsigned vr, double *value) {
  typedef int getter(void *, const uint32_t *, size_t, double *, size_t);
  const uint32_t reference = vr;
  return AS(getter *, "GetFloat64")(c, &reference, 1, value, 1);
}

static int set(void *c, unsigned vr, double value) {
  typedef int setter(void *, const uint32_t *, size_t, const double *, size_t);
  const uint32_t reference = vr;
  return AS(setter *, "SetFloat64")(c, &reference, 1, &value, 1);
}

/* A step that is done says so in all four ways. */
static int step(void *c, double time, double by) {
  typedef int stepper(void *, double, double, bool, bool *, bool *, bool *, double *);
  bool event = true, end = true, early = true;
  double last = -1;
  const int status = AS(stepper *, "DoStep")(c, time, by, true, &event, &end, &early, &last);
  double now;
  if (status == 0 && (event || end || early || get(c, 0, &now) != 0 || last != now))
    return 100;
  return status;
}

static int along(void *c, unsigned unknown, unsigned known, double *value) {
  typedef int derivative(void *, const uint32_t *, size_t, const uint32_t *, size_t, const double *,
                         size_t, double *, size_t);
  const double one = 1;
  return AS(derivative *, "GetDirectionalDerivative")(c, &unknown, 1, &known, 1, &one, 1, value, 1);
}

#define STATE(verb) verb "FMUState"
#define DESERIALIZE "DeserializeFMUState"
#endif

static int plain(const char *name, void *c) {
  return AS(int (*)(void *), name)(c);
}

static int keep(const char *verb, void *c, int s, size_t length) {
  typedef int (*taking)(void *, void *);
  typedef int (*giving)(void *, void **);
  if (strcmp(verb, "save") == 0)
    return AS(giving, STATE("Get"))(c, &saved[s]);
  if (strcmp(verb, "load") == 0)
    return AS(taking, STATE("Set"))(c, saved[s]);
  if (strcmp(verb, "free") == 0)
    return AS(giving, STATE("Free"))(c, &saved[s]);
  if (strcmp(verb, "bytes") == 0) {
    typedef int (*measure)(void *, void *, size_t *);
    typedef int (*put)(void *, void *, void *, size_t);
    const char *name = VERSION == 2 ? "SerializedFMUstateSize" : "SerializedFMUStateSize";
    const int status = AS(measure, name)(c, saved[s], &size);
    if (status != 0 || size > sizeof bytes)
      return status != 0 ? status : 100;
    return AS(put, STATE("Serialize"))(c, saved[s], bytes, size);
  }
  typedef int (*take)(void *, const void *, size_t, void **);
  return AS(take, DESERIALIZE)(c, bytes, length > 0 ? length : size, &saved[s]);
}

static int other(void *c, const char *name) {
  typedef int (*any)(void *, const unsigned *, size_t, void *, size_t);
  const unsigned vr = 1;
  double room[4] = {0};
  return AS(any, name)(c, &vr, 1, room, 1);
}

static int perform(const char *verb, int i, char *rest) {
  char word[80] = "", second[80] = "";
  sscanf(rest, "%79s %79s", word, second);
  const double a = strtod(word, NULL), b = strtod(second, NULL);
  const unsigned vr = (unsigned)strtoul(word, NULL, 10);
  double value = 0;
  if (strcmp(verb, "new") == 0)
    return (instance[i] = new_instance(word, second[0] == '1')) == NULL;
  if (strcmp(verb, "start") == 0)
    return start(instance[i], a, b, second[0] != '-');
  if (strcmp(verb, "ready") == 0)
    return plain("ExitInitializationMode", instance[i]);
  if (strcmp(verb, "set") == 0)
    return set(instance[i], vr, b);
  if (strcmp(verb, "step") == 0)
    return step(instance[i], a, b);
  if (strcmp(verb, "end") == 0)
    return plain("Terminate", instance[i]);
  if (strcmp(verb, "reset") == 0)
    return plain("Reset", instance[i]);
  if (strcmp(verb, "other") == 0)
    return other(instance[i], word);
  if (strcmp(verb, "log") == 0) {
    typedef int (*control)(void *, boolean, size_t, const char *const *);
    const char *category = second;
    return AS(control, "SetDebugLogging")(instance[i], word[0] == '1', 1, &category);
  }
  if (strcmp(verb, "along") == 0) {
    const int status = along(instance[i], vr, (unsigned)strtoul(second, NULL, 10), &value);
    printf("%a ", value);
    return status;
  }
  if (strcmp(verb, "drop") == 0) {
    AS(void (*)(void *), "FreeInstance")(instance[i]);
    return 0;
  }
  return keep(verb, instance[i], (int)vr % MANY, (size_t)b);
}

int main(int argc, char **argv) {
  static char line[4096];
  library = argc == 2 ? dlopen(argv[1], RTLD_NOW | RTLD_LOCAL) : NULL;
  if (library == NULL) {
    fprintf(stderr, "fmu: %s\n", argc == 2 ? dlerror() : "usage: fmu BINARY");
    return 2;
  }
  typedef const char *(*text)(void);
  printf("%s\n", AS(text, "GetVersion")());
  while (fgets(line, sizeof line, stdin) != NULL) {
    char verb[16];
    int i, at = 0, status = 0;
    if (sscanf(line, "%15s %d%n", verb, &i, &at) != 2)
      return 2;
    message[0] = '\0';
    if (strcmp(verb, "get") == 0) {
      char *next = line + at, *end;
      for (;;) {
        const unsigned vr = (unsigned)strtoul(next, &end, 10);
        double value = 0;
        if (end == next)
          break;
        status = status != 0 ? status : get(instance[i % MANY], vr, &value);
        printf("%a ", value);
        next = end;
      }
    } else {
      status = perform(verb, i % MANY, line + at);
    }
    printf("%d%s%s\n", status, message[0] != '\0' ? " # " : "", message);
  }
  return dlclose(library) != 0;
}
