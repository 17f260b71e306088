-- worker.lua -- runs files of cases inside the program and prints what they measure, a line each.
--
--     polhode worker.lua SPEED PATTERN FILE...     (through run.lua; SPEED: fast or all)
--
-- Lines, separated by tabs: `case FILE NAME`, `row WHO REAL ERROR BOUND`, `naive ERROR`, `broken MESSAGE`, `end`.
-- SPDX-License-Identifier: GPL-3.0-or-later

local host, args = ...
local kit = require "generator.hard.kit" (host)

local function line(...) host.out(table.concat({ ... }, "\t") .. "\n") end
local function text(x) return string.format("%.17g", x) end

local speed, pattern = args[1], args[2]
for i = 3, #args do
  local file = require("generator.hard.cases." .. args[i])(kit)
  for _, case in ipairs(file.cases) do
    if (speed == "all" or case.fast) and string.find(case.name, pattern) then
      line("case", args[i], case.name)
      local row = {}
      function row.naive(error) line("naive", text(error)) end
      setmetatable(row, { __call = function(_, who, real, error, bound) line("row", who, real, text(error), text(bound))
      end })
      local fine, why = pcall(case.run, row)
      if not fine then line("broken", (string.gsub(tostring(why), "%s+", " "))) end
      line("end")
    end
  end
end
