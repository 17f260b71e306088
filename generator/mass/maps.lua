-- maps.lua -- a piece of a body under linear maps, one after the other.
--
--     com -> A com      sigma -> A sigma A^T
-- Two general turns are one rotation M, nine numbers; multiplied out in their six angles, M sigma M^T has thousands of
-- terms.  So where the entries of a matrix that several maps make are long, they are opaque: one generator each for the
-- algebra that follows, and a name in the derivation and in the code (parts.lua).  The list `names` gets {node, stem,
-- about, unit} of each in the order in which they are made of one another.
-- A piece keeps own, M and rigid: its first second moments, all maps since, and whether they are rotations.
-- ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local poly = require "generator.algebra.poly"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"

local maps = {}

local tidy = ratio.tidy

local function tidy_all(v) return vec.map(v, function(e) return (tidy(e)) end) end

-- Terms of an entry that is still multiplied out: those of a turn about an axis after three about x, y and z.
local readable = 4

-- Has e more terms than `most`, multiplied out?  Also if it is no polynomial or cannot be multiplied out.
local function longer(e, most)
  local _, p = poly.modest(e)
  return not p or p.n > most
end

local function long(list)
  for _, e in ipairs(list) do
    if longer(e, readable) then return true end
  end
  return false
end

-- The vector v, its entries of more than `most` terms opaque, as they stand; # in `about` is the entry's letter.
function maps.shortened(v, names, stem, about, unit, most)
  return vec.map(v, function(e, k)
    if not longer(e, most or readable) then return (tidy(e)) end
    local one, axis = expr.call("opaque", e), string.sub("xyz", k, k)
    names[#names + 1] = { node = one, stem = stem .. axis, about = string.gsub(about, "#", axis), unit = unit }
    return one
  end)
end

-- M S M^T.  Of a rotation M with columns m, S = s 1 + (s3 - s) e3 e3^T becomes s 1 + (s3 - s) m3 m3^T, in which it is
-- seen that no direction across m3 is another than the others.
local function congruence(M, S, rigid)
  if rigid and expr.iszero(S[4]) and expr.iszero(S[5]) and expr.iszero(S[6]) then
    for k = 1, 3 do
      local i, j = k % 3 + 1, (k + 1) % 3 + 1
      if ratio.equal(S[i], S[j]) then
        local along = vec.outer(vec.column(M, k))
        return vec.map(along, function(e, n) return (n <= 3 and S[i] or expr.zero) + (S[k] - S[i]) * e end)
      end
    end
  end
  return vec.congruence(M, S)
end

-- Gives `out`, a copy of the piece p, centroid and second moments of p under A; rigid: A is a rotation.
function maps.apply(out, p, A, rigid, names)
  out.com = vec.matvec(A, p.com)
  out.own, out.rigid = p.own or p.sigma, rigid and p.rigid ~= false
  out.M = p.M and vec.matmul(A, p.M) or A
  out.opaque = p.opaque or p.M and (long(out.M[1]) or long(out.M[2]) or long(out.M[3]))
  if not out.opaque then
    out.M, out.com = vec.map(out.M, tidy_all), tidy_all(out.com)
    out.sigma = p.sigma and tidy_all(vec.congruence(A, p.sigma))
    return
  end
  local of = out.rigid and "# of the rotation that all turns are" or "# of the matrix of all turns and scalings"
  for i, row in ipairs(out.M) do
    local axis = string.sub("xyz", i, i)
    out.M[i] = maps.shortened(row, names, "R" .. axis, "entry " .. axis .. of, nil, 1)
  end
  out.com = maps.shortened(out.com, names, "place", "centroid # of a piece, turned", "m")
  out.sigma = p.sigma and tidy_all(congruence(out.M, out.own, out.rigid))
end

-- The tensor of a piece about its own centroid, per unit mass.  A rotation keeps the trace; where its entries are
-- opaque, that is seen from the first moments alone.
function maps.own(p)
  local I = vec.inertia(p.sigma)
  if not (p.opaque and p.rigid) then return I end
  local trace = vec.trace(p.own)
  return vec.map(I, function(e, n) return n <= 3 and trace - p.sigma[n] or e end)
end

return maps
