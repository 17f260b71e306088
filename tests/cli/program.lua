-- program.lua - runs the program polhode from a test, with a generator of the test's own.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     local program = require "tests.cli.program"
--     local status, out, err, seconds = program.run(lua_text, "argument", ...)
--     program.run_generator(lua_text, ...)     -- the same; the text can require modules of the generator
--     local dir = program.directory()      -- of this test alone, removed by program.finish()
--
-- POLHODE names another binary (the one with sanitizers).  Every run is under timeout(1): a test never hangs.

local program = {}

local binary = os.getenv("POLHODE") or "build/polhode"
local LIMIT = 60 -- s; far above what any test may take

local dir

local function quote(s)
  return "'" .. s:gsub("'", "'\\''") .. "'"
end

function program.read(path)
  local file = io.open(path, "rb")
  if file == nil then
    return nil
  end
  local text = file:read("a")
  file:close()
  return text
end

function program.write(path, text)
  local file = assert(io.open(path, "wb"))
  assert(file:write(text))
  assert(file:close())
end

function program.directory()
  if dir == nil then
    local pipe = assert(io.popen("mktemp -d"))
    dir = pipe:read("l")
    pipe:close()
  end
  return dir
end

function program.shell(command)
  local _, why, code = os.execute(command)
  return why == "signal" and 128 + code or code
end

-- What a command comes to: its status, what it wrote to standard output and to standard error.
function program.output(command)
  local base = program.directory()
  local code = program.shell(string.format("%s >%s/stdout 2>%s/stderr", command, base, base))
  return code, program.read(base .. "/stdout"), program.read(base .. "/stderr")
end

-- "CC=..." for the program's environment: another compiler (CC's unless named) and level, which gives the same bits
-- (tests/target/bits.t) sooner; -O0 has fewer warnings, which other tests see.
function program.compiler(level, compiler)
  local path = program.directory() .. "/cc" .. level
  program.write(path, "#!/bin/sh\nexec " .. (compiler or os.getenv "CC" or "cc") .. " \"$@\" " .. level .. "\n")
  program.shell("chmod +x " .. quote(path))
  return "CC=" .. quote(path)
end

-- For runs in which there is more to compile than to run: clang, which takes half of gcc's time without optimisation.
function program.quick_compiler()
  local found = program.shell "command -v clang >/dev/null 2>&1" == 0
  return program.compiler("-O0", found and "clang" or nil)
end

-- The program as a command with that compiler.
function program.quick()
  return "env " .. program.quick_compiler() .. " " .. binary
end

-- A tree in which the Lua text has the whole generator beside it.
local function whole_tree()
  local tree = program.directory() .. "/tree"
  program.shell("mkdir -p " .. tree .. "/generator && ln -sf \"$PWD\"/generator/* " .. tree ..
    "/generator && ln -sfn " ..
    "\"$PWD\"/templates " .. tree .. "/templates && rm " .. tree .. "/generator/main.lua && cp " ..
    "tests/cli/tree/generator/main.lua " .. tree .. "/generator")
  return tree
end

-- Run the Lua text as a generator in the tree.
local function run_in(tree, before, after, text, ...)
  local base = program.directory()
  program.write(base .. "/main.lua", text)
  local words = { before, "POLHODE_SOURCE=" .. tree, "timeout", tostring(LIMIT), binary, quote(base .. "/main.lua") }
  for _, argument in ipairs { ... } do
    words[#words + 1] = quote(argument)
  end
  words[#words + 1] = ">" .. base .. "/out 2>" .. base .. "/err " .. after
  local code = program.shell(table.concat(words, " "))
  return code, program.read(base .. "/out"), program.read(base .. "/err")
end

-- Run the Lua text as the program's generator. Environment variables and redirections go before and after.
function program.run_with(before, after, text, ...)
  return run_in("tests/cli/tree", before, after, text, ...)
end

function program.run(text, ...)
  return program.run_with("", "", text, ...)
end

-- The same with the modules of the generator for the text to require.
function program.run_generator(text, ...)
  return run_in(whole_tree(), "", "", text, ...)
end

function program.finish()
  if dir ~= nil then
    program.shell("rm -rf " .. quote(dir))
  end
end

return program
