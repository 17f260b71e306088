-- tree.lua -- formulas as trees: what they mean, not how they look.  setting.lua sets them in a style.
--
-- A node is {kind, ...}:
--     num   digits           "12", "-3", "0.25", "1.5e-07"
--     sym   base             a letter, the name of a Greek one, or a word; .sub index, .vector, .dot how many dots
--     sum   {minus =, node =}...         product nodes...        frac above, below        pow base, exponent
--     cross a, b             dot a, b: the inner product         sqrt of    abs of        call name =, arguments...
--     at    symbol, argument: the value there, omega(0)          matrix rows =
--     integral low =, high = (both nil: over the body)           diff symbol: its differential
--     ratio above, below     a quotient without a bar, as within an exponent
-- and for lines of them:
--     op    name             = < > approx ne , quad              word text               unit text, "kg m^2"
--     quantity node, unit    tuple nodes...              row nodes...: one after the other
--     live  name             a number of a page, which its script puts in
-- Parentheses are not in the tree: a style puts them where its own writing needs them.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local double = require "generator.algebra.double"

local tree = {}

tree.greek = {}
local letters = "alpha beta gamma delta epsilon zeta eta theta kappa lambda mu nu xi rho sigma tau phi psi omega pi " ..
  "Omega Delta Phi Psi Theta Lambda Pi Gamma Sigma Xi"
for word in string.gmatch(letters, "%a+") do tree.greek[word] = true end

function tree.num(digits) return { kind = "num", digits } end
function tree.op(name) return { kind = "op", name } end
function tree.word(text) return { kind = "word", text } end
function tree.row(...) return { kind = "row", ... } end
function tree.frac(a, b) return { kind = "frac", a, b } end
function tree.pow(a, b) return { kind = "pow", a, b } end
function tree.sqrt(a) return { kind = "sqrt", a } end
function tree.matrix(rows) return { kind = "matrix", rows = rows } end
function tree.call(name, ...) return { kind = "call", name = name, ... } end
function tree.minus(a) return { kind = "sum", { minus = true, node = a } } end

function tree.sym(base, sub, more)
  return { kind = "sym", base, sub = sub, vector = more and more.vector or nil, dot = more and more.dot or 0 }
end

-- A name as a letter with an index, if it is one: I1, m_2, omega0, Ixx, Nx_1.
function tree.split(name)
  local base, axes, number = string.match(name, "^(%a)([xyz]+)_?(%d*)$")
  if base then return base, number ~= "" and axes .. "," .. number or axes end
  base, number = string.match(name, "^(%a+)_?(%d+)$")
  if base then return base, number end
  base, number = string.match(name, "^(%a+)_([%w_]+)$")
  return base or name, number and string.gsub(number, "_", ",")
end

-- A list of one is that one; of none, 1.
function tree.product(list)
  if #list == 0 then return tree.num "1" end
  if #list == 1 then return list[1] end
  return { kind = "product", table.unpack(list) }
end

-- The number that is printed for x with so many digits.
function tree.rounded(x, digits) return tonumber(string.format("%." .. string.format("%d", digits) .. "g", x)) end

-- x with so many digits; unit: "kg m^2", or nil.
function tree.number(x, digits, unit)
  local node = tree.num(double.shortest(tree.rounded(x, digits or 5), digits or 5))
  if not unit or unit == "" or unit == "1" then return node end
  return { kind = "quantity", node, { kind = "unit", unit } }
end

-- The rational q, of few digits.
function tree.exact(q)
  local n = tree.num(tostring(R.abs(R.num(q))))
  if R.den(q) ~= R.one then n = tree.frac(n, tree.num(tostring(R.den(q)))) end
  return R.sign(q) < 0 and tree.minus(n) or n
end

-- About how many letters wide a formula is, set with bars and roots.
function tree.width(n)
  local kind, w = n.kind, 0
  if kind == "num" or kind == "word" or kind == "unit" then return #n[1] end
  if kind == "sym" then return (tree.greek[n[1]] and 1.2 or #n[1] * 1.1) + 0.7 * #(n.sub or "") end
  if kind == "op" then return n[1] == "," and 0.7 or 2 end
  if kind == "integral" then return 3 end
  if kind == "diff" then return 1.7 + tree.width(n[1]) end
  if kind == "frac" then return math.max(tree.width(n[1]), tree.width(n[2])) + 0.5 end
  if kind == "ratio" then return tree.width(n[1]) + 0.6 + tree.width(n[2]) end
  if kind == "pow" then
    local bare = n[1].kind == "sym" or n[1].kind == "num"
    return tree.width(n[1]) + 0.7 * tree.width(n[2]) + (bare and 0 or 1.6)
  end
  if kind == "call" then w = #n.name + 2 end
  if kind == "abs" or kind == "sqrt" or kind == "at" then w = 1.6 end
  if kind == "live" then return 8 end
  if kind == "tuple" then w = 2 end
  if kind == "cross" or kind == "dot" then w = 2 end
  if kind == "matrix" then
    for c = 1, #n.rows[1] do
      local most = 0
      for _, r in ipairs(n.rows) do -- fractions are small there
        most = math.max(most, tree.width(r[c]) * (r[c].kind == "frac" and 0.75 or 1))
      end
      w = w + most + 2
    end
    return w + 1
  end
  for _, part in ipairs(n) do
    local node = kind == "sum" and part.node or part
    w = w + tree.width(node) + (kind == "sum" and 2 or kind == "product" and node.kind == "sum" and 1.9 or 0.3)
  end
  return w
end

return tree
