-- compiled.lua: compiles printed programs with gcc and returns what they compute.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- One C file for all programs, warnings are errors, no contraction of a*b + c into one rounding.
-- Results come back as C99 hexadecimal numbers, hence to the bit.

local compiled = {}

local FLAGS = "-std=c99 -O2 -ffp-contract=off -Wall -Wextra -Wconversion -Wfloat-conversion "
  .. "-Wdouble-promotion -Wno-unused-variable -Werror"

-- Compiles and runs the C text; returns the numbers it prints.
function compiled.numbers(source)
  local base = os.tmpname()
  local file = assert(io.open(base .. ".c", "w"))
  file:write(source)
  file:close()
  local command = string.format("gcc %s -o %s.out %s.c -lm 2>&1 && %s.out", FLAGS, base, base, base)
  local pipe = assert(io.popen(command))
  local text = pipe:read("a")
  local fine = pipe:close()
  os.remove(base)
  os.remove(base .. ".c")
  os.remove(base .. ".out")
  if not fine then error("compiled: " .. string.sub(text, 1, 4000)) end
  local values = {}
  local odd = { nan = 0.0 / 0.0, ["-nan"] = 0.0 / 0.0, inf = math.huge, ["-inf"] = -math.huge }
  for word in string.gmatch(text, "%S+") do values[#values + 1] = odd[word] or tonumber(word) end
  return values
end

-- programs: { text = statements, outs = number of results, points = { env } }.  inputs: the symbols behind
-- in[0], in[1] ...  Returns the results of all programs at all their points, in order.
function compiled.run(programs, real, inputs)
  local lines = { "#include <math.h>", "#include <stdio.h>", "typedef " .. real .. " real;" }
  local function line(...) lines[#lines + 1] = string.format(...) end
  for k, p in ipairs(programs) do
    line("static void p%d(const real in[], real out[])", k)
    line("{")
    line("  (void)in;")
    for _, text in ipairs(p.text.loads) do line("  %s", text) end
    for _, group in ipairs(p.text.groups) do
      for _, text in ipairs(group.lines) do line("  %s", text) end
    end
    line("}")
  end
  line("static const struct { void (*f)(const real[], real[]); int outs; real in[%d]; } run[] = {", #inputs)
  local runs = 0
  for k, p in ipairs(programs) do
    for _, point in ipairs(p.points) do
      local values = {}
      for i = 1, #inputs do values[i] = string.format("(real)%a", point[inputs[i]]) end
      line("  { p%d, %d, { %s } },", k, p.outs, table.concat(values, ", "))
      runs = runs + 1
    end
  end
  line("};")
  line("int main(void)")
  line("{")
  line("  real out[16];")
  line("  int i, j;")
  line("  for (i = 0; i < %d; i++) {", runs)
  line("    run[i].f(run[i].in, out);")
  line("    for (j = 0; j < run[i].outs; j++) printf(\"%%a\\n\", (double)out[j]);")
  line("  }")
  line("  return 0;")
  line("}")
  return compiled.numbers(table.concat(lines, "\n") .. "\n")
end

return compiled
