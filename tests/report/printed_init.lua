-- printed_init.lua - what NAME_init computes, for printed.t: the emitted files of a scene, compiled.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     require "tests.report.printed_init" (s)
-- s: {name, files = {name -> text}, params = names, points = list of {values = {parameter = number}}} of a scene; sets
-- s.made, a list of {constant = number} for the points, and returns whether it could.

local program = require "tests.cli.program"

local dir = program.directory()

local MAIN = [[
#include "%s.h"
#include <stdio.h>
int main(void)
{
  %s_model m;
%s  return 0;
}
]]

return function(s)
  local members, calls = {}, {}
  local struct = s.files[s.name .. ".h"]:match("typedef struct " .. s.name .. "_model {(.-)\n} ")
  for name in struct:gmatch "_real ([%w_]+);" do members[#members + 1] = name end
  for n, p in ipairs(s.points) do
    local list, at = {}, {}
    for i, name in ipairs(s.params) do list[i] = string.format("%a", p.values[name]) end
    for i, name in ipairs(members) do at[i] = string.format("  printf(\"%%a\\n\", m.%s);\n", name) end
    local init = #list == 0 and "NULL" or "p" .. n
    calls[n] = (#list == 0 and "" or string.format("  const double p%d[] = { %s };\n", n, table.concat(list, ", "))) ..
      string.format("  if (%s_init(&m, %s) != 0) printf(\"refused\\n\");\n  else {\n%s  }\n", s.name, init,
        table.concat(at))
  end
  local own = dir .. "/" .. s.name .. ".d"
  program.shell("mkdir -p " .. own)
  local units = {}
  for _, name in ipairs(s.files) do
    program.write(own .. "/" .. name, s.files[name])
    local unit = name:find "%.c$" and not name:find "_test%.c$" and not name:find "^qemu"
    if unit then units[#units + 1] = own .. "/" .. name end
  end
  program.write(own .. "/main.c", MAIN:format(s.name, s.name, table.concat(calls)))
  local status = program.shell(string.format("%s sh -c '$CC -w -o %s/run %s/main.c %s -lm && %s/run >%s/out'",
    program.quick_compiler(), own, own, table.concat(units, " "), own, own))
  s.made = {}
  if status ~= 0 then return false end
  local next_line = program.read(own .. "/out"):gmatch "[^\n]+"
  for n = 1, #s.points do
    s.made[n] = {}
    for _, name in ipairs(members) do
      local said = next_line()
      if said == "refused" then break end -- no body, as the library need not find: by the triangle inequality
      s.made[n][name] = tonumber(said)
    end
  end
  return true
end
