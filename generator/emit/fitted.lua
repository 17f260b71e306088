-- fitted.lua -- what `polhode fit` calls of a scene as C: templates/fit/fitted.c filled from plan.fit.
--
--     fitted.fill(job, made) -> the text of fitted.c; made: from code.of
-- job.fit is from dynamics/tangents.lua.  The directions stand side by side in the lanes of a loop that compilers turn
-- into vector instructions; the step itself stands once before it.
-- SPDX-License-Identifier: GPL-3.0-or-later

local calculus = require "generator.algebra.calculus"
local lanes = require "generator.emit.lanes"
local number = require "generator.emit.number"
local source = require "generator.emit.source"
local special = require "generator.emit.special"
local template = require "generator.emit.template"

local fitted = {}

local GROUP = template.group("fit/fitted.c")

local LANES = 4 -- numbers in a vector of 256 bits: directions are filled up to a multiple of it

local function int(n) return string.format("%d", n) end

-- Where the step reads: members of the model, states, time; and, in lanes, the derivatives of both.
local function step_inputs(ctx, fit)
  local list = {}
  local function put(sym, c, rank, lane) list[#list + 1] = { sym = sym, c = c, rank = rank, lane = lane } end
  for _, member in ipairs(ctx.members) do put(member.name, "m->" .. member.name, 3, false) end
  for i, s in ipairs(fit.states) do
    put(s.name, "x[" .. int(i - 1) .. "]", 8, false)
    put("s0_" .. s.name, "s[" .. int(i - 1) .. "]", 8, true)
  end
  for i, row in ipairs(fit.constants) do put("k0_" .. row.name, "k0[" .. int(i - 1) .. "]", 8, true) end
  for i, s in ipairs(fit.inputs) do
    put("u0_" .. s.label, "u[" .. int(i) .. "]", 8, false)
    put("u1_" .. s.label, "u[" .. int(#fit.inputs + i) .. "]", 8, false)
  end
  if #fit.inputs > 0 then put("tu", "u[0]", 8, false) end
  put("t", "t", 8, false)
  put("h", "h", 6, false)
  return list
end

-- The step and its derivatives in lanes: y[] are the new states, s[] the rows of derivatives.
local function step_lines(ctx, fit)
  local groups = {}
  for i, g in ipairs(fit.step) do
    local outs = {}
    for k, o in ipairs(g.outs) do
      outs[k] = { c = (o.lane and "s[" or "y[") .. int(o.row) .. "]", expr = o.expr }
    end
    groups[i] = { why = g.why, where = g.where, defs = g.defs, outs = outs }
  end
  return lanes.make(ctx, { name = "along", args = { "m", "t", "h" }, inputs = step_inputs(ctx, fit),
    groups = groups }, false)
end

local TAKEN = { p = true, t = true, x = true, s = true, y = true, G = true, J = true, real = true, m = true }

local function measure_lines(job, ctx, base, fit)
  local own = {}
  for _, s in ipairs(fit.states) do own[s.name] = true end
  local inputs, map = source.parameters({ upper = base.upper }, job.model.params, function(word)
    return TAKEN[word] or own[word] or job.model.members[word] ~= nil
  end)
  for i, s in ipairs(fit.states) do inputs[#inputs + 1] = { sym = s.name, c = "x[" .. int(i - 1) .. "]", rank = 8 } end
  inputs[#inputs + 1] = { sym = "t", c = "t", rank = 8 }
  local groups = {}
  for i, g in ipairs(fit.measure) do
    local outs = {}
    for k, o in ipairs(g.outs) do
      outs[k] = { array = o.array, index = int(o.index), expr = calculus.substitute(o.expr, map) }
    end
    groups[i] = { why = g.why, defs = g.defs, outs = outs }
  end
  local function array(name, count, out) return { name = name, count = count, out = out } end
  return source.make(ctx, { name = "measured", args = { array("p", 0), "t", array("x", 0), array("y", 0, true),
    array("G", 0, true) }, inputs = inputs, groups = groups }).lines
end

-- Statements of the derivatives J of what is measured: those of the loop over the lanes, and those after it.
-- dy/dp along a direction: dy/dx dx/dp in the lanes, and dy/dp of the parameters that stand in y itself.
local function slope_lines(fit)
  local loop, after = {}, {}
  for v, own in ipairs(fit.slopes) do
    local sum, row = {}, "J[" .. int(v - 1) .. "*LANES + "
    for i, at in ipairs(own.state) do
      sum[i] = "G[" .. int(at[2]) .. "]*s[" .. int(at[1]) .. "*LANES + lane]"
    end
    loop[v] = row .. "lane] = " .. (#sum > 0 and table.concat(sum, " + ") or "0") .. ";"
    for _, at in ipairs(own.param) do
      after[#after + 1] = row .. int(at[1]) .. "] += G[" .. int(at[2]) .. "];"
    end
  end
  return loop, after
end

-- A number of the model as C: what was made a constant of it, or a literal.
local function value(e) return e.kind == "num" and number.text(e.value, "double") or "m->" .. e.name end

-- Statements that set entry [i][k] of an array for all that is not 0.
local function filled(name, rows)
  local lines = {}
  for i, row in ipairs(rows) do
    for k, e in ipairs(row) do
      local text = value(e)
      if e.kind ~= "num" or tonumber(text) ~= 0 then
        lines[#lines + 1] = name .. "[" .. int(i - 1) .. "][" .. int(k - 1) .. "] = " .. text .. ";"
      end
    end
  end
  return lines
end

-- What the lines call and the C library lacks: those of the scene's own file are static there.
local function helpers(job, ctx, base)
  if not special.used(ctx) then return "" end
  local used = {}
  for name in pairs(ctx.helpers) do used[name] = true end -- a set: any order
  return special.pair(job.templates, base, true, true) .. "\n" .. special.text(job.templates, base, ctx, used)
end

function fitted.fill(job, made)
  local fit, v, base = job.fit, {}, made.base
  local ctx = setmetatable({ helpers = {} }, { __index = made.ctx })
  local along = step_lines(ctx, fit)
  local turn = nil -- where the attitude begins
  v.states, v.common, v.loop = {}, along.common, along.lines
  for i, s in ipairs(fit.states) do
    v.states[i] = { row = int(i - 1), place = base.upper .. "_" .. string.upper(s.name) }
    if s.name == "qw" then turn = i - 1 end
  end
  local rows = {}
  for i, row in ipairs(fit.constants) do rows[i] = row.by end
  v.constant_lines, v.start_lines = filled("k0", rows), filled("s", fit.start)
  v.measure_lines = fit.values > 0 and measure_lines(job, ctx, base, fit) or
    { "(void)p;", "(void)t;", "(void)x;", "(void)y;" }
  v.slope_loop, v.slope_after = slope_lines(fit)
  v.slope_room = int(math.max(1, fit.slope_count))
  v.helpers = helpers(job, ctx, base)
  v.state_count, v.constant_count, v.value_count = int(#fit.states), int(#fit.constants), int(fit.values)
  v.constant_room = int(math.max(1, #fit.constants))
  v.input_count = int(#fit.inputs)
  v.free_count, v.attitude = int(#fit.free), int(turn or -1)
  local directions = #fit.free + (job.fit.initial or 0)
  v.lanes = int(LANES * math.max(1, math.ceil(directions / LANES)))
  return GROUP(job.templates, base, v) "fit/fitted.c"
end

return fitted
