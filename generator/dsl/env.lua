-- env.lua -- the words a scene script can use, and the run of one script.
--
-- The environment holds the scene language and the host's safe subset of the base library: no io, os, require,
-- load, debug, metatables or coroutines; `pairs` visits keys in sorted order, so that the same scene is the same
-- everywhere.  A name that is not there is an error (dsl/undefined.lua).  The host's sandbox bounds memory, steps and
-- time.  `record` returns the checked record of the scene, or nil after errors, which are in the diagnostics.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local coordinate = require "generator.algebra.coordinate"
local expr = require "generator.algebra.expr"
local args = require "generator.dsl.args"
local contact = require "generator.dsl.contact"
local input = require "generator.dsl.input"
local names = require "generator.dsl.names"
local scene = require "generator.dsl.scene"
local shapes = require "generator.dsl.shapes"
local units = require "generator.dsl.units"
local unitnames = require "generator.dsl.unitnames"
local value = require "generator.dsl.value"
local inertial = require "generator.dsl.inertial"
local mesh = require "generator.dsl.mesh"
local slips = require "generator.dsl.slips"
local undefined = require "generator.dsl.undefined"
local watched = require "generator.dsl.watched"
local moving = require "generator.dsl.moving"
local diag = require "generator.diag"
local broken = require "generator.diag.broken"

local env = {}

-- "kg m^2" -> exact factor and dimension; reports on the user's line, and then the third result is true.
local function unit(ctx, what, given)
  if given == nil then return expr.one, nil end
  if type(given) ~= "string" then
    local line = ctx.diag:here()
    ctx.diag:error(line, what, "unit must be a string such as \"kg m^2\"" .. slips.comma(ctx.diag, line),
      diag.show(given))
    return expr.one, nil, true
  end
  local factor, dim = nil, "must have at most 60 characters"
  if #given <= 60 then factor, dim = units.parse(given) end
  if not factor then
    local quoted = string.find(dim, diag.show(given), 1, true) -- said once
    ctx.diag:error(ctx.diag:here(), what, "unit: " .. dim, not quoted and diag.show(given) or nil)
    return expr.one, nil, true
  end
  return factor, dim
end

-- A plain number as a rational; after an error 1, so that what follows goes on.
local function number(ctx, what, name, given)
  local q, why = nil, "must be a plain number"
  if not value.is(given) then q, why = R.lift(given) end
  if not q then
    local meant = slips.number(given, "the unit is a text of its own: %s, \"%s\"")
    ctx.diag:error(ctx.diag:here(), what, name .. " " .. why .. meant, diag.show(given))
    return R.one
  end
  return q
end

