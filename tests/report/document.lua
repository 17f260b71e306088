-- document.lua - reads the formulas of a LaTeX hand-out back: what stands beside what, and what it is worth.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     local list = document.equations(tex)           {left =, parts = {texts}, number =, unit =}, in their order
--     document.check(list, env) -> {fine, wrong = {texts}, left = {texts without a value}}
-- env: values by name, such as omega_x or vec_omega; it takes what the document says.  Numbers, vectors and matrices:
-- this file computes with them itself, and knows nothing of the program.

local reader = require "tests.algebra.reader"

local document = {}

-- ---- values ----

local V = {} -- a vector or a matrix {rows = {{...}}}

local function new(rows) return setmetatable({ rows = rows }, V) end
local function is(x) return getmetatable(x) == V end
local function column(x) return is(x) and #x.rows[1] == 1 end
function document.vector(a) return new { { a[1] }, { a[2] }, { a[3] } } end
function document.tensor(I) return new { { I[1], I[4], I[5] }, { I[4], I[2], I[6] }, { I[5], I[6], I[3] } } end

local function each(a, b, f)
  local rows = {}
  for i, r in ipairs(a.rows) do
    rows[i] = {}
    for k, x in ipairs(r) do rows[i][k] = f(x, b and b.rows[i][k]) end
  end
  return new(rows)
