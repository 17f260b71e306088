#!/usr/bin/env lua5.4
-- readme.t - README.md and docs/features.md: what they show is what the program prints; links lead somewhere; README.md
-- is short, and so are the sentences of the pages; every page is in the index.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"
local shown = require "tests.shown"

local dir = program.directory()
shown.prepare(dir)

tap.ok(not shown.compare({ "a", "..." }, { "b" }) and not shown.compare({ "a" }, { "a", "b" }) and
  shown.compare({ "a", "...", "c", "..." }, { "a", "b", "c" }), "the comparison can fail")

for _, page in ipairs { "README.md", "docs/features.md" } do shown.run(page, dir) end

do -- the excerpt of C in the README
  local c = program.read "README.md":match "\n```c\n(.-)```"
  tap.ok(program.read(dir .. "/racket/racket.c"):find(c, 1, true), "README.md: its lines of C are those of racket.c")
end

-- ---- links ----

local function exists(path)
  local file = io.open(path)
  if file then file:close() end
  return file ~= nil
end

local function anchors(path)
  local set = {}
  for head in ("\n" .. program.read(path)):gmatch "\n#+ ([^\n]*)" do
    set[head:lower():gsub("[^%w%s_-]", ""):gsub("%s", "-")] = true
  end
  return set
end

local pages = { "README.md" }
for name in io.popen("LC_ALL=C ls docs/*.md"):lines() do pages[#pages + 1] = name end
local broken = {}
for _, page in ipairs(pages) do
  local folder = page:match "^(.*/)" or ""
  for link in program.read(page):gmatch "%]%(([^%s()]+)%)" do
    local path, anchor = link:match "^([^#]*)#?(.*)$"
    if link:find "[./#]" and not link:find "^%a+://" then
      local target = path == "" and page or folder .. path
      if not exists(target) or anchor ~= "" and target:find "%.md$" and not anchors(target)[anchor] then
        broken[#broken + 1] = page .. ": " .. link
      end
    end
  end
end
tap.is(table.concat(broken, "\n"), "", "every link of the pages leads somewhere")

local index, missing = program.read "docs/README.md", {}
for _, page in ipairs(pages) do
  local name = page:match "^docs/(.*)"
  if name and name ~= "README.md" and not index:find("(" .. name .. ")", 1, true) then missing[#missing + 1] = name end
end
tap.is(table.concat(missing, " "), "", "docs/README.md lists every page")

-- ---- plain English ----
-- A sentence is prose outside of tables, code and headings.  The bounds are those that the best READMEs of the field
-- keep (median 9 to 16 words); they judge length alone.

local function sentences(text)
  local prose = {}
  text = text:gsub("\n```.-\n```", "\n"):gsub("\n    [^\n]*", "\n")
  for line in (text .. "\n"):gmatch "([^\n]*)\n" do
    if line:find "^[#|]" or line == "" then
      prose[#prose + 1] = "."
    elseif line:find "^%s*[-*%d]+%.?%s" then
      prose[#prose + 1] = ". " .. line:gsub("^%s*[-*%d]+%.?%s", "")
    else
      prose[#prose + 1] = line
    end
  end
  local list = {}
  local joined = table.concat(prose, " "):gsub("`[^`]*`", "code"):gsub("%]%([^)]*%)", ""):gsub("(%d)%.(%d)", "%1,%2")
    :gsub("https?://%S+", "link"):gsub("(%a)%.(%a)", "%1%2")
  for sentence in joined:gmatch "[^.?!:]+" do
    local count = select(2, sentence:gsub("%S*%w%S*", ""))
    if count > 1 then list[#list + 1] = { count, sentence } end
  end
  table.sort(list, function(a, b) return a[1] > b[1] end)
  return list
end

local MEDIAN, LONG, SHARE, LONGEST = 16, 25, 0.1, 32
local judged = { "README.md" }
for page in ([[README accuracy changelog closed contributing coverage drift editor emitted errormap features firmware
  fit fixed_point fmi fuzzing hard_peers hunt inputs install interchange lecture library mass measured mechanics
  methods misra mutants planner projects promises proof sandbox security simulation stability sweep targets throw
  versions view]]):gmatch "%S+" do judged[#judged + 1] = "docs/" .. page .. ".md" end
for _, page in ipairs(judged) do
  local list, long = sentences(program.read(page)), 0
  for _, s in ipairs(list) do long = long + (s[1] > LONG and 1 or 0) end
  local middle = list[(#list + 1) // 2]
  tap.ok(#list >= 5 and middle[1] <= MEDIAN and long <= SHARE * #list and list[1][1] <= LONGEST,
    string.format("%s: %d sentences, median %d words, %d above %d", page, #list, middle[1], long, LONG), list[1][2])
end

tap.ok(#shown.lines(program.read "README.md") <= 150, "README.md has at most 150 lines")
local long = {}
for _, page in ipairs { "docs/contributing.md", "docs/security.md" } do
  if #shown.lines(program.read(page)) > 50 then long[#long + 1] = page end
end
tap.is(table.concat(long, " "), "", "the pages for reporting fit on a screen")

tap.done(program.finish())
