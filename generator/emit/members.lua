-- members.lua -- a sweep's members as C: templates/sweep/members.c filled from what was asked for.
--
--     members.fill(job, made) -> the values of the templates, render(template); made: from code.of
--     members.mathematics(job) -> the text of sweep_math.c
-- job.sweep is the study (commands/sweep/study.lua):
--     values   {name, unit, about, kind = "param" (with factor), "state", "turn" (with place 1..3, body), over = {low,
--              high, count, log} or draw = {kind, a, b, dimension, part, row = numbers}}, axes first
--     keeps    {kind = "state" | "final" | "first" | "rise" | "fall" | "max" | "min" | "states" | "drift", name, e,
--              unit, about}
--     times, stretches {t0, t1, h, steps, time = place among times or nil}
--     members, samples, seed, points, stats, accuracy, order (of the method), step (its name among the functions)
-- Values are as the user wrote them, in the parameter's own unit; only the C below turns them into SI units.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local calculus = require "generator.algebra.calculus"
local evaluate = require "generator.algebra.evaluate"
local happenings = require "generator.dynamics.happenings"
local hash = require "generator.hash"
local base = require "generator.emit.base"
local judged = require "generator.emit.judged"
local lanes = require "generator.emit.lanes"
local libm = require "generator.emit.libm"
local number = require "generator.emit.number"
local source = require "generator.emit.source"
local template = require "generator.emit.template"

local members = {}

local GROUP = template.group("sweep/members.c", "sweep/watch.c", "sweep/Makefile", "sweep/cmake.txt", "sweep/job.slurm",
  "sweep/README.md")
local MATHEMATICS = template.group("sweep/sweep_math.c")

local function int(n) return string.format("%d", n) end

-- A double as C text that reads back.
local function double(x, real) return number.text(R.fromdouble(x), real or "double") end

-- Text as C strings of at most 64 characters, and a piece for each line.
local function strings(text)
  local list = {}
  for line in string.gmatch(text, "[^\n]*\n?") do
    while line ~= "" do
      local piece = string.sub(line, 1, 64)
      list[#list + 1] = "\"" .. string.gsub(piece, "[%c\"\\?\128-\255]", function(c)
        return c == "\n" and "\\n" or (c == "\"" or c == "\\") and "\\" .. c or string.format("\\%03o", string.byte(c))
      end) .. "\""
      line = string.sub(line, 65)
    end
  end
  if #list == 0 then list[1] = "\"\"" end
  return list
end

-- ---- values: where they go ----

-- What a value in the parameter's own unit is multiplied by, as C: a quotient where that is exact.
local function in_si(x, factor)
  if factor.kind == "num" then
    local q = factor.value
    if q == R.one then return x end
    if R.num(q) == R.one then return x .. "/" .. number.text(R.one / q, "double") end
  end
  return x .. "*" .. number.text(R.fromdouble(evaluate.double(factor, {})), "double")
end

