-- disc.lua -- docs/disc.svg: how far the contact point of a dropped disc runs round, over how flat the disc falls.
--
--     lua5.4 docs/tools/disc.lua FILE
-- Radius 0.1 m, a sharp edge, dropped from 0.5 rad with no spin about the axis and ever less precession.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path

local svg = require "generator.draw.svg"
local swings = require "generator.dynamics.disc"

local picture = {}

local start = 0.5 -- rad

-- {least tilt in rad, turn in deg} of a disc with these moments per m R^2.
local function falls(I1, I3)
  local list, d = {}, swings.of(I1 * 0.01, I3 * 0.01, 1.0, 0.1, 0.0, 9.80665)
  for k = -30, 3 do
    local a = 10.0 ^ (k / 4)
    local f = swings.swing(d, { s = math.sin(start), c = math.cos(start), a = a, w = 0.0 }, 0.0)
    list[#list + 1] = { math.atan(f.least.s, f.least.c), math.deg(f.turn) }
  end
  return list, math.deg(swings.flat_turn(d))
end

function picture.text()
  local doc = svg.new(560, 330, { title = "How far the contact point of a dropped disc runs round",
    about = "Two curves of an angle over the least tilt. Where it is small they are at 403 degrees for a uniform " ..
      "disc and at 312 for a hoop, elsewhere they rise." })
  local scale = svg.frame(doc, { x0 = 70, y0 = 40, x1 = 530, y1 = 270, xrange = { 1e-9, 1 }, yrange = { 280, 460 },
    xlog = true, xlabel = "least tilt, rad", ylabel = "turn between two greatest heights, deg" })
  doc:text(70, 24, "A disc dropped from 0.5 rad", "title")
  for _, row in ipairs { { 0.25, 0.5, "a", "uniform disc" }, { 0.5, 1.0, "b", "hoop" } } do
    local list, limit = falls(row[1], row[2])
    local x0, y = scale.at(1e-9, limit)
    doc:line(x0, y, 530, y, "axis dashed")
    doc:text(80, y - 7, string.format("%s: %.2f deg", row[4], limit), "label")
    local points = {}
    for i, p in ipairs(list) do points[i] = { scale.at(p[1], p[2]) } end
    doc:path(points, "curve " .. row[3])
  end
  return svg.text(doc)
end

if arg and arg[0] and arg[0]:find "disc%.lua$" then
  local file = assert(io.open(arg[1], "w"))
  file:write(picture.text())
  file:close()
end

return picture
