-- law.lua -- can a body have this tensor?  The one place that says so, to scenes and to files of other programs alike.
--
-- The conditions are necessary and sufficient for a distribution of positive mass with that tensor: the second
-- moments Sigma = tr(I)/2 1 - I about the centre of mass must be positive semidefinite (Wensing, Kim, Slotine 2018,
-- IEEE RA-L 3, 60).  They are decided exactly by the principal minors of rationals; all broken ones are named with
-- their numbers, and mass/slips.lua says which slip would explain them.
--     diagonal of Sigma >= 0       2 Sigma_xx = yy + zz - xx: the triangle inequality of the entries
--     minors of two >= 0           xy^2 <= Sigma_xx Sigma_yy: what the moments leave for a product
--     determinant >= 0             the triangle inequality of the principal moments
-- Three kinds of tensors need not pass.  One is asked to be no body's (physical = false); one would pass if it were not
-- rounded to the digits that are written: both must be positive definite instead, since the equations of motion divide
-- by the moments.  The third was computed in doubles, and what breaks the law is the rounding of that computation; a
-- rod among these is made one (law.rod).
-- What is lawful may still be unlikely: mass/likely.lua.
-- SPDX-License-Identifier: GPL-3.0-or-later

local later = require "generator.later"
local R = require "generator.algebra.rational"
local vec = require "generator.algebra.vec"
local diag = require "generator.diag"
local jacobi = require "generator.mass.jacobi"
local likely = require "generator.mass.likely"
local slips = later "generator.mass.slips"

local law = {}

local function show(q) return diag.show(R.todouble(q)) end

-- What rounding may do to a condition, in parts of the trace: irrational entries are evaluated to 240 bits.
local rounding = R.new(2) ^ -200

-- Which principal minors of a symmetric matrix of rationals are negative: {[1..3] = diagonal entry i, [4..6] = minor of
-- the pair xy, xz, yz, [7] = determinant}; empty if it is positive semidefinite.
local function negative(S)
  local trace = R.abs(S[1]) + R.abs(S[2]) + R.abs(S[3]) + R.abs(S[4]) + R.abs(S[5]) + R.abs(S[6])
  local slack, broken = -trace * rounding, {}
  local adj, det = vec.adjugate(S)
  for i = 1, 3 do
    if S[i] < slack then broken[i] = true end
    if adj[4 - i] < slack * trace then broken[3 + i] = true end -- xy is the cofactor of zz
  end
  if det < slack * trace * trace then broken[7] = true end
  return broken
end

-- Sigma plus k 1, as the tensor that has it: tr(k 1) 1 - k 1 more.
function law.widened(I, k) return { I[1] + 2 * k, I[2] + 2 * k, I[3] + 2 * k, I[4], I[5], I[6] } end

-- Is Sigma + k 1 positive semidefinite?
function law.lawful(I, k) return next(negative(vec.second(k and law.widened(I, k) or I))) == nil end

-- Sylvester's criterion, exactly.
local function definite(I)
  local _, det = vec.adjugate(I)
  return R.sign(I[1]) > 0 and R.sign(I[1] * I[2] - I[4] ^ 2) > 0 and R.sign(det) > 0
end

-- ---- what rounding explains ----
--
-- written: what digits.written says of the six entries, or nil where they are exact.

-- How far errors h of the six entries can move an eigenvalue of Sigma: half the trace of the moments', and no more than
-- all of the products' (Gershgorin).
local function moved(h) return (h[1] + h[2] + h[3]) / 2 + h[4] + h[5] + h[6] end

-- Of entries that a program computed: each is off by 2^-52 of the trace, two units of the rounding of a double.  That
-- is some sums and products of numbers that are no larger, as in R I R^T; of 24000 turned rods and plates, by angles,
-- axes and quaternions, the worst moved Sigma by half of what this allows.
local unit = R.new(2) ^ -52
function law.computed(written, I)
  local u = unit * (R.abs(I[1]) + R.abs(I[2]) + R.abs(I[3]))
  return written and written.computed and moved { u, u, u, u, u, u } or R.zero
end

-- The rod that the entries about the centre of mass are, to the rounding of their computation; nil if they are none, or
-- lawful as they stand.  Its moment about its line is then zero and not some 1e-18, of either sign, which the equations
-- of motion would divide by.  Sigma of a rod is s u uT: the row of its largest diagonal entry has it.  Of three entries
-- that are off by a unit a product over the third is off by three, and a moment is a sum of two of them.
local of_rod = R.new(6)
function law.rod(written, I)
  if not (written and written.computed) or law.lawful(I) then return nil end
  local S, best = vec.second(I), 1
  for i = 2, 3 do
    if S[i] > S[best] then best = i end
  end
  if R.sign(S[best]) <= 0 then return nil end
  local row = {}
  for i = 1, 3 do row[i] = S[vec.index[best][i]] end
  local rod = vec.inertia(vec.scale(R.one / S[best], vec.outer(row)))
  local most = of_rod * unit * (R.abs(I[1]) + R.abs(I[2]) + R.abs(I[3]))
  for i = 1, 6 do
    if R.abs(rod[i] - I[i]) > most then return nil end
  end
  return rod
end

-- Of entries that were rounded, each to the digits that are written.
local function rounded(written) return written and moved(written.halves) or R.zero end

-- ---- the words ----

