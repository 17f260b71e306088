-- report.lua - how much of generator and src the tests run: docs/coverage.md, and the floor.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     lua5.4 tests/coverage/report.lua BUILD PAGE FLOOR
--
-- BUILD has gcc's notes and counts, and in BUILD/lines what hook.c wrote.  Exit status 1 when the lines of generator
-- or those of src that ran are fewer than FLOOR percent.

package.path = "./?.lua;" .. package.path

local lines = require "tests.coverage.lines"

local build, page, floor = arg[1], arg[2], tonumber(arg[3])

local function list(command)
  local out = {}
  local pipe = assert(io.popen(command .. " | LC_ALL=C sort"))
  for name in pipe:lines() do out[#out + 1] = name end
  assert(pipe:close())
  return out
end

local scripts = list "find generator src -name '*.lua'"
local seen = lines.lua(scripts, build .. "/lines")
for path, of in pairs(lines.c(list("find " .. build .. " -name '*.gcno'"))) do -- any order
  seen[path] = of
end

-- "3-5, 9": the lines that did not run; those between two of them that cannot run do not part them.
local function missing(of)
  local out, from, to, last = {}, nil, nil, 0
  for line in pairs(of) do last = math.max(last, line) end -- any order
  for line = 1, last + 1 do
    if of[line] == false then
      from, to = from or line, line
    elseif from and (of[line] or line > last) then
      out[#out + 1] = from == to and tostring(from) or from .. "-" .. to
      from = nil
    end
  end
  return table.concat(out, ", ")
end

-- Rounded down: 94.99 is not 95.0.
local function percent(sum)
  return string.format("%.1f", sum.ran * 1000 // sum.all / 10)
end

local sums, files = {}, {}
local function add(name, ran, all)
  local sum = sums[name] or { name = name, ran = 0, all = 0, files = 0 }
  sums[name] = sum
  sum.ran, sum.all, sum.files = sum.ran + ran, sum.all + all, sum.files + 1
end

for path, of in pairs(seen) do -- sorted below
  local ran, all = 0, 0
  for _, hit in pairs(of) do -- a sum: any order
    ran, all = ran + (hit and 1 or 0), all + 1
  end
  files[#files + 1] = { path = path, ran = ran, all = all, of = of }
  local folder = path:match "^(.*)/"
  local root = path:match "^%w+"
  add(root, ran, all)
  if folder ~= root then add(folder, ran, all) end
end
table.sort(files, function(a, b) return a.path < b.path end)

local names = {}
for name in pairs(sums) do names[#names + 1] = name end -- sorted below
table.sort(names)

local out = { [[
# Coverage

`make coverage` writes this page. It runs the tests of `tests/coverage/tests.txt` and of `tests/runtime` on a
program that is built for it. It fails if less than ]] .. arg[3] .. [[ % of the lines of `generator` or of `src` ran.
The whole suite has more tests.

All lines of both folders that can run are counted. For C, gcov counts them in a build without optimisation. In
Lua, a line counts if `luac` has an instruction for it in any function, called or not. It ran if a line hook saw
it, in the program or in a module of a test under plain `lua5.4`. The return that Lua puts on the line of each
function's `end` does not count. The page does not say how often a line ran, nor whether both ways of a
condition on one line ran. It does not cover generated C, which has its own tests, nor calls of SUNDIALS if that
is not installed.

| folder | files | lines | ran | % |
|---|---:|---:|---:|---:|]] }
local screen = {}
for _, name in ipairs(names) do
  local sum = sums[name]
  local row = name:find "/" and "| %s | %d | %d | %d | %s |" or "| **%s**, with its folders | %d | %d | %d | **%s** |"
  out[#out + 1] = string.format(row, name, sum.files, sum.all, sum.ran, percent(sum))
  screen[#screen + 1] = string.format("%-28s %4d files %6d lines %6d ran %6s %%", name, sum.files, sum.all, sum.ran,
    percent(sum))
end

out[#out + 1] = "\nFiles below the floor, and their lines that no test of the list runs:\n\n" ..
  "| file | % | lines |\n|---|---:|---|"
for _, file in ipairs(files) do
  if file.ran * 100 < floor * file.all then
    local what = missing(file.of)
    out[#out + 1] = string.format("| %s | %s | %s |", file.path, percent(file), what)
    screen[#screen + 1] = string.format("  %-42s %5s %%  %s", file.path, percent(file), what)
  end
end

print(table.concat(screen, "\n"))
local handle = assert(io.open(page, "wb"))
assert(handle:write(table.concat(out, "\n"), "\n"))
assert(handle:close())

local low = {}
for _, root in ipairs { "generator", "src" } do
  if sums[root].ran * 100 < floor * sums[root].all then
    low[#low + 1] = root .. " " .. percent(sums[root]) .. " %"
  end
end
if #low > 0 then
  io.stderr:write("coverage: below ", arg[3], " %: ", table.concat(low, ", "), "\n")
  os.exit(1)
end
