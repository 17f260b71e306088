-- bodies.lua -- mass properties by the emitted code, by the generator's algebra and by the library, against an oracle.
--
--     bodies.compare(row, { parameters = "...", body = "...", origin =, values = {{...}, ...}, oracle = fn, count = 9
--     })
--
-- The scene is called "body"; its parameters take each list of values, rounded to the type.  The oracle gets them as
-- rationals and returns a body of moments.lua; the numbers compared are mass, centre and tensor about the origin of
-- rotation.  What is measured, in all of them: |error|/scale, where the scale is
--     mass      the mass
--     centre    its largest component, or what `size` says (a number, or a function of the parameters) near 0
--     tensor    each entry of the diagonal itself (they are sums of positive terms), for products the root of the
--               product of their two diagonal entries; with entries = "largest" the largest entry.
-- Rows: "init" (NAME_init, NAME_mass, NAME_inertia), the library, and "algebra": the generator's exact expressions at
-- 240 bits, held to u^2.
-- SPDX-License-Identifier: GPL-3.0-or-later

return function(kit)
  local evaluate = require "generator.algebra.evaluate"
  local moments = require "generator.hard.moments"
  local R = kit.R
  local bodies = { moments = moments, q = moments.q }

  -- ---- the programs ----

  local function spelled(command)
    local words = { command[1] }
    for i = 2, #command do words[i] = string.format("%a", command[i]) end
    return table.concat(words, " ")
  end
  local function parsed(lines)
    local rows = {}
    for i, line in ipairs(lines) do
      rows[i] = {}
      for word in string.gmatch(line, "%S+") do
        rows[i][#rows[i] + 1] = tonumber(word) or word == "inf" and math.huge or word == "-inf" and -math.huge or 0 / 0
      end
    end
    return rows
  end

  -- The answers of the emitted code of the scene to commands {word, number...} (mass.c).
  function bodies.ask(text, real, commands, define)
    local list = {}
    for i, c in ipairs(commands) do list[i] = spelled(c) end
    return parsed(kit.program { text = text, real = real, source = "tests/hard/mass.c", arguments = list,
      define = define })
  end

  -- The same of library.c.
  function bodies.library(commands)
    local list = {}
    for i, c in ipairs(commands) do list[i] = spelled(c) end
    return parsed(kit.program { source = "tests/hard/library.c", arguments = list })
  end

  -- The input torque keeps closed forms away: less to compile.
  function bodies.scene(parameters, body, origin, effects)
    return string.format("%s\nreturn scene { name = \"body\", body = %s, effects = { %s }, origin = %s }\n", parameters,
      body, effects or "effect.control{}", origin or "{0, 0, 0}")
  end

  -- ---- errors ----

  -- |x - want|/scale; scale 0: |x|, a number that must be 0
  function bodies.error(x, want, scale)
    if x - x ~= 0 then return math.huge end
    local d = R.abs(R.fromdouble(x) - want)
    return R.todouble(R.sign(scale) == 0 and d or d / R.abs(scale))
  end
  local function largest(list)
    local most = R.zero
    for _, x in ipairs(list) do
      if R.abs(x) > most then most = R.abs(x) end
    end
    return most
  end
  bodies.largest = largest

  local pairs_of = { [4] = { 1, 2 }, [5] = { 1, 3 }, [6] = { 2, 3 } }
  local function scale_of(I, n, entries)
    if entries == "largest" then return largest(I) end
    if n <= 3 then return I[n] end
    local product = I[pairs_of[n][1]] * I[pairs_of[n][2]]
    return R.sign(product) == 0 and R.zero or R.apply("sqrt", 64, product)
  end
  bodies.scale_of = scale_of

  -- The worst error of a tensor of doubles.
  function bodies.tensor_error(got, want, entries)
    local worst = 0.0
    for n = 1, 6 do worst = kit.worst(worst, bodies.error(got[n], want[n], scale_of(want, n, entries))) end
    return worst
  end

  -- got: {mass, com1, com2, com3, I...}
  local function extent(o, com, p)
    local size = o.size
    if type(size) == "function" then size = size(p) end
    return size and bodies.q(size) or largest(com)
  end
  local function whole(got, want, o, p)
    local com, I = moments.com(want), moments.tensor(want)
    local size = extent(o, com, p)
    local worst = bodies.error(got[1], want.m, want.m)
    for i = 1, 3 do worst = kit.worst(worst, bodies.error(got[1 + i], com[i], size)) end
    return kit.worst(worst, bodies.tensor_error({ table.unpack(got, 5, 10) }, I, o.entries))
  end

  -- ---- comparisons ----

  local function names(job)
    local list = {}
    for i, p in ipairs(job.model.params) do list[i] = p.name end
    return list
  end

  -- count: roundings along the longest path to a number, for double and float alike: the bound is count u.
  -- condition: of {"init", value...}, what an error of u grows to in the formula that is promised; library_condition:
  -- of the values, what the library's bodies lose by being doubles between two steps.
  function bodies.compare(row, o)
    local text = bodies.scene(o.parameters, o.body, o.origin, o.effects)
    local job, why = kit.read(text)
    if not job then error(why, 0) end
    local list = names(job)
    local library, algebra = 0.0, 0.0
    for _, real in ipairs(o.reals or kit.reals) do
      local commands, exact, worst = {}, {}, 0.0
      for i, values in ipairs(o.values[real] or o.values) do
        local p = kit.rounded(real, values)
        exact[i] = {}
        for k, x in ipairs(p) do exact[i][k] = R.fromdouble(x) end
        commands[#commands + 1] = { "init", table.unpack(p) }
        commands[#commands + 1] = { "mass" }
        commands[#commands + 1] = { "inertia" }
        if real == "double" and not o.no_library then
          local named = {}
          for k, x in ipairs(p) do named[list[k]] = x end
          local got, reason = kit.mass(job, named)
          if not got then error("library: " .. tostring(reason), 0) end
          local e = whole({ got.mass, got.com[1], got.com[2], got.com[3], table.unpack(got.inertia) },
            o.oracle(exact[i]), o, exact[i])
          library = kit.worst(library, e / (o.library_condition and o.library_condition(p) or 1))
        end
        if real == "double" then algebra = kit.worst(algebra, bodies.algebra(job, list, exact[i], o)) end
      end
      local rows = bodies.ask(text, real, commands)
      for i, p in ipairs(exact) do
        local status, mass, I = rows[3 * i - 2], rows[3 * i - 1], rows[3 * i]
        if status[1] ~= 0 then error(string.format("init answers %g", status[1]), 0) end
        local e = whole({ mass[1], mass[2], mass[3], mass[4], table.unpack(I) }, o.oracle(p), o, p)
        worst = kit.worst(worst, e / (o.condition and o.condition(commands[3 * i - 2]) or 1))
      end
      row("init", real, worst, o.count * kit.u[real])
    end
    if not o.no_library then row("library", "long double", library, (o.library_count or o.count) * kit.u.double) end
    if not o.no_algebra then row("algebra", "exact", algebra, kit.u.double ^ 2) end
  end

  -- The model's own expressions: what explain prints and what is baked.
  function bodies.algebra(job, list, p, o)
    local m, env, worst = job.model, {}, 0.0
    for k, name in ipairs(list) do env[name] = p[k] end
    local want = o.oracle(p)
    local com, I = moments.com(want), moments.tensor(want)
    local size = extent(o, com, p)
    local function compare(e, x, scale)
      local d = R.abs(evaluate.precise(e, env, 240) - x)
      worst = kit.worst(worst, R.todouble(R.sign(scale) == 0 and d or d / R.abs(scale)))
    end
    compare(m.mass, want.m, want.m)
    for i = 1, 3 do compare(m.com[i], com[i], size) end
    for n = 1, 6 do compare(m.inertia[n], I[n], scale_of(I, n, o.entries)) end
    return worst
  end

  return bodies
end
