#!/usr/bin/env lua5.4
-- proof.t - Frama-C's Eva finds no alarm in the emitted steppers of three bodies, and finds those that are put there.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Three bodies in float and double: a free brick, a gyroscope with a control torque, NASA's brick that falls through
-- air (drag, density as a state of its own, position).  Parameters and states are anywhere within their ranges, the
-- number of steps is not bounded.  0 alarms alone may mean that nothing was looked at, so also: the ends of set-up,
-- step and fault branch are reached (make proof fails else), and every statement of the step and of the guard is
-- analysed, but for the return of a step of no time, of which the scene's step is none.
-- Negative controls break one thing each; each must raise the alarm that belongs to it.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"
local proof = require "tests.target.proof"

local missing = proof.missing()
if missing then
  tap.skip("steppers under Frama-C", "frama-c is not installed (Debian package " .. missing .. ")")
  tap.done()
end

local base = program.directory()

local function emitted(what, body, options, ranges)
  local dir = base .. "/" .. what:gsub("[^%w]", "_")
  local status, said = proof.emit(dir, body, options, ranges)
  tap.is(status, 0, what .. ": emitted")
  if status ~= 0 then tap.diag(said) end
  return dir
end

local function covered(got, f, less)
  local c = got.covered[f]
  return c and c[1] >= c[2] - (less or 0) and c[2] > 3
end

local function shown(what, body, options, steps, no_time)
  local got = proof.run(emitted(what, body, options), body)
  tap.ok(got.status == 0 and got.alarms == 0, what .. ": no alarm", got.said)
  tap.is(got.warned, nil, what .. ": and no warning")
  tap.ok(covered(got, body .. "_within"), what .. ": the whole guard was analysed")
  for _, step in ipairs(steps) do
    tap.ok(covered(got, body .. "_" .. step, no_time), what .. ": the whole " .. step .. " was analysed", got.said)
  end
end

-- A free step begins with `if (no time) return;`, of which the return is never reached: 2 statements.
for _, real in ipairs { "float", "double" } do
  shown("brick, " .. real, "brick", "--method rk4 --real " .. real, { "step" }, 2)
  shown("gyroscope with control, " .. real, "gyroscope", "--method rk4 --real " .. real, { "step" })
  shown("falling brick, " .. real, "nasa_brick_damped", "--method rk4 --real " .. real, { "step" })
end
shown("other steppers, float", "heavy_top", "--real float --method semi,adaptive,split2",
  { "step", "adaptive_trial", "split_drift" })
shown("midpoint, float", "tumbling_box", "--real float --method midpoint", { "midpoint_newton", "midpoint_finish" })

-- ---- negative controls ----

-- change: {file's end, text, other text}; kind: of the alarm
local function alarmed(what, kind, body, options, change, ranges)
  local dir = emitted(what, body, options, ranges)
  if change then
    local path = dir .. "/" .. body .. change[1]
    local text = program.read(path)
    local from, to = text:find(change[2], 1, true)
    if not tap.ok(from ~= nil, what .. ": the place is there", change[2]) then return end
    program.write(path, text:sub(1, from - 1) .. change[3] .. text:sub(to + 1))
  end
  local got = proof.run(dir, body)
  tap.ok(got.status ~= 0, what .. ": make proof fails")
  if not kind then return got end
  tap.ok((got.kinds[kind] or 0) > 0, what .. ": alarms of " .. kind, got.said)
end

local infinite, memory = "nan or", "invalid memory" -- as Eva calls the kinds

alarmed("without the guard", infinite, "brick", "--method rk4 --real float",
  { "_proof.c", "if (brick_within(x) != 0)", "if (brick_within(x) != 0 && unknown)" })
alarmed("a guard that lets one rate pass", infinite, "brick", "--method rk4",
  { ".c", "if (!(x[BRICK_WY] >= -10.0 && x[BRICK_WY] <= 10.0)) return 1 + BRICK_WY;", "" })
alarmed("a guard that lets q = 0 pass", infinite, "tumbling_box", "--method midpoint --real float",
  { ".c", "norm >= 0.25F", "norm >= 0.0F" })
alarmed("sides that may be 0", infinite, "brick", "--method rk4", nil,
  'omega = 10, attitude = "any", a = {0, 0.25}, b = {0, 0.2}, c = {0, 0.1}')
alarmed("rates too large for float", infinite, "brick", "--method rk4 --real float", nil,
  'omega = 1e15, attitude = "any"')
alarmed("a state beyond the last", memory, "brick", "--method rk4 --real float",
  { ".c", "x[BRICK_WZ] = t", "x[BRICK_NX] = t" })

local vain = alarmed("a guard that lets nothing pass", nil, "brick", "--method rk4 --real float",
  { ".c", "norm <= 4.0F", "norm <= 0.125F" })
tap.like(vain and vain.said, "nothing is shown, never reached: step_done",
  "a proof of nothing is none: no alarm, and it says so")

-- ---- what is refused ----

local function refused(what, body, options, ranges, part, exit)
  local dir = base .. "/" .. what:gsub("[^%w]", "_")
  local status, said = proof.emit(dir, body, options, ranges)
  tap.is(status, exit or 1, what .. ": refused")
  tap.like(said, part, what .. ": and says why")
end

refused("a state without a range", "nasa_brick_damped", "", 'omega = 3, attitude = "any"',
  "ranges must have every state but the attitude, got none of rx, ry, rz, vx, vy, vz, rho")
refused("three moments, splitting", "tumbling_box", "--method split4", nil, "divides by L^2")
refused("three moments, series", "tumbling_box", "--method taylor", nil, "divides by |L|")
refused("another kind of project", "brick", "--project fmu", nil, "a rule of --project make", 2)

program.finish()
tap.done()
