#!/usr/bin/env lua5.4
-- motion.t - one kind of motion for all commands: what it gives, and what it says where it ends.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Plugin and library are made up: x2 is the start's plus the time since; steps of their own choice reach t = 2.625.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local happenings = require "generator.dynamics.happenings"
local motion = require "generator.dynamics.motion"

local END = 2.625
local job = { model = { has = {} }, states = { { name = "wx", kind = "rates" }, { name = "wy", kind = "rates" } } }

-- What the plugin was asked for last, and what it makes of a state.
local asked, changed, infinite
local plugin = {}
function plugin.integrate(_, x, course, h, times, t0, method)
  asked = { course = course, h = h, times = times, method = method }
  local rows, reached = {}, t0
  for i, t in ipairs(times) do
    if type(h) == "table" and t > END then return nil, reached end
    rows[i], reached = { t, x[1], x[2] + (t - t0) }, t
    if changed then changed(rows[i]) end
  end
  return rows, 10 * #rows, infinite
end
function plugin.solve(_, x) return x[1] < 0 and 1 or 0 end
function plugin.at(_, t) return { 0.0, t < 5 and t or math.huge } end
function plugin.energy(_, x) return 1 / x[1] end
function plugin.peer(_, name, setting, _, times)
  asked = { name = name, setting = setting, times = times }
  return { { 1.0, 2.0, setting } }
end

local function shown(list)
  local out = {}
  for i, s in ipairs(list or {}) do out[i] = string.format("%g: %g %g", s.t, s.x[1], s.x[2]) end
  return table.concat(out, ", ")
end
local function fails(list, failure, t, text, what)
  tap.ok(not list and failure.t == t and failure.text == text and failure.status == 3, what,
    list and "it does not" or tostring(failure.t) .. " " .. failure.text)
end

-- ---- by steps ----

local m = motion.emitted(job, plugin, { x = { 1.0, 0.0 }, method = "rk4", step = 0.1, course = "held" })
local list, steps = m.solve({ 1.0, 2.0 }, {})
tap.is(shown(list), "1: 1 1, 2: 1 2", "states at the times that are asked for")
tap.is(steps, 20, "and the number of steps")
tap.ok(asked.h == 0.1 and asked.method == "rk4" and asked.course == "held", "by its own step, method and inputs")
tap.is(shown(m.solve({ 4.0 }, { from = list[2], step = 0.5 })), "4: 1 4", "from one of its states")
tap.is(asked.h, 0.5, "by another step")
tap.is(shown { (motion.to(m, 3.0)) }, "3: 1 3", "one state alone")

m = motion.emitted(job, plugin, { x = { 1.0, 0.0 }, step = 0.1, corners = { 0.0, 0.5, 1.0, 1.5, 9.0 } })
list = m.solve({ 1.0, 2.0 }, {})
tap.is(table.concat(asked.times, " "), "0.5 1.0 1.5 2.0", "fixed steps end at corners between the times")
tap.is(shown(list), "1: 1 1, 2: 1 2", "whose states nobody asked for")
m.solve({ 2.0 }, { from = list[1] })
tap.is(table.concat(asked.times, " "), "1.5 2.0", "from a state on only later ones")

-- ---- where it ends ----

m = motion.emitted(job, plugin, { x = { 1.0, 0.0 }, tolerance = 1e-9, most = 7 })
list = m.solve({ 1.0 }, {})
tap.ok(list and asked.h[1] == 1e-9 and asked.h[2] == 7, "a tolerance, and the most steps between two times")
local failure
list, failure = m.solve({ 1.0, 2.0, 3.0, 4.0 }, {})
fails(list, failure, nil, happenings.no_steps, "steps that lead no further, without a time")
for _, times in ipairs { { 1.0, 2.0, 3.0, 4.0 }, { 3.0, 4.0 } } do
  m = motion.emitted(job, plugin, { x = { 1.0, 0.0 }, tolerance = 1e-9, dated = true })
  list, failure = m.solve(times, {})
  tap.ok(not list and math.abs(failure.t - END) < 1e-10, "with one where it is asked for", failure and failure.t)
end

