-- analysis.lua -- what can be asked of a body that turns: principal axes, small oscillations, torques.
--
--     analysis.principal(job, base, ctx) -> header, source
--     analysis.rest(job, base) -> header, source
-- Which spins persist: emit/stability_signs.lua.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local base_values = require "generator.emit.base"
local number = require "generator.emit.number"
local source = require "generator.emit.source"
local template = require "generator.emit.template"

local PRINCIPAL = template.group("analysis/principal.h", "analysis/principal.c")
local REST = template.group("analysis/analysis.h", "analysis/analysis.c")

local analysis = {}

-- Entries below 2^top may grow by 2^3 and be split (2^28, 2^13) below the largest number.
analysis.pair_top = { float = "110", double = "990" }

-- What NAME_principal_of promises.  A rounding of 2^-104 (2^-46), magnified by the condition, stays below half an ulp
-- of a moment up to `digits`; the smallest number is 2^-1074 (2^-149), so that a moment 10^-decades of the largest
-- still has all its own.
local PROMISES = { float = { digits = "5", decades = "65" }, double = { digits = "12", decades = "600" } }

-- Of a body symmetric about an oblique axis (job.oblique) the moments are constants; which is the lesser is decided
-- when the code runs, if parameters decide it.
function analysis.principal(job, base, ctx)
  local real = ctx.real
  -- negligible: epsilon^2 of the product of two moments, for the square of an entry; it and 15/16 as in mass/jacobi.lua
  local v = { oblique = job.oblique ~= nil, pair_top = analysis.pair_top[real], pair_digits = PROMISES[real].digits,
    pair_decades = PROMISES[real].decades, sign_margin = number.text(R.new(15, 16), real),
    negligible = number.text(R.new(2) ^ (2 - 2 * base_values.digits[real]), real) }
  if job.oblique then
    local text, I1, I3 = source.constants(job.oblique, real), job.oblique.I1, job.oblique.I3
    v.I1 = text.I1
    if I1.kind == "num" and I3.kind == "num" then -- which is less is known
      v.least, v.most = text.I1, text.I3
      if I3.value < I1.value then v.least, v.most = text.I3, text.I1 end
    else
      local less = text.I3 .. " < " .. text.I1
      v.least, v.most = less .. " ? " .. text.I3 .. " : " .. text.I1, less .. " ? " .. text.I1 .. " : " .. text.I3
    end
  end
  local render = PRINCIPAL(job.templates, base, v)
  return render "analysis/principal.h", render "analysis/principal.c"
end

function analysis.rest(job, base)
  local render = REST(job.templates, base, {})
  return render "analysis/analysis.h", render "analysis/analysis.c"
end

return analysis
