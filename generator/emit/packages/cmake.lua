-- cmake.lua -- a library for CMake: target NAME::NAME, tests by ctest, installed with what find_package wants.
-- SPDX-License-Identifier: GPL-3.0-or-later

local library = require "generator.emit.packages.library"

local reserved = {} -- CMake's own targets (policy CMP0037)
for word in string.gmatch([[all ALL_BUILD help install INSTALL preinstall clean edit_cache rebuild_cache ZERO_CHECK
  test RUN_TESTS package PACKAGE package_source]], "%S+") do
  reserved[word] = true
end

local function check(job)
  if reserved[job.model.name] then
    job.diag:error(job.record.line, "project cmake", "the scene must not be named like a target of CMake's own",
      job.model.name)
    return false
  end
  return true
end

return library.package {
  check = check,
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
    "Options: `BUILD_SHARED_LIBS`; `UPPER_TESTS` (on when this is the whole project, and not cross-compiled);",
    "`UPPER_GC_SECTIONS` (on: a program that links the library drops the functions that it does not call, by",
    "`-Wl,--gc-sections`; off: the program's own linker options decide).",
    "For another processor: `-DCMAKE_TOOLCHAIN_FILE=...`, as always.",
  },
}
