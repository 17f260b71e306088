-- judge.lua -- does one built project keep its promises?  Each function returns a list of faults, empty if it does.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     judge.said(text)                     compilers: any word is a fault
--     judge.symbols(nm, p)                 what the object defines and wants; p: a project, level: of the optimiser
--     judge.sections(text)                 nothing that can be written
--     judge.calls(ci)                      recursion, calls through pointers, frames that are not static
--     judge.text(p)                        header and source: words of the heap, numbers and functions of double
--     judge.all(p, build)                  all of it, of a directory that build.sh has worked in
-- The texts are those of nm, objdump -h and gcc -fcallgraph-info=su.

local program = require "tests.cli.program"
local stack = require "generator.cost.stack"
local tokens = require "generator.cost.tokens"

local judge = {}

local function set(text)
  local s = {}
  for word in string.gmatch(text, "%S+") do s[word] = true end
  return s
end

-- What the source may call of <math.h>; in a float build with an f behind it.
judge.math = set "sqrt sin cos sinh cosh frexp ldexp scalbn exp log floor fabs copysign fma sincos"

-- gcc and clang may make these of the text of any program: struct copies, initialisers; position independence.
judge.compiler = set "memcpy memset memmove _GLOBAL_OFFSET_TABLE_"

-- At -O0 gcc calls even what is one instruction of the processor.
judge.instructions = set "sqrt fabs copysign"

local HEAP = set "malloc calloc realloc free alloca aligned_alloc strdup longjmp setjmp"

function judge.said(text)
  return text == "" and {} or { "a compiler says: " .. string.sub(text, 1, 600) }
end

function judge.symbols(nm, p, level)
  local faults = {}
  local function fault(...) faults[#faults + 1] = string.format(...) end
  local seen = false
  for kind, name in string.gmatch(nm, "[%x ]+ (%a) ([^\n]+)") do
    seen = true
    if kind == "U" then
      local plain = string.gsub(name, "f$", "")
      local base = p.real == "float" and name ~= plain and plain or p.real == "double" and name
      local known
      if p.own then
        known = level == "-O0" and judge.instructions[base]
      else
        known = judge.compiler[name] or judge.math[base]
      end
      if not known then fault("undefined symbol %s", name) end
    elseif not string.find(kind, "[TtRr]") then
      fault("%s is data that may change (nm: %s)", name, kind)
    end
    if string.find(kind, "%u") and kind ~= "U" and string.sub(name, 1, #p.name + 1) ~= p.name .. "_" then
      fault("%s does not begin with the scene's name", name)
    end
  end
  if not seen then fault "nm shows no symbol" end
  return faults
end

function judge.sections(text)
  local faults, seen = {}, false
  for name, size, flags in string.gmatch(text, "\n%s*%d+ (%S+)%s+(%x+)[^\n]*\n%s+([^\n]+)") do
    seen = true
    -- .data.rel.ro holds addresses of constants, which the loader sets: nobody writes there
    if string.find(flags, "ALLOC") and not string.find(flags, "READONLY") and tonumber(size, 16) > 0 then
      faults[#faults + 1] = "section " .. name .. " can be written and has bytes"
    end
  end
  return seen and faults or { "objdump shows no section" }
end

function judge.calls(ci)
  local faults, said = {}, {}
  local list = stack.worst(stack.read(ci))
  for _, f in ipairs(list) do
    for _, what in ipairs { { "cycle", "recursion" }, { "dynamic", "a frame that is not static" },
      { "indirect", "a call through a pointer" } } do
      local names = f[what[1]] and what[2] .. ": " .. table.concat(f[what[1]], " ")
      if names and not said[names] then faults[#faults + 1] = names end
      if names then said[names] = true end
    end
  end
  return #list > 0 and faults or { "no graph of calls" }
end

-- Comments and preprocessor's strings gone.
local function code(text)
  text = string.gsub(text, "/%*.-%*/", " ")
  return (string.gsub(text, "//[^\n]*", " "))
end

-- The name of the array whose initialiser begins with the "=" at place i; is it a static constant?
local function named(list, i)
  while list[i] ~= "[" do i = i - 1 end
  return list[i - 1]
end

local function constant(list, i)
  while list[i] and list[i] ~= ";" and list[i] ~= "{" and list[i] ~= "}" do
    if list[i] == "static" then return true end
    i = i - 1
  end
  return false
end

function judge.text(p)
  local faults = {}
  local function fault(...) faults[#faults + 1] = string.format(...) end
  for _, text in ipairs { p.header, p.source } do
    local list = tokens.of(code(text))
    for i, token in ipairs(list) do
      if HEAP[token] and list[i + 1] == "(" then fault("%s: a word of the heap", token) end
      if p.real == "float" then
        local decimal = string.find(token, "^%.?%d") and not string.find(token, "^0[xX]") and
          string.find(token, "[.eE]")
        local hexadecimal = string.find(token, "^0[xX]") and string.find(token, "[pP.]")
        if (decimal or hexadecimal) and not string.find(token, "[fF]$") then fault("%s: a literal of double", token) end
        if token == "double" then fault "the word double" end
        if judge.math[token] and list[i + 1] == "(" then fault("%s: a function of double", token) end
        if token == "HUGE_VAL" then fault "HUGE_VAL is a double" end
      end
      -- a local array of which the rest is cleared: compilers for small processors make it a call of memset
      if token == "=" and list[i - 1] == "]" and list[i + 1] == "{" and list[i + 3] == "}" and
        tonumber((string.gsub(list[i + 2], "[fF]$", ""))) == 0 and not constant(list, i) then
        fault("%s[]: an initialiser that clears an array", named(list, i))
      end
      if token == "HUGE_VALL" or string.find(token, "^%.?%d.*[lL]$") and string.find(token, "[.eE]") then
        fault("%s: long double", token)
      end
    end
    for include in string.gmatch(text, "#%s*include%s*(%b<>)") do
      if not string.find("<math.h> <stdint.h> <stddef.h>", include, 1, true) then fault("includes %s", include) end
    end
  end
  local guard = "POLHODE_" .. string.upper(p.name) .. "_HEADER\n"
  if not string.find(p.header, "#ifndef " .. guard .. "#define " .. guard, 1, true) then
    fault "the header has no include guard of its name"
  end
  if not string.find(p.header, 'extern "C" {', 1, true) then fault 'the header has no extern "C"' end
  return faults
end

function judge.all(p, level)
  local base, faults = p.where .. "/" .. p.name, {}
  local function add(list)
    for _, f in ipairs(list) do faults[#faults + 1] = f end
  end
  add(judge.said(program.read(p.where .. "/said") or "nothing was built"))
  add(judge.symbols(program.read(base .. ".nm") or "", p, level))
  add(judge.sections(program.read(base .. ".sections") or ""))
  add(judge.calls(program.read(base .. ".ci") or ""))
  add(judge.text(p))
  return faults
end

return judge