-- Statements that set parameters p and states x; attitudes last: given components, then turns.
local function assigned(study, v)
  local params, states, quaternion, turned, turns = {}, {}, false, false, {}
  for i, value in ipairs(study.values) do
    local x = "v[" .. int(i - 1) .. "]"
    if value.kind == "param" then
      params[#params + 1] = "p[" .. v.upper .. "_" .. string.upper(value.name) .. "] = (real)(" ..
        in_si(x, value.factor) .. ");"
    elseif value.kind == "state" then
      states[#states + 1] = "x[" .. v.upper .. "_" .. string.upper(value.name) .. "] = (real)" .. x .. ";"
      quaternion = quaternion or string.find(value.name, "^q[wxyz]$") ~= nil
    else
      turns[value.body] = turns[value.body] or { "0.0", "0.0", "0.0" }
      turns[value.body][value.place], turned = x, true
    end
  end
  if quaternion or turned then
    local q = {}
    for k, name in ipairs { "QW", "QX", "QY", "QZ" } do q[k] = "x[" .. v.upper .. "_" .. name .. "]" end
    states[#states + 1] = "{"
    states[#states + 1] = "  double q[4] = {(double)" .. table.concat(q, ", (double)") .. "};"
    states[#states + 1] = ""
    if quaternion then states[#states + 1] = "  sweep_unit(q);" end
    for _, body in ipairs { true, false } do
      if turns[body] then
        states[#states + 1] = "  sweep_turn(q, " .. table.concat(turns[body], ", ") .. ", " .. (body and "1" or "0") ..
          ");"
      end
    end
    for k = 1, 4 do states[#states + 1] = "  " .. q[k] .. " = (real)q[" .. int(k - 1) .. "];" end
    states[#states + 1] = "}"
  end
  return params, states
end

-- ---- expressions ----

local TAKEN = { p = true, t = true, x = true, y = true, k = true, real = true, m = true, b = true }

-- A description of the expressions as y[0], y[1] ..; they read parameters p, time and states.  why: nil, the user's.
local function description(job, v, name, list, why)
  local m = job.model
  local names = {}
  for _, s in ipairs(job.states) do names[s.name] = true end
  local inputs, map = source.parameters({ upper = v.upper }, m.params, function(word)
    return TAKEN[word] or names[word] or m.members[word] ~= nil
  end)
  for _, s in ipairs(job.states) do
    inputs[#inputs + 1] = { sym = s.name, c = "x[" .. v.upper .. "_" .. string.upper(s.name) .. "]", rank = 8 }
  end
  inputs[#inputs + 1] = { sym = "t", c = "t", rank = 8 }
  local outs = {}
  for i, e in ipairs(list) do
    outs[i] = { array = "y", index = int(i - 1), expr = calculus.substitute(e, map) }
  end
  return { name = name, args = { { name = "p", count = 0 }, "t", "x", { name = "y", count = #list, out = true } },
    inputs = inputs, groups = { { why = why or "as --keep has it", defs = {}, outs = outs } } }
end

local PASSAGE = { first = "0", rise = "1", fall = "-1" }
local EXTREMUM = { max = "1", min = "-1" }

-- What is kept: columns, the statements that put it into a row, and what is watched and evaluated for it.
local function kept(job, v, study)
  local at, lines, columns, watched, final = #study.values, {}, {}, {}, {}
  v.has_drift, v.has_course, v.course_at = false, false, "0"
  v.has_passages, v.has_extrema = false, false
  v.only_passages = not study.accuracy and #study.keeps > 0
  local function column(name, unit, about, times) columns[#columns + 1] = { name, unit, about, times or 1 } end
  for _, k in ipairs(study.keeps) do
    v.only_passages = v.only_passages and PASSAGE[k.kind] ~= nil
    if k.kind == "state" then
      lines[#lines + 1] = "for (i = 0; i < " .. v.upper .. "_NX; i++) row[" .. int(at) .. " + i] = (double)x[i];"
      for _, s in ipairs(job.states) do column("final_" .. s.name, s.unit, "final " .. s.name) end
      at = at + #job.states
    elseif k.kind == "states" then
      v.has_course, v.course_at = true, int(at)
      for _, s in ipairs(job.states) do column(s.name .. "_at", s.unit, s.name .. " at the times", #study.times) end
      at = at + #job.states * #study.times
    else
      local value
      if k.kind == "drift" then
        v.has_drift = true
        value = "(double)" .. v.name .. "_" .. v.energy .. "(&b.model[k%MODELS], " .. (job.conserved.rate and
          "STRETCH[STRETCHES - 1].end, " or "") .. "x) - energy[k]"
      elseif k.kind == "final" then
        final[#final + 1] = k.e
        value = "(double)y[" .. int(#final - 1) .. "]"
      else
        watched[#watched + 1] = { e = k.e, passage = PASSAGE[k.kind] and "1" or "0", way = PASSAGE[k.kind] or
          EXTREMUM[k.kind] }
        local w = int(#watched - 1)
        v.has_passages, v.has_extrema = v.has_passages or PASSAGE[k.kind] ~= nil, v.has_extrema or
          EXTREMUM[k.kind] ~= nil
        value = PASSAGE[k.kind] and "(double)b.found[" .. w .. "][k]" or "(double)greatest(&b, k, " .. w .. ")"
      end
      lines[#lines + 1] = "row[" .. int(at) .. "] = " .. value .. ";"
      column(k.name, k.unit, k.about)
      at = at + 1
    end
  end
  if study.accuracy then
    column("error", "1", "estimated error, by a second run at twice the step")
    at = at + 1
  end
  v.kept_lines, v.width = lines, int(at)
  return columns, watched, final
end

-- ---- tables ----

local DRAWS = { uniform = "SWEEP_UNIFORM", loguniform = "SWEEP_LOGUNIFORM", normal = "SWEEP_NORMAL",
  joint = "SWEEP_JOINT", attitude = "SWEEP_ATTITUDE" }

local function tables(v, study, columns, reasons, scene)
  local out = {}
  local function put(s) out[#out + 1] = s end
  local axes, draws = {}, {}
  for _, value in ipairs(study.values) do
    local a, d = value.over, value.draw
    if a then
      axes[#axes + 1] = string.format("  {%s, %s, %d, %d}, /* %s */", double(a.low), double(a.high), a.count,
        a.log and 1 or 0, value.name)
    else
      local row = "NULL"
      if d.row then
        row = "ROW" .. int(#draws)
        local numbers = {}
        for i, x in ipairs(d.row) do numbers[i] = double(x) end
        put("static const double " .. row .. "[] = {" .. table.concat(numbers, ", ") .. "};")
      end
      draws[#draws + 1] = string.format("  {%s, %s, %s, %d, %d, %s}, /* %s */", DRAWS[d.kind], double(d.a or 0.0),
        double(d.b or 0.0), d.dimension, d.part or 0, row, value.name)
    end
  end
  local function list(head, lines)
    if #lines == 0 then return "NULL" end
    put("static const " .. head .. "[] = {")
    for _, l in ipairs(lines) do put(l) end
    put("};")
    return string.match(head, "(%u+)$")
  end
  v.axes_name, v.draws_name = list("sweep_axis AXES", axes), list("sweep_draw DRAWS", draws)
  v.axis_count, v.draw_count = int(#axes), int(#draws)
  local times = {}
  for i, t in ipairs(study.times) do times[i] = "  " .. double(t) .. "," end
  v.times_name = list("double TIMES_OF_STATES", times) == "NULL" and "NULL" or "TIMES_OF_STATES"
  local lines = {}
  local function quoted(s) return strings(s)[1] end
  for i, c in ipairs(columns) do
    lines[i] = string.format("  {%s, %s, %s, %d},", quoted(c[1]), quoted(c[2]), quoted(c[3]), c[4])
  end
  list("sweep_column COLUMNS", lines)
  lines = {}
  for _, s in ipairs(reasons) do
    local pieces = strings(s)
    for k, piece in ipairs(pieces) do
      lines[#lines + 1] = (k == 1 and "  (" or "    ") .. piece .. (k == #pieces and ")," or "")
    end
  end
  put("static const char *const REASONS[] = {")
  for _, l in ipairs(lines) do put(l) end
  put("};")
  put("static const char *const SCENE[] = {")
  for _, s in ipairs(strings(scene)) do put("  " .. s .. ",") end
  put("  NULL")
  put("};")
  v.table_lines, v.column_count, v.reason_count = out, int(#columns), int(#reasons)
end

local POINTS = { random = "SWEEP_RANDOM", sobol = "SWEEP_SOBOL", lhs = "SWEEP_LHS" }

-- What can become of a member: the words of the status column.
local function reasons(checks, cuts)
  local list = { table.unpack(happenings.members) }
  for _, c in ipairs(checks) do list[#list + 1] = "no body: " .. c.text end
  for _, text in ipairs(cuts and cuts.texts or {}) do list[#list + 1] = "no body: " .. text end
  return list
end

-- What is known of the members whose holes are not in their bodies (commands/sweep/cuts.lua): a table of the grid's
-- points and the place in it of point `at`, or tests of a value.  Reasons have the numbers after NAME_init's checks.
local function cut_lines(v, cuts, checks)
  v.has_cut_table, v.cut_lines, v.cut_place, v.cut_tests = cuts ~= nil and cuts.codes ~= nil, {}, "", {}
  local list, place = {}, {}
  for _, s in ipairs(cuts and cuts.spans or {}) do
    local value, tests = "v[" .. int(cuts.place) .. "]", {}
    if s.low then tests[1] = value .. " >= " .. double(s.low) end
    if s.high then tests[#tests + 1] = value .. " < " .. double(s.high) end
    v.cut_tests[#v.cut_tests + 1] = (#tests > 0 and "if (" .. table.concat(tests, " && ") .. ") " or "") ..
      "return SWEEP_REFUSED + " .. int(checks + s.code) .. ";"
  end
  if not v.has_cut_table then return end
  for i, c in ipairs(cuts.codes) do list[i] = int(c > 0 and checks + c or 0) end
  for i = 1, #list, 16 do
    v.cut_lines[#v.cut_lines + 1] = table.concat(list, ", ", i, math.min(i + 15, #list)) .. ","
  end
  for i, a in ipairs(cuts.axes) do place[i] = string.format("at/%dU%%%dU*%dU", a.stride, a.count, a.step) end
  v.cut_place = table.concat(place, " + ")
end

local function groups_of(job)
  local list = {}
  for i, s in ipairs(job.states) do
    local g = list[#list]
    local together = s.kind == "attitude" or s.kind == "rates" or s.kind == "position" or s.kind == "velocity"
    if not (g and together and g.kind == s.kind) then
      g = { kind = s.kind, first = int(i - 1), attitude = s.kind == "attitude" and "1" or "0" }
      list[#list + 1] = g
    end
    g.last = int(i)
  end
  return list
end

-- The C of what is watched, of what is kept of the final state, and of what members are judged by: all its lines.
local function printed(job, v, made, watched, final)
  local ctx, text = made.ctx, {}
  v.has_watched, v.watched_count = #watched > 0, int(math.max(1, #watched))
  v.watches = watched
  v.has_final, v.final_count = #final > 0, int(#final)
  local function body(list)
    for _, l in ipairs(list) do text[#text + 1] = l end
    return list
  end
  v.watch_lines, v.watch_common, v.watch_loop, v.final_lines, v.law_lines = {}, {}, {}, {}, {}
  if v.has_watched then
    local es = {}
    for i, w in ipairs(watched) do es[i] = w.e end
    local f = description(job, made.base, "watched", es)
    v.watch_lines = body(source.make(ctx, f).lines)
    local block = lanes.make(ctx, f, false)
    v.watch_common, v.watch_loop = body(block.common), body(block.lines)
  end
  if v.has_final then v.final_lines = body(source.make(ctx, description(job, made.base, "final", final)).lines) end
  local laws, why = judged.laws(job)
  v.has_laws, v.law_count = laws ~= nil, int(laws and #laws or 1)
  v.has_flat, v.has_parts = why == judged.flat, why == judged.parts
  v.settling = double(job.model:double(job.model.step) + 0.0, job.real)
  if laws then v.law_lines = body(source.make(ctx, description(job, made.base, "laws", laws, why)).lines) end
  local whole = table.concat(text, "\n")
  v.own_libm_source = ctx.own and libm.source(base.of(job, true), ctx, job.templates, whole) or ""
  return text
end

function members.fill(job, made)
  local study, real, common = job.sweep, job.real, made.base
  local v = setmetatable({}, { __index = common })
  v.step = study.step
  v.advance = study.step == "step" and "advance" or string.gsub(study.step, "_step$", "_advance")
  v.own_models, v.each = false, false
  for _, value in ipairs(study.values) do v.own_models = v.own_models or value.kind == "param" end
  v.each = v.own_models and made.parts.each or false
  v.models = v.own_models and "LANES" or "1"
  v.has_contact = job.equations.touch and true or false
  v.piece = int(judged.piece(job))
  v.contact_inputs = common.has_inputs and "b->u, " or "NULL, "
  v.inputs, v.step_inputs = common.has_inputs and "b->u" or "NULL", common.has_inputs and "u" or "NULL"
  v.energy = job.conserved.rate and "jacobi_integral" or "energy"
  v.energy_time = job.conserved.rate and "STRETCH[0].t, " or ""
  v.parameter_lines, v.state_lines = assigned(study, common)
  local columns, watched, final = kept(job, v, study)
  local all = {}
  for i, value in ipairs(study.values) do all[i] = { value.name, value.unit, value.about, 1 } end
  for _, c in ipairs(columns) do all[#all + 1] = c end
  v.passed = v.only_passages and " || passed(b, k)" or ""
  local text = printed(job, v, made, watched, final)
  v.judged = v.has_contact or common.has_attitude or v.has_laws
  v.stretches = {}
  for i, s in ipairs(study.stretches) do
    v.stretches[i] = { t = double(s.t0, real), last = double(s.t1, real), h = double(s.h, real),
      steps = int(s.steps), time = int(s.time and s.time - 1 or -1) }
  end
  v.stretch_count, v.time_count = int(#v.stretches), int(#study.times)
  v.groups = groups_of(job)
  v.group_count, v.varied_count = int(#v.groups), int(#study.values)
  v.checked = study.accuracy ~= nil
  v.richardson = study.accuracy and double(2.0 ^ study.order - 1.0) or ""
  v.accuracy = study.accuracy and double(study.accuracy) or ""
  v.tolerance = real == "float" and "1e-7F" or "4e-16"
  v.extremum_tolerance = real == "float" and "1e-3F" or "1e-7"
  local render = GROUP(job.templates, common, v)
  v.watch_source = v.has_watched and string.gsub(render "sweep/watch.c", "\n+$", "") or ""
  tables(v, study, all, reasons(made.parts.init.checks, study.cuts), job.text)
  cut_lines(v, study.cuts, #made.parts.init.checks)
  v.members, v.samples, v.seed = int(study.members), int(study.samples), string.format("%u", study.seed)
  v.points, v.stats = POINTS[study.points or "random"], study.stats and "1" or "0"
  v.command_lines, v.command_text = { job.command }, strings(job.command)
  local parts = { common.build, made.header, made.source, v.width, v.models, v.step, v.richardson, v.accuracy,
    v.points, v.stats, v.seed, v.samples, v.members }
  for _, list in ipairs { v.table_lines, v.cut_lines, v.cut_tests, v.parameter_lines, v.state_lines, v.kept_lines,
    text } do
    parts[#parts + 1] = table.concat(list, "\n")
  end
  for _, s in ipairs(v.stretches) do parts[#parts + 1] = table.concat({ s.t, s.last, s.h, s.steps, s.time }, " ") end
  for _, w in ipairs(v.watches) do parts[#parts + 1] = w.passage .. w.way end
  v.fingerprint = hash.of(table.concat(parts, "\n"))
  return v, render
end

-- What the same bits on every machine are computed by.
function members.mathematics(job)
  local doubles = base.of(setmetatable({ real = "double" }, { __index = job }), true)
  local v = setmetatable({ name = "own", upper = "OWN" }, { __index = doubles })
  local ctx = { name = "own", upper = "OWN", real = "double", own = true }
  local text = libm.source(v, ctx, job.templates, "own_log( own_exp( own_sin( own_cos(")
  return MATHEMATICS(job.templates, doubles, { functions_source = text }) "sweep/sweep_math.c"
end

return members
