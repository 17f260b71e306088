#!/usr/bin/env lua5.4
-- manual.t - man pages and completions: they have every command, option and choice; formatters and shells accept them;
-- bash, zsh and fish complete what they should.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- What is needed (man, mandoc, zsh, fish) and missing is skipped; bash and lua5.4 are always there.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"
local completed = require "docs.tools.completed"
local help = require "generator.commands.help"
local fields = require "generator.language.fields"
local catalogue = require "generator.mass.catalogue"
local effects = require "generator.effects.effects"

local root = io.popen("pwd"):read "l"
local binary = os.getenv "POLHODE" or "build/polhode"
if binary:sub(1, 1) ~= "/" then binary = root .. "/" .. binary end
local dir = program.directory()

local function shell(command)
  local status = program.shell(string.format("cd %s && { %s\n} >out 2>&1", dir, command))
  return status, program.read(dir .. "/out")
end
local function found(name) return shell("command -v " .. name) == 0 end

-- ---- man pages ----

local function make(tool, more)
  return program.shell(string.format("mkdir -p %s/%s && lua5.4 docs/tools/%s.lua %s/%s %s", dir, tool, tool, dir, tool,
    more or ""))
end
tap.is(make("manual", "9.8.7 2001-02-03"), 0, "the man pages are written")

local function page(name) return program.read(dir .. "/manual/" .. name) or "" end
-- The text of a page as a reader sees it: without macros and escapes.
local function plain(name)
  return (page(name):gsub("\\f.", ""):gsub("\\%-", "-"):gsub("\\&", ""):gsub("\\%(ga", "`"):gsub("\\%(ti", "~")
    :gsub("\\%(ha", "^"):gsub("\\e", "\\"):gsub("\n%.[^\n]*", function(l) return l:gsub("^\n%.%a+ ?", "\n") end))
end

