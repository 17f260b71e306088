-- cprint.lua: an ir as C99 statements, ready for a template.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Below the line: the text computes what the ir computes, operation for operation.  Parentheses are
-- the fewest that keep the order: infix operators associate to the left, so a right operand of equal
-- level keeps its own (a*(b*c), a - (b - c)).  All literals and libm names follow `real`; there is no
-- double left in float code.
--
-- A named intermediate keeps its name; a value used more than once becomes t1, t2 ... in order of
-- appearance, declared where it is first needed; a value used once is written in place unless the
-- line would pass LINE columns or NESTING levels of parentheses, then its longest part gets a t too.
-- Comments are not made here: why and where of a group are passed through.  Lines carry no
-- indentation; `indent` columns are kept free for it.

local instr = require "generator.ir.core.instr"
local number = require "generator.emit.number"

local cprint = {}

local LINE = 92       -- columns that a statement may fill before it is split; the law is 100
local LAW = 100
local NESTING = 4
local ATOM = 4        -- level of a name, a literal, a call
local CONTINUED = "    "

-- ---- pieces of expressions: { text, level, depth } ------------------------------------------------------

local function atom(text) return { text = text, level = ATOM, depth = 0, solid = true } end

-- A quotient binds like a product, a negative number like the unary minus.
local function literal(q, real)
  local text = number.constant(q, real)
  local quotient = string.find(text, "/", 1, true)
  local level = quotient and 2 or string.sub(text, 1, 1) == "-" and 3 or ATOM
  return { text = text, level = level, depth = 0, solid = true, quotient = quotient }
end

local function enclosed(p)
  return { text = "(" .. p.text .. ")", level = ATOM, depth = p.depth + 1 }
end

-- p as left operand of an operator of that level.  A quotient of constants is always set apart from
-- a product: (5.0/13.0)*x.
local function left(p, level)
  if p.level < level or p.quotient and level == 2 then return enclosed(p) end
  return p
end

-- A right operand that begins with a minus is enclosed too: no x - -y, no x*-y.
local function right(p, level)
  if p.level <= level or p.quotient and level == 2 or string.sub(p.text, 1, 1) == "-" then
    return enclosed(p)
  end
  return p
end

local function call(name, args)
  local texts, depth = {}, 0
  for k, p in ipairs(args) do
    texts[k] = p.text
    depth = math.max(depth, p.depth)
  end
  return { text = name .. "(" .. table.concat(texts, ", ") .. ")", level = ATOM, depth = depth + 1 }
end

-- How an instruction is written with its operands, by the field c of its entry in ir/core/instr.lua.
local joined = {
  infix = function(entry, _, args)
    local a, b = left(args[1], entry.level), right(args[2], entry.level)
    return { text = a.text .. entry.symbol .. b.text, level = entry.level, depth = math.max(a.depth, b.depth) }
  end,
  prefix = function(entry, _, args)
    local a = right(args[1], entry.level)
    return { text = entry.symbol .. a.text, level = entry.level, depth = a.depth }
  end,
  call = function(entry, real, args, scene, own)
    return call(own and scene .. "_" .. entry.stem or entry.stem .. (real == "float" and "f" or ""), args)
  end,
  helper = function(entry, _, args, scene) return call(scene .. "_" .. entry.stem, args) end,
}

-- ---- lines ------------------------------------------------------------------------------------------------

