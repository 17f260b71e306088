-- kit.lua -- what the cases of tests/hard measure with; it runs inside the program, with the whole generator.
--
--     local built = kit.emitted { text = [[return scene { ... }]], methods = { "rk4", "split4" } }
--     built.double.plugin:init(p), :solve(x0), :at(t), :march(t0, x, u, h, n, method), ...   the emitted code, compiled
--     built.float                                          the same scene in float: its numbers cross as doubles
--     kit.library(built.double.job, x0, { t })                states by the general library (long double)
--     kit.oracle("free_top", "-b 512", lines)                 rows of numbers by a program of tests/oracle (MPFR)
--     kit.program { text =, source = "tests/hard/x.c" }       lines that a C program of the case's own prints
--
-- Errors below are plain numbers; a NaN becomes infinite, so that it fails.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local build = require "generator.commands.build"
local driver = require "generator.driver"
local numeric = require "generator.dynamics.numeric"
local reference = require "generator.plan.reference"

return function(host)
  local kit = { host = host, R = R, reals = { "double", "float" },
    -- half a unit in the last place of 1: what one rounding does at most
    u = { double = 2.0 ^ -53, float = 2.0 ^ -24 },
    tiny = { double = 2.0 ^ -1074, float = 2.0 ^ -149 }, huge = { double = (2 - 2.0 ^ -52) * 2.0 ^ 1023,
      float = (2 - 2.0 ^ -23) * 2.0 ^ 127 } }

  -- ---- numbers ----

  -- x as the type holds it.
  function kit.round(real, x)
    if real == "float" then return (string.unpack("f", string.pack("f", x))) end
    return x + 0.0
  end
  function kit.rounded(real, list)
    local out = {}
    for i, x in ipairs(list) do out[i] = kit.round(real, x) end
    return out
  end

  function kit.number(e) return e == e and e or math.huge end
  function kit.worst(...)
    local most = 0.0
    for _, e in ipairs { ... } do
      e = kit.number(e)
      if e > most then most = e end
    end
    return most
  end

  -- The largest |a - b| of two lists over the largest |b|, or absolutely where b is 0.
  function kit.distance(a, b)
    local most, size = 0.0, 0.0
    for i = 1, #b do
      most, size = kit.worst(most, math.abs(a[i] - b[i])), math.max(size, math.abs(b[i]))
    end
    return size > 0 and most / size or most
  end

  -- The angle between two attitudes (quaternions, of either sign), rad; small ones only.
  function kit.angle(a, b)
    local plus, minus = 0.0, 0.0
    for i = 1, 4 do plus, minus = plus + (a[i] - b[i]) ^ 2, minus + (a[i] + b[i]) ^ 2 end
    return 2 * math.sqrt(kit.number(minus < plus and minus or plus))
  end

  -- States (qw qx qy qz wx wy wz ...): the worse of the attitudes' angle and the rates' distance.
  function kit.state(a, b)
    return kit.worst(kit.angle(a, b), kit.distance({ table.unpack(a, 5, 7) }, { table.unpack(b, 5, 7) }))
  end

  function kit.norm(x) -- | |q| - 1 |, to first order
    return kit.number(math.abs((x[1] * x[1] + x[2] * x[2] + x[3] * x[3] + x[4] * x[4] - 1) / 2))
  end

  function kit.finite(x)
    for i = 1, #x do
      if x[i] - x[i] ~= 0 then return false end
    end
    return true
  end

  -- ---- the emitted code ----

  local texts, dir = {}, assert(host.tempdir())

  -- A file beside the scenes (a mesh).
  function kit.beside(name, text) assert(host.write_file(dir .. "/" .. name, text)) end

  -- The scene's text as a job; job.diag:report() has what was refused: nil, message.
  function kit.read(text, set)
    local n = texts[text]
    if not n then
      texts[#texts + 1], n = text, #texts + 1
      texts[text] = n
      assert(host.write_file(string.format("%s/scene%d.lua", dir, n), text))
    end
    local job, d, why = driver.read(host, string.format("%s/scene%d.lua", dir, n), { set = set })
    if not job then return nil, d and d:report() or why end
    return job
  end

  -- o.text; o.methods: list of steppers (none: the closed form's scene with rk4); o.reals (both); o.order, o.libm,
  -- o.flags as gen and the compiler take them.  {real -> {job =, plugin =, real =, u =}}, compiled once for the same o.
  local made = {}
  function kit.emitted(o)
    local key = table.concat({ o.text, table.concat(o.methods or {}, ","), table.concat(o.reals or kit.reals, ","),
      tostring(o.order), tostring(o.libm), table.concat(o.flags or {}, " ") }, "\0")
    if made[key] then return made[key] end
    local list, out = {}, {}
    for i, real in ipairs(o.reals or kit.reals) do
      local s, why = kit.read(o.text)
      if not s then error(why, 0) end
      local job, d = driver.plan(s, { real = real, command = "", methods = o.methods, order = o.order, libm = o.libm })
      if not job then error(d:report(), 0) end
      -- -O1: the same bits as -O2 (no contraction), compiled sooner
      list[i] = { job = job, flags = { "-O1", table.unpack(o.flags or {}) } }
      out[real] = { job = job, real = real, u = kit.u[real] }
    end
    local plugins, failed = build.plugins(host, list)
    for i, item in ipairs(list) do
      if not plugins[i] then error(failed[i].message, 0) end
      out[o.reals and o.reals[i] or kit.reals[i]].plugin, item.flags = plugins[i], nil
    end
    made[key] = out
    return out
  end

  -- Runs fn(built, real) for each real type of the emitted scene, double first.
  function kit.each(o, fn)
    local built = kit.emitted(o)
    for _, real in ipairs(kit.reals) do
      if built[real] then fn(built[real], real) end
    end
  end

  -- The scene's initial state, as the real type holds it.
  function kit.initial(b) return kit.rounded(b.real, numeric.initial(b.job)) end

  -- ---- other roads ----

  -- States of the scene at the times, from x0 at t = 0, by the general library; values: {parameter -> double};
  -- u: held torque.  A second result: how far the library's two runs are apart.  Raises where it cannot.
  function kit.library(job, x0, times, values, u)
    local exact
    if values then
      exact = {}
      for _, p in ipairs(job.model.params) do exact[p.name] = R.fromdouble(values[p.name]) end
    end
    local rows, own = reference.new(host, job):motion(x0, times, exact, false, u)
    if not rows then error(own, 0) end
    return rows, own
  end

  -- Mass, com, tensor, principal moments and axes of the scene's body by the library: see host.mass.
  function kit.mass(job, values)
    local exact
    if values then
      exact = {}
      for _, p in ipairs(job.model.params) do exact[p.name] = R.fromdouble(values[p.name]) end
    end
    return host.mass(numeric.scene(job, exact))
  end

  -- lines: lists of numbers, passed on in hexadecimal.  Rows of numbers (nan for a word that is none).
  local count = 0
  function kit.oracle(name, options, lines)
    local text = {}
    for i, line in ipairs(lines) do
      local words = {}
      for k, x in ipairs(line) do words[k] = string.format("%a", x) end
      text[i] = table.concat(words, " ")
    end
    count = count + 1
    local path = string.format("%s/oracle%d", dir, count)
    assert(host.write_file(path, table.concat(text, "\n") .. "\n"))
    local status, out = host.execute({ "sh", "-c", string.format("build/oracle/%s %s < %s", name, options, path) },
      { seconds = 300 })
    if status ~= 0 then error("oracle " .. name .. ": " .. tostring(out), 0) end
    local rows = {}
    for line in string.gmatch(out, "[^\n]+") do
      local row = {}
      for word in string.gmatch(line, "%S+") do row[#row + 1] = tonumber(word) or 0 / 0 end
      rows[#rows + 1] = row
    end
    return rows
  end

  -- Rates and attitude by a scene of oracle free_top, in the order of a state.
  -- tensor: xx yy zz xy xz yz about the origin; x0: a state; list of states at the times.
  function kit.free_top(tensor, x0, times, options)
    local lines = {}
    for i, t in ipairs(times) do
      lines[i] = { tensor[1], tensor[2], tensor[3], tensor[4], tensor[5], tensor[6], x0[5], x0[6], x0[7], x0[1], x0[2],
        x0[3], x0[4], t }
    end
    local out = {}
    for i, r in ipairs(kit.oracle("free_top", options or "", lines)) do
      out[i] = { r[4], r[5], r[6], r[7], r[1], r[2], r[3] }
    end
    return out
  end

  -- The same of oracle heavy_top: I principal moments, mgr the first moment times g.
  function kit.heavy_top(I, mgr, x0, times, options)
    local lines = {}
    for i, t in ipairs(times) do
      lines[i] = { I[1], I[2], I[3], mgr[1], mgr[2], mgr[3], x0[5], x0[6], x0[7], x0[1], x0[2], x0[3], x0[4], t }
    end
    local out = {}
    for i, r in ipairs(kit.oracle("heavy_top", options or "", lines)) do
      out[i] = { r[4], r[5], r[6], r[7], r[1], r[2], r[3] }
    end
    return out
  end

  -- A toolbox beside this one: tests/hard/NAME.lua, a function of the kit.
  function kit.use(name) return require("generator.hard." .. name)(kit) end

  -- Compiles the emitted C of o.text (name: that of the scene; o.real, o.methods ...) with o.source, a C file that
  -- includes "scene.h" (o.define: lines of it), and runs it with o.arguments; its lines.  Without o.text the library
  -- alone.
  local programs = {}
  function kit.program(o)
    local key = table.concat({ o.text or "", o.real or "double", o.source, table.concat(o.methods or {}, ",") }, "\0")
    local at = programs[key]
    if not at then
      count = count + 1
      at = string.format("%s/program%d", dir, count)
      local files, with = { { name = "scene.h", text = "" } }, "-Isrc/runtime build/libpolhode.a"
      if o.text then
        local s, why = kit.read(o.text)
        if not s then error(why, 0) end
        local job, d = driver.plan(s, { real = o.real, command = "", methods = o.methods, order = o.order,
          libm = o.libm })
        if not job then error(d:report(), 0) end
        files, with = assert(driver.files(job, { plugin = {} })).files, string.format("%s/%s.c", at, job.model.name)
        files[#files + 1] = { name = "scene.h", text = (o.define or "") ..
          string.format('#include "%s.h"\n', job.model.name) }
      end
      assert(host.write_files(at, files))
      local command = string.format("${CC:-cc} -std=c11 -O1 -ffp-contract=off -I%s -Itests/hard -o %s/run %s %s -lm",
        at, at, o.source, with)
      local status, out = host.execute { "sh", "-c", command .. " 2>&1" }
      if status ~= 0 then error(o.source .. ": " .. tostring(out), 0) end
      programs[key] = at
    end
    local status, out = host.execute({ at .. "/run", table.unpack(o.arguments or {}) }, { seconds = o.seconds or 300 })
    if status ~= 0 then error(o.source .. " ends with " .. tostring(status) .. ": " .. tostring(out), 0) end
    local lines = {}
    for line in string.gmatch(out, "[^\n]+") do lines[#lines + 1] = line end
    return lines
  end

  -- tests/hard/NAME.lua, a table or a function of the kit; nil for the catalogue, which only reads what the cases say.
  function kit.tool(name)
    local tool = require("generator.hard." .. name)
    return type(tool) == "function" and tool(kit) or tool
  end

  return kit
end
