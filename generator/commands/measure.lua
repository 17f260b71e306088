-- measure.lua -- what an emitted scene's functions take on small processors, counted: gen and explain --target.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     measure.cores(names, real)         the cores of --target (nil: of none), or nil and what is wrong; all: all that
--                                        have the type
--     measure.run(host, job, cores, files)   the sheet of the emitted files, or nil and a message
-- The emitted source is compiled by each core's cross compiler, a program that calls all functions (emit/calls.lua)
-- runs in its emulator, every function is linked alone, stacks are summed along the graph of calls.  All are numbers of
-- the tools, none of a clock; the tools' versions stand beside them.  A sheet is
--     {real =, when =, step = (text), options = (of all compilers), targets = {target, ...}}
-- a target, or {name =, failed = (why it was not counted)},
--     {name =, compiler =, flags =, emulator =, cycles = (does it count those?),
--      bound = (stack is that of the deepest chain of calls, else of the counted run alone),
--      model =, state =, orbit = (bytes; nil: none), flash = (all functions linked),
--      ram =, library = (bytes of variables; copies: constants too, and all in ram),
--      functions = {{name =, count = (nil: not called), flash =, stack =, least = (part of it is not known)}, ...}}

local later = require "generator.later"
local compiler = later "generator.commands.compiler"
local options = require "generator.commands.options"
local calls = later "generator.emit.calls"
local data = require "generator.cost.cores"
local frames = later "generator.cost.frames"
local object = later "generator.cost.object"
local stack = later "generator.cost.stack"

local measure = { names = {} }

for i, core in ipairs(data.list) do measure.names[i] = core.name end

local MOST = (1 << 20) - 1 -- of what a program prints, that much is kept
local SPARE = 128          -- bytes of stack of who calls
local REFUSED = 9          -- exit status of calls.c
local LIMIT = 60           -- s for an emulator: thousands of times what one needs

-- ---- what is asked for, what is there ----

