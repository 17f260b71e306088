-- zephyr.lua -- a module of Zephyr, with a sample.
-- SPDX-License-Identifier: GPL-3.0-or-later

local library = require "generator.emit.packages.library"

return library.package {
  real = "float", -- what the cores of its boards compute in; --real double for those that have more
  where = { header = "include", source = "src", test = "extras" },
  files = { { "zephyr_module.yml", "zephyr/module.yml" }, { "zephyr_kconfig.txt", "zephyr/Kconfig" },
    { "zephyr_cmake.txt", "zephyr/CMakeLists.txt" }, { "zephyr_sample_cmake.txt", "samples/motion/CMakeLists.txt" },
    { "zephyr_sample.yaml", "samples/motion/sample.yaml" }, { "zephyr_prj.conf", "samples/motion/prj.conf" },
    { "zephyr_main.c", "samples/motion/src/main.c" } },
  about = { { "zephyr", "the module: module.yml, Kconfig (CONFIG_POLHODE_UPPER), CMakeLists.txt" },
    { "samples/motion", "an application that prints the motion in millionths" } },
  use = {
    "In a workspace of Zephyr: `west build -b BOARD /path/to/this/folder/samples/motion`. In an application of your",
    "own: this folder in `ZEPHYR_EXTRA_MODULES`, `CONFIG_POLHODE_UPPER=y` in prj.conf, `#include <NAME.h>`.",
  },
}
