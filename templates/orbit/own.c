%% -- own.c -- the orbit of the scene's own initial state: part of scene.c.  SPDX-License-Identifier: MIT-0
/* Rounded from ${own_bits} bits.  Without a call of ${name}_solve a linker that drops what is not called
 * (-ffunction-sections, --gc-sections) leaves its set-up out. */
const ${name}_orbit ${name}_own_orbit = {
%% for _, line in ipairs(own_lines) do
  ${line}
%% end
};
