-- proof_table.lua -- the table of docs/proof.md: alarms and seconds of bodies, types and steppers.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     lua5.4 tests/target/proof_table.lua docs/proof.md        from the project's root; some minutes
-- It replaces what stands between the marks of the page.

package.path = "./?.lua;" .. package.path

local program = require "tests.cli.program"
local proof = require "tests.target.proof"

local LIMIT = 90 -- seconds

local rows = { -- a body, what acts, steppers
  { "brick", "free, axes oblique", "rk4 semi adaptive midpoint taylor" },
  { "tumbling_box", "free", "rk4 semi adaptive midpoint taylor split2" },
  { "symmetric_top", "free, symmetric", "rk4 semi adaptive midpoint taylor split2 split4 split6" },
  { "heavy_top", "weight, symmetric", "rk4 semi adaptive midpoint taylor split2 split4 split6" },
  { "gyroscope", "control torque, symmetric", "rk4 semi adaptive midpoint taylor split2 split4 split6" },
  { "thruster", "pulses, sine of time", "rk4 semi adaptive midpoint taylor" },
  { "damped_brick", "damping", "rk4 semi adaptive midpoint taylor" },
  { "gravity_gradient", "orbit of some eccentricity", "rk4 semi" },
  { "wheels", "three wheels", "rk4" },
  { "thrown_book", "flight with drag", "rk4" },
  { "solar_sail", "pressure of light", "rk4" },
  { "nasa_brick_damped", "fall through air", "rk4" },
}

local base = program.directory()

local function cell(body, method, real)
  local dir = table.concat({ base, body, method, real }, "/")
  local options = "--method " .. method .. " --real " .. real .. (method == "taylor" and " --order 8" or "")
  local status, said = proof.emit(dir, body, options)
  if status ~= 0 then
    if said:find "with proof:" then return "refused" end
    return "-", said
  end
  local got = proof.run(dir, body, LIMIT)
  if not got.alarms then return "over " .. LIMIT .. " s" end
  if got.alarms == 0 and got.status ~= 0 then return "failed" end
  return string.format("%d, %.1f s", got.alarms, got.seconds)
end

local out = { "| body | what acts | stepper | float | double |", "|---|---|---|---|---|" }
for _, row in ipairs(rows) do
  for method in row[3]:gmatch "%S+" do
    local float, why = cell(row[1], method, "float")
    if not why then
      out[#out + 1] = string.format("| %s | %s | %s | %s | %s |", row[1], row[2],
        method == "taylor" and "taylor, order 8" or method, float, cell(row[1], method, "double"))
      io.stderr:write(out[#out], "\n")
    else
      io.stderr:write(row[1], " ", method, ": ", why, "\n")
    end
  end
end
program.finish()

local path = assert(arg[1], "which page?")
local text = assert(program.read(path))
local from, to = text:find("<!%-%- proof %-%->\n.-<!%-%- /proof %-%->")
program.write(path, text:sub(1, from - 1) .. "<!-- proof -->\n\n" .. table.concat(out, "\n") .. "\n\n<!-- /proof -->" ..
  text:sub(to + 1))
