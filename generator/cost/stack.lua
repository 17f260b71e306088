-- stack.lua -- the deepest stack of each function: frames summed along the graph of calls.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     local g = stack.read(ci)            text of gcc's -fcallgraph-info=su (gcc 10 or later), one file a source
--     stack.read(ci2, g)                  one more into the same graph
--     stack.disassembly(text, nm, g)      `objdump -d` and `nm` of a Thumb program: what has no .ci, what gcc forgot
--     for _, f in ipairs(stack.worst(g, known)) do ... end
-- A graph is {order = titles, nodes = title -> {name, public, place, bytes, kind, calls = titles}}.  The frame has the
-- saved registers, and on x86 the return address; kind is gcc's word: static, dynamic (unbounded) or dynamic,bounded.
-- worst: a list in the order of the text, each
--     {name, public, place, bytes, path = names from it down to the deepest,
--      missing = names without a frame that it reaches, in order,
--      cycle = names, dynamic = names, indirect = names   (nil where there are none, as there should be)}
-- known: bytes by name (a table) of functions without a frame; the others count as 0 and stand in `missing`.  So
-- `bytes` is a bound if missing, cycle, dynamic and indirect are empty.  A call in the tail counts like any other.
-- On ARM gcc's frames lack up to 16 bytes where a structure comes half in registers: there both together are a bound.

local stack = {}

local INDIRECT = "__indirect_call" -- gcc's node for all calls through pointers

