-- convert.lua - reference tables from JSON and CSV into C headers that a test can include.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     lua5.4 tests/reference/convert.lua DIRECTORY_OF_THE_TABLES tests/reference
--
-- Nothing is computed: digits are copied as text, fractions stay fractions. Inputs stay doubles (shortest repr),
-- references become long double literals with all their digits. Rows are chosen by the rules written beside each table.
-- Provenance of the tables themselves: README.md here.

local from, to = arg[1], arg[2]

local function slurp(name)
  local file = assert(io.open(from .. "/" .. name))
  local text = file:read "a"
  file:close()
  return text
end

-- JSON: a value at position i, and the position after it. Objects and arrays become tables; null becomes false.
local value

local function sequence(text, i, close, item)
  local result = {}
  i = text:match("^%s*()", i + 1)
  while text:sub(i, i) ~= close do
    i = item(result, i)
    i = text:match("^%s*,?%s*()", i)
  end
  return result, i + 1
end

local escapes = { n = "\n", t = "\t" }

function value(text, i)
  i = text:match("^%s*()", i)
  local c = text:sub(i, i)
  if c == "{" then
    return sequence(text, i, "}", function(object, at)
      local key, colon = value(text, at)
      local v, next = value(text, text:match("^%s*:()", colon))
      object[key] = v
      return next
    end)
  elseif c == "[" then
    return sequence(text, i, "]", function(array, at)
      local v, next = value(text, at)
      array[#array + 1] = v
      return next
    end)
  elseif c == '"' then
    local j = i + 1
    while text:sub(j, j) ~= '"' do
      j = j + (text:sub(j, j) == "\\" and 2 or 1)
    end
    local raw = text:sub(i + 1, j - 1):gsub("\\u%x%x%x%x", "?"):gsub("\\(.)", function(e) return escapes[e] or e end)
    return raw, j + 1
  end
  local word, after = text:match("^([%w%.%+%-]+)()", i)
  return tonumber(word) or word == "true", after
end

local function json(name)
  return (value(slurp(name), 1))
end

local function write(name, lines)
  local file = assert(io.open(to .. "/" .. name, "w"))
  file:write(table.concat(lines, "\n"), "\n")
  file:close()
end

local function each(list, f)
  local result = {}
  for i, v in ipairs(list) do
    result[i] = f(v)
  end
  return result
end

local function braces(list)
  return "{" .. table.concat(list, ", ") .. "}"
end

-- Text of a number as a C literal: a point or an exponent is added where there is none.
local function double(text)
  text = tostring(text)
  return text:find "[%.eE]" and text or text .. ".0"
end

-- Below the range of an 80-bit long double only 0 is left.
local function long(text)
  local exponent = tonumber(tostring(text):match "e(%-%d+)$")
  return exponent and exponent < -4900 and "0.0L" or double(text) .. "L"
end

local function head(name, what, declaration)
  return {
    "/* " .. name .. " - " .. what,
    "   SPDX-License-Identifier: GPL-3.0-or-later",
    "",
    "   Made by convert.lua; provenance in README.md beside this file. */",
    "/* clang-format off */",
    declaration,
  }
end

-- ---- eigen.json: all rows ----
do
  local out = head("eigen.h", "symmetric tensors with eigenvalues and axes, 32 digits",
    "static const struct {\n  const char *id, *category;\n  double tensor[6];\n  long double value[3];\n" ..
    "  int simple[3]; /* is this eigenvalue simple, so that axis[k] means something? */\n  long double axis[3][3];\n" ..
    "} eigen_rows[] = {")
  for _, case in ipairs(json("eigen.json").cases) do
    local simple, axis = { 0, 0, 0 }, { "{0}", "{0}", "{0}" }
    for _, a in ipairs(case.simple_axes_unit_largest_component_positive or {}) do
      simple[a.index + 1] = 1
      axis[a.index + 1] = braces(each(a.axis, long))
    end
    out[#out + 1] = string.format('  {"%s", "%s", %s,\n   %s,\n   %s, %s},', case.id, case.category,
      braces(each(case.a_xx_yy_zz_xy_xz_yz, double)), braces(each(case.eigenvalues_ascending, long)),
      braces(simple), braces(axis))
  end
  out[#out + 1] = "};"
  write("eigen.h", out)
end

-- ---- inertia.json: all bodies; other points as sums of fractions, with one surd ----
do
  local SQRT5 = "2.236067977499789696409173668731276"
  local function coordinate(text)
    local c = text:gsub("sqrt%(5%)", "S"):gsub("%d+", "%0.0L"):gsub("S", SQRT5 .. "L"):gsub("/", " / ")
    return c
  end
  local out = head("inertia.h", "mass, centroid and tensors of bodies, 34 digits",
    "static const struct inertia_row {\n  const char *id;\n  long double mass, measure, centroid[3], tensor[6];\n" ..
    "  long double point[3], about[6]; /* another point, and the tensor about it */\n} inertia_rows[] = {")
  for _, body in ipairs(json("inertia.json").bodies) do
    out[#out + 1] = string.format('  {"%s", %s, %s, %s,\n   %s,\n   %s, %s},', body.id, long(body.mass.decimal),
      long(body.measure.decimal), braces(each(body.centroid.decimal, long)),
      braces(each(body.tensor_about_centroid_xx_yy_zz_xy_xz_yz.decimal, long)),
      braces(each(body.other_point.coordinates, coordinate)),
      braces(each(body.other_point.tensor_xx_yy_zz_xy_xz_yz.decimal, long)))
  end
  out[#out + 1] = "};"
  write("inertia.h", out)
end

-- ---- free_top.json: all samples of physical bodies; first those within 20000 rad of the start that move by less than
-- 1e-3 if the inputs do by 2^-53 ----
do
  local near, rest = {}, {}
  for _, case in ipairs(json("free_top.json").cases) do
    local tensor = case.tensor_xx_yy_zz_xy_xz_yz or { case.I[1], case.I[2], case.I[3], "0.0", "0.0", "0.0" }
    local speed = 0
    for _, w in ipairs(case.omega0) do
      speed = math.max(speed, math.abs(tonumber(w)))
    end
    for _, s in ipairs(case.id ~= "nonphysical_triangle_violation" and case.samples or {}) do
      local ws, qs = s.input_ulp_sensitivity.omega_rel, s.input_ulp_sensitivity.q_abs
      local out = speed * math.abs(tonumber(s.t)) <= 2e4 and tonumber(ws) < 1e-3 and tonumber(qs) < 1e-3 and near or
        rest
      out[#out + 1] = string.format('  {"%s", %s, %s, %s, %s,\n   %s,\n   %s, %s, %s, %s, %s},', case.id,
        braces(each(tensor, double)), braces(each(case.omega0, double)), braces(each(case.q0, double)), double(s.t),
        braces(each(s.omega, long)), braces(each(s.q, long)), double(ws), double(qs), double(case.period or "0"),
        double(case.sep_rel or "1"))
    end
  end
  local out = head("free_top.h", "torque-free motion, 32 digits",
    "enum { FREE_TOP_NEAR = " .. #near .. " }; /* so many rows first: not far away, not sensitive */\n" ..
    "static const struct {\n  const char *id;\n  double tensor[6], w0[3], q0[4], t;\n  long double w[3], q[4];\n" ..
    "  double w_sensitivity, q_sensitivity; /* change (of w relative, of q) when the inputs move by 2^-53 */\n" ..
    "  double period, separation; /* of the rates; (L^2 - 2 T I2)/L^2: distance from the separatrix */\n" ..
    "} free_top_rows[] = {")
  table.move(near, 1, #near, #out + 1, out)
  table.move(rest, 1, #rest, #out + 1, out)
  out[#out + 1] = "};"
  write("free_top.h", out)
end

-- ---- elliptic.json: all rows; what a row does not have is 0, n HUGE_VAL ----
do
  local out = head("elliptic.h", "elliptic integrals and functions, 32 digits",
    "enum { ELLIPTIC_JACOBI, ELLIPTIC_INCOMPLETE, ELLIPTIC_COMPLETE };\n" ..
    "static const struct {\n  int kind, complement; /* is value 1 - m? */\n  double value, u, phi, n;\n" ..
    "  long double sn, cn, dn, am, F, E, Pi; /* complete: F is K; n not finite: no Pi */\n} elliptic_rows[] = {")
  local kinds = { jacobi = "ELLIPTIC_JACOBI", incomplete = "ELLIPTIC_INCOMPLETE", complete = "ELLIPTIC_COMPLETE" }
  local function field(v, f, none)
    return v and f(v) or none or "0"
  end
  for _, c in ipairs(json("elliptic.json").cases) do
    local row = { kinds[c.kind], c.given == "mc" and "1" or "0", double(c.value), field(c.u, double),
      field(c.phi, double), field(c.n, double, "HUGE_VAL") }
    for _, key in ipairs { "sn", "cn", "dn", "am", "F", "E", "Pi" } do
      row[#row + 1] = field(c[key] or key == "F" and c.K, long)
    end
    out[#out + 1] = "  " .. braces(row) .. ","
  end
  out[#out + 1] = "};"
  write("elliptic.h", out)
end

-- ---- forced_top.json: the models that the library has ----
do
  local out = head("forced_top.h", "heavy tops, linear damping, constant torques, a gyrostat, 32 digits",
    "enum { FORCED_HEAVY, FORCED_DAMPING, FORCED_BODY, FORCED_INERTIAL, FORCED_ROTOR };\n" ..
    "static const struct {\n  const char *id;\n  int model;\n  double moment[3];\n" ..
    "  double load[3]; /* m g r, diagonal of C, torque, or momentum of the rotor */\n" ..
    "  double x0[7], t; /* state: w, then q */\n  long double x[7];\n} forced_top_rows[] = {")
  local models = {
    ["heavy top"] = { "FORCED_HEAVY", "mgr" }, ["linear damping"] = { "FORCED_DAMPING", "c" },
    ["constant body torque"] = { "FORCED_BODY", "tau_body" },
    ["constant inertial torque"] = { "FORCED_INERTIAL", "tau_inertial" },
    ["gyrostat (constant relative rotor momentum)"] = { "FORCED_ROTOR", "h" },
  }
  for _, case in ipairs(json("forced_top.json").cases) do
    local model = models[case.model]
    for _, s in ipairs(model and case.samples or {}) do
      out[#out + 1] = string.format('  {"%s", %s, %s, %s,\n   %s, %s,\n   %s},', case.id, model[1],
        braces(each(case.params.I, double)), braces(each(case.params[model[2]], double)),
        braces(each(case.x0, double)), double(s.t), braces(each(s.x, long)))
    end
  end
  out[#out + 1] = "};"
  write("forced_top.h", out)
end

-- ---- forced_top.json: points in rotating frames ----
do
  local out = head("moving.h", "points in rotating frames, 32 digits",
    "static const struct {\n  const char *id;\n  int n; /* states: r, v in n/2 coordinates */\n" ..
    "  double x0[6], t;\n  long double x[6];\n} moving_rows[] = {")
  for _, case in ipairs(json("forced_top.json").cases) do
    for _, s in ipairs(case.model == "point motion in rotating frame" and case.samples or {}) do
      out[#out + 1] = string.format('  {"%s", %d, %s, %s,\n   %s},', case.id, #case.x0, braces(each(case.x0, double)),
        double(s.t), braces(each(s.x, long)))
    end
  end
  out[#out + 1] = "};"
  write("moving.h", out)
end

-- ---- forced_top.json: effects, for tests/effects ----

-- The cases of these models; scalars, lists: which parameters are kept.
local function effects(file, about, names, models, scalars, lists)
  local out = { "-- " .. file .. " - " .. about .. ": states at times, 32 digits",
    "-- SPDX-License-Identifier: GPL-3.0-or-later", "--",
    "-- Made by convert.lua; provenance in README.md beside this file.  x: " .. names .. ".", "",
    "return {" }
  local function words(list) -- a long list takes a second line
    local text = table.concat(each(list, tostring), "\", \"")
    if #list > 7 then
      text = "\n      \"" .. table.concat(each({ table.unpack(list, 1, 7) }, tostring), "\", \"") .. "\",\n      \"" ..
        table.concat(each({ table.unpack(list, 8) }, tostring), "\", \"")
    else
      text = " \"" .. text
    end
    return "{" .. text .. "\" }"
  end
  for _, case in ipairs(json("forced_top.json").cases) do
    if models[case.model] then
      local p = case.params
      out[#out + 1] = string.format("  { id = %q,\n    model = %q,", case.id, case.model)
      if p.I then out[#out + 1] = "    I = " .. words(p.I) .. "," end
      for _, k in ipairs(scalars) do
        if p[k] then out[#out + 1] = string.format("    %s = %q,", k, tostring(p[k])) end
      end
      for _, k in ipairs(lists) do
        if p[k] then out[#out + 1] = "    " .. k .. " = " .. words(p[k]) .. "," end
      end
      out[#out + 1] = "    x0 = " .. words(case.x0) .. ","
      for _, s in ipairs(case.samples) do
        out[#out + 1] = "    { t = \"" .. tostring(s.t) .. "\","
        for i = 1, #s.x, 2 do
          local row = {}
          for k = i, math.min(i + 1, #s.x) do row[#row + 1] = "\"" .. tostring(s.x[k]) .. "\"" end
          out[#out + 1] = "      " .. table.concat(row, ", ") .. (i + 2 > #s.x and " }," or ",")
        end
      end
      out[#out + 1] = "  },"
    end
  end
  out[#out + 1] = "}"
  write(file, out)
end

effects("effects.lua", "drag, wheels", "w, then q, then the wheels' speeds",
  { ["quadratic damping"] = true, ["gyrostat (torque-free rotor on axis 3)"] = true,
    ["three reaction wheels on the principal axes, constant motor torque"] = true },
  { "c", "J", "Js" }, { "u" })
effects("effects_time.lua", "gravity gradient, a tensor that changes", "w, or L in body axes with I_of_t, then q",
  { ["gravity gradient"] = true, ["time-varying principal inertia (no internal momentum)"] = true },
  { "n", "I_of_t" }, {})

-- ---- nesc_brick_case2.csv: simulator 04, every half second ----
do
  local out = head("nesc_case2.h", "NASA check case 2, simulator 04",
    "static const struct {\n  double t, rate[3]; /* s; p q r, deg/s, inertial */\n" ..
    "  double angle[3];   /* yaw, pitch, roll against local north-east-down, deg */\n} nesc_rows[] = {")
  local column
  for line in slurp("nesc_brick_case2.csv"):gmatch "[^\r\n]+" do
    local field = {}
    for f in line:gmatch "[^,]+" do
      field[#field + 1] = f
    end
    if not column then
      column = {}
      for i, name in ipairs(field) do
        column[name] = i
      end
    elseif tonumber(field[1]) * 2 % 1 == 0 then
      local function get(name)
        return double(field[column["sim04_" .. name]])
      end
      out[#out + 1] = string.format("  {%s, %s, %s},", double(field[1]),
        braces { get "p", get "q", get "r" }, braces { get "psi", get "theta", get "phi" })
    end
  end
  out[#out + 1] = "};"
  write("nesc_case2.h", out)
end

-- ---- nesc_brick_case3.csv: the five simulators, every half second ----
do
  local out = { "-- nesc_case3.lua - NASA check case 3, five simulators",
    "-- SPDX-License-Identifier: GPL-3.0-or-later", "--",
    "-- Made by convert.lua; provenance in README.md beside this file.  Rows: t, then of simulators 01,",
    "-- 02, 04, 05, 06 p, q, r (deg/s, inertial), yaw, pitch, roll (deg, against local north-east-down).", "",
    "return {" }
  local titles = false
  for line in slurp("nesc_brick_case3.csv"):gmatch "[^\r\n]+" do
    local field = {}
    for f in line:gmatch "[^,]+" do field[#field + 1] = f end
    if titles and tonumber(field[1]) * 2 % 1 == 0 then
      out[#out + 1] = "  { " .. field[1] .. ","
      for i = 2, 31, 6 do
        out[#out + 1] = "    " .. braces { table.unpack(field, i, i + 5) } .. (i < 26 and "," or " },")
      end
    end
    titles = true
  end
  out[#out + 1] = "}"
  write("nesc_case3.lua", out)
end

-- ---- plane.json: bodies that roll and slide on a plane ----
do
  local laws = { rolling = "PH_ROLLING", frictionless = "PH_SMOOTH", sliding_viscous = "PH_VISCOUS",
    sliding_coulomb = "PH_COULOMB" }
  local out = head("plane.h", "bodies on a plane: state, reaction and what the inputs' rounding moves, 32 digits",
    "static const struct {\n  const char *id;\n  double mass, inertia[6];\n  ph_plane plane;\n" ..
    "  double q[4], w[3], com[3], v[3], damping;\n  double t;\n" ..
    "  long double at_q[4], at_w[3], at_com[3], at_v[3], N;\n" ..
    "  double q_sensitivity, w_sensitivity, com_sensitivity, v_sensitivity, N_sensitivity;\n} plane_rows[] = {")
  local function doubles(list, n)
    local texts = {}
    for i = 1, n or #list do texts[i] = double(list and list[i] or "0.0") end
    return braces(texts)
  end
  local function longs(list)
    local texts = {}
    for i, x in ipairs(list) do texts[i] = long(x) end
    return braces(texts)
  end
  for _, case in ipairs(json("plane.json").cases) do
    local p, s, first = case.params, case.params.surface, case.initial
    local axes = s.kind == "ellipsoid" and s.semi_axes
    if s.kind == "disc" then axes = { s.radius, s.radius, "0.0" } end
    local f = p.friction or {}
    local plane = string.format("{.law = %s, .placed = 1, .half_axes = %s, .axes = %s, .rim = %s, .centre = %s, " ..
      ".normal = %s, .e1 = {1, 0, 0}, .rate = %s, .gravity = {0, 0, -%s}, .friction = %s, .smoothing = %s}",
      laws[case.mode], doubles(axes or { "0.0", "0.0", "0.0" }), doubles(s.axes or { "1.0", "0.0", "0.0", "0.0" }),
      double(s.kind == "sphere" and s.radius or s.rim or "0.0"), doubles(s.centre or { "0.0", "0.0", "0.0" }),
      doubles(p.plane.normal), double(p.plane.rate), double(p.g), double(f.c or f.mu or "0.0"),
      double(f.eps or "0.0"))
    for _, row in ipairs(case.samples) do
      local far = row.input_ulp_sensitivity
      local none = { "0.0", "0.0", "0.0" }
      local fields = { '"' .. case.id .. '"', double(p.mass), doubles(p.inertia), plane, doubles(first.q),
        doubles(first.omega), doubles(first.com), doubles(first.velocity or none), double(p.damping or "0.0"),
        double(row.t), longs(row.q), longs(row.omega), longs(row.com), longs(row.velocity), long(row.N),
        double(far.q_abs), double(far.omega_rel), double(far.com_abs), double(far.velocity_abs), double(far.N_rel) }
      out[#out + 1] = "  " .. braces(fields) .. ","
    end
  end
  out[#out + 1] = "};"
  write("plane.h", out)
end
