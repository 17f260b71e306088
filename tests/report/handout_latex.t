#!/usr/bin/env lua5.4
-- handout_latex.t - pdflatex sets the hand-out of every body without a warning and without a line too wide.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Needs texlive-latex-base: `.ci/setup latex`, `make check-latex`.  Without pdflatex it is skipped.

local tap = require "tests.tap"

local program = os.getenv "POLHODE" or "build/polhode"
if not os.execute "command -v pdflatex >/dev/null 2>&1" then
  tap.skip("the hand-outs are set", "pdflatex is not there (.ci/setup latex)")
  tap.done()
  return
end

local function output(command)
  local pipe = assert(io.popen(command))
  local text = pipe:read "a"
  return text, (pipe:close())
end

local folder = string.gsub(output "mktemp -d", "\n", "")

-- What pdflatex complains of, nil if of nothing.
local function complaint(tex)
  local _, fine = output(string.format("cd '%s' && pdflatex -halt-on-error -interaction=batchmode '%s' 2>&1",
    folder, tex))
  local file = io.open(folder .. "/" .. string.gsub(tex, "%.tex$", ".log"))
  local log = file and file:read "a" or "no log"
  if file then file:close() end
  for line in string.gmatch(log, "[^\n]+") do
    if string.find(line, "^!") or string.find(line, "Warning") or string.find(line, "^Overfull") or
      string.find(line, "^Underfull") then return line end
  end
  return not fine and "it failed" or nil
end

local function write(name, text)
  local file = assert(io.open(folder .. "/" .. name, "w"))
  file:write(text)
  file:close()
end

write("wrong.tex", "\\documentclass{article}\\begin{document}\\hbox to 1pt{too wide}\\end{document}")
tap.ok(complaint "wrong.tex", "control: a line too wide is seen")

for path in string.gmatch(output "ls bodies/*.lua", "[^\n]+") do
  local name = string.match(path, "([%w_]+)%.lua")
  local text = output(program .. " explain " .. path .. " --format latex --sections all " ..
    "--title '50% _of_ $1 & #2 {~^\\}' " ..
    "--author 'A. Bee' --date '1. 2.' 2>/dev/null")
  write(name .. ".tex", text)
  tap.is(complaint(name .. ".tex") or "nothing", "nothing", name .. ": what pdflatex complains of")
end
os.execute("rm -r '" .. folder .. "'")
tap.done()
