-- platformio.lua -- a library of PlatformIO, for all its frameworks and platforms.
-- SPDX-License-Identifier: GPL-3.0-or-later

local library = require "generator.emit.packages.library"

return library.package {
  real = "float", -- what the cores of its boards compute in; --real double for those that have more
  where = { header = "include", source = "src", test = "extras" },
  files = { { "platformio.json", "library.json" }, { "platformio.ini", "examples/motion/platformio.ini" },
    { "motion.c", "examples/motion/src/main.c" } },
  about = { { "library.json", "PlatformIO's manifest: any framework, any platform" },
    { "examples/motion", "prints the motion; `pio run -t exec` in it (platform native)" } },
  use = {
    "In a project's platformio.ini: `lib_deps = symlink:///path/to/this/folder`, or put the folder into its `lib`;",
    "then `#include <NAME.h>`.",
  },
}
