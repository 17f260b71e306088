#!/usr/bin/env lua5.4
-- command.t - polhode plot: well-formed pictures of finite numbers, curves where theory has them, reasons, files.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Curves are read back from the picture through its frame; a coordinate is written in tenths of a pixel.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"

local function run(arguments)
  return program.output(string.format("timeout 120 %s %s", binary, arguments))
end

-- Absolute points of path data of our own kind: "M1 2l3 4 5-.6...", after M absolute and after l relative.
local function points(data)
  local list = {}
  for piece in data:gmatch "M[^M]*" do
    local x, y = 0, 0
    for letter, numbers in piece:gmatch "([Ml])([^Ml]*)" do
      local n = {}
      for number in numbers:gmatch "%-?%d*%.?%d+" do n[#n + 1] = tonumber(number) end
      for i = 1, #n, 2 do
        if letter == "M" then x, y = 0, 0 end
        x, y = x + n[i], y + n[i + 1]
        list[#list + 1] = { x, y }
      end
    end
  end
  return list
end

-- ---- every scene of bodies/ ----

local names = {}
do
  local pipe = assert(io.popen("ls bodies/*.lua"))
  for line in pipe:lines() do names[#names + 1] = line:match "([%w_]+)%.lua$" end
  pipe:close()
end
local some = { tennis_racket = true, heavy_top = true, foucault = true, energy_sink = true, wheels = true }
-- The sheet of a body on a plane takes 20 s: two of the seven; POLHODE_PLANE=all: all of them.
local slow = { egg = true, eulers_disk = true, chaplygin_ball = true, rattleback = true, turntable_ball = true }
if os.getenv "POLHODE_PLANE" == "all" then slow = {} end
for _, name in ipairs(names) do
  if some[name] or not tier.quick and not slow[name] then
    local status, text, err = run("plot bodies/" .. name .. ".lua")
    tap.ok(status == 0 and (err == "" or err:find("bends too often", 1, true) or
      err:find("note: curves over time show the first", 1, true)), name .. ": a sheet", err)
    tap.ok(not text:find("nan", 1, true) and not text:find("inf%f[%W]"), name .. ": of finite numbers")
    local wide, high = text:match 'width="(%d+)" height="(%d+)"'
    local outside = 0
    for data in text:gmatch '<path class="[^"]*" d="([^"]*)"' do
      for _, p in ipairs(points(data)) do
        if p[1] < 0 or p[1] > tonumber(wide) or p[2] < 0 or p[2] > tonumber(high) then outside = outside + 1 end
      end
    end
    tap.is(outside, 0, name .. ": no curve leaves the picture")
    outside = 0
    for shape in text:gmatch '<polygon class="[^"]*" points="([^"]*)"' do
      for x, y in shape:gmatch "([^ ,]+),([^ ,]+)" do
        local inside = tonumber(x) >= 0 and tonumber(x) <= tonumber(wide) and tonumber(y) >= 0 and
          tonumber(y) <= tonumber(high)
        outside = outside + (inside and 0 or 1)
      end
    end
    for class, x, y, more in text:gmatch '<text class="(%l+)" x="([^"]*)" y="([^"]*)"([^>]*)>' do
      local left, right = tonumber(x), tonumber(x) -- a name of two letters is 20 pixels wide
      if class == "math" and more:find("end", 1, true) then left = left - 20 else right = right + 20 end
      outside = outside + ((class ~= "math" or left >= 0 and right <= tonumber(wide) and tonumber(y) >= 12 and
        tonumber(y) <= tonumber(high)) and 0 or 1)
    end
    tap.is(outside, 0, name .. ": nor does an arrow's head or a name")
    program.write(dir .. "/" .. name .. ".svg", text)
    local code, said = program.run("local e, why = host.xml(host.read '" .. dir .. "/" .. name .. ".svg')\n" ..
      "say(e and e.name .. ' ' .. e.at.viewBox or why)")
    tap.ok(code == 0 and said == "svg 0 0 " .. wide .. " " .. high .. "\n", name .. ": an XML parser takes it", said)
    local _, again = run("plot bodies/" .. name .. ".lua")
    tap.ok(text == again, name .. ": the same bytes twice")
  end
end

-- ---- the herpolhode between its circles, read from the picture ----

do
  local _, text = run "plot bodies/tennis_racket.lua --what herpolhode --until 20"
  local rings = {}
  for x, y, r in text:gmatch '<circle class="ring" cx="([%d.]+)" cy="([%d.]+)" r="([%d.]+)"/>' do
    rings[#rings + 1] = { tonumber(x), tonumber(y), tonumber(r) }
  end
  tap.is(#rings, 2, "the herpolhode has two circles")
  local least, most, n = math.huge, 0, 0
  for _, p in ipairs(points(text:match '<path class="trace" d="([^"]*)"')) do
    local r = math.sqrt((p[1] - rings[1][1]) ^ 2 + (p[2] - rings[1][2]) ^ 2)
    least, most, n = math.min(least, r), math.max(most, r), n + 1
  end
  table.sort(rings, function(a, b) return a[3] < b[3] end)
  local why = "coordinates are written in tenths of a pixel, and a curve is simplified to 0.12"
  tap.near(most, rings[2][3], 0, 0.25, "it touches the outer one", why)
  tap.near(least, rings[1][3], 0, 0.25, "and the inner one", why)
  tap.ok(n > 200, "with points enough")
end

-- ---- rates over time against run ----

do
  local _, text = run "plot bodies/tennis_racket.lua --what rates"
  local x0, y0, w, h = text:match '<rect class="frame" x="([%d.]+)" y="([%d.]+)" width="([%d.]+)" height="([%d.]+)"'
  x0, y0, w, h = tonumber(x0), tonumber(y0), tonumber(w), tonumber(h)
  -- two ticks of the y axis give its scale
  local ticks = {}
  for y, value in text:gmatch '<text class="tick" x="[%d.]+" y="([%d.]+)" text%-anchor="end">([^<]*)</text>' do
    ticks[#ticks + 1] = { tonumber(y) - 4, tonumber((value:gsub("−", "-"))) }
    if #ticks == 2 then break end
  end
  local slope = (ticks[2][2] - ticks[1][2]) / (ticks[2][1] - ticks[1][1])
  local line = points(text:match '<path class="line cx" d="([^"]*)"')
  local _, csv = run "run bodies/tennis_racket.lua --every 0.05"
  local worst, at, count = 0, 1, 0
  for row in csv:gmatch "[^\n]+" do
    local cells = {}
    for cell in row:gmatch "[^,]+" do cells[#cells + 1] = tonumber(cell) end
    if cells[1] then
      local x = x0 + cells[1] / 5 * w
      while line[at + 1] and line[at + 1][1] < x do at = at + 1 end
      local a, b = line[at], line[at + 1] or line[at]
      local s = b[1] > a[1] and math.max(0, math.min(1, (x - a[1]) / (b[1] - a[1]))) or 0
      local y = a[2] + s * (b[2] - a[2])
      local steep = b[1] > a[1] and math.abs((b[2] - a[2]) / (b[1] - a[1])) or 0
      local want = ticks[1][1] + (cells[6] - ticks[1][2]) / slope
      worst, count = math.max(worst, math.abs(y - want) / math.sqrt(1 + steep ^ 2)), count + 1
    end
  end
  tap.ok(count == 101, "rows of run to compare with", count)
  tap.near(worst, 0, 0, 0.3, "wx in the picture is wx of run, to 0.3 pixels",
    "tenths of a pixel in both coordinates, 0.12 of the curve, 0.05 of a tick's place")
  tap.ok(y0 > 0 and h > 100, "the frame is there")
end

-- ---- what has no meaning ----

local function refused(arguments, want)
  local status, out, err = run(arguments)
  tap.ok(status == 2 and out == "" and err:find(want, 1, true), arguments .. ": " .. want, err)
end

refused("plot bodies/tennis_racket.lua --what cones", "cones: no two moments are equal")
refused("plot bodies/heavy_top.lua --what polhode", "polhode: the motion is not a free body's")
refused("plot bodies/heavy_top.lua --what polhode,cones", "; cones: the motion is not a free body's")
refused("plot bodies/foucault.lua --what rates", "rates: the body is a point")
refused("plot bodies/brick.lua --what path", "path: nothing moves the body")
refused("plot bodies/brick.lua --what error", "error: it needs two runs: --method A,B or --step H,H/2")
refused("plot bodies/brick.lua --what polhodes", "did you mean polhode?")
refused("plot bodies/brick.lua --sequence zzx", "--sequence must be")
refused("plot bodies/brick.lua --sequence zyx --what rates", "--what does not name euler")
refused("plot bodies/brick.lua --until 0", "--until must be positive")
refused("plot bodies/brick.lua --method rk4,rk4", "rk4 stands there twice")
refused("plot bodies/brick.lua --method a,b,c", "--method must have one value, or two for two runs, got 3 values")
refused("plot bodies/brick.lua --step 0.1,0.1", "--step: 0.1 stands there twice")
refused("plot bodies/brick.lua --set a=1,2,3", "--set must be NAME=NUMBER or NAME=NUMBER,NUMBER, got a=1,2,3")
refused("plot bodies/brick.lua --method exact --step 0.01", "--step: the method exact has no steps")
refused("plot bodies/brick.lua --method exact,linearised --step 0.01", "--step: the method exact has no steps")
refused("plot bodies/brick.lua --what tlt", "--what: the scene has no tlt; did you mean tilt?")
refused("plot bodies/brick.lua --what {wx,wy,wz,qx,qy,qz}", "a panel has up to 5 curves, got 6")
refused("plot bodies/brick.lua --what rates,", "--what must")
refused("plot bodies/brick.lua --range t=2:1", "--range must be NAME=LOW:HIGH, with LOW below HIGH, got t=2:1")
refused("plot bodies/brick.lua --range t=-1:1", "--range t must begin at 0 or later, got −1")
refused("plot bodies/brick.lua --range t=0:2 --until 1", "--range t must end by --until 1, got 2")
refused("plot bodies/brick.lua --what rates --range tilt=0:1", "--range tilt: --what does not name it")
refused("plot bodies/brick.lua --what polhode --range polhode=0:1", "--range polhode: it is no picture over time")
refused("plot bodies/brick.lua --what error --method rk4,exact --step 0.1 --range error=0:1", "must be above 0 on its")
refused("plot bodies/brick.lua --method rk5", "did you mean rk4?")
refused("plot bodies/brick.lua -o x.gif", "must end in .svg, .png or .pdf")
refused("plot", "SCENE is missing")
refused("plot --from " .. dir .. "/no.csv", "no.csv")
refused("plot bodies/gyrostat.lua --what herpolhode", "a rotor or a wheel has momentum of its own")
refused("plot bodies/dumbbell.lua --what polhode", "rod")

-- ---- a table of run ----

do
  local csv = dir .. "/racket.csv"
  run("run bodies/tennis_racket.lua --every 0.01 -o " .. csv)
  local status, text, err = run("plot bodies/tennis_racket.lua --from " .. csv .. " --what polhode,herpolhode")
  tap.ok(status == 0 and err == "", "a table of run and its scene make the polhode", err)
  tap.like(text, "Herpolhode", "and the herpolhode")
  status, text, err = run("plot --from " .. csv)
  tap.ok(status == 0 and text:find("racket.csv", 1, true), "a table alone makes what it can", err)
  tap.like(text, "Angular velocity, inertial axes", "with what follows from it")
  refused("plot --from " .. csv .. " --what polhode", "name the SCENE, too")
  refused("plot --from " .. csv .. " --what path", "the file has no columns rx, ry, rz")
  refused("plot --from " .. csv .. " --method rk4", "--from has rows")
  refused("plot --from " .. csv .. " --set a=1", "there is only --from")
  program.write(csv, "t,wx,wy,wz\n0,1,0,0\n0,1,0,0\n")
  refused("plot --from " .. csv, "racket.csv:3: times must ascend, got 0 s after 0 s")
  program.write(csv, "t,wx,wy,wz\n0,1,0,0\n1,nan,0,0\n")
  refused("plot --from " .. csv, 'racket.csv:3: column wx must be a number, got "nan"')
  program.write(csv, "a,b\n0,1\n")
  refused("plot --from " .. csv, "no column t")
end

-- ---- two methods ----

do
  local status, text, err = run "plot bodies/nodding_top.lua --what error --method rk4,adaptive --step 0.02"
  tap.ok(status == 0, "two methods", err)
  tap.like(text, "Difference of rk4 and adaptive", "and their difference")
  tap.ok(text:find('>0.001</text>', 1, true) and text:find('>0.01</text>', 1, true) and
    text:find('>0.1</text>', 1, true) and text:find('>1</text>', 1, true), "on a logarithmic scale")
  status, text, err = run "plot bodies/brick.lua --method linearised --until 2 --what rates"
  tap.ok(status == 0 and text and err:find("the exact motion differs by", 1, true), "as is what linearising costs", err)
  status, text, err = run "plot bodies/nodding_top.lua --method rk4 --step 0.05 --what rates"
  tap.ok(status == 0 and text and (err:find("its error is estimated", 1, true) or
    err:find("no digit is known", 1, true)), "steps that are too long are told", err)
end

-- ---- one range of time ----

do -- the rates turn once in a second or so, the energy not at all: all are cut where the rates are a block of ink
  local status, text, err = run "plot bodies/brick.lua --until 100 --what rates,attitude,energy,momentum"
  local cut = err:match "^note: curves over time show the first ([%d.]+) s of 100 s, where [^\n]*%-%-until[^\n]*\n$"
  local first, all, other = 0, 0, 0
  for part, of in text:gmatch "the first ([%d.]+) s of ([%d.]+) s<" do
    first, other = first + 1, other + ((part ~= cut or of ~= "100") and 1 or 0)
  end
  for of in text:gmatch "all ([%d.]+) s<" do all, other = all + 1, other + (of ~= "100" and 1 or 0) end
  tap.ok(status == 0 and cut and first >= 3 and all == 2 and other == 0,
    "panels over time have one range, drifts all of the time, and standard error tells it", err)
  status, text, err = run "plot bodies/brick.lua --until 0.5 --what rates,attitude,energy,momentum"
  tap.ok(status == 0 and err == "" and not text:find "the first" and not text:find("all 0.5", 1, true),
    "what is not cut says nothing", err)
end

-- ---- PNG and PDF ----

do
  local have = program.shell "command -v rsvg-convert >/dev/null" == 0
  for _, kind in ipairs { "png", "pdf" } do
    local file = dir .. "/picture." .. kind
    local status, _, err = run("plot bodies/brick.lua --what rates -o " .. file)
    if have then
      local bytes = program.read(file)
      local begins = kind == "png" and "\x89PNG" or "%PDF"
      tap.ok(status == 0 and bytes:sub(1, 4) == begins, kind .. " by rsvg-convert", err)
      run("plot bodies/brick.lua --what rates -o " .. file)
      tap.ok(program.read(file) == bytes, kind .. ": the same bytes twice")
    else
      tap.ok(status == 2 and err:find("librsvg2-bin", 1, true), kind .. " without rsvg-convert names the package", err)
    end
  end
  local found = io.popen("command -v env"):read "l"
  program.shell("mkdir -p " .. dir .. "/bin && ln -sf " .. found .. " " .. dir .. "/bin/env")
  local status = program.shell(string.format("PATH=%s/bin %s plot bodies/brick.lua -o %s/none.pdf 2>%s/stderr", dir,
    binary:find("^/") and binary or "./" .. binary, dir, dir))
  tap.ok(status == 2 and program.read(dir .. "/stderr"):find("librsvg2-bin", 1, true),
    "without the program one message names its package", program.read(dir .. "/stderr"))
  tap.ok(not program.read(dir .. "/none.pdf"), "and no file is written")
end

program.finish()
tap.done()
