-- linear.lua -- formulas in one line of text: plain for comments, code-like; ascii and unicode for people.
-- SPDX-License-Identifier: GPL-3.0-or-later

local mathml = require "generator.formula.mathml"

local linear = {}

local superscript = { ["0"] = "⁰", ["1"] = "¹", ["2"] = "²", ["3"] = "³", ["4"] = "⁴", ["5"] = "⁵", ["6"] = "⁶",
  ["7"] = "⁷", ["8"] = "⁸", ["9"] = "⁹", ["-"] = "⁻" }

-- How the theory's letters are written where Greek is not: w for omega is what the code's names have.
local latin = { omega = "w" }

local operators = { approx = "≈", ne = "≠", times = "×", to = "→" }
local ascii_operators = { approx = "~", ne = "!=", times = "x", to = "->" }

local function style(o)
  local s = { linear = true, slash = "/" }
  local ops = o.greek and operators or ascii_operators
  local function same(text) return text end
  s.num, s.word, s.escape = same, same, same
  function s.sym(base, sub, _, dot)
    local name = (o.greek or o.raised and base == "pi") and mathml.letters[base] or latin[base] or base
    local dots = string.rep("'", dot)
    if not sub then return name .. dots end
    sub = string.gsub(sub, ",", "_")
    return name .. ((string.find(sub, "^%d+$") or #sub == 1 and #base == 1) and "" or "_") .. sub .. dots
  end
  function s.op(name) return name == "quad" and "  " or ops[name] or name end
  function s.unit(text) return text end
  function s.quantity(a, unit) return a .. " " .. unit end
  function s.row(list)
    return (string.gsub(string.gsub(table.concat(list, " "), " ,", ","), "   +", "  "))
  end
  function s.product(list) return table.concat(list, o.times) end
  function s.minus(a) return "-" .. a end
  function s.sum(list, starts)
    local out = {}
    for i, t in ipairs(list) do
      if t.sign then
        out[#out + 1] = i > 1 and " " .. t.sign .. " " or starts and t.sign or t.sign .. " "
      end
      out[#out + 1] = t.text
    end
    return table.concat(out)
  end
  function s.cross(a, b) return a .. (o.greek and " × " or " x ") .. b end
  function s.dot(a, b) return a .. (o.greek and "·" or ".") .. b end
  function s.frac(a, b) return a .. "/" .. b end
  function s.sqrt(a) return (o.root or "sqrt") .. "(" .. a .. ")" end
  function s.pow(a, b, ratio)
    if ratio then return a .. "^(" .. b .. ")" end
    if not o.raised or string.find(b, "[^%d%-]") then return a .. "^" .. b end
    return a .. string.gsub(b, ".", superscript)
  end
  function s.par(a) return "(" .. a .. ")" end
  function s.abs(a) return "|" .. a .. "|" end
  function s.at(a, b) return a .. "(" .. b .. ")" end
  function s.call(name, args, power)
    local call = name .. "(" .. table.concat(args, ", ") .. ")"
    return power and s.pow(call, power) or call
  end
  function s.matrix(rows)
    local lines = {}
    for i, r in ipairs(rows) do lines[i] = #r == 1 and r[1] or "(" .. table.concat(r, ", ") .. ")" end
    return "(" .. table.concat(lines, ", ") .. ")"
  end
  function s.tuple(list) return "(" .. table.concat(list, ", ") .. ")" end
  function s.integral(low, high) return "int" .. (low and "_" .. low .. "^" .. high or "") end
  function s.diff(a) return "d" .. a end
  return s
end

linear.plain = style { times = "*" }
linear.ascii = style { times = " ", theory = true }
linear.unicode = style { times = " ", raised = true, root = "√" }
linear.greek = style { times = " ", raised = true, root = "√", greek = true }

return linear
