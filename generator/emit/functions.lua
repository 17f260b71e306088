-- functions.lua -- the functions that are made of equations: their C, and what each of them costs.
--
--     functions.of(job, ctx) -> {list = for templates, costs = rows of the README's table, banner = lines}
--     functions.fragment(made, templates, base) -> header, source
--     functions.cost_row(name, counts)     a row of that table
-- SPDX-License-Identifier: GPL-3.0-or-later

local rounding = require "generator.ir.core.rounding"
local source = require "generator.emit.source"
local template = require "generator.emit.template"

local GROUP = template.group "core/functions.c"

local functions = {}

local function commented(doc)
  local out = {}
  for k, line in ipairs(doc) do
    out[k] = (k == 1 and "/* " or " * ") .. line .. (k == #doc and " */" or "")
  end
  return table.concat(out, "\n")
end

function functions.cost_row(name, c)
  local row = { name = name }
  for _, k in ipairs { "add", "mul", "div", "sqrt", "call" } do row[k] = string.format("%d", c[k] or 0) end
  return row
end

-- "rhs: 12 additions, 24 multiplications": what one call costs, for the banner.
local function cost_line(f)
  local parts, c = {}, f.cost
  for _, k in ipairs { { "add", "addition" }, { "mul", "multiplication" }, { "div", "division" }, { "sqrt", "root" },
    { "call", "function call" } } do
    local n = c[k[1]] or 0
    if n > 0 then parts[#parts + 1] = string.format("%d %s%s", n, k[2], n == 1 and "" or "s") end
  end
  return f.name .. ": " .. table.concat(parts, ", ")
end

-- What is computed from numbers that are given by arithmetic alone, without steps or iterations.
local BOUNDED = { energy = true, jacobi_integral = true, particle_energy = true, momentum = true, momentum_body = true,
  torque = true, rhs = true, inertia_at = true, inertia_now = true }

-- The bound on the error of what a function returns, as lines of its description.
local function bound(f, real)
  local k, single = rounding.run(f.ir, real)
  if not k or k == 0 or not BOUNDED[f.name] then return {} end
  local epsilons = string.format("%d", k // 2) .. (k % 2 == 0 and "" or ".5") -- k times half of epsilon
  if single then return { "Relative error at most " .. epsilons .. " epsilon." } end
  return { "Error at most " .. epsilons .. " epsilon times the sum of the absolute values of the terms,",
    "multiplied out." }
end

function functions.of(job, ctx)
  local made = { list = {}, costs = {}, banner = {} }
  for i, description in ipairs(job.functions) do
    local f = source.make(ctx, description)
    local doc = table.move(f.doc, 1, #f.doc, 1, {})
    for _, line in ipairs(bound(f, ctx.real)) do doc[#doc + 1] = line end
    made.list[i] = { prototype = commented(doc) .. "\n" .. f.declaration, head = f.head, lines = f.lines }
    made.costs[i] = functions.cost_row(f.name, f.cost)
    if f.name == "rhs" or f.name == "step" then
      made.banner[#made.banner + 1] = "Operations of " .. cost_line(f) .. "."
    end
  end
  return made
end

function functions.fragment(made, templates, base)
  local prototypes = {}
  for i, f in ipairs(made.list) do prototypes[i] = f.prototype end
  return table.concat(prototypes, "\n\n") .. "\n",
    GROUP(templates, base, { functions = made.list }) "core/functions.c"
end

return functions