-- Appends text to lines, broken at blanks so that no line passes `width`.
local function append(lines, text, width)
  while #text > width do
    local at
    for k = width, #CONTINUED + 1, -1 do
      if string.sub(text, k, k) == " " then
        at = k
        break
      end
    end
    if not at then break end -- one token longer than a line: nothing to do
    lines[#lines + 1] = string.sub(text, 1, at - 1)
    text = CONTINUED .. string.sub(text, at + 1)
  end
  lines[#lines + 1] = text
end

-- What an input is read from, without index or member: the loads of one array stand together.
local function array_of(c)
  return string.match(c, "^([%w_]+)") or c
end

-- Declarations of the loaded inputs: runs from one array, two to four on a line, evenly.
local function loads_of(ir, type_name, width)
  local runs = {}
  for _, i in ipairs(ir.inputs) do
    if i.c ~= i.sym then
      local run = runs[#runs]
      if not run or run.array ~= array_of(i.c) then
        run = { array = array_of(i.c) }
        runs[#runs + 1] = run
      end
      run[#run + 1] = i.sym .. " = " .. i.c
    end
  end

  local function broken(run, rows)
    local texts, at = {}, 1
    for row = 1, rows do
      local last = at + math.ceil((#run - at + 1) / (rows - row + 1)) - 1
      texts[row] = "const " .. type_name .. " " .. table.concat(run, ", ", at, last) .. ";"
      at = last + 1
    end
    return texts
  end

  local lines = {}
  for _, run in ipairs(runs) do
    local rows = math.ceil(#run / 4)
    local texts
    repeat
      texts = broken(run, rows)
      local fits = true
      for _, text in ipairs(texts) do fits = fits and #text <= width end
      rows = rows + 1
    until fits or rows > #run
    for _, text in ipairs(texts) do append(lines, text, width) end
  end
  return lines
end

-- The name that a line declares alone, as a whole statement.
local function declared_in(line) return string.match(line, "^const ([%w_]+) ([%w_]+) = [^,;]*;$") end

-- Are these components of one vector (kx1, ky1), or temporaries (t1, t2)?
local function related(a, b)
  if string.find(a, "^%l%d+$") and string.find(b, "^%l%d+$") then
    return string.sub(a, 1, 1) == string.sub(b, 1, 1)
  end
  if #a ~= #b then return false end
  local apart = 0
  for k = 1, #a do
    local x, y = string.sub(a, k, k), string.sub(b, k, k)
    if x ~= y then
      apart = apart + (string.find(x, "[wxyz]") and string.find(y, "[wxyz]") and 1 or 2)
    end
  end
  return apart == 1
end

-- Declarations side by side: of a vector's components, and of temporaries.
local function side_by_side(lines, width)
  local out, last, last_kind = {}, nil, nil
  for _, line in ipairs(lines) do
    local kind, name = declared_in(line)
    local joins = name and last and kind == last_kind and related(last, name)
    local more = joins and string.sub(out[#out], 1, -2) .. ", " .. string.sub(line, #("const " .. kind .. " ") + 1)
    if more and #more <= width then out[#out] = more else out[#out + 1] = line end
    last, last_kind = name, kind
  end
  return out
end

-- ---- statements -------------------------------------------------------------------------------------------

-- A printer P of one ir: its instructions by value (define), how often each is read (uses), the C names that values
-- have got (declared) and that are taken, and the lines of the group that is being printed.
local function printer(ir, real, opts)
  local P = { real = real, type = opts.type or real, indent = opts.indent or 2, scene = opts.scene, own = opts.own,
    letter = opts.letter or "t", define = instr.definitions(ir), uses = instr.uses(ir), declared = {}, taken = {},
    temporaries = 0, lines = nil }
  instr.each(ir, function(i)
    if i.sym then P.taken[i.sym] = true end
    if i.name then P.taken[i.name] = true end
    if instr.of(i.op).c == "helper" then opts.helpers[i.op] = true end
  end)
  return P
end

-- The next of t1, t2 .. that no input and no intermediate is called like.
local function temporary(P)
  repeat
    P.temporaries = P.temporaries + 1
  until not P.taken[P.letter .. P.temporaries]
  return P.letter .. P.temporaries
end

-- Columns that are left for an expression behind a prefix, and a semicolon.
local function room(P, prefix) return LINE - P.indent - #prefix - 1 end

local function declare(P, v, name, text)
  append(P.lines, "const " .. P.type .. " " .. name .. " = " .. text .. ";", LAW - P.indent)
  P.declared[v] = name
end

-- Which part of an expression gets a name of its own when the whole does not fit: of one that is nested too deeply the
-- deepest, else the longest; nil where all parts are names and numbers.
local function heaviest(args, whole)
  local best
  for k, p in ipairs(args) do
    local heavier = not best or (whole.depth > NESTING and p.depth > args[best].depth)
      or (whole.depth <= NESTING and #p.text > #args[best].text)
    if not p.solid and heavier then best = k end
  end
  return best
end

local piece

-- The expression of instruction i, in at most `width` columns if splitting off parts can do it.  Each turn gives one
-- part a name, so it ends.
local function expression(P, i, width)
  local entry = instr.of(i.op)
  local join = joined[entry.c] or error("cprint: '" .. i.op .. "' has no form in C; run the passes")
  local args = {}
  for k, field in ipairs(entry.srcs) do args[k] = piece(P, i[field], width) end
  while true do
    local whole = join(entry, P.real, args, P.scene, P.own)
    if #whole.text <= width and whole.depth <= NESTING then return whole end
    local longest = heaviest(args, whole)
    if not longest then return whole end
    local v = i[entry.srcs[longest]]
    declare(P, v, temporary(P), args[longest].text)
    for k, field in ipairs(entry.srcs) do
      if i[field] == v then args[k] = atom(P.declared[v]) end
    end
  end
end

-- The value v as a part of an expression: its name, or what it is made of, which is then read here alone.
function piece(P, v, width)
  if P.declared[v] then return atom(P.declared[v]) end
  local i = P.define[v] or error("cprint: value " .. tostring(v) .. " is never defined")
  if i.op == "const" then return literal(i.value, P.real) end
  if i.op == "input" then return atom(i.sym) end
  return expression(P, i, width)
end

-- -x of a name is as short as a name: no temporary for it.
local function trivial(P, i)
  if i.op ~= "neg" then return false end
  return P.declared[i.src1] or P.define[i.src1].op == "input"
end

-- A statement for what is stored, what has a name, and what is read more than once; all else is a part of these.
local function statement(P, i)
  if i.op == "store" then
    local prefix = i.c .. " " .. i.assign .. " "
    local p = piece(P, i.src1, math.min(room(P, prefix), room(P, "const " .. P.type .. " t999 = ")))
    append(P.lines, prefix .. p.text .. ";", LAW - P.indent)
  elseif i.name or (P.uses[i.dst] or 0) > 1 and not trivial(P, i) then
    if P.declared[i.dst] then return end
    local p = expression(P, i, room(P, "const " .. P.type .. " " .. (i.name or "t999") .. " = "))
    declare(P, i.dst, i.name or temporary(P), p.text)
  end
end

-- { loads = { lines }, groups = { { why, where, lines } } }; groups that compute nothing are left out.
-- real: "double" or "float".  opts: type (the C name of the real, default real itself), indent (2), scene (the prefix
-- of helpers), helpers (a set that the stems of the helpers called go to), letter (of temporaries, "t"), own (functions
-- of the C library are the scene's own: NAME_sin).
function cprint.statements(ir, real, opts)
  local P = printer(ir, real, opts or {})
  local result = { loads = loads_of(ir, P.type, LINE - P.indent), groups = {} }
  for _, group in ipairs(ir.groups) do
    P.lines = {}
    for _, i in ipairs(group.code) do statement(P, i) end
    if #P.lines > 0 then
      local lines = side_by_side(P.lines, LINE - P.indent)
      table.insert(result.groups, { why = group.why, where = group.where, lines = lines })
    end
  end
  return result
end

return cprint
