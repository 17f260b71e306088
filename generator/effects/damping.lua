-- damping.lua -- linear damping: a torque -C w, or -rate L.
--
-- c may be a number (isotropic), three numbers (principal) or a 3x3 matrix, in N m s; rate, in 1/s, damps the
-- angular momentum uniformly, so the motion is the free one with a slower and slower clock.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local motion = require "generator.algebra.motion"
local vec = require "generator.algebra.vec"
local custom = require "generator.effects.custom"

local damping = {
  name = "effect.damping",
  takes = { { "c", "kg m^2/s", nil, "a number (isotropic), {cx, cy, cz} or a 3x3 matrix, body axes" },
    { "rate", "1/s", nil, "or: N = -rate L" } },
  idle = { { "c", "rate", c = "C" } },
  formula = "N = -C w, or N = -rate L",
  signs = "positive c and rate take energy; a matrix need not be symmetric; L is I w, without what wheels and " ..
    "rotors hold",
  source = "the definition; rate: the free motion with a slower clock, derived in docs/closed.md",
  example = "damped_brick",
  about = "torque -C w (c: number, {cx, cy, cz} or 3x3 matrix), or -rate L",
}

-- Own reading: c has three shapes, and exactly one of c and rate is given.
function damping.read(ctx, line, what, given, args)
  args.unknown(ctx, line, what, { { name = "c" }, { name = "rate" } }, given)
  local at = ctx.diag:locate(line, given.c ~= nil and "c" or "rate")
  if (given.c == nil) == (given.rate == nil) then
    ctx.diag:error(line, what, "give c or rate, one of them")
    return nil
  end
  if given.rate ~= nil then
    local rate = args.scalar(ctx, at, what, "rate", { dim = "rate", decay = true }, given.rate)
    return rate and { rate = rate }
  end
  local c, spec = given.c, { dim = "damping", motion = true }
  local zero = expr.zero
  if args.list(c, 3) and type(c[1]) == "table" and #c[1] == 3 then
    local C = {}
    for i = 1, 3 do
      C[i] = args.vector(ctx, at, what, "c[" .. i .. "]", { dim = "damping", size = 3, motion = true }, c[i])
      if not C[i] then return nil end
    end
    return { C = C }
  end
  if args.plain(c) and #c == 3 then
    local v = args.vector(ctx, at, what, "c", { dim = "damping", size = 3, motion = true }, c)
    return v and { C = { { v[1], zero, zero }, { zero, v[2], zero }, { zero, zero, v[3] } } }
  end
  local k = args.scalar(ctx, at, what, "c", spec, c)
  return k and { C = { { k, zero, zero }, { zero, k, zero }, { zero, zero, k } } }
end

-- Does the coefficient depend on the motion (an input, time, a state)?
function damping.varies_with(a)
  return not a.rate and (motion.any(a.C[1]) or motion.any(a.C[2]) or motion.any(a.C[3]))
end

function damping.torque(a, c)
  if a.rate then
    local rate = c.constant("decay", a.rate, "rate of decay of L, 1/s")
    return vec.scale(-rate, c.L())
  end
  local C = {}
  for i = 1, 3 do
    C[i] = vec.map(a.C[i], function(x, j)
      return c.lift(x, "C" .. string.sub("xyz", i, i) .. string.sub("xyz", j, j), "damping, N m s")
    end)
  end
  return vec.scale(expr.lift(-1), vec.matvec(C, c.w))
end

-- A coefficient that varies goes as expressions.
function damping.numeric(a, num, _, code, c)
  if a.rate then return { kind = "damping", rate = num(a.rate) } end
  if damping.varies_with(a) then return custom.told(damping.torque(a, c), nil, code) end
  local C = {}
  for i = 1, 3 do
    for j = 1, 3 do C[#C + 1] = num(a.C[i][j]) end
  end
  return { kind = "damping", C = C }
end

return damping
