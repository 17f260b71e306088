#!/usr/bin/env lua5.4
-- touch.t - polhode plot of bodies on a plane: the contact point's path, the normal force, the loss of contact.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Curves are read back from the picture through its ticks and compared with textbook motions.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"

local function run(arguments)
  return program.output(string.format("timeout 120 %s %s", binary, arguments))
end

-- The curves of a picture of one panel in its own units: a list of {x, y} of the path of a class, and the size of a
-- pixel in x and in y.
local function curve(text, class)
  local function scale(pattern, shift)
    local at, value = {}, {}
    for pixel, tick in text:gmatch(pattern) do
      at[#at + 1], value[#value + 1] = tonumber(pixel) - shift, tonumber((tick:gsub("−", "-")))
    end
    local n = #at
    local size = (value[n] - value[1]) / (at[n] - at[1])
    return function(pixel) return value[1] + (pixel - at[1]) * size end, math.abs(size)
  end
  local x, dx = scale('<text class="tick" x="([%d.]+)" y="[%d.]+" text%-anchor="middle">([^<]*)</text>', 0)
  local y, dy = scale('<text class="tick" x="[%d.]+" y="([%d.]+)" text%-anchor="end">([^<]*)</text>', 4)
  local list, px, py, numbers = {}, 0, 0, {}
  local data = text:match('<path class="' .. class .. '" d="([^"]*)"')
  for number in data:gmatch "%-?%d*%.?%d+" do numbers[#numbers + 1] = tonumber(number) end
  for i = 1, #numbers, 2 do
    px, py = px + numbers[i], py + numbers[i + 1]
    list[#list + 1] = { x(px), y(py) }
  end
  return list, dx, dy, x
end

local paper = "tenths of a pixel in both coordinates, 0.12 of the curve, 0.05 of a tick's place"

-- ---- a homogeneous ball on a turntable: a circle (Milne, Vectorial Mechanics, 1948, section 326) ----

do
  -- V' = 2/7 Omega n x V, so the radius is |V0|/(2/7 Omega), and the centre p0 + n x V0/(2/7 Omega); at the start the
  -- ball's lowest point has the table's velocity: V0 = Omega n x p0 + r w0 x n
  local _, text, err = run "plot bodies/turntable_ball.lua --what contact"
  local turn, p0, r, w0 = 33 * 2 * math.pi / 60, { 0.1, 0.0 }, 0.02, { 0.0, 5.0 }
  local V = { -turn * p0[2] + r * w0[2], turn * p0[1] - r * w0[1] }
  local rate = 2 / 7 * turn
  local radius, centre = math.sqrt(V[1] ^ 2 + V[2] ^ 2) / rate, { p0[1] - V[2] / rate, p0[2] + V[1] / rate }
  local points, pixel = curve(text, "trace")
  local worst = 0.0
  for _, p in ipairs(points) do
    local d = math.sqrt((p[1] - centre[1]) ^ 2 + (p[2] - centre[2]) ^ 2)
    worst = math.max(worst, math.abs(d - radius))
  end
  tap.ok(err == "" and #points > 50, "turntable: a path", err)
  tap.near(worst, 0, 0, 0.4 * pixel, "turntable: it is the textbook's circle, to 0.4 pixels", paper)
  tap.near(points[1][1], p0[1], 0, 0.4 * pixel, "turntable: from where the ball was put down", paper)
  _, text = run "plot bodies/turntable_ball.lua --what normal_force --until 1"
  local line, _, newton = curve(text, "line cn")
  for _, p in ipairs { line[1], line[#line] } do
    tap.near(p[2], 0.26 * 9.80665, 0, 0.4 * newton, "turntable: N is the weight", paper)
  end
  tap.ok(not text:find("contact lost", 1, true), "turntable: contact is kept")
  -- T + V with V = m g r: the energy's parts include the motion of the centre of mass
  _, text = run "plot bodies/turntable_ball.lua --what energy --until 1"
  local height, _, joule = curve(text, "line cy")
  tap.near(height[#height][2], 0.26 * 9.80665 * r, 0, 0.4 * joule, "turntable: the potential energy is m g r", paper)
end

-- ---- a ball with its mass off the middle, without friction, goes over the top and hops ----
--
-- The centre of mass, a below the middle, moves on a vertical line: height R - a cos s, s the turn about x.  So
--     N = m (g + a cos s s'^2)/(1 + m a^2 sin^2 s/I),   (I + m a^2 sin^2 s) s'^2/2 - m g a cos s = const
-- and with c = -cos s, N = 0 where s'^2 = g/(a c).

do
  local m, I, a, g, w0 = 1, 0.001, 0.05, 9.81, 60
  program.write(dir .. "/hop.lua", [[
return scene {
  name = "hop",
  body = tensor { mass = 1, xx = 0.001, yy = 0.001, zz = 0.001 },
  effects = { effect.plane { surface = contact.sphere { r = 0.1, at = { 0, 0, 0.05 } }, law = "smooth",
    gravity = 9.81 } },
  initial = { omega = { 60, 0, 0 } },
  time = { horizon = 2, step = 0.0005 },
}
]])
  local function rate(s) -- s'
    return math.sqrt((I * w0 ^ 2 + 2 * m * g * a * (math.cos(s) - 1)) / (I + m * a ^ 2 * math.sin(s) ^ 2))
  end
  local low, high = math.pi / 2, math.pi
  for _ = 1, 60 do
    local s = (low + high) / 2
    if g + a * math.cos(s) * rate(s) ^ 2 > 0 then low = s else high = s end
  end
  local n, when = 2000, 0.0 -- Simpson's rule: its error is far below 1e-6 s
  for i = 0, n do when = when + ((i == 0 or i == n) and 1 or i % 2 == 1 and 4 or 2) / rate(low * i / n) end
  when = when * low / n / 3
  local status, text, err = run("plot " .. dir .. "/hop.lua --what normal_force")
  tap.ok(status == 0 and err:find(string.format("contact is lost at t = %.4g s", when), 1, true),
    "hop: a warning says when contact is lost", err)
  local line, second, newton, x = curve(text, "line cn")
  tap.near(line[1][2], m * (g + a * w0 ^ 2), 0, 0.4 * newton, "hop: N begins with the weight and m a w^2", paper)
  tap.near(line[#line][2], 0, 0, 0.4 * newton, "hop: and ends with 0", paper)
  tap.near(line[#line][1], when, 0, 0.4 * second, "hop: when contact is lost", paper)
  local mark = tonumber(text:match '<line class="ring" x1="([%d.]+)"')
  tap.near(x(mark), when, 0, 0.4 * second, "hop: a line marks it", paper)
  tap.like(text, "contact lost", "hop: with words")
  text = select(2, run("plot " .. dir .. "/hop.lua --what contact"))
  local points, pixel = curve(text, "trace")
  -- turned by s about x the middle is at y = -a sin s from the centre of mass, which keeps to its vertical line
  tap.near(points[#points][2], -a * math.sin(low), 0, 0.4 * pixel, "hop: the path ends under the ball's middle", paper)
  tap.like(text, "contact lost", "hop: the path's end is marked")
  local _, same = run("plot " .. dir .. "/hop.lua --what normal_force --method taylor --engine generated")
  local other = curve(same, "line cn")
  tap.near(other[#other][1], when, 0, 0.4 * second, "hop: by the emitted code, too", paper)

  local csv = dir .. "/hop.csv"
  run("run " .. dir .. "/hop.lua --columns t,q,w,N,contact_point --every 0.0005 -o " .. csv)
  status, text, err = run("plot " .. dir .. "/hop.lua --what normal_force --from " .. csv)
  line, second = curve(text, "line cn")
  tap.ok(status == 0 and err == "" and text:find("contact lost", 1, true), "hop: so does a table that run wrote", err)
  tap.near(line[#line][1], when, 0, 0.4 * second, "hop: with its time", paper)
  status, text, err = run("plot --from " .. csv .. " --what contact")
  tap.ok(status == 2 and text == "" and err:find("name the SCENE, too", 1, true), "a table alone has no plane", err)
end

-- ---- what there is, and what not ----

do
  local status, text, err = run "plot bodies/rolling_coin.lua"
  tap.ok(status == 0 and err:find "^note: curves over time show" and text:find("Path of the contact point", 1, true) and
    text:find("Normal force of the plane", 1, true), "both are in the sheet of a body on a plane", err)
  status, text, err = run "plot bodies/brick.lua --what contact,normal_force"
  tap.ok(status == 2 and text == "" and err:find("contact: the body touches no plane", 1, true) and
    err:find("; normal_force: the body touches no plane", 1, true), "and have a reason where there is none", err)
  -- 30 degrees about x: e2 = n x e1 is tilted, and the picture says so
  program.write(dir .. "/slope.lua", [[
return scene {
  name = "slope",
  body = solid.sphere { r = 0.1, mass = 1 },
  effects = { effect.plane { surface = contact.sphere { r = 0.1 }, normal = { 0, -1, 1 } } },
  initial = { omega = { 0, 0, 0 } },
  time = { horizon = 1, step = 0.001 },
}
]])
  status, text, err = run("plot " .. dir .. "/slope.lua --what contact")
  tap.ok(status == 0 and text:find("0.7071, 0.7071)", 1, true), "a tilted plane's axes are told", err)
  local points, pixel = curve(text, "trace")
  -- a homogeneous ball rolls down with 5/7 g sin 45 degrees
  tap.near(math.abs(points[#points][2]), 5 / 7 * 9.80665 * math.sin(math.pi / 4) / 2, 0, 0.4 * pixel,
    "a ball rolls down it as Galilei's", paper)
  text = select(2, run("plot " .. dir .. "/slope.lua --what normal_force"))
  local line, _, newton = curve(text, "line cn")
  tap.near(line[#line][2], 9.80665 * math.cos(math.pi / 4), 0, 0.4 * newton, "pressed on by m g cos 45 degrees", paper)
end

program.finish()
tap.done()
