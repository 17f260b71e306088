#!/usr/bin/env lua5.4
-- layout.t - gen writes what is called for: --only, --layout, --list, --with analysis, and no line beyond 100 columns.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Each function that --list names is emitted alone: it compiles without a warning, its object defines nothing else that
-- others could call (but the set-up that fills the model), and its self-test passes, by make without rules of its own
-- (-r), which the emitted Makefile gets from one that calls it.  Whatever the layout, the states
-- have the same bits.  The quick tier asks for every twelfth function, and for three bodies' lines.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"
local STRICT = "-std=c99 -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror -ffp-contract=off"

local function shell(...)
  return program.output(string.format("{ %s; }", string.format(...)))
end

local function lines(text)
  local out = {}
  for line in text:gmatch "[^\n]+" do out[#out + 1] = line end
  return out
end

-- ---- one function alone ----

local function alone(body, real, name)
  local at = string.format("%s/%s_%s", dir, body, name)
  local status, _, err = shell("%s gen bodies/%s.lua --real %s --only %s -o %s", binary, body, real, name, at)
  local why = status ~= 0 and err
  if not why then
    status, _, err = shell("cd %s && make -rs CC=gcc CFLAGS='-O1 -Werror' check && for f in %s*.c; do case $f in " ..
      "*_test.c) ;; *) clang %s -c -o $f.o $f || exit 1;; esac; done && nm --defined-only -g *.c.o", at, body, STRICT)
    why = status ~= 0 and err .. program.read(dir .. "/stdout")
  end
  if not why then
    for symbol in program.read(dir .. "/stdout"):gmatch "%x+ [TDBR] ([%w_]+)" do
      local own = symbol:sub(#body + 2)
      if own ~= name and own ~= "init" and own ~= "defaults" then why = "it defines " .. symbol end
    end
  end
  tap.ok(not why, string.format("%s, %s: %s alone", body, real, name), why)
end

for _, row in ipairs { { "brick_centroid", "double" }, { "heavy_top", "float" }, { "wheels", "double" },
  { "foucault", "float" } } do
  local body, real = row[1], row[2]
  local status, text, err = shell("%s gen bodies/%s.lua --list", binary, body)
  local list = lines(text)
  tap.ok(status == 0 and err == "" and #list > 12 and list[1]:find "^function +file +lines +operations +calls$",
    body .. ": --list names " .. #list - 1 .. " functions", text .. err)
  local names = {}
  for i = 2, #list do names[i - 1] = list[i]:match "^[%w_]+" end
  for _, name in ipairs(tier.every(12, names)) do alone(body, real, name) end
end

-- ---- the same bits in every layout ----

program.write(dir .. "/main.c", [[
#include <stdio.h>
int main(void)
{
  brick_centroid_model m;
  brick_centroid_real x[BRICK_CENTROID_NX], moments[3], axes[9];
  brick_centroid_orbit o;
  int i;
  if (brick_centroid_init(&m, 0)) return 1;
  brick_centroid_initial(&m, x);
  for (i = 0; i < 1000; i++) brick_centroid_step(&m, 0, x, 0, 0.01);
  for (i = 0; i < BRICK_CENTROID_NX; i++) printf("%a ", x[i]);
  if (brick_centroid_solve(&o, &m, x) || brick_centroid_principal(&m, moments, axes)) return 1;
  brick_centroid_at(&o, 123.5, x);
  for (i = 0; i < BRICK_CENTROID_NX; i++) printf("%a ", x[i]);
  printf("%a %a\n", moments[0], axes[4]);
  return 0;
}
]])
local first
for _, way in ipairs { "split", "single", "header" } do
  local at = dir .. "/" .. way
  local status, out, err = shell("%s gen bodies/brick_centroid.lua --with analysis --layout %s -o %s && cd %s && " ..
    "{ %s for h in $(ls *.h | grep -v private); do echo \"#include \\\"$h\\\"\"; done; cat ../main.c; } >main.c && " ..
    "gcc %s -O2 -o main $(ls *.c | grep -v -e _test -e qemu) -lm && ./main && ls *.c *.h | wc -l", binary, way, at, at,
    way == "header" and "echo '#define BRICK_CENTROID_IMPLEMENTATION';" or "", STRICT)
  local state = out:match "^[^\n]*"
  first = first or state
  tap.ok(status == 0 and state == first and #state > 200, way .. ": the same bits", out .. err)
end
tap.is(select(2, shell("cd %s/header && ls *.h | grep -c . && ls brick_centroid*.c", dir)),
  "1\nbrick_centroid_test.c\n", "header: one file of code")

-- ---- what it holds ----

local function gen(options)
  program.shell("rm -rf " .. dir .. "/o")
  local status, _, err = shell("%s gen %s -o %s/o", binary, options, dir)
  return status, err
end
gen "bodies/brick_centroid.lua --method rk4"
local source = program.read(dir .. "/o/brick_centroid.c")
tap.ok(#lines(source) <= 300, "rk4 of a free box: at most 300 lines", tostring(#lines(source)))
tap.ok(not source:find "_principal%(" and not source:find "pair", "and nothing of the analysis")
gen "bodies/brick_centroid.lua"
local orbit = program.read(dir .. "/o/brick_centroid_orbit.c")
local length = select(2, orbit:gsub("\n", ""))
tap.ok(length <= 900, "closed form of a free box: at most 900 lines, the plan's bar", tostring(length))
source = program.read(dir .. "/o/brick_centroid.c")
local common = program.read(dir .. "/o/brick_centroid_private.h")
tap.ok(common:find "pair_log%(" and not common:find "inline pair pair_log" and not source:find "_private",
  "what is equal for every body stands apart, and is inline only where several sources read it")
-- Of functions that two bodies have in common the texts are the same.
gen "bodies/heavy_top.lua"
local other, same, differ = program.read(dir .. "/o/heavy_top_private.h"), 0, {}
for head, body in other:gmatch "\n(static [^\n]*)\n(%b{})" do
  if common:find("\n" .. head .. "\n", 1, true) then
    same = same + 1
    if not common:find("\n" .. head .. "\n" .. body .. "\n", 1, true) then differ[#differ + 1] = head end
  end
end
tap.ok(same >= 12 and #differ == 0, same .. " functions that two bodies share are the same",
  table.concat(differ, "; "))
gen "bodies/brick_centroid.lua"
tap.ok(not orbit:find "a rod",
  "what positive moments exclude is not there: a rod")
local public = {}
for name in program.read(dir .. "/o/brick_centroid_orbit.h"):gmatch "%f[%w]brick_centroid_([%w_]+)%(" do
  public[#public + 1] = name
end
tap.is(table.concat(public, " "), "solve at", "by default it has the set-up and the state at a time")
tap.ok(not orbit:find "jacobi%(" and not orbit:find "uint64_t rate_tick", "no eigen-solver, nothing for ticks")
gen "bodies/brick_centroid.lua --with orbit"
tap.ok(program.read(dir .. "/o/brick_centroid_orbit.h"):find "brick_centroid_next_flip%(", "--with orbit: all of it")
gen "bodies/brick_centroid.lua --only init,initial,step --method rk4"
local model = program.read(dir .. "/o/brick_centroid.h"):match "typedef struct brick_centroid_model {(.-)\n}"
local members = {}
for name in model:gmatch "_real ([%w_]+);" do members[#members + 1] = name end
tap.is(table.concat(members, " "), "c1_twice c1_fourtimes c2_twice c2_fourtimes c3_twice c3_fourtimes",
  "--only: the model has the constants that these functions read")
tap.ok(not program.read(dir .. "/o/brick_centroid.c"):find "defaults", "and nothing that fills in parameters alone")
for _, real in ipairs { "double", "float" } do
  gen("bodies/brick_centroid.lua --only step --bake --real " .. real)
  local count = select(2, program.read(dir .. "/o/brick_centroid.c"):gsub("\n", ""))
  tap.ok(count <= (real == "float" and 190 or 150), "--only step --bake, " .. real .. ": " .. count .. " lines")
end
-- the page's table of these numbers
do
  local page, wrong = program.read "docs/emitted.md", {}
  for _, row in ipairs { { "`brick_centroid.c` with `--method rk4`", "--method rk4", ".c" },
    { "`--only step --bake`", "--only step --bake", ".c" },
    { "the closed form, `brick_centroid_orbit.c`", "", "_orbit.c" },
    { "the closed form `--with orbit`", "--with orbit", "_orbit.c" },
    { "the arithmetic that it needs, `brick_centroid_private.h`", "", "_private.h" },
    { "all of it, `--layout single --with analysis,orbit`", "--layout single --with analysis,orbit", ".c" } } do
    gen("bodies/brick_centroid.lua " .. row[2])
    local count = select(2, program.read(dir .. "/o/brick_centroid" .. row[3]):gsub("\n", ""))
    if not page:find("| " .. row[1] .. " | " .. count .. " |", 1, true) then
      wrong[#wrong + 1] = row[1] .. ": " .. count
    end
  end
  tap.is(table.concat(wrong, "; "), "", "docs/emitted.md says how many lines there are")
end
for _, row in ipairs {
  { "bodies/brick.lua --only stp", "--only: the scene has no function stp; did you mean step? (it has init, " },
  { "bodies/brick.lua --only step --project firmware", "--only: the project's own files decide what they call" },
  { "bodies/brick.lua --layout header --project fmu", "--layout: the project's own files decide what they call" },
  { "bodies/brick.lua --only step,energy,step", "--only: step is given twice" },
  { "bodies/brick.lua --only step --with analysis", "--with analysis: --only names the functions" },
  { "bodies/brick.lua --only step --with orbit", "--with orbit: --only names the functions" },
  { "bodies/brick.lua --method rk4 --with orbit", "--with orbit: of the methods exact alone has one, got --method" },
  { "bodies/brick.lua --only step --with jacobians", "--with jacobians: --only names none of its functions" },
  { "bodies/brick.lua --only step --with compensated", "--with compensated: --only names none of its functions" },
  { "bodies/brick.lua --with analysis --project fmu", "--with analysis: the project's own files decide" },
  { "bodies/spinner.lua --with proof --layout split", "--layout: the proof is of one file, got --layout split" },
} do
  local status, err = gen(row[1])
  tap.ok(status == 2 and err:find("polhode gen: " .. row[2], 1, true) and err:find "^[^\n]*\n$", "gen " .. row[1], err)
end
for _, row in ipairs { { "--list --only step", "--only" }, { "--list --show cse", "--list" },
  { "--list --with analysis", "--with analysis" }, { "--list --with orbit", "--with orbit" } } do
  local status, _, err = shell("%s gen bodies/brick.lua %s", binary, row[1])
  tap.ok(status == 2 and err:find("polhode gen: " .. row[2] .. ": ", 1, true), "gen " .. row[1] .. " is refused", err)
end

-- What float cannot hold is told by every door in the same words.
for _, command in ipairs { "gen -o " .. dir .. "/o", "gen --list", "explain" } do
  local status, _, err = shell("%s %s bodies/water.lua --real float", binary, command)
  tap.ok(status == 1 and err:find("bodies/water.lua:5: real float: every constant must be within its range, got ", 1,
    true) == 1, command:match "^[^/]*" .. " of a scene that float cannot hold is refused at the scene's line", err)
end

do
  local status, _, err = shell("%s gen bodies/wheels.lua --with orbit -o %s/o", binary, dir)
  tap.ok(status == 0 and err:find("with orbit: this scene has no closed form: ", 1, true), "--with orbit warns", err)
end

-- ---- what several files read ----

for _, row in ipairs { { "brick_centroid", "--real float" }, { "heavy_top", "--only principal_of,solve" },
  { "turntable_ball", "--with analysis --real float" } } do
  gen("bodies/" .. row[1] .. ".lua " .. row[2])
  local status, _, err = shell("cd %s/o && grep -q inline %s_private.h && for f in %s_*.c; do gcc %s -fsyntax-only " ..
    "$f && clang %s -fsyntax-only $f && g++ -Wall -Wextra -Werror -fsyntax-only -x c++ $f || exit 1; done", dir, row[1],
    row[1], STRICT, STRICT)
  tap.ok(status == 0, row[1] .. " " .. row[2] .. ": gcc, clang and g++ have nothing to say", err)
end

-- ---- names of the scene that are names of the code, too ----

program.write(dir .. "/clash.lua", [[
local real, pair = param("real", 0.3, "m"), param("pair", 0.2, "m")
local overflows, state = param("overflows", 0.1, "m"), param("state", 2, "kg")
return scene { name = "clash", body = solid.box { x = real, y = pair, z = overflows, mass = state },
  initial = { omega = {0.1, 6, 0.2} } }
]])
for _, layout in ipairs { "split", "header" } do
  gen(string.format("%s/clash.lua --with analysis --layout %s", dir, layout))
  local status, _, err = shell("make -rs -C %s/o CC=gcc CFLAGS='-O1 -Werror' check", dir)
  tap.ok(status == 0, "parameters real, pair, overflows, state: " .. layout, err)
end

-- the sine's own names begin with the scene's: s_odd
program.write(dir .. "/s.lua", [[
return scene { name = "s", body = solid.box { x = 1, y = 2, z = 3, mass = 1 },
  effects = { effect.torque { body = { quantity(1, "N m")*sin(t*quantity(1, "rad/s")), 0, 0 } } } }
]])
do
  local status, err = gen(dir .. "/s.lua --libm own --layout single")
  tap.ok(status == 0, "a scene may be called s", err)
end

-- ---- lines ----

local LIBRARY = {} -- the own mathematical functions keep it: these names are taken
for word in ("sin cos tan asin acos atan atan2 sinh cosh tanh exp log pow sqrt cbrt floor frexp ldexp fabs copysign")
  :gmatch "%a+%d?" do
  LIBRARY[word] = true
end
local _, bodies = shell "ls bodies/*.lua"
for _, body in ipairs(tier.every(14, lines(bodies))) do
  local real = body:find "water" and "double" or "float" -- water's constants leave the range of float
  local status, err = gen(body .. " --with analysis --real " .. real)
  local long = {}
  local _, text = shell("cat %s/o/*.c %s/o/*.h", dir, dir)
  local name, prefixed = body:match "([%w_]+)%.lua$", {}
  for line in text:gmatch "\n(static [^\n]*)" do
    local own = line:match "^[^(={]*":match("%f[%w_]" .. name .. "_([%w_]+) *$")
    if own and not LIBRARY[own] then prefixed[#prefixed + 1] = line end
  end
  tap.ok(#prefixed == 0, body .. ": what is static has no prefix", table.concat(prefixed, "\n"))
  for _, line in ipairs(lines(text)) do
    local plain = line:gsub('"[^"]*"', ""):gsub("%d+", "") -- strings and numbers are not broken
    if #line > 100 and #plain > 100 then long[#long + 1] = line end
  end
  tap.ok(status == 0 and #long == 0, body .. ": no line beyond 100 columns", err .. table.concat(long, "\n"))
end
tap.done(program.finish())
