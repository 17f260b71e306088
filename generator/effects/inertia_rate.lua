-- inertia_rate.lua -- parts that move or burn in the body: the tensor changes with time.
--
-- What is given is what the parts ADD to the body's tensor, as expressions of t: with I the body's own and D(t) these,
--     L = (I + D) w,    (I + D) w' = L x w - D' w + N
-- as follows from dL/dt|body + w x L = N when the parts have no angular momentum of their own relative to the body axes
-- (they move symmetrically, or along lines through the origin; what burns leaves without a torque).  The centre of mass
-- and the mass stay as the body has them.  L in inertial axes is conserved, T is not.
-- Energy and momentum have to know the time, so it is a state, `clock`, with clock' = 1 from 0: the t of these
-- expressions.  NAME_inertia is the body's own tensor; NAME_inertia_now(m, x, I) is I + D of the state.
-- I + D must be a body's tensor for all times that are asked for (dynamics/exists.lua).
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local motion = require "generator.algebra.motion"
local vec = require "generator.algebra.vec"

local rate = {
  name = "effect.inertia_rate",
  about = "moving or burning parts: what they add to the tensor as expressions of t, xx .. yz",
  single = true, keeps = "L and |L|",
  takes = { { "xx, yy, zz, xy, xz, yz", "kg m^2", "0", "entry of D(t): a number or an expression of t" } },
  idle = { {}, "no entry is given, or all are 0" },
  formula = "(I + D) w' = L x w - D' w + N, L = (I + D) w",
  signs = "D is added to the body's tensor (off-diagonals are tensor entries); D' w > 0 slows the body down",
  source = "dL/dt = N with L = (I + D) w: Goldstein, Poole, Safko, Classical Mechanics, 3rd ed., 5.37, before I " ..
    "is taken constant",
  example = "skater",
}

function rate.read(ctx, line, what, given, args)
  local a, ok, specs = { D = {} }, true, {}
  for i, name in ipairs(vec.entry) do specs[i] = { name = name } end
  args.unknown(ctx, line, what, specs, given)
  for i, name in ipairs(vec.entry) do
    local e, at = expr.zero, ctx.diag:locate(line, name)
    if given[name] ~= nil then e = args.scalar(ctx, at, what, name, { dim = "inertia", motion = true }, given[name]) end
    ok = ok and e ~= nil
    for _, s in ipairs(e and expr.symbols(e) or {}) do
      if s.rank >= motion.rank and s.name ~= "t" then
        ctx.diag:error(at, what, name .. " must depend on time only", s.name)
        ok = false
      end
    end
    a.D[i] = e
  end
  return ok and a or nil
end

local function nothing(a)
  for _, e in ipairs(a.D) do
    if e ~= expr.zero then return false end
  end
  return true
end

function rate.states(a)
  if nothing(a) then return {} end
  return { { name = "clock", initial = expr.zero, unit = "s", about = "time of the moving parts" } }
end

function rate.derivative() return { clock = expr.one } end

-- D as a function of the clock, constants kept; and D'.
local function entries(c, D)
  return vec.map(D, function(e, n)
    e = c.lift(e, "D" .. vec.entry[n], "of the moving parts")
    return calculus.substitute(e, { [motion.sym "t"] = c.own.clock })
  end)
end

function rate.varies(a, c)
  if nothing(a) then return nil end
  return entries(c, a.D)
end

local function slopes(a) return vec.map(a.D, function(e) return calculus.diff(e, motion.sym "t") end) end

-- -D' w; the rest of (I + D) w' = L x w + .. is in the equations (builders.varying)
function rate.torque(a, c)
  if nothing(a) then return { expr.zero, expr.zero, expr.zero } end
  return vec.scale(-expr.one, vec.apply(entries(c, slopes(a)), c.w))
end

function rate.conserves() return { "L" } end

function rate.numeric(a, _, _, code, c)
  local function coded(D) return vec.map(entries(c, D), code) end
  return { kind = "inertia_rate", tensor = coded(a.D), rate = coded(slopes(a)) }
end

return rate
