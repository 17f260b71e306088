#!/usr/bin/env lua5.4
-- columns.t - polhode run --columns: quantities against identities between them, expressions, names, what is refused.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"

local function run(arguments)
  return program.output(string.format("timeout 120 %s run %s", binary, arguments))
end

-- Rows by the names of the columns; names may be quoted.
local function rows(text)
  local names, list = nil, {}
  for line in text:gmatch "[^\n]+" do
    local cells, rest = {}, line .. ","
    while rest ~= "" do
      local quoted, after = rest:match '^"([^"]*)",(.*)$'
      local plain, behind = rest:match "^([^,]*),(.*)$"
      cells[#cells + 1], rest = quoted or plain, quoted and after or behind
    end
    if names then
      local row = {}
      for i, name in ipairs(names) do row[name] = tonumber(cells[i]) end
      list[#list + 1] = row
    else
      names = cells
    end
  end
  return list, names
end

local why = "each side is a few products of doubles of about the size that is given"

do
  local status, text, err = run("bodies/nodding_top.lua --until 3 --every 0.1 --columns 't,states,energy,L,L_body," ..
    "speed,momentum,omega_inertial,tilt,axis,matrix,rotation_vector,euler,euler_zyx,twice = 2*wx + wy,atan2(qx, qw)'")
  tap.ok(status == 0 and err == "", "all kinds of columns", err)
  local list, names = rows(text)
  tap.is(#list, 31, "and all rows")
  tap.is(names[1], "t", "in the order that is asked for")
  tap.is(names[#names], "atan2(qx, qw)", "an expression has its text for a name, quoted where it has commas")
  local worst = { 0, 0, 0, 0, 0, 0, 0, 0, 0 }
  local function off(k, d) worst[k] = math.max(worst[k], math.abs(d)) end
  for _, r in ipairs(list) do
    local w = { r.wx, r.wy, r.wz }
    local R = { { r.matrix_11, r.matrix_12, r.matrix_13 }, { r.matrix_21, r.matrix_22, r.matrix_23 },
      { r.matrix_31, r.matrix_32, r.matrix_33 } }
    for i, name in ipairs { "x", "y", "z" } do
      off(1, R[i][1] * w[1] + R[i][2] * w[2] + R[i][3] * w[3] - r["omega_inertial_" .. name])
      off(2, R[i][1] * r.L_body_x + R[i][2] * r.L_body_y + R[i][3] * r.L_body_z - r["L" .. name])
      off(3, R[i][3] - r["axis_" .. name])
    end
    off(4, math.sqrt(w[1] ^ 2 + w[2] ^ 2 + w[3] ^ 2) - r.speed)
    off(4, math.sqrt(r.Lx ^ 2 + r.Ly ^ 2 + r.Lz ^ 2) - r.momentum)
    off(5, math.cos(r.tilt) - R[3][3])
    off(6, r.euler_2 - r.tilt)
    -- z, then x, then z: the axis is (sin 1 sin 2, -cos 1 sin 2, cos 2)
    off(6, math.sin(r.euler_1) * math.sin(r.euler_2) - r.axis_x)
    off(6, -math.cos(r.euler_1) * math.sin(r.euler_2) - r.axis_y)
    -- yaw, pitch, roll: sin of the second is -R31
    off(7, math.sin(r.euler_zyx_2) + R[3][1])
    local v = { r.rotation_vector_x, r.rotation_vector_y, r.rotation_vector_z }
    off(8, 1 + 2 * math.cos(math.sqrt(v[1] ^ 2 + v[2] ^ 2 + v[3] ^ 2)) - (R[1][1] + R[2][2] + R[3][3]))
    off(9, r.twice - (2 * r.wx + r.wy))
    off(9, r["atan2(qx, qw)"] - math.atan(r.qx, r.qw))
  end
  local what = { "the matrix turns w into space", "and L_body into L", "its last column is the axis",
    "speed and momentum",
    "the tilt's cosine is the matrix's last entry", "Euler angles zxz: tilt and axis", "zyx: pitch",
    "the trace is 1 + 2 cos of the rotation vector's length", "expressions are what Lua computes" }
  for k, name in ipairs(what) do tap.near(worst[k], 0, 0, 1e-13, name, why .. "; rates are about 40 rad/s") end
  local I = { 0.00075, 0.00075, 0.00054 }
  local r = list[7]
  tap.near(r.L_body_x, I[1] * r.wx, 0, 1e-15, "L_body is I w", "L is about 0.02")
  tap.near(r.L_body_z, I[3] * r.wz, 0, 1e-15, "about each axis", "L is about 0.02")
end

-- ---- poses in which angles are not unique ----

do
  local status, text = run("bodies/tennis_racket.lua --at 0 --columns euler,euler_zyz,euler_xyz,euler_zyx,tilt," ..
    "rotation_vector")
  local list = rows(text)
  local all = true
  for _, x in pairs(list[1]) do all = all and x == 0 end -- any order
  tap.ok(status == 0 and all, "no rotation: every angle is 0, none is missing", text)
end

-- ---- the usual columns, other engines and forms ----

do
  local _, usual = run "bodies/thrown_book.lua --until 1 --every 0.5"
  local _, same = run "bodies/thrown_book.lua --until 1 --every 0.5 --columns t,q,w,energy,L,r,v"
  tap.ok(usual == same, "the usual columns by their names are the usual table")
  local status, text = run "bodies/brick.lua --engine generated --at 1 --columns tilt,speed"
  local list = rows(text)
  _, text = run "bodies/brick.lua --at 1 --columns tilt,speed"
  local other = rows(text)
  tap.ok(status == 0, "the emitted code has them, too")
  tap.near(list[1].tilt, other[1].tilt, 1e-13, 0, "the same tilt", "two closed forms, errors of some 1e-15")
  status, text = run "bodies/brick.lua --at 0,1 --columns wx,t --format json"
  tap.ok(status == 0 and text:find('"wx"', 1, true) and text:find('"columns"', 1, true), "as JSON", text)
  program.write(dir .. "/e.lua", [[
return scene { name = "e", body = solid.sphere { r = 1, mass = 1 }, initial = { omega = {0, 0, 1} },
  events = { { name = "half", when = qw, stop = true } }, time = { horizon = 10 } }]])
  status, text = run(dir .. "/e.lua --every 1 --columns tilt,wz,t --events " .. dir .. "/events.csv")
  local happened = program.read(dir .. "/events.csv")
  tap.ok(status == 0 and happened:find("event,tilt,wz,t\nhalf,", 1, true), "the table of events has the same columns",
    happened)
  tap.like(text, "0.0,1.0,3.14159265358979", "a run that stops knows its time wherever the column stands")
end

-- ---- what is refused ----

local function refused(arguments, want, status)
  local got, out, err = run(arguments)
  tap.ok(got == (status or 2) and out == "" and err:find(want, 1, true), arguments .. ": " .. want, err)
end

refused("bodies/brick.lua --columns tild", "did you mean tilt?")
refused("bodies/brick.lua --columns euler_zzx", "the scene has no euler_zzx")
refused("bodies/foucault.lua --columns tilt", "the scene has no tilt")
refused("bodies/brick.lua --columns t,,wx", "words or expressions with commas between")
refused("bodies/brick.lua --columns t,t", "the column t is there twice")
refused("bodies/brick.lua --columns 'a = wx, a = wy'", "the column a is there twice")
refused("bodies/brick.lua --columns 'wx + qx'", "both sides must have one dimension")
refused("bodies/brick.lua --columns 'wx +'", "--columns wx +:")
refused("bodies/brick.lua --columns 'f(wx)'", "no word f")
refused("bodies/tennis_racket.lua --at 0 --columns '1/qz'", "a column is not finite", 3)

-- A frame that turns changes what is seen, not the motion: w in inertial axes is that of the scene without it, and in
-- the frame's axes it is turned back by the angle of the frame, rate t + rate_dot t^2/2 about (1, 2, 2)/3.
do
  local function scene(effects)
    program.write(dir .. "/frame.lua", 'return scene { name = "frame", body = solid.box { x = 0.1, y = 0.2, ' ..
      "z = 0.3, mass = 1 }, effects = { " .. effects .. " }, initial = { omega = { 0.1, 2, 0.3 } } }")
    return dir .. "/frame.lua"
  end
  local function measured(effects, words)
    local status, text, err = run(scene(effects) .. " --at 0.5,1,3 --columns t,q,w," .. words)
    return status == 0 and rows(text) or {}, err
  end
  local still = measured("", "omega_inertial")
  local seen, err = measured("effect.rotating_frame { rate = { 0.3, 0.6, 0.6 }, rate_dot = { 0.1, 0.2, 0.2 } }",
    "omega_inertial,omega_frame")
  tap.is(#seen, 3, "omega in both axes: " .. err)
  for i, r in ipairs(seen) do
    local angle, n, F, I, worst = 0.9 * r.t + 0.15 * r.t ^ 2, { 1 / 3, 2 / 3, 2 / 3 }, {}, {}, 0
    for k, x in ipairs { "x", "y", "z" } do
      F[k], I[k] = r["omega_frame_" .. x], r["omega_inertial_" .. x]
      worst = math.max(worst, math.abs(I[k] - still[i]["omega_inertial_" .. x]))
    end
    local along = n[1] * I[1] + n[2] * I[2] + n[3] * I[3]
    for k = 1, 3 do -- Rodrigues, by -angle
      local a, b = k % 3 + 1, (k + 1) % 3 + 1
      local cross = n[a] * I[b] - n[b] * I[a]
      worst = math.max(worst, math.abs(math.cos(angle) * I[k] - math.sin(angle) * cross +
        (1 - math.cos(angle)) * along * n[k] - F[k]))
    end
    tap.ok(worst < 1e-11, "at " .. r.t .. " s: w in inertial axes as without the frame, and turned back in the frame's",
      worst)
  end
  local tumbling = scene "effect.rotating_frame { rate = { 0.3, 0, 0 }, rate_dot = { 0, 0.1, 0 } }"
  tap.is(run(tumbling .. " --columns omega_frame"), 0, "an axis that moves: in the frame's axes")
  local status, _, said = run(tumbling .. " --columns omega_inertial")
  tap.ok(status == 2 and said:find("the scene has no omega_inertial: the axis of its frame moves", 1, true),
    "and in no others, with the reason", said)
  status, _, said = run(scene "" .. " --columns omega_frame")
  tap.ok(status == 2 and said:find("the scene has no omega_frame", 1, true), "without a frame there is none", said)
end
-- the words of a body on a plane in expressions: the speed of the slip, the height
do
  local status, text, err = run("bodies/tippe_top.lua --at 0.1,0.4 --columns slip,com,height,'s = 2*slip'")
  for _, r in ipairs(status == 0 and rows(text) or { { s = 1 } }) do
    local far = r.s - 2 * math.sqrt((r.slip_x or 0) ^ 2 + (r.slip_y or 0) ^ 2 + (r.slip_z or 0) ^ 2)
    tap.ok(math.abs(far) < 1e-15 and r.height == r.com_z, "slip is its length in an expression; height", err)
  end
end

program.finish()
tap.done()
