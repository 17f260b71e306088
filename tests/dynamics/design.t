#!/usr/bin/env lua5.4
-- design.t - stability by design: conditions in the parameters, their text, the emitted predicate near its boundary.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The law is a comparison of principal moments (Landau, Lifshitz, section 37; the major-axis rule). The oracle
-- compares
-- the moments themselves, exact rationals from the body's tensor, or, where a root stands in them, numbers of 600 bits;
-- conditions, verdicts and texts must agree with it at random parameters.  The emitted predicate is driven with
-- parameters a few ulp on either side of the boundary; its oracle is the sign of a rational number.
-- The quick tier takes fewer parameters, in double.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local tier = require "tests.tier"
local scene = require "tests.scene"
local compiled = require "tests.ir.compiled"
local R = require "generator.algebra.rational"
local evaluate = require "generator.algebra.evaluate"
local vec = require "generator.algebra.vec"
local facts = require "generator.report.facts"
local stability = require "generator.mass.spin_stability"

---- the conditions that books and a few lines of algebra give ----------------------------------------

-- Moments about the centroid, M left out (Goldstein, problem 5; any handbook):
--   cylinder  Iz = r²/2, Ix = (3r² + h²)/12               Iz > Ix  <=>  h² < 3 r²
--   cone      Iz = 3r²/10, Ix = 3(4r² + h²)/80            Iz > Ix  <=>  h² < 4 r²
--   tube      Iz = (r1² + r2²)/2, Ix = (3(r1² + r2²) + h²)/12
--   box       Ix = (y² + z²)/12 and so on: the largest moment is about the shortest edge
local texts = {
  { "solid.cylinder { r = r, h = h, mass = M }", { "M", "r", "h" }, 3, "h != sqrt(3)*r", "h < sqrt(3)*r" },
  { "solid.cylinder { r = r, h = h, mass = M }", { "M", "r", "h" }, 1, "never (neutral: equal moments)",
    "never (neutral if h > sqrt(3)*r)" },
  { "solid.cone { r = r, h = h, mass = M }", { "M", "r", "h" }, 3, "h != 2*r", "h < 2*r" },
  { "solid.tube { r_in = ra, r_out = rb, h = h, mass = M }", { "M", "ra", "rb", "h" }, 3,
    "h != sqrt(3*(ra^2 + rb^2))", "h < sqrt(3*(ra^2 + rb^2))" },
  { "solid.box { x = a, y = b, z = c, mass = M }", { "M", "a", "b", "c" }, 1,
    "(a < b and a < c) or (a > b and a > c)", "a < b and a < c" },
  { "solid.box { x = a, y = b, z = c, mass = M }", { "M", "a", "b", "c" }, 2,
    "(b < c and b < a) or (b > c and b > a)", "b < c and b < a" },
  { "solid.ellipsoid { a = a, b = b, c = c, mass = M }", { "M", "a", "b", "c" }, 3,
    "(c < a and c < b) or (c > a and c > b)", "c < a and c < b" },
  { "plate.rectangle { x = x, y = y, mass = M }", { "M", "x", "y" }, 3, "always", "always" },
  { "plate.rectangle { x = x, y = y, mass = M }", { "M", "x", "y" }, 1, "x > y", "never" },
  { "plate.polygon { profile = { {0, 0}, {x, 0}, {0, y} }, mass = M }", { "M", "x", "y" }, 3, "always", "always" },
  { "plate.polygon { profile = { {0, 0}, {x, 0}, {x, y}, {0, y} }, density = rho }", { "rho", "x", "y" }, 1,
    "(x - y)*(x + y) > 0", "never" }, -- x y > 0 is the mass's
  { "points { {M, x, 0, 0}, {M, -x, 0, 0}, {M, 0, y, 0}, {M, 0, -y, 0} }", { "M", "x", "y" }, 3, "x != 0 and y != 0",
    "x != 0 and y != 0" }, -- with one of them 0 they lie on a line
  { "solid.torus { R = b, r = a, mass = M }", { "M", "a", "b" }, 3, "always", "always" },
  { "rod.straight { length = l, mass = M }", { "M", "l" }, 3, "always", "never" },
  { "solid.sphere { r = r, mass = M }", { "M", "r" }, 2, "never (neutral: equal moments)",
    "never (neutral: equal moments)" },
}
for _, t in ipairs(texts) do
  local job = assert(scene.body(t[1], t[2]))
  local s = stability.of(job.model)
  tap.is(s:condition(t[3], false, "plain"), t[4], t[1] .. ", axis " .. t[3])
  tap.is(s:condition(t[3], true, "plain"), t[5], t[1] .. ", axis " .. t[3] .. ", with dissipation")