for _, name in ipairs(help.names) do
  local text, lacks = plain("polhode-" .. name .. ".1"):gsub("%s+", " "), {}
  local function need(what)
    if not text:find((what:gsub("%s+", " ")), 1, true) then lacks[#lacks + 1] = what end
  end
  for _, row in ipairs(help.of(name).options) do
    need(row[1])
    need(row[3]:sub(2))
    if row.default then need(row.default) end
    for _, choice in ipairs(type(row[2]) == "table" and row[2] or {}) do need(choice) end
  end
  for _, e in ipairs(help.of(name).examples) do need(e[1]) end
  tap.is(table.concat(lacks, "\n"), "", "polhode-" .. name .. "(1) has every option, choice, default and example")
  tap.ok(plain "polhode.1":find("polhode-" .. name .. "(1)", 1, true), "and polhode(1) names it")
end
do
  local text, lacks = "\n" .. plain "polhode-scene.5", {}
  local function need(word)
    if not text:find("\n" .. word, 1, true) then lacks[#lacks + 1] = word end
  end
  for _, g in ipairs(fields.groups) do
    for _, f in ipairs(g.fields) do need(f[1]) end
  end
  for _, list in ipairs { catalogue.list, effects } do
    for _, entry in ipairs(list) do need(entry.name) end
  end
  tap.is(table.concat(lacks, " "), "", "polhode-scene(5) has every field, shape and effect")
  local declared = 0
  text, lacks = plain "polhode.3":gsub("%s+", " "), {}
  for header in io.popen "ls src/runtime/polhode*.h":lines() do
    for function_name in program.read(header):gmatch "\n%a[%w_ %*]-(ph_[%w_]+)%(" do
      declared = declared + 1
      if not text:find(function_name .. "(", 1, true) then lacks[#lacks + 1] = function_name end
    end
  end
  tap.ok(declared > 100 and #lacks == 0, "polhode(3) has all " .. declared .. " functions of the headers",
    table.concat(lacks, " "))
end
for name in io.popen("ls " .. dir .. "/manual"):lines() do
  local first = page(name):match "\n(%.TH [^\n]*)" or ""
  tap.ok(first:find('2001-02-03 "polhode 9.8.7"', 1, true), name .. ": has version and day", first)
end
if found "mandoc" then
  local status, text = shell "mandoc -T lint -W warning manual/*"
  tap.ok(status == 0, "mandoc -T lint finds nothing", text)
else
  tap.skip("mandoc -T lint finds nothing", "no mandoc here")
end
if found "man" and found "groff" then
  local _, text = shell "for f in manual/*; do man --warnings -E UTF-8 -l -Tutf8 -Z $f 2>&1 >/dev/null; done"
  tap.is(text, "", "man --warnings has none")
else
  tap.skip("man --warnings has none", "no man here")
end

-- ---- completions ----

tap.is(make "completions", 0, "the completions are written")
program.write(dir .. "/top.lua", "")
program.write(dir .. "/data.csv", "")
program.shell("mkdir " .. dir .. "/folder " .. dir .. "/bin && ln -s " .. binary .. " " .. dir .. "/bin/polhode")
local path = string.format("export PATH=%s/bin:$PATH POLHODE_BODIES=%s/bodies\n", dir, root)

-- What bash offers for the last of the words, sorted.
local function bash(words)
  local quoted = {}
  for i, w in ipairs(words) do quoted[i] = "'" .. w .. "'" end
  local _, text = shell(path .. string.format([[bash --norc --noprofile -c '
. completions/polhode.bash
COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMPREPLY=()
_polhode
for c in "${COMPREPLY[@]}"; do echo "$c"; done | LC_ALL=C sort' bash %s]], table.concat(quoted, " ")))
  return (text:gsub("\n$", ""):gsub("\n", " "))
end

local function sorted(list)
  local copy = { table.unpack(list) }
  table.sort(copy)
  return table.concat(copy, " ")
end

do
  local names = { "--help", "--version" }
  for _, c in ipairs(completed.commands()) do names[#names + 1] = c.name end
  tap.is(bash { "polhode", "" }, sorted(names), "bash: every command")
  for _, c in ipairs(completed.commands()) do
    local options, wrong = {}, {}
    for i, o in ipairs(c.options) do
      options[i] = o.name
      if o.value and o.value.words then
        local words = sorted(o.value.words)
        if bash { "polhode", c.name, o.name, "" } ~= words then wrong[#wrong + 1] = o.name end
        if o.name:find "^%-%-" and bash { "polhode", c.name, o.name, "=", "" } ~= words then
          wrong[#wrong + 1] = o.name .. "="
        end
      end
    end
    local want = sorted(options)
    if want ~= "" then tap.is(bash { "polhode", c.name, "-" }, want, "bash: every option of " .. c.name) end
    tap.is(table.concat(wrong, " "), "", "bash: every choice of " .. c.name)
  end
end
for _, case in ipairs {
  { { "polhode", "gen", "--re" }, "--real" },
  { { "polhode", "gen", "--with", "analysis,j" }, "analysis,jacobians" },
  { { "polhode", "gen", "--with", "q31,q" }, "" },
  { { "polhode", "gen", "symm" }, "symmetric_top" },
  { { "polhode", "gen", "to" }, "top.lua torsion_pendulum" },
  { { "polhode", "gen", "-o", "" }, "bin completions folder manual" },
  { { "polhode", "run", "--input", "d" }, "data.csv" },
  { { "polhode", "run", "--step", "" }, "" },
  { { "polhode", "list", "s" }, "shapes" },
} do
  tap.is(bash(case[1]), case[2], "bash: " .. table.concat(case[1], " "))
end

-- The choices that are offered are those that the program takes: its own message lists them.
for _, command in ipairs { "gen", "bench", "view" } do
  local _, text = shell(binary .. " " .. command .. " /dev/null --method nonsense")
  local list = {}
  for word in (text:match "some of (.-), got" or ""):gmatch "[^, ]+" do list[#list + 1] = word end
  tap.is(bash { "polhode", command, "--method", "" }, sorted(list), command .. " --method: the methods that it takes")
end

if found "zsh" then
  local status, text, _ = shell "zsh -n completions/_polhode"
  tap.ok(status == 0, "zsh accepts its file", text)
  -- zsh completes in a terminal of its own
  _, text = shell(path .. [==[
cat >drive.zsh <<'EOF'
zmodload zsh/zpty
zpty z zsh -f -i
zpty -w z "PS1=; fpath=($PWD/completions \$fpath); autoload -Uz compinit; compinit -u -D; unsetopt beep"
zpty -w z "zstyle ':completion:*' list-separator ' '; LISTMAX=9999; echo ready"
sleep 0.5
zpty -n -w z $'polhode gen --real \t\t'
sleep 1
zpty -n -w z $'\x15polhode ex\t'
sleep 0.5
zpty -r -t z text; while [[ -n $text ]]; do print -r -- $text; text=; zpty -r -t z text || break; done
EOF
TERM=dumb timeout 20 zsh -f drive.zsh]==])
  tap.ok(text:find "double" and text:find "float" and text:find "explain",
    "zsh: --real offers double and float, ex is explain", text)
else
  tap.skip("zsh accepts its file", "no zsh here")
end
if found "fish" then
  local function fish(line)
    local _, text = shell(path .. "export HOME=$PWD\nfish --no-config -c 'source completions/polhode.fish; " ..
      "complete -C \"" .. line .. "\"' | cut -f1 | LC_ALL=C sort")
    return (text:gsub("\n$", ""):gsub("\n", " "))
  end
  local names = {}
  for i, c in ipairs(completed.commands()) do names[i] = c.name end
  tap.is(fish "polhode ", sorted(names), "fish: every command")
  tap.is(fish "polhode gen --real ", "double float", "fish: a choice")
  tap.is(fish "polhode gen --with analysis,j", "analysis,jacobians", "fish: the second of several")
  tap.is(fish "polhode gen symm", "symmetric_top", "fish: a scene")
else
  tap.skip("fish: every command", "no fish here")
end

tap.done(program.finish())
