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

local function literal(q, real)
  local text = number.text(q, real)
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

-- { loads = { lines }, groups = { { why, where, lines } } }; groups that compute nothing are left out.
-- real: "double" or "float".  opts: type (the C name of the real, default real itself), indent (2), scene (the prefix
-- of helpers), helpers (a set that the stems of the helpers called go to), letter (of temporaries, "t"), own (functions
-- of the C library are the scene's own: NAME_sin).
function cprint.statements(ir, real, opts)
  opts = opts or {}
  local type_name, indent = opts.type or real, opts.indent or 2
  local define, uses = instr.definitions(ir), instr.uses(ir)
  local declared = {} -- value number -> its C name
  local taken = {}
  local lines, temporaries, letter = nil, 0, opts.letter or "t"

  instr.each(ir, function(i)
    if i.sym then taken[i.sym] = true end
    if i.name then taken[i.name] = true end
    if instr.of(i.op).c == "helper" then opts.helpers[i.op] = true end
  end)

  local function temporary()
    repeat
      temporaries = temporaries + 1
    until not taken[letter .. temporaries]
    return letter .. temporaries
  end

  local function room(prefix) return LINE - indent - #prefix - 1 end

  local function declare(v, name, text)
    append(lines, "const " .. type_name .. " " .. name .. " = " .. text .. ";", LAW - indent)
    declared[v] = name
  end

  local piece

  -- The expression of instruction i, in at most `width` columns if splitting off parts can do it.
  local function expression(i, width)
    local entry = instr.of(i.op)
    local join = joined[entry.c] or error("cprint: '" .. i.op .. "' has no form in C; run the passes")
    local args = {}
    for k, field in ipairs(entry.srcs) do args[k] = piece(i[field], width) end
    while true do
      local whole = join(entry, real, args, opts.scene, opts.own)
      if #whole.text <= width and whole.depth <= NESTING then return whole end
      local longest
      for k, p in ipairs(args) do
        local heavier = not longest or (whole.depth > NESTING and p.depth > args[longest].depth)
          or (whole.depth <= NESTING and #p.text > #args[longest].text)
        if not p.solid and heavier then longest = k end
      end
      if not longest then return whole end
      local v = i[entry.srcs[longest]]
      declare(v, temporary(), args[longest].text)
      for k, field in ipairs(entry.srcs) do
        if i[field] == v then args[k] = atom(declared[v]) end
      end
    end
  end

  function piece(v, width)
    if declared[v] then return atom(declared[v]) end
    local i = define[v] or error("cprint: value " .. tostring(v) .. " is never defined")
    if i.op == "const" then return literal(i.value, real) end
    if i.op == "input" then return atom(i.sym) end
    return expression(i, width)
  end

  -- -x of a name is as short as a name: no temporary for it.
  local function trivial(i)
    if i.op ~= "neg" then return false end
    return declared[i.src1] or define[i.src1].op == "input"
  end

  local function statement(i)
    if i.op == "store" then
      local prefix = i.c .. " " .. i.assign .. " "
      local p = piece(i.src1, math.min(room(prefix), room("const " .. type_name .. " t999 = ")))
      append(lines, prefix .. p.text .. ";", LAW - indent)
    elseif i.name or (uses[i.dst] or 0) > 1 and not trivial(i) then
      if declared[i.dst] then return end
      local p = expression(i, room("const " .. type_name .. " " .. (i.name or "t999") .. " = "))
      declare(i.dst, i.name or temporary(), p.text)
    end
  end

  local result = { loads = loads_of(ir, type_name, LINE - indent), groups = {} }
  for _, group in ipairs(ir.groups) do
    lines = {}
    for _, i in ipairs(group.code) do statement(i) end
    if #lines > 0 then
      lines = side_by_side(lines, LINE - indent)
      table.insert(result.groups, { why = group.why, where = group.where, lines = lines })
    end
  end
  return result
end

return cprint