end

---- against the moments, at random parameters --------------------------------------------------------

-- The principal moments in the order of mass/stability's axes at exact parameters.
local function moments(job, s, env)
  local I = {}
  for n, e in ipairs(job.model.inertia) do
    local ok, x = pcall(evaluate.exact, e, env)
    I[n] = ok and x or evaluate.precise(e, env, 600)
  end
  if s.line then
    local st = job.model.structure
    return { evaluate.exact(st.alpha, env), evaluate.exact(st.alpha, env), evaluate.exact(st.axial, env) }
  end
  if not s.block then return { I[1], I[2], I[3] } end
  local b, off = s.block, { [3] = 4, [4] = 5, [5] = 6 } -- i + j of the off-diagonal entry
  local x, y, p = I[b.i], I[b.j], I[off[b.i + b.j]]
  local root = R.apply("sqrt", 600, (x - y) ^ 2 + R.new(4) * p ^ 2)
  local out = {}
  out[b.c], out[b.i], out[b.j] = I[b.c], (x + y - root) / R.new(2), (x + y + root) / R.new(2)
  return out
end

-- The law, by comparing.  Differences below 2^-500 of numbers with a root are equalities.
local function law(m, k, dissipation)
  local above, below, equal = 0, 0, 0
  for i = 1, 3 do
    if i ~= k then
      local d = m[k] - m[i]
      local s = (R.sign(d) == 0 or R.log2(d) < R.log2(m[k] + m[i]) - 500) and 0 or R.sign(d)
      if s > 0 then above = above + 1 elseif s < 0 then below = below + 1 else equal = equal + 1 end
    end
  end
  if dissipation then return below > 0 and -1 or equal > 0 and 0 or 1 end
  if equal > 0 then return 0 end
  return (above == 2 or below == 2) and 1 or -1
end

local function holds(tree, sign)
  if type(tree) == "boolean" then return tree end
  if tree.op then
    local a, b = holds(tree[1], sign), holds(tree[2], sign)
    if tree.op == "and" then return a and b end
    return a or b
  end
  local v = 1
  for _, atom in ipairs(tree.atoms) do v = v * sign(atom) end
  if tree.relation == ">" then return v > 0 elseif tree.relation == "<" then return v < 0 else return v ~= 0 end
end

-- The value of a condition's text at doubles.
local function read(text, env)
  if text == "always" then return true end
  if text:find "^never" then return false end
  local lua = text:gsub("!=", "~=")
  local values = { sqrt = math.sqrt, pi = math.pi, sin = math.sin, cos = math.cos }
  for name, q in pairs(env) do values[name] = R.todouble(q) end
  return assert(load("return " .. lua, lua, "t", values))()
end