function measure.cores(names, real)
  if not names then return nil end
  local list, known = {}, {}
  for _, core in ipairs(data.list) do known[core.name] = core end
  local all = #names == 1 and names[1] == "all"
  local wrong = not all and options.unknown("--target", names, measure.names, "all")
  if wrong then return nil, wrong end
  for _, name in ipairs(all and measure.names or names) do
    local core = known[name]
    if real == "float" or not core.single then
      list[#list + 1] = core
    elseif not all then
      return nil, "--target " .. name .. " must have --real float: its compiler's double is a float"
    end
  end
  return list
end

-- The version in the first line that a tool prints; the packager's own stands in parentheses.
local function version(text)
  local first = string.gsub(string.match(text, "^[^\n]*"), "%b()", "")
  return string.match(first, "%d+%.%d+%.%d+") or string.match(first, "%d+%.%d+") or "?"
end

-- Versions by command; nil and a message that names what is missing and its packages.
local function tools(host, cores, dir)
  local found, commands, packages, seen = {}, {}, {}, {}
  local function lack(command, package)
    if not seen[command] then commands[#commands + 1] = command end
    if not seen[package] then packages[#packages + 1] = package end
    seen[command], seen[package] = true, true
  end
  local function try(command, package)
    if found[command] or seen[command] then return end
    local status, text = host.execute { command, "--version" }
    if status then found[command] = version(text) else lack(command, package) end
  end
  for _, core in ipairs(cores) do
    for _, p in ipairs(core.packages) do try(p[1], p[2]) end
    for _, h in ipairs(core.header) do
      local source, gcc = dir .. "/header.c", core.prefix .. "gcc"
      host.write_file(source, "#include <" .. h[1] .. ">\n")
      local made = host.compile(dir, { "header.c" }, "header.i",
        { cc = not h.host and gcc or nil, flags = h.host and { "-E" } or { "-E", table.unpack(core.flags) } })
      if not made then lack("<" .. h[1] .. ">" .. (h.host and "" or " of " .. gcc), h[2]) end
    end
  end
  local broken = compiler.missing(host) -- what counts inside an emulator is compiled for this machine
  if broken and #commands == 0 then return nil, "--target: " .. broken end
  if #commands == 0 then return found end
  for _, package in ipairs(broken and { "gcc", "libc6-dev" } or {}) do
    lack("a C compiler for this machine", package)
  end
  return nil, "--target needs " .. table.concat(commands, ", ") ..
    ", not found here; on Debian: apt-get install --no-install-recommends " .. table.concat(packages, " ")
end

-- ---- compiling ----

local function joined(...)
  local list = {}
  for _, part in ipairs { ... } do table.move(part, 1, #part, #list + 1, list) end
  return list
end

-- As host.compile_many has it; core nil: for the host itself.
local function item(dir, core, sources, output, flags, libs)
  local own = core and { cc = core.prefix .. "gcc", flags = joined(core.flags, flags), libs = libs }
  return { dir, sources, output, own or { flags = flags, libs = libs } }
end

local function compile(host, list)
  for i, made in ipairs(host.compile_many(list)) do
    if made.message then return nil, list[i][3] .. ": " .. made.message end
  end
  return true
end

-- Linking of chosen functions alone, without the start of a program.
local function alone(dir, core, sources, output, names)
  local flags = { "-nostartfiles", "-Wl,--gc-sections", "-Wl,-e," .. names[1] }
  for i, name in ipairs(names) do flags[i + 3] = "-Wl,-u," .. name end
  local script = core.script and { "-T", core.script } or {}
  return item(dir, core, sources, output, joined(core.link, flags, script), { "-lm" })
end

local function symbols_of(list)
  local names = {}
  for i, f in ipairs(list) do names[i] = f.symbol end
  return names
end

-- The objects of a core, by the modules' stems.
local function objects(core, modules)
  local names = {}
  for i, m in ipairs(modules) do names[i] = core.name .. "." .. m.stem .. ".o" end
  return names
end

local function build(host, dir, modules, cores, list)
  local first, second, native = {}, {}, {}
  local all = symbols_of(list)
  for _, core in ipairs(cores) do
    local n, kind = core.name, core.run and "count" or "avr"
    if not native[kind] then
      first[#first + 1] = core.run and item(dir, nil, { "count.c" }, "count.so", { "-O2", "-shared", "-fPIC" }) or
        item(dir, nil, { "avr.c" }, "avr", { "-O2" }, { "-lsimavr", "-l:libelf.so.1" })
      native[kind] = true
    end
    local made = objects(core, modules)
    for i, m in ipairs(modules) do
      first[#first + 1] = item(dir, core, { m.stem .. ".c" }, made[i],
        joined(data.options, { "-std=c99", "-w", "-c", core.run and "-fcallgraph-info=su" or nil }))
    end
    local start = core.script and { "-T", core.script, core.start } or {}
    second[#second + 1] = item(dir, core, joined({ "calls.c" }, made), n .. ".elf",
      joined(data.options, { "-std=gnu11", "-Wl,--gc-sections" }, core.link, start), { "-lm" })
    second[#second + 1] = alone(dir, core, made, n .. ".all", all)
    for _, f in ipairs(list) do
      second[#second + 1] = alone(dir, core, made, n .. "." .. f.name, { f.symbol })
    end
  end
  local ok, why = compile(host, first)
  if ok then ok, why = compile(host, second) end
  return ok, why
end

-- ---- counting ----

-- A function's address; the lowest bit of Arm's says Thumb.
local function hex(o, name) return string.format("0x%x", o.symbols[name].value & ~1) end

-- The counts of a program's calls, the first of which is none, and the second number of each line.
local function count(host, dir, core, elf)
  local command
  local log = core.name .. ".counts"
  if core.run then
    local plugin = "./count.so,begin=" .. hex(elf, "begin") .. ",end=" .. hex(elf, "end") ..
      (data.plugin[core.name] or "")
    command = joined(core.run, { "-nographic", "-monitor", "none", "-serial", "none", "-plugin", plugin, "-d", "plugin",
      "-D", log, "-kernel", core.name .. ".elf" })
  else
    command = { "./avr", core.name .. ".elf", hex(elf, "begin"), hex(elf, "end"), hex(elf, "finish") }
  end
  local status, text = host.execute(command, { dir = dir, seconds = LIMIT })
  if status == REFUSED then return nil, "init, solve or set_tick refuses the scene's initial state" end
  if status ~= 0 then return nil, "the emulator: " .. (status and "exit status " .. status .. ": " or "") .. text end
  if core.run then text = host.read(dir .. "/" .. log) end
  local counts, others = {}, { version = string.match(text, "simavr [%d.]+") }
  for n, other in string.gmatch(text, "%f[^\n\0](%d+) ?(%d*)\n") do
    counts[#counts + 1], others[#others + 1] = math.tointeger(tonumber(n)), math.tointeger(tonumber(other))
  end
  return counts, others
end

-- ---- stacks ----

local PIECE = 0x2000 -- bytes of code whose listing is surely shorter than MOST

-- The listing of all functions of a linked file, and their addresses as nm(1) writes them.
local function listing(host, dir, core, elf)
  local places, nm, text = {}, {}, {}
  for name, s in pairs(object.read(host.read(dir .. "/" .. elf)).symbols) do -- sorted below: order is lost
    places[#places + 1] = s.value & ~1
    nm[#nm + 1] = string.format("%x T %s", s.value, name)
  end
  table.sort(places)
  table.sort(nm)
  local from = places[1]
  for i, place in ipairs(places) do -- cut where a symbol is, so no function is cut
    local next_one = places[i + 1]
    if not next_one or next_one - from > PIECE then
      local stop = next_one and place > from and place or next_one
      local command = { core.prefix .. "objdump", "-d", string.format("--start-address=0x%x", from) }
      if stop then command[#command + 1] = string.format("--stop-address=0x%x", stop) end
      command[#command + 1] = elf
      local _, piece = host.execute(command, { dir = dir })
      if #piece >= MOST then return nil, "a function is too large to be read" end
      text[#text + 1] = piece
      from = stop
    end
  end
  return table.concat(text), table.concat(nm, "\n")
end

-- Worst stacks by name from the compiler's graph; the C library's functions, and on ARM all, from their machine code.
local function stacks(host, dir, core, modules)
  local graph
  for _, name in ipairs(objects(core, modules)) do
    graph = stack.read(host.read(dir .. "/" .. string.gsub(name, "o$", "ci")), graph)
  end
  if core.arm then -- all of it: gcc's graph forgets a part of some frames
    local text, nm = listing(host, dir, core, core.name .. ".all")
    if not text then return nil, nm end
    stack.disassembly(text, nm, graph)
  else
    local names, seen = {}, {}
    for _, f in ipairs(stack.worst(graph)) do
      for _, name in ipairs(f.missing) do
        if not seen[name] then names[#names + 1] = name end
        seen[name] = true
      end
    end
    if #names > 0 then
      local elf = core.name .. ".lib"
      local ok, why = compile(host, { alone(dir, core, {}, elf, names) })
      if not ok then return nil, why end
      local text, nm = listing(host, dir, core, elf)
      if not text then return nil, nm end
      frames.riscv(text, nm, graph)
    end
  end
  local worst = {}
  for _, f in ipairs(stack.worst(graph)) do worst[f.name] = worst[f.name] or f end
  return worst
end

-- ---- the sheet ----

local function bytes_of(elf, name) return elf.symbols[name] and elf.symbols[name].bytes end

local function one(host, dir, core, modules, list, found)
  local function read(suffix) return object.read(host.read(dir .. "/" .. core.name .. "." .. suffix)) end
  local elf, all, own = read "elf", read "all", 0
  for _, m in ipairs(modules) do own = own + read(m.stem .. ".o").ram end
  local counts, others = count(host, dir, core, elf)
  if not counts then return nil, others end
  local worst, why = {}, nil
  if core.run then worst, why = stacks(host, dir, core, modules) end
  if not worst then return nil, why end
  local gcc, emulator = core.packages[1][1], core.run and core.packages[2][1]
  local target = { name = core.name, cycles = not core.run, bound = core.run ~= nil,
    flags = table.concat(core.flags, " "), compiler = gcc .. " " .. found[gcc],
    emulator = (emulator and emulator .. " " .. found[emulator] or others.version) .. ", " .. core.machine,
    model = bytes_of(elf, "model"), state = bytes_of(elf, "start"), orbit = bytes_of(elf, "orbit"), flash = all.flash,
    ram = core.copies and all.ram or own, library = core.copies and 0 or all.ram - own, copies = core.copies,
    functions = {} }
  local called = 1
  for _, f in ipairs(list) do called = called + (f.text and 1 or 0) end
  if #counts ~= 2 * called then
    return nil, string.format("the program has come to call %d of %d", #counts, 2 * called)
  end
  local k, deepest = called + 1, 0 -- of the second time
  for i, f in ipairs(list) do
    local row, deep = { name = f.name, flash = read(f.name).flash }, worst[f.symbol]
    if f.text then
      k = k + 1
      row.count = counts[k] - counts[called + 1]
      row.stack = not core.run and others[k] or nil
    end
    if deep then
      row.stack, row.least = deep.bytes, (#deep.missing > 0 or deep.cycle or deep.dynamic or deep.indirect) and true
    end
    target.functions[i] = row
    deepest = math.max(deepest, row.stack or 0)
  end
  local needs = elf.ram + deepest + SPARE
  if core.memory and needs > core.memory then
    return nil, string.format("%s has %d bytes of RAM, the program that calls all functions needs %d", core.machine,
      core.memory, needs)
  end
  return target
end

function measure.run(host, job, cores, emitted)
  local dir, why = host.tempdir()
  if not dir then return nil, why end
  local found
  found, why = tools(host, cores, dir)
  if not found then return nil, why end
  local modules = calls.modules(job, emitted)
  local plan = calls.of(job, modules)
  local files = { { name = "calls.c", text = plan.program } }
  for _, m in ipairs(modules) do
    files[#files + 1] = { name = m.stem .. ".h", text = m.header }
    files[#files + 1] = { name = m.stem .. ".c", text = m.source }
  end
  if modules.private then files[#files + 1] = { name = job.model.name .. "_private.h", text = modules.private } end
  for _, file in ipairs { "marks.h", "count.c", "avr.c", "startup.c", "riscv.c", "cortex.ld", "riscv.ld" } do
    files[#files + 1] = { name = file, text = host.templates[data.folder .. file] }
  end
  local ok
  ok, why = host.write_files(dir, files)
  if ok then ok, why = build(host, dir, modules, cores, plan.list) end
  if not ok then return nil, "--target: " .. why end
  local sheet = { real = job.real, when = plan.when, step = plan.step, options = table.concat(data.options, " "),
    targets = {} }
  for i, core in ipairs(cores) do
    local target
    target, why = one(host, dir, core, modules, plan.list, found)
    if not target and #cores == 1 then return nil, "--target " .. core.name .. ": " .. why end
    sheet.targets[i] = target or { name = core.name, failed = why }
  end
  return sheet
end

return measure
