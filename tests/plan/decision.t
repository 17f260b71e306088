#!/usr/bin/env lua5.4
-- decision.t - a plan as text: what is kept, what is believed when it is read back, and what it is the answer to.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local decision = require "generator.plan.decision"
local plan = require "generator.plan.plan"

local function question(text, more)
  local job = assert(scene.read(text or [[local a = param("a", 0.2, "m")
return scene { name = "s", body = solid.box { x = a, y = 0.1, z = 0.05, mass = 1 },
  initial = { omega = {1, 2, 3} } }]]))
  local q = { job = job, accuracy = 1e-9, real = "double", target = "x86-64" }
  for k, v in pairs(more or {}) do q[k] = v end -- into a table: order is lost anyway
  return decision.question(q, "0123")
end

local made = { method = "taylor", setting = "step", order = 14, value_text = "0.05715", title = "taylor, order 14, ...",
  accuracy_text = "1e-9", real = "double", target = "x86-64", expected = { "1", "0.5" }, bounds = { "1e-9", "2e-9" },
  report = { "Planned for ...", "    and a second line" } }

-- ---- there and back ----

local asked = question()
local text = decision.text(asked, made)
local back = decision.kept(asked, text, 2)
tap.is(back and back.order, 14, "the order comes back as a number")
for _, k in ipairs { "method", "setting", "value_text", "title", "accuracy_text", "real", "target" } do
  tap.is(back[k], made[k], k .. " comes back")
end
for _, k in ipairs { "expected", "bounds", "report" } do
  tap.is(table.concat(back[k], "\n"), table.concat(made[k], "\n"), "the list " .. k .. " comes back")
end
local no = decision.kept(asked, decision.text(asked, { refused = "cannot be", got = "1e-20" }), 2)
tap.is(no.refused .. no.got, "cannot be1e-20", "a refusal is kept, too")

-- ---- what is not whole is not believed ----

tap.is(decision.kept(asked, nil, 2), nil, "nothing kept")
for cut = #asked, #text - 1, 7 do
  if decision.kept(asked, string.sub(text, 1, cut), 2) then tap.ok(false, "cut after " .. cut) end
end
tap.is(decision.kept(asked, string.sub(text, 1, -2), 2), nil, "a text that was cut anywhere")
local function spoiled(name, from, to)
  local bad, n = string.gsub(text, from, to)
  assert(n == 1, name)
  tap.is(decision.kept(asked, bad, 2), nil, name)
end
spoiled("a number that is none", "0%.05715", "0.0x715")
spoiled("an expected state that is none", "expected 0%.5", "expected half")
spoiled("an unknown method", "method taylor", "method magic")
spoiled("an unknown word", "title ", "titel ")
spoiled("the end of a comment", "and a second line", "*/ int system(void); /*")
spoiled("bytes that no text has", "and a second line", "\1\2")
spoiled("another question", "accuracy 1e%-9", "accuracy 1e-3")
tap.is(decision.kept(asked, text, 3), nil, "another number of states")
tap.is(decision.kept(asked, text .. "more\n", 2), nil, "more after the end")

-- ---- the question has everything that decides ----

tap.is(question(), asked, "the same question, the same text")
local box = [[local a = param("a", 0.2, "m")
return scene { name = "s", body = solid.box { x = a, y = 0.1, z = %s, mass = 1 },
  initial = { omega = {1, 2, %s} }, %s }]]
local base = string.format(box, "0.05", "3", "")
local keys = { [decision.key(asked)] = "the first" }
for _, c in ipairs { { "a size", string.format(box, "0.06", "3", "") },
  { "a rate", string.format(box, "0.05", "4", "") },
  { "an effect", string.format(box, "0.05", "3", "effects = { effect.damping { c = 0.1 } }") },
  { "the horizon", string.format(box, "0.05", "3", "time = { horizon = 11 }") },
  { "a range", string.format(box, "0.05", "3", "ranges = { omega = 4 }") },
  { "another range", string.format(box, "0.05", "3", "ranges = { omega = 5 }") },
  { "a parameter's range", string.format(box, "0.05", "3", "ranges = { a = {0.1, 0.3} }") },
  { "a parameter's default", (string.gsub(base, "0%.2,", "0.3,")) },
  { "the name", (string.gsub(base, '"s"', '"other"')) }, { "the accuracy", base, { accuracy = 1e-8 } },
  { "the type", base, { real = "float" } }, { "the target", base, { target = "avr" } },
  { "the budget", base, { ops = 100 } }, { "the methods", base, { methods = { "rk4" } } },
  { "the order", base, { order = 8 } } } do
  local other = decision.key(question(c[2], c[3]))
  tap.is(keys[other], nil, "another question: " .. c[1])
  keys[other] = c[1]
end

-- A torque that is too long to be shown, of which one number differs.
local function long(number)
  return decision.key(question(string.format(box, "0.05", "3", string.format([[effects = { effect.custom {
    torque = function(s)
      local e = %s * s.w[1]
      for _ = 1, 12 do e = sin(e + e ^ 2) end
      return { e, 0, 0 }
    end } }]], number))))
end
tap.is(long("0.5"), long("0.5"), "a long torque, the same question")
tap.ok(long("0.5") ~= long("0.25"), "another number in it, another question")
tap.is(decision.key(question("-- a comment\n" .. base)), decision.key(asked), "comments do not count")
tap.like(decision.key(asked), "^%x+$", "a name of hexadecimal digits", true)

-- ---- a refusal names what limits ----

-- 1e-9 is wanted and half of it is not known: more than an eighth
local unknown = { refused = {}, found = {}, own = 5e-10 }
tap.is(decision.refusal({ accuracy = 1e-9, real = "double" }, unknown).refused, "cannot be planned: the motion " ..
  "magnifies roundings so much that the library itself knows it to 5e-10 only", "the library's own knowledge")
unknown.own = 0
tap.is(decision.refusal({ accuracy = 1e-9, real = "float" }, unknown).refused,
  "cannot be planned: the rounding of float", "the type")

-- ---- the order that NAME_taylor_run takes, as the emitted code has it ----

local job = assert(scene.read [[return scene { name = "s", body = solid.box { x = 3, y = 2, z = 1, mass = 1 } }]])
job = scene.plan(job, { methods = { "taylor" } })
local source = scene.files(job)["s.c"]
-- least - slope log2(tolerance), cut to a whole number: 9.5 + 0.375*30 = 20.75 for 2^-30
tap.ok(source:find("9.5", 1, true) and source:find("0.375*taylor_log2(tolerance)", 1, true),
  "the emitted code has the law that is counted with")
tap.is(plan.order(2 ^ -30, "double"), 20, "its order at 2^-30")
tap.is(plan.order(2 ^ -30, "float"), 20, "in float, too")
tap.is(plan.order(0.5, "double"), 9, "at 1/2")
tap.is(plan.order(2 ^ -60, "double"), 30, "never above the largest")

tap.done()
