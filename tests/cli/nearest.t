#!/usr/bin/env lua5.4
-- nearest.t: which word of a list is offered for a mistyped one, against distances counted by hand.
-- SPDX-License-Identifier: GPL-3.0-or-later

local tap = require "tests.tap"
local nearest = require "generator.nearest"

for _, case in ipairs {
  { "explian", { "gen", "explain", "run" }, "explain", "two neighbours exchanged" },
  { "gn", { "run", "gen" }, "gen", "a letter missing of three" },
  { "genn", { "run", "gen" }, "gen", "a letter too many" },
  { "gin", { "run", "gen" }, "gen", "another letter" },
  { "xyz", { "run", "gen" }, nil, "three slips of three letters" },
  { "rn", { "run", "ran" }, "run", "of equals the first" },
  { "rn", { "ran", "run" }, "ran", "of equals the first, the other way" },
  { "tailor", { "rk4", "taylor", "sailor" }, "taylor", "one slip each: the first" },
  { "adaptve", { "adaptation", "adaptive" }, "adaptive", "fewer slips before the first" },
  { "--fromat", { "--over", "--format" }, "--format", "an option" },
  { "abcdef", { "abcdxy" }, "abcdxy", "two slips of six letters" },
  { "abcdef", { "abcxyz" }, nil, "three slips of six letters" },
  { "abcde", { "abcxy" }, nil, "two slips of five letters" },
  { "xy", { "xz" }, "xz", "of two letters the second may be another" },
  { "xy", { "zy" }, nil, "not the first" },
  { "abcd", { "abcdef" }, "abcdef", "the length is that of the longer one" },
  { "TW", { "tw" }, "tw", "capitals do not count" },
  { "y", { "x" }, nil, "a letter is no third of itself" },
  { "", { "gen" }, nil, "nothing is near nothing" },
  { "gen", {}, nil, "an empty list" },
  { string.rep("a", 65), { string.rep("a", 65) }, nil, "what is longer than 64 letters is not looked at" },
} do
  tap.is(nearest.one(case[1], case[2]), case[3], "nearest: " .. case[4])
end

for _, case in ipairs {
  { "rn", { "ran", "gen", "run" }, 3, "ran run", "all that are near, in their order" },
  { "pairs", { "ipairs", "pears", "repairs", "pairs" }, 3, "pairs", "the word itself is the nearest" },
  { "Taylor", { "tailor", "taylor", "sailor" }, 3, "taylor", "other capitals are half a slip: nothing else was meant" },
  { "wheal", { "w", "wheel", "wheels", "heal" }, 2, "wheel heal", "at most so many, nearest first" },
  { "Cd", { "Cw", "ad", "c" }, 3, "Cw", "of two letters the second may be another" },
  { "wheel", { "wheel2", "wheel2", "wheel1" }, 3, "wheel2 wheel1", "each once" },
} do
  tap.is(table.concat(nearest.of(case[1], case[2], case[3]), " "), case[4], "the nearest: " .. case[5])
end

tap.done()
