-- plan.lua -- the tables of docs/planner.md: accuracy asked for and got, and what it costs beside the best of a sweep.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     lua5.4 tests/bench/plan.lua [PAGE]
-- prints the tables, and puts them between the two marks of the page.  The work is done by tests/plan/promise.lua.

package.path = "./?.lua;" .. package.path

local lua = require "tests.plan.tree"
local program = require "tests.cli.program"

local page = arg[1]
local scenes = { "tumbling_box", "tennis_racket", "nodding_top", "damped_brick", "gravity_gradient", "gyrostat" }
local accuracies = { "1e-3", "1e-5", "1e-7", "1e-9", "1e-11" }
local sets = { { "All methods", "-", { "1e-3", "1e-11" } },
  { "Closed forms forbidden (`--method` names the others)", "taylor,rk4,adaptive,split2,split4,split6,midpoint,semi",
    accuracies } }

local text = program.read "tests/plan/promise.lua"
local out = {}
for _, set in ipairs(sets) do
  out[#out + 1] = set[1] .. ":\n"
  out[#out + 1] = "| scene | asked | got | plan | cycles | over the sweep's best |"
  out[#out + 1] = "|---|---|---|---|---|---|"
  for _, scene in ipairs(scenes) do
    local result, failure = lua(text, nil, "bodies/" .. scene .. ".lua", "double", set[2], "100",
      table.unpack(set[3]))
    if failure ~= "" then io.stderr:write(failure) end
    for line in result:gmatch "[^\n]+" do
      local asked, got, cost, ratio, _, name = line:match "^(%S+) (%S+) (%S+) (%S+) (%S+) (.*)$"
      if cost then
        out[#out + 1] = string.format("| %s | %s | %s%s | %s | %s | %.2f |", scene, asked, got,
          tonumber(got) <= tonumber(asked) and "" or " **missed**", name, cost, tonumber(ratio))
      else
        out[#out + 1] = string.format("| %s | %s | refused | | | |", scene, line:match "^%S+")
      end
    end
  end
  out[#out + 1] = ""
end
program.finish()

local tables = table.concat(out, "\n")
io.stdout:write(tables)
if page then
  local before, after = assert(program.read(page)):match "^(.-<!%-%- plan %-%->\n).-(\n<!%-%- end of plan %-%->.*)$"
  assert(before, "the page has no marks")
  program.write(page, before .. "\n" .. tables .. after)
end
