-- tested.lua -- NAME_test.c, the emitted self-test.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local number = require "generator.emit.number"
local selftest = require "generator.emit.selftest"
local template = require "generator.emit.template"
local vectors = require "generator.emit.vectors"

local GROUP = template.group("test/test.c", "test/test_follows.c", "test/test_tangent.c", "test/test_compensated.c",
  "test/test_normalise.c", "test/test_attitude.c", "test/test_many.c",
  "test/test_estimator.c")

local tested = {}

-- The tests of the attitude in other numbers that the functions on offer allow.
local function turns(offers)
  local list = {}
  if offers.matrix and offers.rotate then list[#list + 1] = "matrix_turns" end
  if offers.rotate and offers.unrotate then list[#list + 1] = "turned_back" end
  if offers.euler and offers.set_euler then list[#list + 1] = "euler_angles" end
  if offers.rotation_vector then list[#list + 1] = "rotation_vector" end
  return list
end

-- made: from code.of.
function tested.render(job, made)
  local p, v = made.parts, vectors.of(job, made)
  local planned = p.stepper.planned
  v.bits, v.headers = string.format("%d", selftest.bits), made.names.public
  v.has_full, v.has_centre = job.closed.full or false, job.closed.centre or false
  v.has_integral, v.ranges, v.planned = job.conserved.rate ~= nil, p.guard and p.guard.rows, planned ~= nil
  if planned then v.plan_want, v.plan_tolerance = planned.want, planned.tolerance end
  local render = GROUP(job.templates, made.base, v)
  v.follows_test, v.tangent_test = render "test/test_follows.c", render "test/test_tangent.c"
  v.compensated_test = v.test_compensated and render "test/test_compensated.c" or ""
  v.normalise_test = made.offers.normalise and render "test/test_normalise.c" or ""
  v.angle_square = number.text(R.parse "7.50144619136130430329531991444", job.real) -- (2 acos 0.2)^2
  v.turns = turns(made.offers)
  v.attitude_test = #v.turns > 0 and render "test/test_attitude.c" or ""
  v.has_estimator = made.offers.inertia
  for _, part in ipairs { "open", "add", "solve", "inertia" } do
    v.has_estimator = v.has_estimator and made.offers["estimator_" .. part]
  end
  v.estimator_test = v.has_estimator and render "test/test_estimator.c" or ""
  v.has_many = made.offers.step_many and made.offers.step and made.offers.initial
  v.many_apart = v.has_many and number.text(R.new(1, 1024), made.ctx.real) or nil
  v.many_test = v.has_many and render "test/test_many.c" or ""
  return render "test/test.c"
end

return tested
