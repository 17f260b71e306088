-- arduino.lua -- a library of the Arduino IDE (layout 1.5), in float: on AVR boards a double is a float.
-- SPDX-License-Identifier: GPL-3.0-or-later

local library = require "generator.emit.packages.library"

local function check(job)
  if job.real ~= "float" then
    job.diag:error(job.record.line, "project arduino",
      "must be in float: the library is for all boards, and a double has 32 bits on some", "--real " .. job.real)
    return false
  elseif #job.model.name > 63 then
    job.diag:error(job.record.line, "project arduino", "a library's name has at most 63 characters", job.model.name)
    return false
  end
  return true
end

return library.package {
  real = "float", check = check,
  where = { header = "src", source = "src", test = "extras" },
  files = { { "arduino.properties", "library.properties" }, { "arduino_keywords.txt", "keywords.txt" },
    { "arduino.ino", "examples/NAME_motion/NAME_motion.ino" } },
  once = { ["arduino.properties"] = true },
  about = { { "library.properties, keywords.txt", "what the IDE wants to know" },
    { "examples/NAME_motion", "prints the motion over the serial line" } },
  use = {
    "Put this folder into the sketchbook's `libraries`, then `#include <NAME.h>`. The example is under File, Examples.",
    "Everything is in float. Before you publish it fill in `author`, `maintainer` and `url` of library.properties.",
    "A library cannot give options to the compiler. On boards that fuse products into sums (not AVR, not Cortex-M0)",
    "`compiler.c.extra_flags=-ffp-contract=off` in the board's platform.local.txt does, else last bits differ and some",
    "functions lose digits.",
  },
}
