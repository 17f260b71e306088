-- engine.lua -- what a case of the fuzz targets of engine.c is, and what of its outcome is a finding.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- A case goes through generator/main.lua, as a command line does, with a host that reads the case's own bytes, takes
-- what is written, and starts no process.  The sandbox has a fiftieth of its instructions and half its seconds, for
-- the sake of cases a second: a bound that is passed earlier is passed the same way.
-- Findings: an error nobody caught; an exit status that the command does not have; status 0 with words about an error,
-- or another without; a message with a traceback, an address, a file of the generator or the sign of a nan that the
-- case did not bring itself; files of a scene that are not whole.

local host, mode, plant = ...

local main = require "generator.main"

-- ---- the host ----

local real_read, real_sandbox = host.read, host.sandbox
local given, out, err, written = {}, {}, {}, nil

function host.read(path)
  if plant == "error" and path == "s.lua" and string.find(given[path], "planted", 1, true) then
    error "a planted defect"
  end
  if given[path] then return given[path] end
  if path == "-" or string.find(path, "/", 1, true) then return nil, "cannot read " .. path .. ": it is not here" end
  return real_read(path)
end

function host.sandbox(text, chunk, env)
  return real_sandbox(text, chunk, env, { steps = 2000000, seconds = 5 })
end

function host.out(text)
  out[#out + 1] = text
  return true
end

function host.err(text)
  err[#err + 1] = text
  return true
end

function host.write_files(_, files)
  local names = {}
  for i, f in ipairs(files) do names[i] = f.name end
  written = files
  return true, names
end

function host.list_dir() return {} end
function host.bodies() return nil end
function host.write_file() return true end
function host.cache_read() return nil end
function host.cache_write() return false end
function host.fingerprint() return nil end
function host.isatty() return false end
function host.coloured() return false end
for _, name in ipairs { "tempdir", "execute", "compile", "plugin", "baseline", "peers" } do
  host[name] = function() return nil, "not here" end
end
function host.compile_many(list)
  local none = {}
  for i in ipairs(list) do none[i] = { message = "not here" } end
  return none
end

-- ---- what is a finding ----

local TRACES = { "internal error", "traceback", "generator/", "function:", "table:", "-nan", "templates/",
  "userdata:", "error object" }

-- The words of `text` that no message may have, unless the case has them.
local function trace(text, data)
  for _, t in ipairs(TRACES) do
    if string.find(text, t, 1, true) and not string.find(data, t, 1, true) then return t end
  end
  if string.find(text, "0x%x%x%x%x%x") and not string.find(data, "0x", 1, true) then return "an address" end
  -- a scene must not steer the terminal; who types a command line has it already
  if mode ~= "command" and string.find(text, "[%z\1-\8\11-\31\127]") then return "a control character" end
end

-- Numbers that no emitted line may have.
local function not_whole(files)
  for _, f in ipairs(files) do
    if string.find(f.name, "%.[ch]$") and (string.find(f.text, "[^%w_]nan[^%w_]") or
        string.find(f.text, "[^%w_]inf[^%w_]") or string.find(f.text, "${", 1, true)) then
      return f.name
    end
  end
end

-- Runs a command: its status, or nil and the finding.
local function run(data, allowed, args)
  out, err, written = {}, {}, nil
  local status = main(host, args)
  if plant == "status" and string.find(data, "planted", 1, true) then status = 4 end
  local command, text = table.concat(args, " "), table.concat(err)
  if not allowed[status] then return nil, command .. ": status " .. tostring(status) .. "\n" .. text end
  local bad = trace(text, data)
  if bad then return nil, command .. ": the message has: " .. bad .. "\n" .. text end
  -- links and check say it with their results
  if status ~= 0 and text == "" and #out == 0 then return nil, command .. ": no word of what is wrong" end
  if status == 0 and string.find(text, "^polhode") then return nil, command .. ": status 0 and an error\n" .. text end
  bad = written and not_whole(written)
  if bad then return nil, command .. ": " .. bad .. " is not whole" end
  return status
end

local function hash(data)
  local h = #data
  for i = 1, #data do h = (h * 31 + string.byte(data, i)) & 0xffffff end
  return h
end

-- ---- the modes ----

local one = { [0] = true, true }        -- right or wrong
local two = { [0] = true, true, true }  -- or no such thing
local three = { [0] = true, true, true, true } -- or numbers that failed a check

-- One scene in eight that is right goes on to one of these, chosen by the bytes.
local FURTHER = { { "gen", "s.lua" }, { "gen", "s.lua", "--real", "float" }, { "gen", "s.lua", "--bake" },
  { "gen", "s.lua", "--method", "midpoint,taylor,adaptive" }, { "gen", "s.lua", "--with", "jacobians" },
  { "explain", "s.lua", "--format", "json" }, { "explain", "s.lua", "--format", "latex" },
  { "explain", "s.lua", "--format", "urdf" }, { "gen", "s.lua", "--method", "exact" }, { "explain", "s.lua" } }

-- All that reads and validates: what every command does first, and `explain --format sdf` does nothing beside.
local function scene(text)
  given = { ["s.lua"] = text }
  local status, finding = run(text, one, { "explain", "s.lua", "--format", "sdf" })
  if status ~= 0 then return finding end
  local h = hash(text)
  -- a scene with an accuracy is planned by running compiled code, which is not for here
  if h % 8 ~= 0 or string.find(text, "accuracy", 1, true) or string.find(text, "budget", 1, true) then return nil end
  local _, further = run(text, one, FURTHER[h // 8 % #FURTHER + 1])
  return further
end

-- The bytes are the rows of a table, and an expression beside it, where a scene takes such.
local TABLE = [[
local m = param("m", 2, "kg")
return scene { name = "s", body = solid.box { x = 1, y = 2, z = 3, mass = m },
  effects = { effect.torque { body = { {%s}, 0, 1 } } }, time = { horizon = 1 } }
]]

local modes = { scene = scene }

function modes.table(data)
  return scene((string.gsub(TABLE, "%%s", function() return data end)))
end

function modes.robot(data)
  given = { ["x.xml"] = data, ["s.lua"] = 'return scene { name = "s", body = inertial { file = "x.xml" } }' }
  local status, finding = run(data, two, { "links", "x.xml" })
  if finding or status == 2 then return finding end
  local _, further = run(data, one, { "explain", "s.lua", "--format", "sdf" })
  return further
end

-- Each line an argument.  What would compile or run programs finds none.
function modes.command(data)
  given = { ["s.lua"] = 'local a = param("a", 0.3, "m")\nreturn scene { name = "s", body = solid.box ' ..
    '{ x = a, y = 2, z = 3, mass = 1 } }' }
  local args = {}
  for word in string.gmatch(data .. "\n", "([^\n]*)\n") do
    if #args < 12 then args[#args + 1] = (string.gsub(word, "%z.*", "")) end
  end
  if args[#args] == "" then args[#args] = nil end
  -- one times, for as long as it takes; the other draws all shapes, for seconds
  if args[1] == "bench" or args[1] == "list" and args[2] == "shapes" then return nil end
  local _, finding = run(data, three, args)
  return finding
end

assert(modes[mode], mode)
return function(data)
  math.randomseed(1758)
  return modes[mode](data)
end
