/* named.c - all effects: the files of effects/, as the build has found them.
   SPDX-License-Identifier: GPL-3.0-or-later */
#include "effects/effect.h"

#include <string.h>

/* build/effects.h, by the Makefile: a line EFFECT(NAME) for each file, in the order of names. */
#define EFFECT(name) extern const effect_table effect_##name;
#include "effects.h"
#undef EFFECT

#define EFFECT(name) &effect_##name,
const effect_table *const effect_all[] = {
#include "effects.h"
    NULL};

const effect_table *effect_named(const char *name) {
  const effect_table *const *effect = effect_all;
  while (*effect && strcmp((*effect)->name, name) != 0)
    effect++;
  return *effect;
}
