#!/usr/bin/env lua5.4
-- hostile.t - scenes that mean harm, each given to `polhode gen` as its user would: nothing comes of any.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- tests/cli/hostile/*.lua is the list.  Each attempt ends within 4 s of processor time (the longest takes 1.6 s alone,
-- and up to 2.9 s beside other tests) and 72 MiB (wait4 says: 40 that a scene may have, what is not collected yet, the
-- program), by itself; it is refused with status 1 and messages that begin with the scene's name, and no file is made;
-- or it is accepted, and then what was emitted compiles without a warning and no text of the scene is code in it.
-- The bounds count work, so a slow machine is given more seconds: as many times 4 s as it needs longer than 0.5 s for
-- the endless loop, which is 5e7 instructions (0.2 to 0.4 s where this was written).
-- The quick tier makes every eighth attempt of a list.
-- POLHODE_HOSTILE=FILE refreshes the table of that page (docs/sandbox.md).

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"
if binary:sub(1, 1) ~= "/" then binary = io.popen("pwd"):read("l") .. "/" .. binary end
local sanitized = os.getenv "POLHODE_SANITIZED" ~= nil
local MOST, MIB = 4, 72
local BOX = "return scene { name = 's', body = solid.box { x = 1, y = 2, z = 3, mass = 1 } }"
local STRICT = (os.getenv "CC" or "cc") .. " -std=c99 -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion " ..
  "-Wshadow" ..
  " -Werror -fsyntax-only"

local function quote(s) return "'" .. s:gsub("'", "'\\''") .. "'" end

local confine = dir .. "/confine"
assert(program.shell((os.getenv "CC" or "cc") .. " -O1 -o " .. confine .. " tests/cli/hostile/confine.c") == 0)

local count = 0

-- How the run of gen ended: {how =, status =, seconds =, mib =, out =, err =, files =, place =}.
local function run(row)
  count = count + 1
  local place = dir .. "/" .. count
  program.shell("mkdir " .. place)
  if row.first then program.shell("cd " .. place .. " && " .. row.first) end
  local text = row[2]
  if row.scene then text = string.format("return scene { name = %q, body = solid.sphere { r = 1, mass = 1 } }",
    row.scene) end
  if row.param then
    text = string.format("local a = param(%q, 1, 'm') return scene { name = 's', body = solid.box { x = a, y = " ..
      "2, z = 3, " ..
      "mass = 1 } }", row.param)
  end
  if not row.file then program.write(place .. "/s.lua", (text:gsub("BOX$", BOX))) end
  local before = program.shell("ls -A " .. place .. " > " .. dir .. "/before")
  local limit = sanitized and 60 or 8
  local pipe = io.popen(string.format("cd %s && %s %d %s/out %s/err %s gen %s -o made </dev/null", place,
    confine, limit, dir,
    dir, quote(binary), row.file or "s.lua"))
  local how, status, seconds, mib = pipe:read("a"):match("(%a+) (%d+) (%S+) (%S+)")
  pipe:close()
  return { how = how, status = tonumber(status), seconds = tonumber(seconds), mib = tonumber(mib), place = place,
    out = program.read(dir .. "/out"), err = program.read(dir .. "/err"),
    kept = before == 0 and program.shell("ls -A " .. place .. " | cmp -s - " .. dir .. "/before") == 0 }
end

-- Every line begins with the scene's name (a warning's after that word), or is the line of the scene that it blames.
local function clear(err, file)
  for line in err:gmatch("[^\n]+") do
    if not (line:find(file .. ":", 1, true) == 1 or line:find("warning: " .. file .. ":", 1, true) == 1 or
      line:find("    ", 1, true) == 1 or line:find("polhode", 1, true) == 1) then return false end
  end
  return err ~= "" and not err:find("internal error", 1, true) and not err:find("traceback", 1, true) and
    not err:find("[\0-\8\11-\31]")
end

-- What the preprocessor leaves of the emitted files, without strings, has nothing of the scene's own text.
local function harmless(place)
  local command = "cd " .. place .. "/made && for f in *.c; do " .. STRICT .. " $f && " .. (os.getenv "CC" or "cc") ..
    " -E -P -std=c99 $f; done 2>&1"
  local pipe = io.popen(command)
  local text = pipe:read "a"
  local good = pipe:close()
  return good and not text:gsub('"[^"\n]*"', '""'):find("INJECTED", 1, true) and not text:find("error:", 1, true)
end

local worst, slowness, rows = { seconds = 0, mib = 0 }, 1, {}

local function measure_slowness()
  if not sanitized then slowness = math.max(slowness, run({ "", "while true do end" }).seconds / 0.5) end
end

local function attempt(about, row, again)
  local want = row[3]
  if want == nil then want = row[2] end -- a name or a file is the row's other field
  local r = run(row)
  local within = sanitized or r.seconds <= MOST * slowness and r.mib <= MIB
  if not within and not again then -- the machine may be busier than it was
    measure_slowness()
    return attempt(about, row, true)
  end
  local ended
  if want == true then
    ended = r.how == "exit" and r.status == 0 and r.out == "" and harmless(r.place)
  elseif want == "" and r.status == 0 then
    ended = harmless(r.place)
  else
    ended = r.how == "exit" and r.status == (row.status or 1) and r.out == "" and r.kept and
      clear(r.err, row.file or "s.lua") and r.err:find(want, 1, true) ~= nil
  end
  tap.ok(within and ended, about .. ": " .. row[1], string.format("%s %s, %s s, %s MiB, files %s\nwant " ..
    "%s\n%s%s", r.how, r.status,
    r.seconds, r.mib, r.kept and "as before" or "made", want, r.out:sub(1, 300), r.err:sub(1, 600)))
  worst.seconds, worst.mib = math.max(worst.seconds, r.seconds), math.max(worst.mib, r.mib)
  local verdict = "accepted, compiles"
  if r.status ~= 0 then verdict = r.err:match("^[^\n]*"):gsub("^%S+: ", "", 1):gsub("|", "\\|"):sub(1, 110) end
  rows[#rows + 1] = string.format("| %s | %s | %.2f | %.0f |", (row[1]:gsub("|", "\\|"):gsub("%c", "?")), verdict,
    r.seconds, r.mib)
  program.shell("rm -rf " .. r.place)
  return r
end

measure_slowness()
for _, name in ipairs { "words", "bombs", "algebra", "names", "files" } do
  local list = require("tests.cli.hostile." .. name)
  for _, row in ipairs(tier.every(8, list)) do attempt(list.about, row) end
end
tap.ok(program.shell("test ! -e INJECTED") == 0 and #rows >= (tier.quick and 10 or 60),
  #rows .. " attempts, none of which made a file")
tap.diag(string.format("worst: %.2f s, %.1f MiB", worst.seconds, worst.mib))

local page = os.getenv "POLHODE_HOSTILE"
if page then
  local text = program.read(page)
  local mark = "<!-- attempts -->\n"
  local head = text:sub(1, (select(2, text:find(mark, 1, true))))
  program.write(page, head .. string.format("%d attempts; worst %.2f s and %.1f MiB.\n\n| attempt | what came of it " ..
    "| s | MiB |\n|---|---|---|---|\n", #rows, worst.seconds, worst.mib) .. table.concat(rows, "\n") .. "\n")
end

tap.done(program.finish())
