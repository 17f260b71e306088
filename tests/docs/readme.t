#!/usr/bin/env lua5.4
-- readme.t - README.md and docs/features.md: what they show is what the program prints; links lead somewhere; README.md
-- and its sentences are short; every page is in the index.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- A block ```lua is saved as NAME.lua, NAME from its first line (-- NAME.lua) or from its name = "...".  A line
-- "$ ..." of an indented block is run; what follows is compared, "..." standing for any lines.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local root = io.popen("pwd"):read "l"
local binary = os.getenv "POLHODE" or "build/polhode"
if binary:sub(1, 1) ~= "/" then binary = root .. "/" .. binary end
local dir = program.directory()
program.shell(string.format("mkdir %s/bin && ln -s %s %s/bin/polhode", dir, binary, dir))

local function lines_of(text)
  local list = {}
  for line in (text .. "\n"):gmatch "(.-)\n" do list[#list + 1] = line end
  if list[#list] == "" then list[#list] = nil end
  return list
end

-- ---- what is shown ----

local function save_scenes(text)
  for block in text:gmatch "\n```lua\n(.-)```" do
    local name = block:match "^%-%- (%w+)%.lua\n" or block:match 'name%s*=%s*"(%w+)"'
    program.write(dir .. "/" .. name .. ".lua", block)
  end
end

-- The commands of the page with what is shown of their output.
local function commands(text)
  local list, now = {}, nil
  for line in text:gmatch "([^\n]*)\n" do
    local command, shown = line:match "^    %$ (.*)", line:match "^    (.*)"
    if command then
      now = { command = command, shown = {} }
      list[#list + 1] = now
    elseif shown and now then
      table.insert(now.shown, shown)
    else
      now = nil
    end
  end
  return list
end

-- Do the lines follow each other in the output as shown?  Else the first line that does not.
local function compare(shown, output)
  local at, free = 1, false
  for _, line in ipairs(shown) do
    if line == "..." then
      free = true
    else
      while free and output[at] and output[at] ~= line do at = at + 1 end
      if output[at] ~= line then return false, line end
      at, free = at + 1, false
    end
  end
  return free or at > #output, "and no more, but there is: " .. tostring(output[at])
end

tap.ok(not compare({ "a", "..." }, { "b" }) and not compare({ "a" }, { "a", "b" }) and
  compare({ "a", "...", "c", "..." }, { "a", "b", "c" }), "the comparison can fail")

for _, page in ipairs { "README.md", "docs/features.md" } do
  local text = program.read(page)
  save_scenes(text)
  local list = commands(text)
  tap.ok(#list >= 3, page .. ": it shows commands")
  for _, c in ipairs(list) do
    program.shell(string.format("cd %s && PATH=%s/bin:$PATH POLHODE_BODIES=%s/bodies timeout 60 sh -c '%s' >out 2>&1",
      dir, dir, root, (c.command:gsub("'", "'\\''"))))
    local same, line = compare(c.shown, lines_of(program.read(dir .. "/out")))
    tap.ok(same, page .. ": $ " .. c.command,
      same or "shown: " .. line .. "\n" .. program.read(dir .. "/out"):sub(1, 2000))
  end
end

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
for _, page in ipairs { "README.md", "docs/README.md", "docs/features.md", "docs/install.md", "docs/versions.md",
  "docs/contributing.md", "docs/security.md", "docs/changelog.md" } do
  local list, long = sentences(program.read(page)), 0
  for _, s in ipairs(list) do long = long + (s[1] > LONG and 1 or 0) end
  local middle = list[(#list + 1) // 2]
  tap.ok(#list >= 5 and middle[1] <= MEDIAN and long <= SHARE * #list and list[1][1] <= LONGEST,
    string.format("%s: %d sentences, median %d words, %d above %d", page, #list, middle[1], long, LONG), list[1][2])
end

tap.ok(#lines_of(program.read "README.md") <= 150, "README.md has at most 150 lines")
local long = {}
for _, page in ipairs { "docs/contributing.md", "docs/security.md" } do
  if #lines_of(program.read(page)) > 50 then long[#long + 1] = page end
end
tap.is(table.concat(long, " "), "", "the pages for reporting fit on a screen")

tap.done(program.finish())
