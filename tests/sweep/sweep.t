#!/usr/bin/env lua5.4
-- sweep.t - polhode sweep: which members there are, that each has the motion `polhode run` gives it, what is kept.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Oracles: grids and distributions computed here; `polhode run --engine generated`, a scalar program of the same scene,
-- to the last bit; for passages and extrema a spin about an axis, qw = cos(w t/2).

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local dir, here = program.directory(), os.getenv "PWD"
local binary = program.quick():gsub("build/polhode$", here .. "/build/polhode")

-- The program in the test's folder: status, standard output and error.
local function polhode(format, ...)
  local code = program.shell(string.format("cd %s && POLHODE_SOURCE=%s %s %s > out 2> err", dir, here, binary,
    string.format(format, ...)))
  return code, program.read(dir .. "/out"), program.read(dir .. "/err")
end

-- Rows of a CSV by column, numbers where they are; and the names.
local function rows(csv)
  local list, names = {}, nil
  for line in (csv or ""):gmatch "[^\n]+" do
    local cells = {}
    for cell in (line .. ","):gmatch "([^,]*)," do cells[#cells + 1] = tonumber(cell) or cell end
    if names then
      local row = {}
      for i, n in ipairs(names) do row[n] = cells[i] end
      list[#list + 1] = row
    else
      names = cells
    end
  end
  return list, names or {}
end

-- ---- grids ----

local code, out, err = polhode "sweep tumbling_box --over wx=0.1:0.3:3,a=0.2:0.4:2,wz=1:100:3:log --until 1"
local list, names = rows(out)
if not tap.is(code, 0, "a grid runs") then tap.diag(err) end
tap.is(table.concat(names, " "), "member wx a wz final_qw final_qx final_qy final_qz final_wx final_wy final_wz status",
  "a row has the member's number, what was varied, its final state, its status")
tap.is(#list, 18, "a grid has the product of its counts as members")
do
  local good, k = true, 0
  for i = 0, 2 do
    for j = 0, 1 do
      for l = 0, 2 do
        k = k + 1
        local r = list[k] or {}
        local wx = i == 2 and 0.3 or 0.1 + (i / 2) * (0.3 - 0.1)
        good = good and r.member == k - 1 and r.wx == wx and r.a == (j == 0 and 0.2 or 0.4) and
          math.abs(r.wz / 10.0 ^ l - 1) < 4 * 2.0 ^ -52 and r.status == "ok" -- exp and log, an ulp each
      end
    end
  end
  tap.ok(good, "the last name is the fastest, and the ends are exact")
  tap.ok(list[1] and list[1].wz == 1 and list[3].wz == 100, "of a logarithmic axis, too")
end

-- ---- the same motion as the scalar program ----

local function scene(name, text) program.write(dir .. "/" .. name .. ".lua", text) end
local function agree(name, r, csv)
  local one, columns = rows(csv)
  local same = #one == 1
  for _, c in ipairs(columns) do
    local final = r["final_" .. c]
    if final then same = same and final == one[1][c] end
  end
  tap.ok(same, name)
end

do
  local text = program.read "bodies/tumbling_box.lua"
  for _, k in ipairs { 1, 8, 18 } do
    local r = list[k]
    scene("t", text:gsub("omega = {1, 6.5, 1}", string.format("omega = {%.17g, 6.5, %.17g}", r.wx, r.wz)))
    local _, csv = polhode("run t.lua --engine generated --method rk4 --at 1 --set a=%.17g", r.a)
    agree("member " .. k - 1 .. " ends where `polhode run` ends, to the bit", r, csv)
  end
end

do -- a unit of its own, an initial state of effects' own, taylor
  scene("s", [[local h = param("h", 300, "mm")
    return scene { name = "s", body = solid.box { x = h, y = 0.2, z = 0.1, mass = 1 }, effects = { effect.gravity {} },
      origin = {0, 0, 0.3}, initial = { omega = {1, 2, 3} }, time = { horizon = 1, step = 0.01 } }]])
  code, out, err = polhode "sweep s.lua --over h=250:350:3 --method taylor --order 8 --keep final"
  if not tap.is(code, 0, "a parameter in a unit of its own, and a stepper that goes body by body") then
    tap.diag(err)
  end
  local r = rows(out)[1] or {}
  tap.ok(r.h == 250, "its column is in that unit")
  local _, csv = polhode "run s.lua --engine generated --method taylor --order 8 --step 0.01 --at 1 --set h=250"
  agree("its member ends where `polhode run --set` ends", r, csv)
end

-- ---- what is kept ----

-- Spin at w about z: qw = cos(w t/2), qz = sin(w t/2).  The error of an rk4 step is (w h/2)^5/120 in phase, 2e-13 in
-- all, and 10^4 roundings add 1e-12.
scene("spin", [[return scene { name = "spin", body = solid.box { x = 1, y = 2, z = 3, mass = 1 },
  initial = { omega = {0, 0, 2} }, time = { horizon = 10, step = 0.001 } }]])
code, out, err = polhode([[sweep spin.lua --over wz=1.3:2.3:3 --keep "first: zero = qw" --keep "rise: up = qw" ]] ..
  [[--keep "max: most = qz + t/100" --keep "min: least = qw - t/100" --keep "final: angle = 2*atan2(qz, qw)" ]] ..
  [[--keep "states: 1:5:3" --keep "first: never = qw - 2" --keep drift]])
list = rows(out)
if not tap.is(code, 0, "many kinds are kept together") then tap.diag(err) end
local near = true
local function like(got, want)
  if not (type(got) == "number" and math.abs(got - want) < 1e-11) then
    near = false
    tap.diag(string.format("got %s, want %.17g", got, want))
  end
end
for _, r in ipairs(list) do
  local w = r.wz / 2
  like(r.zero, math.pi / 2 / w)
  like(r.up, 3 * math.pi / 2 / w)
  -- d/dt (sin w t + t/100) = 0: w t = 2 pi n +- acos(-1/(100 w)); the last maximum before 10 s, or the end
  local best, lowest = math.max(0, math.sin(w * 10) + 0.1), math.min(1, math.cos(w * 10) - 0.1)
  for n = 0, 3 do
    local t = (2 * math.pi * n + math.acos(-1 / (100 * w))) / w
    if t < 10 then best = math.max(best, math.sin(w * t) + t / 100) end
    t = (2 * math.pi * n + math.pi + math.asin(1 / (100 * w))) / w
    if t < 10 then lowest = math.min(lowest, math.cos(w * t) - t / 100) end
  end
  like(r.most, best)
  like(r.least, lowest)
  like(math.cos(r.angle / 2), math.cos(w * 10) * (math.cos(w * 10) * math.cos(r.angle / 2) < 0 and -1 or 1))
  for i = 1, 3 do like(r["qw_at@" .. 2 * i - 1], math.cos(w * (2 * i - 1))) end
  like(r.drift, 0)
  near = near and r.never == "nan"
end
tap.ok(near and #list == 3, "first and upward passages, extrema between steps, expressions, states at times, drift")

-- ---- attitudes ----

out = select(2, polhode("sweep spin.lua --over turn_x=0:1:2,tilt_z=0:1:2,wz=0:1:2 --until 0.01 " ..
  "--keep states:0:0.01:2"))
list = rows(out)
do
  local r = list[7] or {} -- turn_x = 1, tilt_z = 1, wz = 0: q = exp(z/2) exp(x/2)
  local c, s = math.cos(0.5), math.sin(0.5)
  local want = { qw = c * c, qx = c * s, qy = s * s, qz = s * c }
  local good = #list == 8
  for name, x in pairs(want) do good = good and math.abs((r[name .. "_at@0"] or 9) - x) < 4e-16 end -- 4 roundings of 1
  tap.ok(good, "a turn about body axes comes first, one about the axes of space after it")
end
out = select(2, polhode("sweep spin.lua --sample 4000 --vary 'attitude=any()' --points sobol --until 0.01"))
list = rows(out)
do
  local sums, length = { 0, 0, 0, 0 }, 0
  for _, r in ipairs(list) do
    local n = 0
    for i, name in ipairs { "qw", "qx", "qy", "qz" } do
      sums[i] = sums[i] + r[name] ^ 2
      n = n + r[name] ^ 2
    end
    length = math.max(length, math.abs(n - 1))
  end
  local good = #list == 4000 and length < 1e-15
  -- each square has the mean 1/4; 4000 even points are far better than the 0.0034 of independent ones
  for i = 1, 4 do good = good and math.abs(sums[i] / 4000 - 0.25) < 0.0034 end
  tap.ok(good, "attitudes are drawn from all of them, evenly")
end

-- (1, x, 0, 0) is no unit: it is taken as the attitude (cos A, sin A, 0, 0), tan A = x.  The spin about z turns it by
-- B = t/2: (cos B cos A, cos B sin A, -+sin B sin A, sin B cos A).
program.write(dir .. "/about_z.lua", [[
return scene { name = "about_z", body = solid.sphere { r = 1, mass = 1 }, initial = { omega = { 0, 0, 1 } },
  time = { horizon = 1, step = 0.01 } }
]])
code, out, err = polhode "sweep about_z.lua --over qx=1:3:3 --method taylor --until 1"
if not tap.is(code, 0, "one component of the attitude is varied") then tap.diag(err) end
do
  local good = #rows(out) == 3
  for i, r in ipairs((rows(out))) do
    local n = math.sqrt(1 + i * i)
    for k, x in pairs { w = math.cos(0.5) / n, x = math.cos(0.5) * i / n, z = math.sin(0.5) / n } do
      good = good and math.abs(r["final_q" .. k] - x) <= 1e-13
    end
    good = good and math.abs(math.abs(r.final_qy) - math.sin(0.5) * i / n) <= 1e-13
  end
  tap.ok(good, "and the four together are made a unit", out)
end

-- ---- samples ----

program.write(dir .. "/c.csv", "name,mean,wx,wy\nwx,6,0.01,0.006\nwy,1,0.006,0.04\n")
code, out, err = polhode("sweep spin.lua --sample 20000 --vary 'wz=uniform(1,2)' --covariance c.csv --until 0.01 " ..
  "--keep 'final: w = wx'")
list = rows(out)
if not tap.is(code, 0, "uniform and correlated values are drawn") then tap.diag(err) end
do
  local n, mx, my, xx, xy, yy, low, high = #list, 0, 0, 0, 0, 0, 9, 0
  for _, r in ipairs(list) do
    mx, my, low, high = mx + r.wx / n, my + r.wy / n, math.min(low, r.wz), math.max(high, r.wz)
  end
  for _, r in ipairs(list) do
    xx, xy, yy = xx + (r.wx - mx) ^ 2 / n, xy + (r.wx - mx) * (r.wy - my) / n, yy + (r.wy - my) ^ 2 / n
  end
  -- five standard errors: sd/sqrt n for means, variance sqrt(2/n) for variances, and less for the covariance
  local e = 5 / math.sqrt(n)
  tap.ok(n == 20000 and low > 1 and high < 2 and low < 1.001 and high > 1.999, "uniform numbers fill their range")
  tap.ok(math.abs(mx - 6) < 0.1 * e and math.abs(my - 1) < 0.2 * e, "correlated numbers have their means")
  tap.ok(math.abs(xx / 0.01 - 1) < 1.5 * e and math.abs(yy / 0.04 - 1) < 1.5 * e and
    math.abs(xy - 0.006) < 0.02 * 1.5 * e, "and their covariance")
end
local SQUARE = "sweep spin.lua --sample 64 --vary 'wz=uniform(0,64),wx=uniform(0,64)' --points lhs --until 0.01"
out = select(2, polhode(SQUARE))
list = rows(out)
do
  local x, z, count = {}, {}, 0
  for _, r in ipairs(list) do
    x[math.floor(r.wx)], z[math.floor(r.wz)] = true, true
  end
  for i = 0, 63 do count = count + (x[i] and 1 or 0) + (z[i] and 1 or 0) end
  tap.is(count, 128, "a Latin hypercube has a member in every stratum of each range")
end
local _, again = polhode(SQUARE .. " --seed 2")
tap.ok(again ~= out and #rows(again) == 64, "another seed draws others")

-- ---- statistics, and what the program says of itself ----

-- 1001 points of 1 to 2: the value at rank q is 1 + q, a bucket of 8 bits below 1 is at most 2^-8 wide, a rank 2^-9.
code, out, err = polhode "sweep spin.lua --over wz=1:2:1001 --until 0.01 --stats"
if not tap.is(code, 0, "statistics without rows") then tap.diag(err) end
tap.is(out:match "^[^\n]*", "quantity,count,missing,mean,deviation,least,most," ..
  "q0.001,q0.01,q0.05,q0.25,q0.5,q0.75,q0.95,q0.99,q0.999", "the nine quantiles are named")
do
  local cells, good = {}, true
  for cell in (out:match "\nwz,([^\n]*)" or ""):gmatch "[^,]+" do cells[#cells + 1] = tonumber(cell) end
  for i, q in ipairs { 0.001, 0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99, 0.999 } do
    good = good and math.abs((cells[6 + i] or 0) - 1 - q) <= 2.0 ^ -7
  end
  tap.ok(#cells == 15 and good, "and are where a uniform distribution has them", table.concat(cells, " "))
  tap.ok(cells[1] == 1001 and cells[2] == 0 and cells[5] == 1 and cells[6] == 2, "count, missing, least and most")
end

code, _, err = polhode "sweep tumbling_box --over wx=1:2:3 --set a=0.2 --set b=0.3 --emit told"
if not tap.is(code, 0, "a program is emitted") then tap.diag(err) end
tap.ok((program.read(dir .. "/told/README.md") or ""):find("--over wx=1:2:3 --set a=0.2 --set b=0.3\n", 1, true),
  "and names the whole command that it comes from")

-- ---- members that fail, accuracy ----

scene("p", [[local a, b = param("a", 1, "kg m^2"), param("b", 1.5, "kg m^2")
  return scene { name = "p", body = tensor { mass = 1, xx = a, yy = b, zz = 2 }, initial = { omega = {1, 2, 3} },
    time = { horizon = 1, step = 0.01 } }]])
code, out, err = polhode "sweep p.lua --over a=0.1:3.7:5"
list = rows(out)
tap.is(code, 0, "members that are no body do not stop the rest")
do
  local failed = 0
  for _, r in ipairs(list) do
    if r.status ~= "ok" then
      failed = failed + (tostring(r.status):find "^\"?no body" and r.final_qw == "nan" and 1 or 0)
    end
  end
  tap.ok(#list == 5 and failed == 2, "their status says which rule they break, their results are no numbers")
  tap.ok(err:find "of 5 members: no body", "and a line on standard error counts them")
  tap.ok(list[2] and list[2].status == "ok" and type(list[2].final_qw) == "number", "the members beside them are fine")
end
code, out, err = polhode "sweep tumbling_box --over wy=1:400:4 --accuracy 1e-7 --until 10"
list = rows(out)
tap.ok(code == 0 and #list == 4 and list[1].status == "ok" and list[1].error < 1e-7 and
  list[4].status == "accuracy missed" and list[4].error > 1e-7 and list[4].final_qw ~= "nan",
  "with --accuracy a member that misses it is named, its numbers stay")
tap.ok(err and err:find "of 4 members: accuracy missed", "and counted")

-- ---- what is wrong is said, all at once ----

-- ---- steps that are too long ----

-- With y = h |w|/2 a step of rk4 multiplies q by R(i y), |R|^2 = 1 - y^6/72 + y^8/576: 0.988 for h |w| = 2, 0.25 for
-- 4.9.  The damping stops the body, and then |q| comes back: the end alone tells nothing.
program.write(dir .. "/fast.lua", 'return scene { name = "fast", body = solid.box { x = .1, y = .2, z = .3, ' ..
  "mass = 1 }, effects = { effect.damping { c = 2e-3 } }, initial = { omega = { 0, 0, 470 } }, " ..
  "time = { horizon = 20, step = .01 } }")
code, out, err = polhode "sweep fast.lua --over wz=200:490:2"
list = rows(out)
tap.ok(code == 0 and #list == 2 and list[1].status == "ok" and math.abs(list[1].final_qw ^ 2 +
  list[1].final_qz ^ 2 - 1) < 1e-12, "h |w| = 2: ok", err)
tap.ok(#list == 2 and list[2].status == "the step is too long: |q| is not 1", "4.9: a member whose step loses |q|",
  out .. err)
-- a rattleback that leaves the plane at 8.8 ms: the time at which `run` ends
program.write(dir .. "/hops.lua", 'return scene { name = "hops", body = tensor { mass = .3, xx = 3e-5, yy = 3.2e-4, ' ..
  "zz = 3.3e-4 }, effects = { effect.plane { surface = contact.ellipsoid { a = .03, b = .1, c = .02, " ..
  'at = {0, 0, .004}, turned = { axis = "z", angle = .15 } } } }, initial = { omega = {25, 10, -25} }, ' ..
  "time = { horizon = 3, step = 1e-4 } }")
code, _, err = polhode "run hops.lua --until 3"
local lost = tonumber(err:match "event contact_lost at t = (%S+) s")
tap.ok(code == 0 and lost and lost > 8.7e-3 and lost < 8.9e-3, "a run on a plane ends where the contact is lost", err)
for _, c in ipairs { { lost - 1e-4, "", "ok" }, { lost + 1e-4, "", "contact is lost: the plane would have to pull" },
  { 3, "--keep 'first: a = wx - 8.4'", "ok" }, -- that was before
  { 3, "--keep 'max: a = wx'", "contact is lost: the plane would have to pull" } } do
  code, out, err = polhode(string.format("sweep hops.lua --over wz=-25 --until %.17g %s", c[1], c[2]))
  list = rows(out)
  tap.ok(code == 0 and #list == 1 and list[1].status == c[3], "and so does a member, until " .. c[1] .. " " .. c[2],
    out .. err)
end
program.write(dir .. "/told.lua", 'local gain = input("gain", "N m")\nreturn scene { name = "told", body = ' ..
  "solid.box { x = 1, y = 2, z = 3, mass = 1 }, effects = { effect.torque { body = {gain, 0, 0} } }, " ..
  "initial = { omega = {1, 2, 3} }," ..
  ' events = { { name = "half", when = wx, stop = true } } }')
code, _, err = polhode "sweep told.lua --over wx=1:2:2 --until 1"
tap.ok(code == 0 and err:find("inputs are 0: gain", 1, true) and err:find("event half (line 2) does not end", 1, true),
  "what a run has and a member has not is said", err)

code, out, err = polhode "run fast.lua --engine generated --method rk4 --every 0.1"
tap.ok(code == 3 and out == "" and err:find("the step is too long: |q| is not 1", 1, true) and
  err:find("--step 0.", 1, true), "and a run", err)

code, _, err = polhode([[sweep spin.lua --over "wz=,q=1:2:3,wx=1:2:0,wy=1:1:2,qw=1:2,qx=-1:1:3:log" --keep foo ]] ..
  [[--keep "final: qw +" --keep "max: zz" --keep "first: wx + qx" --keep "max:" --sample 0 -o x.txt --threads 0.5 ]] ..
  [[--method foo --vary "wx=nomal(1,2),wy=normal(1,-1),wy=uniform(2,1)" --until -1]])
tap.is(code, 2, "a command line that is wrong has status 2")
for _, part in ipairs { "-o must end in .csv or .h5, or be -, got x.txt", "--threads must be a whole number", "got foo",
  "--over must be NAME=..., got wz=", "q is no parameter and no state", "wx: must have a count of points from 1 on",
  "wy: must have ends that differ", "qw: must be LOW:HIGH:COUNT", "qx: must have positive ends", "did you mean normal?",
  "DEVIATION must be positive", "LOW must be less than HIGH", "--sample must be a whole number from 1 on, got 0",
  "--keep must be one of", "\"final: qw +\": unexpected symbol", "no word zz", "--keep max: needs an expression",
  "--until must be positive" } do
  tap.ok(err:find(part, 1, true) ~= nil, "said: " .. part)
end
tap.ok(err:find("wx + qx", 1, true), "and that rates and quaternions are not added")
for _, case in ipairs { { "", "nothing is varied" }, { "--sample 5", "--vary or --covariance says what is drawn" },
  { "--over wz=1:2:2 --seed 5", "--seed: --sample N says" },
  { "--over wz=1:2:2 --resume", "--resume: it needs the -o" },
  { "--over wz=1:2:2,wz=3:4:2", "wz is varied twice" },
  { "--over wz=1:2:2 --emit e -o f.csv", "-o: the program takes" },
  { "--sample 5 --covariance none.csv", "none.csv" } } do
  code, out, err = polhode("sweep spin.lua %s", case[1])
  tap.ok(code == 2 and out == "" and err:find(case[2], 1, true) ~= nil, "said: " .. case[2])
  if not err:find(case[2], 1, true) then tap.diag(err) end
end
program.write(dir .. "/c.csv", "name,mean,wx,wy\nwx,6,0.01,0.06\nwy,1,0.06,0.04\n")
code, _, err = polhode "sweep spin.lua --sample 5 --covariance c.csv"
tap.ok(code == 2 and err:find("negative variance", 1, true), "said: a matrix that is no covariance")

program.finish()
tap.done()