m = motion.emitted(job, plugin, { x = { 1.0, 0.0 }, step = 0.1 })
changed = function(row) row[3] = row[1] > 1 and 0 / 0 or row[3] end
list, failure = m.solve({ 1.0, 2.0, 3.0 }, {})
fails(list, failure, 2.0, happenings.infinite, "a state that is no number")
infinite = 1.75
list, failure = m.solve({ 1.0, 2.0, 3.0 }, {})
fails(list, failure, 1.75, happenings.infinite, "at the end of the step that led to it, where that is known")
infinite = nil
job.model.has.attitude = true
job.states[1].kind, job.states[2].kind = "attitude", "rates"
for _, square in ipairs { 0.89, 1.11 } do
  changed = function(row) row[2] = row[1] > 1 and math.sqrt(square) or 1.0 end
  list, failure = m.solve({ 1.0, 2.0 }, {})
  fails(list, failure, 2.0, happenings.long_step, "|q|^2 = " .. square .. ": the step is too long")
end
changed = function(row) row[2] = math.sqrt(0.91) end
tap.ok(m.solve({ 1.0, 2.0 }, {}), "0.91 may be")
changed = nil
m = motion.emitted(job, plugin, { x = { 1.0, 0.0 }, peer = "gsl", patience = 1 })
tap.is(shown(m.solve({ 1.0 }, { tolerance = 0.25 })) .. asked.name, "gsl", "an integrator of others is held to it, too")
job.model.has.attitude = nil
tap.is(shown(m.solve({ 1.0 }, { tolerance = 0.25 })) .. " " .. asked.name, "1: 2 0.25 gsl", "its states")

-- ---- the closed form ----

m, failure = motion.emitted(job, plugin, { x = { -1.0, 0.0 }, method = "exact" })
fails(m, failure, nil, "the closed form refuses the initial state", "a start that the closed form refuses")
m = motion.emitted(job, plugin, { x = { 1.0, 0.0 }, method = "exact" })
tap.is(shown(m.solve({ 3.0, 4.0 }, {})), "3: 0 3, 4: 0 4", "its states")
list, failure = m.solve({ 4.0, 6.0 }, {})
fails(list, failure, 6.0, happenings.infinite, "where they end")
tap.is(m.measured { t = 1.0, x = { 4.0, 0.0 } }, 0.25, "the energy")
list, failure = m.measured { t = 1.0, x = { 0.0, 0.0 } }
fails(list, failure, 1.0, "the energy is not finite", "where it has none")

-- ---- the library ----

local host, implicit = {}, 0
function host.run(numbers, o)
  asked = { numbers = numbers, o = o }
  if o.times[1] > END then return nil, "at t = 2.625 s: the state is not finite", "numbers", END end
  if o.step then return nil, "no such method", "refused" end
  local rows = {}
  for i, t in ipairs(o.times) do rows[i] = { t, 1, 0, 0, 0, 8.0 + t, 9.0, 0, 77.0, 1.0, 2.0, 3.0 } end
  return rows, implicit
end
m = motion.library(host, job, { w = { 0, 0, 0 } }, { method = "taylor", tolerance = 1e-18, most = 5 })
list = m.solve({ 1.0 }, {})
tap.is(shown(list), "1: 9 9", "the scene's part of the library's state")
local energy, L = m.measured(list[1])
tap.is(energy .. ": " .. table.concat(L, " "), "77.0: 1.0 2.0 3.0", "with energy and L")
tap.ok(asked.o.tol == 1e-18 and asked.o.most == 5 and asked.o.t0 == 0 and not m.stiff, "by what it is made from")
implicit = 3
m.solve({ 2.0 }, { from = { t = 1.5, x = { 5.0, 6.0 } }, tolerance = 1e-9 })
tap.is(asked.o.t0 .. ": " .. table.concat(asked.numbers.w, " ") .. " " .. asked.o.tol, "1.5: 5.0 6.0 0.0 1e-09",
  "from a state, by another tolerance")
tap.ok(m.stiff, "it turned to an implicit method")
list, failure = m.solve({ 3.0 }, {})
fails(list, failure, END, happenings.infinite, "the words without the time")
tap.is(happenings.said(failure), "at t = 2.625 s: the state is not finite", "which messages have")
list, failure = m.solve({ 1.0 }, { step = 0.1 })
tap.ok(not list and failure.status == 2 and happenings.said(failure) == "no such method", "what was asked for is wrong")

tap.done()
