-- setting.lua -- one walk over a formula; each format says how its pieces look.
--
--     setting.of(style, node) -> text
-- style has a function per kind of node that gets the texts of the parts (see handout/latex.lua).
-- SPDX-License-Identifier: GPL-3.0-or-later

local setting = {}

local function texts(style, list)
  local out = {}
  for i, part in ipairs(list) do out[i] = setting.of(style, part) end
  return out
end

local kinds = {}

function kinds.num(style, n)
  local digits = string.match(n[1], "^%-(.*)$")
  return digits and style.row { style.op "-", style.num(digits) } or style.num(n[1])
end
function kinds.sym(style, n) return style.sym(n[1], n.sub, n.vector, n.dot) end
function kinds.op(style, n) return style.op(n[1]) end
function kinds.word(style, n) return style.word(n[1]) end
function kinds.unit(style, n) return style.unit(n[1]) end
function kinds.row(style, n) return style.row(texts(style, n)) end
function kinds.frac(style, n) return style.frac(setting.of(style, n[1]), setting.of(style, n[2])) end
function kinds.sqrt(style, n) return style.sqrt(setting.of(style, n[1])) end
function kinds.pow(style, n) return style.pow(setting.of(style, n[1]), setting.of(style, n[2])) end
function kinds.par(style, n) return style.par(setting.of(style, n[1])) end
function kinds.abs(style, n) return style.abs(setting.of(style, n[1])) end
function kinds.call(style, n) return style.call(n.name, texts(style, n)) end
function kinds.matrix(style, n)
  local rows = {}
  for i, r in ipairs(n.rows) do rows[i] = texts(style, r) end
  return style.matrix(rows)
end
function kinds.integral(style, n)
  return style.integral(n.low and setting.of(style, n.low), n.high and setting.of(style, n.high))
end

-- The terms of a sum with their signs, from one to another.
function setting.terms(style, n, from, to)
  local list = {}
  for i = from, to do
    local t = n[i]
    if i > 1 or t.minus then list[#list + 1] = style.op(t.minus and "-" or "+") end
    list[#list + 1] = setting.of(style, t.node)
  end
  return style.row(list)
end
function kinds.sum(style, n) return setting.terms(style, n, 1, #n) end

function setting.of(style, n) return kinds[n.kind](style, n) end

return setting
