-- typst.lua -- the hand-out in Typst.
-- SPDX-License-Identifier: GPL-3.0-or-later

local math_ = require "generator.report.handout.math"
local setting = require "generator.report.handout.setting"

local typst = { style = {} }
local style = typst.style

local operators = { cross = "times", dot = "dot.op", approx = "approx", ne = "!=", thin = "thin", quad = "quad",
  times = "times" }
local functions = {}
for word in string.gmatch("sin cos tan exp log sinh cosh tanh min max", "%a+") do functions[word] = word end

local function quoted(s) return '"' .. string.gsub(s, '["\\]', "\\%0") .. '"' end

function style.num(s) return s end
function style.sym(base, sub, vector, dot)
  local s = (math_.greek[base] or #base == 1) and base or "italic(" .. quoted(base) .. ")"
  if vector then s = "bold(" .. s .. ")" end
  if dot > 0 then s = (dot > 1 and "dot.double(" or "dot(") .. s .. ")" end
  return sub and s .. "_(" .. (string.gsub(string.gsub(sub, "%a%a+", function(w)
    return string.find(w, "^[xyz]+$") and string.gsub(w, ".", "%0 ") or quoted(w)
  end), "%s+$", "")) .. ")" or s
end
function style.op(name)
  return operators[name] or (name == "(" or name == ")") and "\\" .. name or name
end
style.word = quoted
function style.unit(s)
  local out = {}
  for stem, power in string.gmatch(s, "([^%s%^]+)%^?(%-?%d*)") do
    out[#out + 1] = quoted(stem) .. (power ~= "" and "^(" .. power .. ")" or "")
  end
  return table.concat(out, " thin ")
end
function style.row(list) return table.concat(list, " ") end
function style.frac(a, b) return "frac(" .. a .. ", " .. b .. ")" end
function style.sqrt(a) return "sqrt(" .. a .. ")" end
function style.pow(a, b) return a .. "^(" .. b .. ")" end
function style.par(a) return "lr(( " .. a .. " ))" end
function style.abs(a) return "abs(" .. a .. ")" end
function style.call(name, args)
  return (functions[name] or "op(" .. quoted(name) .. ")") .. " lr(( " .. table.concat(args, " , ") .. " ))"
end
function style.matrix(rows)
  local out = {}
  for i, r in ipairs(rows) do out[i] = table.concat(r, ", ") end
  return "mat(" .. table.concat(out, "; ") .. ")"
end
function style.integral(low, high)
  return "integral" .. (low and "_(" .. low .. ")" or "") .. (high and "^(" .. high .. ")" or "")
end

function typst.inline(n) return "$" .. setting.of(style, n) .. "$" end
function typst.display(lines)
  local out = {}
  for i, l in ipairs(lines) do out[i] = l[1] .. " & " .. l[2] end
  return "$ " .. table.concat(out, " \\\n  ") .. " $\n"
end
function typst.title(s)
  return "#set page(paper: \"a4\", margin: 22mm)\n#set par(justify: true)\n= " .. typst.words(s) .. "\n"
end
function typst.heading(s) return "== " .. typst.words(s) .. "\n" end
function typst.paragraph(parts) return table.concat(parts) .. "\n" end
function typst.words(s) return (string.gsub(s, "[\\#$*_`<>@~%[%]=/]", "\\%0")) end
function typst.list(items) return "- " .. table.concat(items, "\n- ") .. "\n" end
function typst.listing(lines) return "```\n" .. table.concat(lines, "\n") .. "\n```\n" end
typst.tail = ""

return typst