local function node(graph, title)
  local n = graph.nodes[title]
  if not n then
    n = { calls = {}, seen = {} }
    graph.nodes[title] = n
    graph.order[#graph.order + 1] = title
  end
  return n
end

local function edge(from, title)
  if not from.seen[title] then
    from.seen[title] = true
    from.calls[#from.calls + 1] = title
  end
end

function stack.read(text, graph)
  graph = graph or { order = {}, nodes = {} }
  for line in string.gmatch(text, "[^\n]+") do
    local title, label = string.match(line, '^node: { title: "(.-)" label: "(.-)"')
    local from, to = string.match(line, '^edge: { sourcename: "(.-)" targetname: "(.-)"')
    if title then
      -- a label: name\nplace\nbytes (kind); of what is only declared the first two
      local name, place, bytes, kind = string.match(label, "^(.-)\\n(.-)\\n(%d+) bytes %(([%w,]+)%)")
      if name then
        local n = node(graph, title)
        -- the title of a static function begins with its file; that of a copy has .part.0 or the like, its label not
        n.public, n.name = not string.find(title, ":", 1, true), string.match(title, "[^:]*$")
        n.place, n.bytes, n.kind = place, math.tointeger(tonumber(bytes)), kind
      end
    elseif from then
      edge(node(graph, from), to)
    end
  end
  return graph
end

-- Bytes of a list of registers: "r4, r5, lr", "r4-r7", "d8-d9", "s16".
local function registers(list)
  local bytes = 0
  for item in string.gmatch(list, "[%w%-]+") do
    local bank, first, last = string.match(item, "^(%a)(%d+)%-%a(%d+)$")
    if not bank then bank, first, last = string.sub(item, 1, 1), 0, 0 end
    bytes = bytes + (bank == "d" and 8 or 4) * (last - first + 1)
  end
  return math.tointeger(bytes)
end

-- Bytes that an instruction takes from the stack: a number, or "dynamic".  value: what was last loaded into a register.
local function taken(instruction, operands, value)
  local list = string.match(operands, "{(.-)}")
  if list and (string.find(instruction, "^v?push") or string.find(operands, "^sp!")) then
    return string.find(instruction, "^v?ldm") and 0 or registers(list)
  elseif string.find(instruction, "^str") and string.find(operands, "%[sp, #%-%d+%]!") then
    return math.tointeger(tonumber(string.match(operands, "%[sp, #%-(%d+)%]!")))
  elseif string.find(instruction, "^sub") and string.find(operands, "^sp,") then
    return math.tointeger(tonumber(string.match(operands, "#(%d+)$"))) or "dynamic"
  elseif string.find(instruction, "^add") and string.find(operands, "^sp, r") then
    local n = value[string.match(operands, "^sp, (r%d+)")]
    return n and (n < 0 and -n or 0) or "dynamic"
  end
  return 0
end

-- The words behind the code, by address: frames too large for one instruction of a Cortex-M0 stand there.
local function words(text)
  local at = {}
  for address, word in string.gmatch(text, "\n%s*(%x+):[%x%s]-%.word%s+0x(%x+)") do
    local n = tonumber(word, 16)
    at[tonumber(address, 16)] = n >= 1 << 31 and n - (1 << 32) or n
  end
  return at
end

-- Does the instruction never go on to the next one?
local function ends(instruction, operands)
  return instruction == "b" or instruction == "b.n" or instruction == "b.w" or instruction == "bx"
    or instruction == "udf" or string.find(operands, "pc}$") ~= nil or string.find(operands, "^pc, ") ~= nil
    or string.find(instruction, "^tb[bh]$") ~= nil
end

-- One line of a function: what it takes, whom it calls.
local function instruct(n, name, line, constants, value)
  local instruction, operands = string.match(line, "^%s*%x+:\t[%x ]+\t([%w%.]+)\t?([^;@]*)")
  if not instruction or string.sub(instruction, 1, 1) == "." then return end
  operands = string.gsub(operands, "%s+$", "")
  local filling = string.find(instruction, "^nop") or instruction == "movs" and operands == "r0, r0" -- a word of zeros
  if not filling then n.ends = ends(instruction, operands) end
  local loaded, from = string.match(operands, "^(r%d+), %[pc"), string.match(line, "%((%x+) <")
  if loaded then value[loaded] = from and constants[tonumber(from, 16)] end
  local bytes = taken(instruction, operands, value)
  if bytes == "dynamic" then
    n.kind = "dynamic"
  else
    n.bytes = n.bytes + bytes
  end
  local target = string.match(operands, "<([^>+]+)>$")
  if instruction == "blx" and not target then edge(n, INDIRECT) end
  -- a jump into the middle of its own is a loop, a call of its own beginning is none
  if target and string.find(instruction, "^c?b") and (target ~= name or string.find(instruction, "^bl")) then
    edge(n, target)
  end
end

-- A function's frame is here the sum of all that it takes anywhere; one that runs on into the next calls it.
-- What has a .ci keeps its calls, and its frame unless this one is larger.
function stack.disassembly(text, nm, graph)
  graph = graph or { order = {}, nodes = {} }
  local constants, current, name, value, known = words(text), nil, nil, nil, {}
  for _, title in ipairs(graph.order) do
    local n = graph.nodes[title]
    if n.name then known[n.name] = n end
  end
  local function define(title)
    local n = graph.nodes[title]
    if n and n.name and not known[title] then return nil end
    n = known[title] and { ci = known[title], calls = {}, seen = {} } or node(graph, title)
    n.name, n.public, n.place, n.bytes, n.kind = title, false, "", 0, "static"
    return n
  end
  local function finish()
    if current and current.ci then current.ci.bytes = math.max(current.ci.bytes, current.bytes) end
  end
  for line in string.gmatch(text, "[^\n]+") do
    local start = string.match(line, "^%x+ <([^>]+)>:$")
    if start then
      if current and not current.ends then edge(current, start) end
      finish()
      current, name, value = define(start), start, {}
    elseif current then
      instruct(current, name, line, constants, value)
    end
  end
  finish()
  -- second names of the same address, which objdump does not show
  local first = {}
  for address, title in string.gmatch(nm, "(%x+) [TtWw] ([^\n]+)") do
    local n = graph.nodes[title]
    if n and n.name then first[address] = title end
  end
  for address, title in string.gmatch(nm, "(%x+) [TtWw] ([^\n]+)") do
    if first[address] and first[address] ~= title then
      local alias = define(title)
      if alias then edge(alias, first[address]) end
    end
  end
  return graph
end

-- Appends what is in `more` and not yet in the list.
local function unite(list, more)
  local seen = {}
  for _, name in ipairs(list) do seen[name] = true end
  for _, name in ipairs(more) do
    if not seen[name] then list[#list + 1] = name end
    seen[name] = true
  end
end

-- Depth first; `open` is the chain of titles that are being visited, so that a cycle is seen.  Each title is worked out
-- once (`done`); in a cycle, where that is no bound, all that reach it say so.
local function depth(graph, known, done, open, title)
  if done[title] then return done[title] end
  local n = graph.nodes[title]
  local result = { name = n and n.name or title, bytes = 0, missing = {}, cycle = {}, dynamic = {}, indirect = {} }
  if not (n and n.name) then
    local name = result.name
    if name == INDIRECT then
      result.name = "a call through a pointer"
    else
      result.bytes = known[name] or 0
      if not known[name] then result.missing[1] = name end
    end
    done[title] = result
    return result
  end
  if n.kind ~= "static" then result.dynamic[1] = n.name end
  open[#open + 1] = title
  open[title] = #open
  local deepest
  for _, called in ipairs(n.calls) do
    if called == INDIRECT then unite(result.indirect, { n.name }) end
    if open[called] then
      for i = open[called], #open do unite(result.cycle, { graph.nodes[open[i]].name }) end
    else
      local below = depth(graph, known, done, open, called)
      for _, what in ipairs { "missing", "cycle", "dynamic", "indirect" } do unite(result[what], below[what]) end
      if not deepest or below.bytes > deepest.bytes then deepest = below end
    end
  end
  open[title], open[#open] = nil, nil
  result.bytes, result.below = n.bytes + (deepest and deepest.bytes or 0), deepest
  done[title] = result
  return result
end

-- A chain of calls stays below the deepest that is called: `below` leads from a function down to it.
function stack.worst(graph, known)
  local list, done = {}, {}
  for _, title in ipairs(graph.order) do
    local n = graph.nodes[title]
    if n.name then
      local found, path = depth(graph, known or {}, done, {}, title), {}
      local step = found
      while step do
        path[#path + 1], step = step.name, step.below
      end
      local function some(t) return #t > 0 and t or nil end
      list[#list + 1] = { name = n.name, public = n.public, place = n.place, bytes = found.bytes, path = path,
        missing = found.missing, cycle = some(found.cycle), dynamic = some(found.dynamic),
        indirect = some(found.indirect) }
    end
  end
  return list
end

return stack