-- param(name, default, unit): a symbol that stays one, down to the emitted code.
local function param(ctx, params)
  local seen = ctx.named
  return function(name, default, u)
    local line = ctx.diag:here()
    local rule = names.parameter(name)
    if rule then
      ctx.diag:error(line, "param", "name " .. rule .. slips.name(name), diag.show(name))
      return value.new(expr.one, nil)
    end
    local upper = string.upper(name)
    if seen[upper] then
      local other, kind = table.unpack(seen[upper])
      ctx.diag:error(line, "param", other == name and "name is already " .. kind or
        "name differs only in capitals from " .. other, diag.show(name))
      return value.new(expr.one, nil)
    end
    seen[upper] = { name, "a parameter" }
    local factor, dim, wrong = unit(ctx, "param", u)
    if wrong then
      ctx.used[name] = true -- (--set)
      number(ctx, "param", "default of " .. name, default)
      return broken.object -- what is computed from it is not blamed again
    end
    u = dim and unitnames.plain(u)
    if ctx.set[name] then
      default = ctx.set[name]
      ctx.used[name] = true
    end
    local given = (ctx.set[name] or diag.show(default)) .. (dim and " " .. u or "")
    local default_si = expr.num(number(ctx, "param", "default of " .. name, default)) * factor
    local is_mass = dim and units.equal(dim, units.mass)
    local positive = dim and is_mass -- a length may be a coordinate; the shapes check their own sizes
    local sym = expr.sym(name, is_mass and 1 or 2, positive)
    local q = value.number(default_si)
    value.default(sym, q)
    if positive then
      args.condition(ctx, line, "param", name .. " must be positive", expr.num(q), given)
      ctx.checks[#ctx.checks + 1] = { e = sym, what = "param", rule = name .. " must be positive", line = line }
    end
    params[#params + 1] = { name = name, sym = sym, default = q, unit = units.si(dim or units.none), line = line,
      given = given, own = u or nil, factor = factor }
    return value.counts(value.write(value.new(sym, dim), default, factor), u)
  end
end

-- quantity(number, unit): an exact constant with a unit.
local function quantity(ctx)
  return function(n, u)
    local factor, dim, wrong = unit(ctx, "quantity", u)
    local q = number(ctx, "quantity", "the number", n)
    if wrong then return broken.object end
    local v = value.write(value.new(expr.num(q) * factor, dim), n, factor)
    return value.counts(v, u)
  end
end

-- A table of constructors {solid = {box = f, ...}, tensor = f, ...} from names such as "solid.box".
local function tree(host, list, make)
  local out = {}
  local function constructor(spec) return host.visible(make(spec)) end
  for _, spec in ipairs(list) do
    local family, name = string.match(spec.name, "^(%w+)%.([%w_]+)$")
    if family then
      out[family] = out[family] or {}
      out[family][name] = constructor(spec)
    else
      out[spec.name] = constructor(spec)
    end
  end
  return out
end

-- Families report an unknown name on the user's line.
local function strict(ctx, family, t)
  ctx.families[family] = args.keys(t)
  return setmetatable({}, {
    __index = function(_, k)
      if t[k] then return t[k] end
      undefined.member(ctx, family, k, ctx.families[family])
      return broken.object
    end,
    __newindex = function() ctx.diag:error(ctx.diag:here(), family, "cannot be changed") end,
    __tostring = function() return family end,
  })
end

local effect_object = { __name = "effect", __tostring = function() return "an effect" end }
local scene_object = { __name = "scene", __tostring = function() return "a scene" end }

-- Effects: opaque handles {kind=, a={args}, line=}.
local function effect_constructor(ctx, record)
  return function(spec)
    local what = "effect." .. string.match(spec.name, "([%w_]+)$")
    return function(given)
      local line = ctx.diag:here()
      local a, ok
      if given ~= nil and not args.plain(given) then
        ctx.diag:error(line, what, "takes a table of named arguments", diag.show(given))
      elseif spec.read or spec.reader then
        a = (spec.read or moving[spec.reader])(ctx, line, what, given or {}, args)
        ok = a ~= nil
      else
        a, ok = args.read(ctx, line, what, spec.args, given or {})
      end
      local refused = ok and a and spec.refuse and spec.refuse(a, given or {})
      if refused then
        ctx.diag:error(line, what, refused)
        ok = false
      end
      for _, c in ipairs(ok and a and spec.check and spec.check(a) or {}) do
        local got = args.named(spec.args or args.specs(given), c[2], given or {})
        ok = args.condition(ctx, line, what, c[2], c[1], got) and ok
      end
      local h = setmetatable({}, effect_object)
      record[h] = { kind = spec.name, spec = spec, a = a or {}, line = line, broken = not ok or a == nil }
      return h
    end
  end
end

-- The last line of the text with something on it.
local function last_line(d)
  for n = #d.lines, 2, -1 do
    if string.find(d.lines[n], "%S") then return n end
  end
  return 1
end

-- What a scene may name: the host's safe part of Lua, shapes, effects, the other constructors, numbers and functions of
-- values, words of the motion.  effects: filled with what the script makes, by its handle.
local function environment(ctx, tables, params, inputs, effects)
  local host, e = ctx.host, {}
  for _, k in ipairs(args.keys(host.safe)) do e[k] = host.safe[k] end
  local made = tree(host, tables.shapes, function(spec)
    return shapes[spec.reader or ""] or shapes.constructor(spec)
  end)
  for _, k in ipairs(args.keys(made)) do
    e[k] = type(made[k]) == "table" and strict(ctx, k, made[k]) or made[k]
  end
  e.inertial, e.mesh = host.visible(inertial.constructor(ctx)), host.visible(mesh.constructor(ctx))
  local effect = effect_constructor(ctx, effects)
  e.effect = strict(ctx, "effect", tree(host, tables.effects, effect).effect)
  e.contact = strict(ctx, "contact", tree(host, contact.kinds, contact.constructor(ctx)).contact)
  e.param, e.quantity = param(ctx, params), quantity(ctx)
  e.input = input.constructor(ctx, inputs, function(u) return unit(ctx, "input", u) end)
  e.exact = function(s)
    return value.write(value.new(expr.num(number(ctx, "exact", "the number", s)), nil), s, expr.one)
  end
  for i, s in ipairs(coordinate.symbols) do e[coordinate.names[i]] = value.new(s, units.length, true) end
  for _, s in ipairs(moving.words) do e[s[1]] = moving.value(s) end
  e.pi = value.new(expr.pi, nil)
  for _, f in ipairs(value.functions) do e[f[1]] = value.func(table.unpack(f)) end
  return e
end

-- Tells of a script that Lua stopped.  What comes from the generator's own lines is a bug and raised again.
local function stopped(d, raised)
  local text, source = raised.message or "", raised.source or ""
  local excess = string.find(text, "stack overflow", 1, true) or string.find(text, "number too large", 1, true)
  if raised.kind == "runtime" and not excess and source ~= d.file and string.find(source, "^generator/") then
    error(raised.message .. "\n" .. raised.traceback, 0)
  end
  -- what the scene does after an unknown name may be its consequence: it is not told where Lua itself says so, by
  -- the mark, nor that the script took too long
  local by_lua = raised.kind == "syntax" or raised.kind == "runtime"
  if d:failed() and (not by_lua or string.find(text, broken.mark, 1, true)) then return end
  local message = string.gsub(string.gsub(text, "^.-:%d+: ", ""), "%c", " ") -- may steer a terminal
  local word = raised.kind == "syntax" and string.match(message, "near '(%a+)'$")
  local line, said = raised.line or 0, message
  if raised.kind == "syntax" then line, said = slips.syntax(d, line, message) end
  if said == message and word and units.parse(word) then
    said = message .. " (a unit is given by quantity(30, \"" .. word .. "\"))"
  end
  message = said
  d:error(line, raised.kind == "syntax" and "syntax" or "script", message)
end

-- The emitted code's own names begin with the scene's: no parameter, no input and nothing of an effect may.
local function names_apart(d, result, params, inputs)
  local function apart(line, what, name)
    if string.find(name, "^" .. result.name .. "_") then
      d:error(line, what, "name must not begin with " .. result.name .. "_, as the emitted code's own names do",
        diag.show(name))
    end
  end
  for _, p in ipairs(params) do apart(p.line, "param", p.name) end
  for _, i in ipairs(inputs) do apart(i.line, "input", i.name) end
  for _, e in ipairs(result.effects) do
    for _, own in ipairs(e.kind == "effect.custom" and { e.a.params, e.a.states } or {}) do
      for _, x in ipairs(own) do apart(e.line, e.kind, x.name) end
    end
  end
end

-- Runs the script in the host's sandbox.  tables: {shapes =, effects =} (the catalogues), quantities = (words of
-- events, attitude/quantities.lua); set: {name = "0.3"} replaces
-- parameters' defaults (in their own units); renamed: in place of the scene's name.  Returns the scene record with
-- .params and .checks, or nil when d has errors; second result: the first name of `set` that is no parameter.
function env.record(host, d, text, tables, set, renamed)
  local ctx = { diag = d, host = host, checks = {}, set = set or {}, used = {}, named = {}, families = {} }
  local params, inputs, effects = {}, {}, setmetatable({}, { __mode = "k" })
  value.begin(d)
  shapes.begin(ctx, host.visible)
  local e = environment(ctx, tables, params, inputs, effects)
  local result, calls, scene_handle = nil, 0, nil
  e.scene = scene.constructor(ctx, function(h) return effects[h] end, function(s)
    calls, result, scene_handle = calls + 1, s, setmetatable({}, scene_object)
    return scene_handle
  end)
  undefined.guard(ctx, e, params, watched.new(ctx, tables.quantities or {}))

  text = string.gsub(text, "^\239\187\191", "") -- a byte order mark, as some editors write it
  local ok, first = host.sandbox(text, "@" .. d.file, e)
  if not ok then
    stopped(d, first)
    return nil
  end
  if not d:failed() then
    if calls == 0 then
      d:error(last_line(d), "scene", "the script must end with: return scene { ... }")
    elseif calls > 1 then
      d:error(result.line, "scene", "must be called once", calls .. " calls")
    elseif first ~= scene_handle then
      d:error(result.line, "scene", "the script must return its scene", value.show(first))
    end
  end
  if renamed and result then result.name = renamed end
  watched.idle(ctx)
  if not d:failed() then names_apart(d, result, params, inputs) end
  if d:failed() then return nil end
  result.params, result.inputs, result.checks, result.files = params, inputs, ctx.checks, ctx.files or {}
  for _, name in ipairs(args.keys(ctx.set)) do
    if not ctx.used[name] then return result, name end
  end
  return result
end

return env
