-- times.lua -- panels over time: components, lengths, angles, drift, errors.
-- SPDX-License-Identifier: GPL-3.0-or-later

local rotation = require "generator.attitude.rotation"
local frame = require "generator.plot.frame"
local space = require "generator.plot.space"

local times = {}

local turns = 24 -- extrema of a curve that a panel shows; more is a block of ink
local colours = { "cx", "cy", "cz", "cn", "ce" }

function times.list(samples, f)
  local out = {}
  for i, s in ipairs(samples) do out[i] = f(s) end
  return out
end
local list = times.list

-- Four digits, for people.
function times.number(x) return (string.gsub(string.format("%.4g", x), "^%-", "−")) end

-- Greatest less least value, and the greatest size.
function times.extent(values)
  local low, high = math.huge, -math.huge
  for _, x in ipairs(values) do low, high = math.min(low, x), math.max(high, x) end
  return high - low, math.max(math.abs(low), math.abs(high))
end

-- The extent in parts of the size: what is constant on paper has a small one.
function times.change(values)
  local extent, size = times.extent(values)
  return size > 0 and extent / size or 0.0
end

-- How many samples show `turns` extrema of each curve; ripples below a hundredth of the panel's range do not count.
local function enough(curves, n)
  local last, range = n, frame.range(list(curves, function(c) return c.values end))
  for _, c in ipairs(curves) do
    local least, count, peak, up = (range[2] - range[1]) / 100, 0, c.values[1], nil
    for i = 1, last do
      local v = c.values[i]
      if up == true and v > peak or up == false and v < peak then
        peak = v
      elseif math.abs(v - peak) > least and not (c.breaks and c.breaks[i]) then
        if up ~= nil then count = count + 1 end
        up, peak = v > peak, v
      elseif c.breaks and c.breaks[i] then
        peak, count = v, count + 1
      end
      if count > turns then
        last = i
        break
      end
    end
  end
  return last
end