end
-- A number beside a matrix is that times the unit tensor.
local function lifted(a) return is(a) and a or document.tensor { a, a, a, 0, 0, 0 } end
function V.__add(a, b) return each(lifted(a), lifted(b), function(x, y) return x + y end) end
function V.__sub(a, b) return each(lifted(a), lifted(b), function(x, y) return x - y end) end
function V.__unm(a) return each(a, nil, function(x) return -x end) end
function V.__div(a, k) return each(a, nil, function(x) return x / k end) end
function V.__mul(a, b)
  if not is(a) then a, b = b, a end
  if not is(b) then return each(a, nil, function(x) return b * x end) end
  assert(#a.rows[1] == #b.rows, "shapes")
  local rows = {}
  for i, r in ipairs(a.rows) do
    rows[i] = {}
    for k = 1, #b.rows[1] do
      local s = 0.0
      for n, x in ipairs(r) do s = s + x * b.rows[n][k] end
      rows[i][k] = s
    end
  end
  return new(rows)
end
local function at(v, i) return v.rows[i][1] end
local function dot(a, b) return at(a, 1) * at(b, 1) + at(a, 2) * at(b, 2) + at(a, 3) * at(b, 3) end

-- Jacobi's functions by descending Landen steps, K by the arithmetic-geometric mean.
local function jacobi(u, k)
  if k == 0 then return math.sin(u), math.cos(u), 1.0 end
  local a, b, c, n = { 1.0 }, math.sqrt((1 - k) * (1 + k)), { k }, 1
  while math.abs(c[n]) > 1e-16 and n < 30 do
    local mean, root = (a[n] + b) / 2, math.sqrt(a[n] * b)
    c[n + 1], a[n + 1], b, n = (a[n] - b) / 2, mean, root, n + 1
  end
  local phi = 2.0 ^ (n - 1) * a[n] * u
  for i = n, 2, -1 do phi = (math.asin(c[i] / a[i] * math.sin(phi)) + phi) / 2 end
  return math.sin(phi), math.cos(phi), math.sqrt(1 - (k * math.sin(phi)) ^ 2)
end
local function complete(k)
  local a, b = 1.0, math.sqrt((1 - k) * (1 + k))
  for _ = 1, 30 do a, b = (a + b) / 2, math.sqrt(a * b) end
  return math.pi / (2 * a)
end

local function arithmetic(env)
  return { number = tonumber, pi = math.pi, dot = dot,
    cross = function(a, b)
      return document.vector { at(a, 2) * at(b, 3) - at(a, 3) * at(b, 2), at(a, 3) * at(b, 1) - at(a, 1) * at(b, 3),
        at(a, 1) * at(b, 2) - at(a, 2) * at(b, 1) }
    end,
    power = function(x, n)
      if n == "transposed" then return new { { at(x, 1), at(x, 2), at(x, 3) } } end
      return x ^ n
    end,
    call = function(fn, x, y)
      local k = env.k
      if fn == "abs" and column(x) then return math.sqrt(dot(x, x)) end
      if fn == "sn" then return (jacobi(x, k)) end
      if fn == "cn" then return (select(2, jacobi(x, k))) end
      if fn == "dn" then return (select(3, jacobi(x, k))) end
      if fn == "K" then return complete(x) end
      if fn == "atan2" then return math.atan(x, y) end
      return reader.doubles.call(fn, x, y)
    end }
end

-- ---- the text ----

local UNITS = { ["\\mathrm{deg}"] = math.pi / 180 }

-- A printed number with its unit, or nil.
local function number(s)
  local unit = string.match(s, "\\, (\\mathrm{.*})%s*$")
  s = string.gsub(s, " \\, \\mathrm{.*}%s*$", "")
  local minus, digits, rest = string.match(s, "^%s*(%-?)%s*([%d.]+)(.*)$")
  if not digits then
    minus, rest = string.match(s, "^%s*(%-?)%s*(10%^.*)$")
    digits, rest = rest and "1", rest and "\\times " .. rest
  end
  if not digits then return nil end
  local power = string.match(rest, "^ ?\\times 10%^{([- %d]+)}%s*$")
  if not power and string.find(rest, "%S") then return nil end
  local x = tonumber(digits) * 10.0 ^ (power and tonumber((string.gsub(power, " ", ""))) or 0)
  return (minus == "-" and -x or x) * (UNITS[unit] or 1), #string.gsub(string.gsub(digits, "%.", ""), "^0+", "")
end

-- The sides of a line between its relations outside braces.
local function sides(line)
  local list, depth, from = {}, 0, 1
  local at_ = 1
  while at_ <= #line do
    local c = string.sub(line, at_, at_)
    if c == "{" then depth = depth + 1 elseif c == "}" then depth = depth - 1 end
    local relation = depth == 0 and (c == "=" and "=" or string.match(line, "^\\approx", at_))
    if relation then
      list[#list + 1] = string.sub(line, from, at_ - 1)
      from = at_ + #relation
      at_ = from - 1
    end
    at_ = at_ + 1
  end
  list[#list + 1] = string.sub(line, from)
  return list
end

function document.equations(tex)
  local list = {}
  for block in string.gmatch(tex, "\\begin{align%*}\n(.-)\n\\end{align%*}") do
    local lines = {}
    for line in string.gmatch(block .. " \\\\\n", "(.-) \\\\\n") do
      local left, right = string.match(line, "^(.-) &(.*)$")
      if left == "" and #lines > 0 and not string.find(right, "^%s*\\quad") then
        lines[#lines] = lines[#lines] .. right
      elseif left ~= "" then
        lines[#lines + 1] = left .. right
      end
    end
    for _, line in ipairs(lines) do
      for piece in string.gmatch(line .. "\\quad", "(.-)%s*,?%s*\\quad") do
        local parts = sides(piece)
        if #parts > 1 then list[#list + 1] = parts end
      end
    end
  end
  return list
end

-- LaTeX of this program as words for the reader: vectors are vec_NAME, dots dot_NAME, {a, b, c} a column.
local function words(s)
  s = string.gsub(s, "\\left\\langle.*", "nothing")
  s = string.gsub(s, "%^{T}", "^{transposed}")
  s = string.gsub(s, " \\: ", " ") -- between words
  s = string.gsub(s, "(%b{})%(0%)", "%1") -- the value at t = 0
  s = string.gsub(s, "\\d?dot{\\vct{\\?(%a+)}}", "dot_vec_%1")
  s = string.gsub(s, "\\vct{\\?(%a+)}", "vec_%1")
  s = string.gsub(s, "\\ddot{\\?(%a+)}", "ddot_%1")
  s = string.gsub(s, "\\dot{\\?(%a+)}", "dot_%1")
  return s
end

local function value(text, env)
  if string.find(text, "pmatrix", 1, true) then
    local before, inside = string.match(text, "^(.-)\\begin{pmatrix}(.-)\\end{pmatrix}")
    local rows = {}
    for row in string.gmatch(inside .. "\\\\[1ex]", "(.-)\\\\%[1ex%]") do
      rows[#rows + 1] = {}
      for cell in string.gmatch(row .. "&", "([^&]*)&") do
        table.insert(rows[#rows], number(cell) or reader.value(words(cell), env, arithmetic(env), "latex"))
      end
    end
    local m = new(rows)
    if string.find(before, "%S") then m = m * reader.value(words(before), env, arithmetic(env), "latex") end
    return m
  end
  local x, digits = number(text)
  if x then return x, digits end
  local a, b, c = string.match(text, "^%s*\\left%(%s*([^,]+), ([^,]+), ([^,]+) \\right%)%s*$")
  if a and number(a) and number(b) and number(c) then return document.vector { number(a), number(b), number(c) } end
  return reader.value(words(text), env, arithmetic(env), "latex")
end

local function name_of(text)
  local s = words(text)
  s = string.gsub(s, "\\math%a+{([^{}]*)}", "%1")
  s = string.gsub(string.gsub(s, "[\\{} ]", ""), ",", "_")
  return string.match(s, "^[%a_][%w_]*$")
end

-- Are two values one, to the digits that a document prints?
local function near(a, b, digits, scale)
  if is(a) ~= is(b) then return false end
  if is(a) then
    local size = 0.0
    for _, r in ipairs(a.rows) do
      for _, x in ipairs(r) do size = math.max(size, math.abs(x)) end
    end
    for i, r in ipairs(a.rows) do
      for k, x in ipairs(r) do
        if not near(x, b.rows[i][k], digits, size) then return false end
      end
    end
    return true
  end
  if a ~= a or b ~= b then return a ~= a and b ~= b end -- without a value at the start, as of a body at rest
  return math.abs(a - b) <= 10.0 ^ -digits * math.max(math.abs(a), math.abs(b), scale or 0) + 1e-12 -- of 0
end

-- digits: to how many the document's numbers are good.
function document.check(list, env, digits)
  local found = { fine = 0, wrong = {}, left = {} }
  env.transposed = "transposed"
  local function values_of(parts)
    local values = {}
    for _, p in ipairs(parts) do
      local ok, v = pcall(value, p, env)
      if ok and type(v) ~= "string" then values[#values + 1] = v end
    end
    return values
  end
  local times = {} -- how many lines give a name a number: what has several holds from line to line
  for _, parts in ipairs(list) do
    local name = name_of(parts[1])
    if name and number(parts[#parts]) then times[name] = (times[name] or 0) + 1 end
  end
  local given = {}
  for name in pairs(env) do given[name] = true end -- a set: order is lost anyway
  local function passing(name) return name and not given[name] and (times[name] or 0) > 1 end
  repeat -- what has a name takes its value from its line, wherever that stands
    local more = false
    for _, parts in ipairs(list) do
      local name = name_of(parts[1])
      if name and env[name] == nil and not passing(name) then
        local v = values_of { table.unpack(parts, 2) }
        if #v > 0 then env[name], more = v[#parts - 1 == #v and 1 or #v], true end
      end
    end
  until not more
  for _, parts in ipairs(list) do
    local name = name_of(parts[1])
    if passing(name) then env[name] = nil end
    local values, text = values_of(parts), table.concat(parts, "=")
    if passing(name) then env[name] = number(parts[#parts]) end
    if #values < 2 then
      found.left[#found.left + 1] = text
    else
      local same = true
      for k = 2, #values do same = same and near(values[1], values[k], digits) end
      if same then found.fine = found.fine + 1 else found.wrong[#found.wrong + 1] = text end
    end
  end
  return found
end

return document
