-- cmake.lua -- a library for CMake: target NAME::NAME, tests by ctest, installed with what find_package wants.
-- SPDX-License-Identifier: GPL-3.0-or-later

local library = require "generator.emit.packages.library"

return library.package {
  where = { header = "include", source = "src", test = "tests" },
  files = { { "cmake.txt", "CMakeLists.txt" } },
  about = { { "CMakeLists.txt", "library NAME::NAME, self-test, installation; C99, CMake 3.13 or later" } },
  use = {
    "    cmake -B build -DCMAKE_BUILD_TYPE=Release && cmake --build build",
    "    (cd build && ctest)                              # the self-test",
    "    cmake --install build --prefix /usr/local        # CMake 3.15; before: cmake --build build --target install",
    "",
    "In a project: `find_package(NAME)` or `add_subdirectory(NAME)`, then",
    "`target_link_libraries(app PRIVATE NAME::NAME)`.",
    "Options: `BUILD_SHARED_LIBS`, `UPPER_TESTS` (on when this is the whole project).",
  },
}
