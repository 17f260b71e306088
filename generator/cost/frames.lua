-- frames.lua -- frames and calls of RISC-V functions from their disassembly, for what has no .ci: C libraries.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     frames.riscv(text, nm, graph)     `objdump -d` and `nm` into a graph of cost/stack.lua; what has a node keeps it
-- A frame is the sum of all that a function takes from sp anywhere; __riscv_save_N, which leaves the registers on the
-- stack of its caller, counts as part of that: 64 bytes for four registers or more, of which some are given back, and
-- 16 (libgcc, config/riscv/save-restore.S, RV32).

local frames = {}

-- A node with an empty frame; nil where there is one with a frame already.
local function define(graph, title)
  local n = graph.nodes[title]
  if n and n.name then return nil end
  if not n then
    n = { calls = {}, seen = {} }
    graph.nodes[title] = n
    graph.order[#graph.order + 1] = title
  end
  n.name, n.public, n.place, n.bytes, n.kind = title, false, "", 0, "static"
  return n
end

-- One line of a function: what it takes from sp, whom it calls.
local function instruct(n, name, line)
  local instruction, operands = string.match(line, "^%s*%x+:\t[%x ]+\t([%w%.]+)\t?(.*)")
  if not instruction then return end
  local down = string.match(operands, "^sp,sp,%-(%d+)")
  if down then
    n.bytes = n.bytes + math.tointeger(tonumber(down))
  elseif string.find(operands, "^sp,%w+,%a") then -- by a register: add is how frames beyond 2 kB are made
    n.kind = "dynamic"
  end
  if not string.find(instruction, "^[jb]") then return end
  local target = string.match(operands, "<([^>+]+)>")
  local saved = target and string.match(target, "^__riscv_save_(%d+)$")
  if saved then
    n.bytes = n.bytes + (tonumber(saved) > 3 and 64 or 16)
  elseif target and target ~= name and not string.find(target, "^__riscv_restore_") and not n.seen[target] then
    n.seen[target] = true
    n.calls[#n.calls + 1] = target
  elseif instruction == "jalr" and not target then
    n.calls[#n.calls + 1] = "__indirect_call"
  end
end

-- Second names of one address, which objdump does not show, call the first.
local function aliases(nm, graph)
  local first = {}
  for address, title in string.gmatch(nm, "(%x+) T ([^\n]+)") do
    local n = graph.nodes[title]
    if n and n.name then first[address] = title end
  end
  for address, title in string.gmatch(nm, "(%x+) T ([^\n]+)") do
    local n = first[address] and first[address] ~= title and define(graph, title)
    if n then n.calls[1] = first[address] end
  end
end

function frames.riscv(text, nm, graph)
  local current, name
  for line in string.gmatch(text, "[^\n]+") do
    local start = string.match(line, "^%x+ <([^>]+)>:$")
    if start then
      current, name = define(graph, start), start
    elseif current then
      instruct(current, name, line)
    end
  end
  aliases(nm, graph)
  return graph
end

return frames
