#!/usr/bin/env lua5.4
-- reference.t - the emitted C of every body of the reference set, with its sizes as parameters, to 4 ulp.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Every number of a body's scene becomes a parameter, so that NAME_init has the whole tensor to compute, in double and
-- in float; the baked code has the constants themselves.  What is compared: mass, centre of mass and tensor, about the
-- centroid and about the row's second point, norm-wise: the largest error over the largest entry.  The reference is the
-- exact table (tests/reference/inertia.lua) where the scene's numbers are numbers of the real type; where they are not
-- (8.3322, 0.1), it is the model's symbolic tensor at the numbers as they were rounded, and the symbolic tensor is held
-- against the table at the numbers themselves.
-- 4 ulp: a moment is a dozen products and sums of terms of one sign, each good to half a unit of the result at most.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local program = require "tests.cli.program"
local R = require "generator.algebra.rational"
local evaluate = require "generator.algebra.evaluate"
local rows = require "tests.reference.inertia"
local exact = require "tests.reference.exact"

local ULP = 4
local REAL = { double = 53, float = 24 } -- bits
local BITS = 240

-- ---- scenes with parameters ----

-- The scene's text with every number that has a size as a parameter of its own.  Zeros stay: they are the structure; so
-- does what counts (faces, powers) and what is an angle's fraction of pi.
local function parametrised(body)
  local list = {}
  local function param(literal)
    list[#list + 1] = string.format('local n%d = param("n%d", %s)', #list + 1, #list + 1, literal)
    return "n" .. #list
  end
  local kept = {}
  local function keep(s)
    kept[#kept + 1] = s
    return "\1" .. string.char(64 + #kept) .. "\1"
  end
  local function quoted(s)
    local q = R.parse(s)
    local x = R.todouble(q)
    return keep(R.lift(x) == q and param(string.format("%.17g", x)) or 'exact("' .. s .. '")')
  end
  local text = body:gsub('exact%("([^"]+)"%)', quoted):gsub("quantity%b()", keep):gsub('%b""', keep)
  text = text:gsub("turned(%b{})", function(s) return keep("turned" .. s) end)
  text = text:gsub("faces = %d+", keep):gsub("sqrt%(%d+%)", keep):gsub("pi/%d+", keep)
  text = text:gsub("2%^%d+", function(s) return keep(param(s)) end)
  text = text:gsub("%f[%w%.\1]%d+%.?%d*", function(s) return tonumber(s) == 0 and s or param(s) end)
  for _ = 1, 2 do -- what is kept may hold what is kept
    text = text:gsub("\1(.)\1", function(c) return kept[c:byte() - 64] end)
  end
  return table.concat(list, "\n") .. "\n", text
end

-- ---- what is to be computed ----

local function number(e, env) return evaluate.precise(e, env, BITS) end

-- The rational that the real type has for q.
local function rounded(q, real)
  local x = R.todouble(q)
  if real == "float" then x = string.unpack("f", string.pack("f", x)) end
  return R.fromdouble(x)
end

local dir = program.directory()
local jobs = {}

local function add(row, k, real, where, origin)
  local params, text = parametrised(row.body)
  local name = string.format("r%d%s%s", k, where, real:sub(1, 1))
  local job = assert(scene.read(params .. "return scene { name = \"" .. name .. "\", body = " .. text ..
    ", origin = " .. origin .. " }\n"))
  local m = job.model
  job = scene.plan(job, { real = real })
  local files = scene.files(job)
  program.write(dir .. "/" .. name .. ".c", files[name .. ".c"])
  program.write(dir .. "/" .. name .. ".h", files[name .. ".h"])
  local given, near, whole = m.defaults, {}, true
  for p, q in pairs(given) do -- in any order: by name
    near[p] = rounded(q, real)
    whole = whole and near[p] == q
  end
  jobs[#jobs + 1] = { name = name, row = row, model = m, real = real, where = where, given = given, near = near,
    whole = whole }
end

for k, row in ipairs(rows) do
  add(row, k, "double", "c", '"centroid"')
  add(row, k, "double", "p", exact.point(row))
  add(row, k, "float", "c", '"centroid"')
end

-- ---- one program ----

do
  local includes, calls, objects = {}, {}, {}
  for i, j in ipairs(jobs) do
    includes[i] = string.format('#include "%s.h"\n', j.name)
    calls[i] = string.gsub([[
  {
    NAME_model m;
    NAME_real I[6], c[3], mass;
    const int code = NAME_init(&m, 0);

    if (code != 0) printf("NAME %d\n", code);
    else {
    mass = NAME_mass(&m, c);
    NAME_inertia(&m, I);
    printf("NAME %a %a %a %a %a %a %a %a %a %a\n", (double)mass, (double)c[0], (double)c[1], (double)c[2],
      (double)I[0], (double)I[1], (double)I[2], (double)I[3], (double)I[4], (double)I[5]);
    }
  }
]], "NAME", j.name)
    objects[i] = j.name .. "\n"
  end
  program.write(dir .. "/main.c", "#include <stdio.h>\n" .. table.concat(includes) .. "int main(void)\n{\n" ..
    table.concat(calls) .. "  return 0;\n}\n")
  program.write(dir .. "/names", table.concat(objects))
end
local code = program.shell("cd " .. dir ..
  " && xargs -P 2 -I N cc -std=c99 -ffp-contract=off -O1 -c N.c -o N.o <names " ..
  ">log 2>&1 && cc -std=c99 main.c r*.o -lm -o all >>log 2>&1 && ./all >out")
tap.is(code, 0, #jobs .. " emitted bodies compile into one program, which runs")
if code ~= 0 then tap.diag((program.read(dir .. "/log") or "") .. (program.read(dir .. "/out") or "")) end

local results = {}
for name, list in (program.read(dir .. "/out") or ""):gmatch "(%S+) ([^\n]+)\n" do
  local v = {}
  for x in list:gmatch "%S+" do v[#v + 1] = tonumber(x) end
  results[name] = v
end

-- ---- comparison ----

-- The largest error over the largest entry, in units of its last place; the reference is zero where all is.
local function distance(got, want, bits)
  local scale, worst = R.zero, R.zero
  for _, w in ipairs(want) do
    if R.abs(w) > scale then scale = R.abs(w) end
  end
  for i, w in ipairs(want) do
    if not got[i] or got[i] ~= got[i] or got[i] == math.huge or got[i] == -math.huge then return math.huge end
    local d = R.abs(R.fromdouble(got[i]) - w)
    if d > worst then worst = d end
  end
  if R.sign(worst) == 0 then return 0 end
  if R.sign(scale) == 0 then return math.huge end
  local exponent = R.log2(scale) -- near it; a unit of the last place is 2^(exponent + 1 - bits)
  while R.new(2) ^ exponent > scale do exponent = exponent - 1 end
  while R.new(2) ^ (exponent + 1) <= scale do exponent = exponent + 1 end
  return R.todouble(worst / R.new(2) ^ (exponent + 1 - bits))
end

local function all(list, env)
  local out = {}
  for i, e in ipairs(list) do out[i] = number(e, env) end
  return out
end

local function table_values(list)
  local out = {}
  for i, s in ipairs(list) do out[i] = number(exact.value(s), {}) end
  return out
end

-- The one body that NAME_init refuses: about a point 2^30 away its tensor has the condition 1e18 (the generator warns),
-- and the determinant that the equations of motion divide by has no digit.
local refused = { ["tetrahedron_far_2^30"] = "p" }

local worst = {}
for _, j in ipairs(jobs) do
  local row, m, got = j.row, j.model, results[j.name] or {}
  local centroid, point = table_values(row.centroid), table_values(row.point)
  local com = { R.zero, R.zero, R.zero }
  if j.where == "p" then
    for i = 1, 3 do com[i] = centroid[i] - point[i] end
  end
  local want = { table_values { row.mass }, com, table_values(j.where == "p" and row.about or row.tensor) }
  local function model(env) return { all({ m.mass }, env), all(m.com, env), all(m.inertia, env) } end
  local given = model(j.given)
  local near = j.whole and want or model(j.near)
  local what = string.format("%s, %s, about the %s: ", row.id, j.real, j.where == "p" and "second point" or "centroid")
  if refused[row.id] == j.where then
    tap.ok(#got == 1 and got[1] > 0, what .. "refused, for its condition", #got .. " numbers")
  else
    local ulp, from = {}, 1
    local agree = true
    for k, n in ipairs { 1, 3, 6 } do
      ulp[k] = distance({ table.unpack(got, from, from + n - 1) }, near[k], REAL[j.real])
      from = from + n
      for i, w in ipairs(want[k]) do -- 240 bits, of which 90 may cancel
        local d = R.abs(given[k][i] - w)
        agree = agree and (R.sign(d) == 0 or R.log2(d) < R.log2(want[3][1]) - 150)
      end
    end
    tap.ok(agree, what .. "the model with parameters is the table's body")
    local most = math.max(table.unpack(ulp))
    tap.ok(most <= ULP, what .. "mass, centre and tensor to " .. ULP .. " ulp",
      string.format("%.2f, %.2f and %.2f ulp", table.unpack(ulp)))
    local w = worst[j.real .. j.where]
    if not w or most > w[1] then worst[j.real .. j.where] = { most, row.id } end
  end
end
for _, kind in ipairs { "doublec", "doublep", "floatc" } do
  local w = worst[kind]
  tap.diag(string.format("worst in %s about the %s: %.2f ulp (%s)", string.sub(kind, 1, -2),
    string.sub(kind, -1) == "c" and "centroid" or "second point", w[1], w[2]))
end

-- ---- baked: the constants themselves ----

do
  local largest, id = 0, ""
  for _, row in ipairs(rows) do
    for _, origin in ipairs { '"centroid"', exact.point(row) } do
      local m = assert(scene.read("return scene { name = \"b\", body = " .. row.body .. ", origin = " .. origin ..
        " }\n",
        { bake = true })).model
      local got = {}
      for i = 1, 6 do got[i] = m:double(m.inertia[i]) end
      local ulp = distance(got, table_values(origin == '"centroid"' and row.tensor or row.about), 53)
      if ulp > largest then largest, id = ulp, row.id end
    end
  end
  tap.ok(largest <= 0.5, "baked constants are the nearest doubles", largest .. " ulp at " .. id)
end

-- the scenes were parametrised: a body without parameters would compute nothing
do
  local none = {}
  for _, j in ipairs(jobs) do
    if next(j.given) == nil then none[#none + 1] = j.row.id end
  end
  tap.is(table.concat(none, " "), "", "every body has parameters")
  local p, text = parametrised "solid.box { x = 2^27, y = 1, z = exact(\"1/8\"), mass = 0 }:at{0, 1.5, 0}"
  tap.is(text, "solid.box { x = n2, y = n3, z = n1, mass = 0 }:at{0, n4, 0}", "numbers become parameters")
  tap.ok(p:find('param("n1", 0.125)', 1, true) and p:find('param("n2", 2^27)', 1, true),
    "with the values they had", p)
end

program.finish()
tap.done()