local names = { "xx", "yy", "zz", "xy", "xz", "yz" }
local pairs_of = { { 1, 2 }, { 1, 3 }, { 2, 3 } }

-- The six entries, for a message.
local function entries(I)
  return string.format("xx %s, yy %s, zz %s, xy %s, xz %s, yz %s", show(I[1]), show(I[2]), show(I[3]), show(I[4]),
    show(I[5]), show(I[6]))
end

-- a > b as text, and by how much where their doubles agree.
local function excess(a, b, text)
  local close = R.todouble(a) == R.todouble(b)
  return show(a) .. " > " .. text .. (close and " by " .. R.magnitude(a - b) or "")
end

function law.not_negative(name) return name .. " must not be negative" end

-- The broken conditions of a central tensor as {rule, got}, simplest first: what follows from a broken diagonal, or
-- from a broken pair, is not said again.  about: what the entries are about that I comes from, nil if from no entries.
function law.faults(I, about)
  local S, list = vec.second(I), {}
  local broken = negative(S)
  local function put(rule, got) list[#list + 1] = { rule, got } end
  for i = 1, 3 do
    if R.sign(I[i]) < 0 and next(broken) then
      put(law.not_negative(names[i] .. (about == "com" and "" or " about the centre of mass")), show(I[i]))
    end
  end
  if #list > 0 and about == "com" then return list end
  for i = 1, 3 do
    local j, k = i % 3 + 1, (i + 1) % 3 + 1
    if broken[i] then
      put(string.format("triangle inequality about the centre of mass: %s <= %s + %s must hold", names[i], names[j],
        names[k]), excess(I[i], I[j] + I[k], show(I[j]) .. " + " .. show(I[k])))
    end
  end
  if #list > 0 then return list end
  for n, p in ipairs(pairs_of) do
    if broken[3 + n] then
      local i, j = p[1], p[2]
      local k = 6 - i - j
      local limit = R.apply("sqrt", 240, S[i] * S[j])
      local rule = string.format("|%s| <= sqrt((%s + %s - %s)(%s + %s - %s))/2 must hold about the centre of mass",
        names[3 + n], names[j], names[k], names[i], names[k], names[i], names[j])
      put(rule, excess(R.abs(I[3 + n]), limit, show(limit)))
    end
  end
  if #list > 0 or not broken[7] then return list end
  local m = jacobi.run(vec.map(I, R.todouble))
  put("triangle inequality of the principal moments about the centre of mass must hold",
    string.format("%s > %s + %s from %s", diag.rough(m[3]), diag.rough(m[1]), diag.rough(m[2]), entries(I)))
  return list
end

-- A body that is this tensor alone cannot turn in a way that follows from anything.
function law.nothing(about) return "has no moment of inertia about " .. about .. ", so its rotation is undetermined" end

-- The likely slip, for the end of a message: "; most likely: ...", or "".
function law.hint(g)
  g.lawful = law.lawful
  local hint = slips.hint(g)
  return hint and "; " .. hint or ""
end

-- For what law.rod could not take.
local straighten = "; it is a rod but for the rounding of doubles, and is made one if its entries are plain numbers " ..
  "about the centre of mass"

-- ---- the verdict ----

-- g: {I = the entries as given, mass =, com =, about = "com" | "origin", written =, formal = with physical = false,
-- scene = whose author may write physical = false}, of rationals.  Calls fail(rule, got) and warn(text) for each thing
-- there is to say.  Returns {central =, written =, good =, slack = what Sigma is allowed beyond the law, in parts of
-- the trace of the central tensor, or nil, positive = by a rounding to written digits}.
function law.judge(g, fail, warn)
  local v = { central = g.about == "origin" and vec.sub(g.I, slips.steiner(g.mass, g.com)) or g.I, good = true,
    written = g.written }
  local I = v.central
  local list = law.faults(I, g.about)
  local computed = law.computed(g.written, g.I)
  local function allow(k) v.slack = k / vec.trace(I) end
  if #list == 0 and not g.formal then
    likely.tensor(warn, R.todouble(g.mass), vec.map(g.com, R.todouble), vec.map(I, R.todouble))
    return v
  end
  local positive = definite(I)
  if g.formal then
    if not positive then
      fail("the principal moments about the centre of mass must be positive, also with physical = false", entries(I))
    end
    v.good = positive
    return v
  end
  local by_doubles = R.sign(computed) > 0 and law.lawful(I, computed)
  if positive and by_doubles then
    allow(computed)
    return v
  end
  local k = rounded(g.written)
  if k < computed then k = computed end
  if not positive or R.sign(k) == 0 or not law.lawful(I, k) then
    local advice = g.scene and positive and "; physical = false takes any positive moments" or ""
    local hint = by_doubles and straighten or law.hint(g)
    for n, f in ipairs(list) do fail(f[1], f[2] .. (n == 1 and hint or "") .. advice) end
    v.good = false
    return v
  end
  local moment = jacobi.run(vec.map(I, R.todouble))
  warn(list[1][1] .. ", got " .. list[1][2] .. ": too large by " ..
    diag.rough(moment[3] - moment[1] - moment[2]) .. ", which rounding to the digits that are written explains " ..
    "(up to " .. diag.rough(2 * R.todouble(k)) .. "); the numbers are taken as they are")
  allow(k)
  v.positive = true
  return v
end

return law