local bodies = {
  { "solid.box { x = a, y = b, z = c, mass = M }", { "M", "a", "b", "c" } },
  { "solid.cylinder { r = r, h = h, mass = M }", { "M", "r", "h" } },
  { "solid.cone { r = r, h = h, mass = M }", { "M", "r", "h" } },
  { "solid.cone { r = r, h = h, mass = M }", { "M", "r", "h" }, "origin = {0, 0, 0}" },
  { "solid.cylinder { r = r, h = h, mass = M } + solid.sphere { r = k*r, mass = Mb }:at{0, 0, h}",
    { "M", "Mb", "r", "h", "k" } },
  { "solid.box { x = a, y = b, z = c, mass = M } + points { {Mb, u, 0, 0}, {Mb, -u, 0, 0} }",
    { "M", "Mb", "a", "b", "c", "u" } },
  { "wire.hoop { r = r, mass = M } + solid.cylinder { r = s, h = h, mass = Mb }:turned{axis = 'x', angle = pi/2}" ..
    ":at{0, -r - h/2, 0}", { "M", "Mb", "r", "s", "h" } },
  { "plate.rectangle { x = x, y = y, mass = M }", { "M", "x", "y" }, "origin = 'corner'" },
  { "solid.box { x = a, y = b, z = c, mass = M }:turned{axis = 'y', angle = 0.3}", { "M", "a", "b", "c" } },
  { "solid.box { x = a, y = b, z = c, mass = M } + points { {Mb, u, v, 0} }", { "M", "Mb", "a", "b", "c", "u", "v" } },
  { "solid.box { x = a, y = a, z = a, mass = M }", { "M", "a" }, "origin = 'corner'" },
  { "plate.rectangle { x = a, y = t, mass = M }:at{a/2, t/2, 0} + plate.rectangle { x = t, y = b, mass = Mb }" ..
    ":at{t/2, t + b/2, 0}", { "M", "Mb", "a", "b", "t" } }, -- a lamina: a block whose third axis is the largest
}
scene.seed(41)
for _, b in ipairs(bodies) do
  local job = assert(scene.body(b[1], b[2], b[3]))
  local s = stability.of(job.model)
  local wrong, texts_wrong, met = {}, {}, {}
  for n = 1, 64, tier.quick and 7 or 1 do
    local env = {}
    for _, p in ipairs(job.model.params) do env[p.name] = scene.rational() end
    if n % 4 == 0 and env.a and env.b then env.b = env.a end -- equal edges are met too
    if n % 8 == 0 and env.b and env.c then env.c = env.b end
    local m = moments(job, s, env)
    local function sign(atom)
      local ok, x = pcall(evaluate.exact, atom, env)
      return R.sign(ok and x or evaluate.precise(atom, env, 600))
    end
    local signs = s:signs(sign)
    for k = 1, 3 do
      for _, dissipation in ipairs { false, true } do
        local want = law(m, k, dissipation)
        met[want] = (met[want] or 0) + 1
        local said = holds(s:tree(k, dissipation), sign)
        if s.verdict(signs, k, dissipation) ~= want or said ~= (want == 1) then
          wrong[#wrong + 1] = string.format("axis %d %s want %d", k, tostring(dissipation), want)
        end
        -- in doubles an equality may go either way
        local equal = false
        for _, atom in ipairs(s:atoms()) do equal = equal or sign(atom) == 0 end
        if not equal and read(s:condition(k, dissipation, "plain"), env) ~= (want == 1) then
          texts_wrong[#texts_wrong + 1] = s:condition(k, dissipation, "plain")
        end
      end
    end
  end
  tap.is(#wrong, 0, b[1] .. ": verdicts and conditions are those of the exact moments", table.concat(wrong, "; "))
  tap.is(#texts_wrong, 0, b[1] .. ": so are the texts, read back", texts_wrong[1])
  tap.ok((met[1] or 0) > 0 and (met[-1] or 0) > 0, b[1] .. ": stable and unstable spins were met")
end

---- the report -----------------------------------------------------------------------------------------

do
  local f = facts.of(scene.file "bodies/symmetric_top.lua") -- r = 0.03, h = 0.12: the axis has the least moment
  local e = f.stability[1]
  tap.is(e.condition_dissipative, "h < sqrt(3)*r", "symmetric_top: the first moment is the axis'")
  tap.ok(e.stable == 1 and e.stable_dissipative == -1, "symmetric_top: stable until it dissipates")
  tap.is(#e.margins_dissipative, 2, "symmetric_top: r and h may both change the verdict, the density may not")
  -- a root by bisection and a root of 3: a few roundings
  tap.near(e.margins_dissipative[1].above, 0.12 / math.sqrt(3), 4 * 2.0 ^ -52, 0.0, "r would have to grow to h/sqrt(3)",
      "a root and two products")
  tap.near(e.margins_dissipative[2].below, 0.03 * math.sqrt(3), 4 * 2.0 ^ -52, 0.0,
    "h would have to shrink to sqrt(3) r",
      "a root and two products")
  tap.ok(f.stability[2].stable == 0 and f.stability[2].stable_dissipative == 0, "across: neutral, the greater moments")
  f = facts.of(scene.file "bodies/brick_centroid.lua") -- a > b > c
  for k, want in ipairs { { "a", 1, -1 }, { "b", -1, -1 }, { "c", 1, 1 } } do
    e = f.stability[k]
    tap.ok(e.condition:find("^%(" .. want[1]) and e.stable == want[2] and e.stable_dissipative == want[3],
      "brick: the axis of moment " .. k .. " is along " .. want[1])
  end
  for _, m in ipairs(f.stability[2].margins) do
    if m.name == "b" then
      tap.ok(math.abs(m.below - 0.05) < 1e-15 and math.abs(m.above - 0.2) < 1e-15,
        "brick: b is the middle edge between c and a")
    end
  end
  f = facts.of(scene.file "bodies/tennis_racket.lua")
  tap.ok(f.stability[2].about == "axis x" and f.stability[2].stable == -1 and f.stability[1].about == "axis y",
    "tennis racket: the handle has the least moment, the axis across it is the unstable one")
  f = facts.of(scene.file "bodies/brick.lua")
  tap.ok(f.design == nil and f.stability[2].stable == -1 and f.stability[3].stable_dissipative == 1
    and f.stability[1].condition == nil, "a body without axes in closed form has verdicts and no conditions")
end

-- A parameter goes no further than the body is one.  The rim of the gyroscope would turn neutral at rim_in = 40.06 mm,
-- rim_out = 28.96 mm, but has rim_in = 30 < rim_out = 38.  a + b is a height, so a > -0.2 before a^2 + .. is 3 r^2
-- again.
do
  local seen = {}
  for _, e in ipairs(facts.of(scene.file "bodies/gyroscope.lua").stability) do
    for _, m in ipairs(e.margins_dissipative) do seen[m.name] = true end
  end
  tap.ok(not seen.rim_in and not seen.rim_out and seen.width, "gyroscope: margins of its width, none of its rim")
  local job = scene.read [[local a, b, r = param("a", 0.1, "m"), param("b", 0.2, "m"), param("r", 0.3, "m")
    return scene { name = "s", body = solid.cylinder { r = r, h = a + b, mass = 1 } }]]
  local m = facts.of(job).stability[3].margins_dissipative[1]
  tap.ok(m.name == "a" and m.below == nil and math.abs(m.above - (0.3 * math.sqrt(3) - 0.2)) < 1e-14,
    "a height a + b: above sqrt(3) r it is unstable, below it ends before")
  -- the moments of a block over the corners (0, 0), (a, 0), (a, b), (0, b) change their order where a or b is 0, and
  -- there, too, it ends
  job = scene.read [[local a, b, h = param("a", 0.3, "m"), param("b", 0.2, "m"), param("h", 0.15, "m")
    return scene { name = "s", body = extrude { profile = { {0, 0}, {a, 0}, {a, b}, {0, b} }, h = h, density = 800 } }]]
  local ends = 0
  for _, e in ipairs(facts.of(job).stability) do
    for _, way in ipairs { "margins", "margins_dissipative" } do
      for _, m2 in ipairs(e[way]) do ends = ends + ((m2.below or 1) < 0.1 and 1 or 0) end
    end
  end
  tap.is(ends, 0, "no margin is where the block has no volume")
end

---- the emitted predicate near its boundary ---------------------------------------------------------------

-- The number `n` steps of the real type above x.
local function step(x, n, real)
  local to, of = real == "float" and "<f" or "<d", real == "float" and "<i4" or "<i8"
  return (string.unpack(to, string.pack(of, string.unpack(of, string.pack(to, x)) + n)))
end

local function rounded(x, real) return real == "float" and (string.unpack("<f", string.pack("<f", x))) or x end

-- points: lists of parameters; returns verdicts of axes 0..2, with and without dissipation, as text per point.
local function emitted(job, points, real)
  local planned = scene.plan(job, { real = real })
  local files, name = scene.files(planned), job.model.name
  local np = #job.model.params
  local lines = { "#include <stdio.h>",
    (files[name .. ".c"]:gsub('#include "[^\n]*\n', function() return files[name .. ".h"] end)),
    "static const " .. real .. " points[][" .. np .. "] = {" }
  for _, p in ipairs(points) do
    local row = {}
    for i, x in ipairs(p) do row[i] = "(" .. real .. ")" .. string.format("%a", x) end
    lines[#lines + 1] = "  {" .. table.concat(row, ", ") .. "},"
  end
  lines[#lines + 1] = string.format([[
};
int main(void)
{
  %s_model m;
  int i, k;
  for (i = 0; i < %d; i++) {
    printf("%%d\n", %s_init(&m, points[i]));
    for (k = 0; k < 3; k++) printf("%%d %%d\n", %s_spin_stable(&m, k, 0), %s_spin_stable(&m, k, 1));
  }
  return 0;
}
]], name, #points, name, name, name)
  return compiled.numbers(table.concat(lines, "\n"))
end

-- Compares the emitted verdicts with the law for the exact values of the parameters.
local function compare(what, job, points, real)
  local s = stability.of(job.model)
  local got, at, wrong, signs = emitted(job, points, real), 0, {}, {}
  for n, p in ipairs(points) do
    local env = {}
    for i, param in ipairs(job.model.params) do env[param.name] = R.fromdouble(p[i]) end
    local m = moments(job, s, env)
    at = at + 1
    if got[at] ~= 0 then wrong[#wrong + 1] = "init refuses point " .. n end
    for k = 1, 3 do
      for d = 0, 1 do
        at = at + 1
        local want = law(m, k, d == 1)
        signs[want] = true
        if got[at] ~= want then
          wrong[#wrong + 1] = string.format("point %d axis %d dissipation %d: got %g, want %d", n, k - 1, d, got[at],
            want)
        end
      end
    end
  end
  tap.is(#wrong, 0, what .. ", " .. real .. ": the emitted verdict is exact near equality", wrong[1])
  tap.ok(signs[1] and signs[-1], what .. ", " .. real .. ": both sides of the boundary were met")
end

local random = require "tests.ir.random"
random.seed(7)
local STRIDE = tier.quick and 6 or 1
local function uniform() return random.int(2 ^ 30) / 2.0 ^ 30 + random.int(2 ^ 30) / 2.0 ^ 61 end

for _, real in ipairs(tier.every(2, { "double", "float" })) do
  local points = {}
  for n = 1, 60, STRIDE do
    local r = rounded((0.1 + uniform()) * (real == "float" and 1 or 10.0 ^ (n - 30)), real)
    local h = rounded(math.sqrt(3) * r, real)
    for k = -2, 2 do points[#points + 1] = { 1.5, r, step(h, k, real) } end
  end
  compare("cylinder, h = sqrt(3) r", assert(scene.body("solid.cylinder { r = r, h = h, mass = M }", { "M", "r", "h" })),
    points, real)
  points = {}
  for _ = 1, 40, STRIDE do
    local a, c = rounded(uniform() + 0.1, real), rounded(uniform() + 0.1, real)
    for k = -1, 1 do points[#points + 1] = { 2.5, a, step(a, k, real), c } end
    points[#points + 1] = { 2.5, a, a, a }
  end
  compare("box, a = b", assert(scene.body("solid.box { x = a, y = b, z = c, mass = M }", { "M", "a", "b", "c" })),
    points,
    real)
  if tier.quick then goto continue end
  points = {}
  for _ = 1, 60, STRIDE do
    local r1, dr = rounded(uniform() + 0.1, real), uniform() + 0.1
    local r2 = rounded(r1 + dr, real)
    local h = rounded(math.sqrt(3 * (r1 * r1 + r2 * r2)), real)
    for k = -2, 2 do points[#points + 1] = { 1.0, r1, r2, step(h, k, real) } end
  end
  compare("tube, h^2 = 3 (r1^2 + r2^2)", assert(scene.body("solid.tube { r_in = ra, r_out = rb, h = h, mass = M }",
    { "M", "ra", "rb", "h" })), points, real)
  points = {}
  for _ = 1, 60, STRIDE do -- M h^2 + 13 Mb h^2 = 3 r^2 (M + Mb): degree 3, three columns of factors
    local m1, m2, r = rounded(uniform() + 0.1, real), rounded(uniform() + 0.1, real), rounded(uniform() + 0.1, real)
    local h = rounded(r * math.sqrt(3 * (m1 + m2) / (m1 + 13 * m2)), real)
    for k = -2, 2 do points[#points + 1] = { m1, m2, r, step(h, k, real) } end
  end
  compare("cylinder and ball", assert(scene.body(
    "solid.cylinder { r = r, h = h, mass = M } + solid.sphere { r = r, mass = Mb }:at{0, 0, h}", { "M", "Mb", "r",
      "h" })),
    points, real)
  points = {}
  for _ = 1, 60, STRIDE do -- numbers of the scene that are not doubles: 0.1 and 1/3 are meant exactly
    local r = rounded(uniform() / 8 + 0.1, real)
    local h = rounded(math.sqrt(3 * (r * r + 0.01)), real)
    for k = -2, 2 do points[#points + 1] = { r, step(h, k, real) } end
  end
  compare("tube with a bore of 0.1", assert(scene.body("solid.tube { r_in = 0.1, r_out = r, h = h, mass = 1 }",
    { "r", "h" })), points, real)
  ::continue::
end

do -- turned about an axis: a block; the third axis and the two of the plane
  local job = assert(scene.body("solid.box { x = a, y = b, z = c, mass = M } + points { {Mb, u, v, 0} }",
    { "M", "Mb", "a", "b", "c", "u", "v" }))
  local points = {}
  for n = 1, 80, STRIDE do
    local p = {}
    for i = 1, 7 do p[i] = uniform() + 0.1 end
    if n % 2 == 0 then p[2] = p[2] / 64 end
    points[n] = p
  end
  compare("box and a particle", job, points, "double")
  compare("a plate of two rectangles", assert(scene.body("plate.rectangle { x = a, y = t, mass = M }:at{a/2, t/2, 0}" ..
    " + plate.rectangle { x = t, y = b, mass = Mb }:at{t/2, t + b/2, 0}", { "M", "Mb", "a", "b", "t" })),
  vec.map(points, function(p) return { table.unpack(p, 1, 5) } end), "double")
end

tap.done()
