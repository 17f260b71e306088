/* init.c - fuzz target: emitted code with arbitrary bits in every argument.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The first byte chooses a scene and a type (init_scene.c is compiled for each); FUZZ_SCENES lists
 * them as X(name).
 */
#include "init.h"

#define X(name) init_case fuzz_case_##name;
FUZZ_SCENES
#undef X

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static init_case *const list[] = {
#define X(name) fuzz_case_##name,
      FUZZ_SCENES
#undef X
  };
  struct bytes b = {data, size};
  const unsigned which = bytes_take(&b);
  list[which % (sizeof list / sizeof list[0])](&b);
  return 0;
}