-- A panel of curves over time.  p: {title =, note =, y = {name, unit}, curves = {{name, values, class =, breaks =},
-- ...}, whole = all of the time, however often they turn, log =, yrange =, mark =}; ts: the times.
-- The panel says so by `over`, and has these fields and `xrange` until it is drawn: what a user asks for, or a second
-- run (plot/pair.lua), may change them.
function times.panel(ts, p)
  local curves = {}
  for i, c in ipairs(p.curves) do
    curves[i] = { name = c[1], values = c[2], class = c.class or colours[i], breaks = c.breaks, xs = ts }
  end
  local n = p.whole and #ts or enough(curves, #ts)
  local panel = { over = true, title = p.title, note = p.note, shown = ts[n], finish = ts[#ts], whole = p.whole,
    y = p.y, curves = curves, log = p.log, yrange = p.yrange, mark = p.mark }
  function panel.draw(d, box, to)
    to = to or not panel.xrange and panel.shown or math.huge
    local cut = list(panel.curves, function(c)
      local n_of = 0
      while c.xs[n_of + 1] and c.xs[n_of + 1] <= to do n_of = n_of + 1 end
      return { name = c.name, class = c.class, breaks = c.breaks, xs = { table.unpack(c.xs, 1, n_of) },
        values = { table.unpack(c.values, 1, n_of) } }
    end)
    frame.over(d, { box = box, x = { "t", "s" }, y = panel.y, curves = cut, log = panel.log, xrange = panel.xrange,
      yrange = panel.yrange, mark = panel.mark, legend = panel.legend })
  end
  return panel
end

-- One range of time for all panels of curves: to where the first of them would become a block of ink.  Those with all
-- of the time (a drift, an error, a loss of contact at the end) keep it, and say so.  Returns nil, or where the time
-- is cut and where it ends.
function times.together(panels)
  local to, finish = math.huge, 0.0
  for _, p in ipairs(panels) do
    if p.over and not p.whole then to, finish = math.min(to, p.shown), math.max(finish, p.finish) end
  end
  if to >= finish then return nil end
  for _, p in ipairs(panels) do
    if p.over then
      local part = p.whole and "all " or "the first " .. times.number(to) .. " s of "
      p.note = (p.note and p.note .. "; " or "") .. part .. times.number(finish) .. " s"
      p.shown = p.whole and p.shown or to
    end
  end
  return to, finish
end

local function ts_of(course) return list(course.samples, function(s) return s.t end) end

-- The components of a vector of the samples, f(sample), and its length if that has a name.
local function components(course, f, names, length)
  local out, vectors = {}, list(course.samples, f)
  for k, name in ipairs(names) do out[k] = { name, list(vectors, function(v) return v[k] end) } end
  if length then out[#out + 1] = { length, list(vectors, space.length), class = "cn" } end
  return out
end

function times.rates(course)
  local ts = ts_of(course)
  local out = { times.panel(ts, { title = "Angular velocity, body axes", y = { "ω", "rad/s" },
    curves = components(course, function(s) return s.w end, { "ω_x", "ω_y", "ω_z" }, "|ω|") }) }
  if course.samples[1].q then
    out[2] = times.panel(ts, { title = "Angular velocity, " .. (course.framed and "axes of the frame" or
      "inertial axes"), y = { "ω", "rad/s" },
      curves = components(course, function(s) return s.space end, { "ω_X", "ω_Y", "ω_Z" }, "|ω|") })
  end
  return out
end

function times.quaternion(course)
  return times.panel(ts_of(course), { title = "Attitude: quaternion, body to space", y = { "q", "1" },
    yrange = { -1.05, 1.05 }, curves = components(course, function(s) return { s.q[2], s.q[3], s.q[4], s.q[1] } end,
      { "q_x", "q_y", "q_z", "q_w" }) })
end

local greek = { "φ", "θ", "ψ" }

function times.euler(course)
  local angles, curves = list(course.samples, function(s) return rotation.euler(s.q, course.sequence) end), {}
  for k = 1, 3 do
    local values, breaks, last = list(angles, function(a) return math.deg(a[k]) end), {}, nil
    for i, v in ipairs(values) do
      breaks[i] = last ~= nil and math.abs(v - last) > 180
      last = v
    end
    curves[k] = { greek[k], values, breaks = breaks }
  end
  return times.panel(ts_of(course), { title = "Euler angles " .. course.sequence, y = { "φ, θ, ψ", "°" },
    note = "q = q_{" .. string.sub(course.sequence, 1, 1) .. "}(φ) q_{" .. string.sub(course.sequence, 2, 2) ..
      "}(θ) q_{" .. string.sub(course.sequence, 3) .. "}(ψ)", curves = curves })
end

-- Rounding is noise: a few hundred points of it tell what all would.
local function drift(course, title, name, unit, differences, size)
  local ts, values, every = {}, {}, math.max(1, #differences // 400)
  for i = 1, #differences, every do
    ts[#ts + 1], values[#values + 1] = course.samples[i].t, differences[i] / size
  end
  return times.panel(ts, { title = title, y = { name, "1" }, whole = true, note = unit,
    curves = { { "", values } } })
end

-- Is the energy all that it was, but for rounding?
function times.exact(course)
  local E = list(course.samples, function(s) return s.energy end)
  return times.change(E) < 1e-12
end

-- Curves of what changed since the first sample, where that is little of the whole.
local function changes(curves)
  local most, extents = 0.0, 0.0
  for _, c in ipairs(curves) do
    local extent, size = times.extent(c[2])
    most, extents = math.max(most, size), math.max(extents, extent)
  end
  local little = extents < 0.3 * most
  for _, c in ipairs(little and curves or {}) do
    local first = c[2][1]
    c[1], c[2] = "Δ" .. c[1], list(c[2], function(x) return x - first end)
  end
  return little
end

-- The energy, and where it is conserved its drift; the kinetic and the potential part where they are known.
function times.energy(course)
  local E = list(course.samples, function(s) return s.energy end)
  local T = course.kinetic and list(course.samples, course.kinetic)
  local _, size = times.extent(E)
  local out, constant = {}, course.conserved["T+V"]
  local curves = { { "E", E, class = "cn" } }
  if T and times.change(T) > 1e-6 then
    local V = {}
    for i, x in ipairs(T) do V[i] = E[i] - x end
    local _, most = times.extent(V)
    if most > 1e-9 * size then curves[2], curves[3] = { "T", T, class = "cx" }, { "V", V, class = "cy" } end
  end
  if #curves > 1 or not constant then
    local note = #curves > 1 and "T_0 = " .. times.number(T[1]) .. " J, V_0 = " .. times.number(E[1] - T[1]) .. " J"
    local little = #curves > 1 and changes(curves)
    out[1] = times.panel(ts_of(course), { title = little and "Energy: what it changed by" or "Energy", note = note,
      y = { (little and "Δ" or "") .. "E" .. (note and (little and ", ΔT, ΔV" or ", T, V") or ""), "J" },
      curves = curves })
  end
  if constant and not (#out > 0 and times.extent(E) == 0) then
    out[#out + 1] = drift(course, "Drift of the energy, which is conserved", "(E − E_0)/|E|", "E_0 = " ..
      times.number(E[1]) .. " J", list(E, function(x) return x - E[1] end), size > 0 and size or 1.0)
  end
  return out
end

function times.momentum(course)
  local samples, out = course.samples, {}
  local length = list(samples, function(s) return space.length(s.L) end)
  local first, size = samples[1].L, length[1]
  local whole, only = course.conserved.L, course.conserved["|L|"]
  if not whole then
    out[1] = times.panel(ts_of(course), { title = "Angular momentum, inertial axes", y = { "L", "N m s" },
      curves = components(course, function(s) return s.L end, { "L_X", "L_Y", "L_Z" }, "|L|") })
  end
  if (whole or only) and size > 0 then
    local far = list(samples, function(s)
      if not whole then return space.length(s.L) - length[1] end
      return space.length { s.L[1] - first[1], s.L[2] - first[2], s.L[3] - first[3] }
    end)
    out[#out + 1] = drift(course, whole and "Drift of the angular momentum, which is conserved" or
      "Drift of |L|, which is conserved", whole and "|L − L_0|/|L_0|" or "(|L| − |L_0|)/|L_0|", "|L_0| = " ..
      times.number(length[1]) .. " N m s", far, size)
  end
  return out
end

function times.momentum_body(course)
  return times.panel(ts_of(course), { title = "Angular momentum, body axes", y = { "L", "N m s" },
    curves = components(course, function(s) return rotation.back(s.q, s.L) end, { "L_x", "L_y", "L_z" }, "|L|") })
end

-- The reaction of a plane; where it becomes 0, contact is lost, and a line tells when.
function times.reaction(course)
  local lost = course.lost
  return times.panel(ts_of(course), { title = "Normal force of the plane", y = { "N", "N" }, whole = lost ~= nil,
    note = lost and "contact is lost at t = " .. times.number(lost) .. " s, where N becomes 0",
    mark = lost and { lost, "contact lost" }, curves = { { "N", list(course.samples, function(s) return s.N end),
      class = "cn" } } })
end

-- Where a logarithmic axis begins: below it is what a curve has at its start, where an error grows from 0, and where it
-- happens to pass 0.  Of each curve a fiftieth of the time and a fiftieth of the values may be there.
local function lowest(ts, curves, high)
  local low = high
  for _, c in ipairs(curves) do
    local later = {}
    for i, x in ipairs(c.values) do
      if x > 0 and ts[i] > ts[#ts] / 50 then later[#later + 1] = x end
    end
    table.sort(later)
    low = math.min(low, later[1 + #later // 50] or high)
  end
  return low
end

-- The difference of two runs, on a logarithmic scale; where it is 0 there is no curve.
function times.difference(course)
  local e = course.error
  local high = 0.0
  for _, c in ipairs(e.curves) do
    for _, x in ipairs(c.values) do high = math.max(high, x) end
  end
  if high == 0 then high = 1e-16 end
  local from = math.floor(math.log(math.max(lowest(e.ts, e.curves, high), 1e-19), 10))
  local to = math.max(math.ceil(math.log(high, 10)), from + 1)
  return times.panel(e.ts, { title = "Difference of " .. e.names[1] .. " and " .. e.names[2], whole = true,
    note = "attitude: |q − q'|; all else: in parts of the largest", y = { "difference", "1" },
    curves = list(e.curves, function(c) return { c.name, c.values } end), log = true,
    yrange = { 10.0 ^ from, 10.0 ^ to } })
end

-- Curves of columns that a user asks for: {title =, note =, list of {name =, unit =, place in sample.asked}}.  What has
-- a name with a blank or brackets is named in a legend.
function times.asked(course, one)
  local curves, units, names = {}, {}, {}
  for i, c in ipairs(one) do
    local values, breaks = list(course.samples, function(s) return s.asked[c.place] end), {}
    for k = 2, c.unit == "rad" and #values or 0 do -- an angle that goes on at the other end of its range
      breaks[k] = math.abs(values[k] - values[k - 1]) > math.pi
    end
    curves[i] = { (string.gsub(c.name, "^(%a%w*)_([%w_]+)$", function(a, b)
      return a .. "_{" .. string.gsub(b, "_", " ") .. "}"
    end)), values, breaks = breaks, class = colours[(i - 1) % #colours + 1] }
    units[c.unit or "1"], names[i] = true, curves[i][1]
  end
  local unit = next(units)
  local all = table.concat(names, ", ")
  return times.panel(ts_of(course), { title = one.title, note = one.note, curves = curves,
    y = next(units, unit) and { all, "1" } or { all, unit } })
end

return times
