-- page.lua - docs/mutants.md: what became of the planted defects.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     page.write(path, seed, defects, nobody)    a row for the run, one for each defect that the quick tests let pass
--                                             (nobody: what to say where no test found it), the sums of all runs
--     lua5.4 tests/mutants/page.lua [FILE]    the sums anew after verdicts were written, by hand or from the lines of
--                                             FILE: SEED, file:line, verdict, with tabs between
--
-- Rows of the same seed are replaced; a verdict that was written by hand stays as long as its row stays the same.  A
-- verdict begins with one of four words: found (by which longer test), closed (by which test, written since), equal
-- (why), gap (what is missing).

local page = {}

local PAGE = "docs/mutants.md"

local function cell(text) return (text:gsub("|", "\\|")) end

local function code(text)
  if text == "" then return "" end
  if #text > 160 then text = text:sub(1, 157) .. "..." end
  return "`" .. cell(text) .. "`"
end

local function slurp(path)
  local file = assert(io.open(path))
  local text = file:read "a"
  file:close()
  return text
end

local function write(path, text)
  local file = assert(io.open(path, "w"))
  file:write(text)
  file:close()
end

-- head, rows and tail of what stands behind a mark.
local function parts(text, mark)
  local head, rows, tail = text:match("^(.-<!%-%- " .. mark .. " %-%->\n)(.-)(<!%-%- end %-%->.*)$")
  assert(head, "the page has no mark " .. mark)
  return head, rows, tail
end

-- Puts the new rows into the table behind a mark, instead of those with the same first cell.
local function merged(text, mark, seed, rows)
  local head, old, tail = parts(text, mark)
  local kept, verdicts = {}, {}
  for line in old:gmatch "[^\n]+" do
    if not line:find("| " .. seed .. " |", 1, true) then kept[#kept + 1] = line end
    local body, verdict = line:match "^(.*|) ([^|]*) |$"
    if body then verdicts[body] = verdict end
  end
  for _, row in ipairs(rows) do
    if row:find "|  |$" then
      local body = row:sub(1, -4)
      row = body .. " " .. (verdicts[body] or "") .. " |"
    end
    kept[#kept + 1] = row
  end
  return head .. table.concat(kept, "\n") .. "\n" .. tail
end

-- The sums of both tables.
local WORDS = { found = true, closed = true, equal = true, gap = true }
local function summed(text)
  local n = { planted = 0, quick = 0, found = 0, closed = 0, equal = 0, gap = 0, ["not read"] = 0 }
  local _, runs = parts(text, "runs")
  for planted, quick in runs:gmatch "| %d+ | (%d+) | (%d+) |" do
    n.planted, n.quick = n.planted + planted, n.quick + quick
  end
  local _, missed = parts(text, "missed")
  for by, verdict in missed:gmatch "| ([^|]+) | ([^|\n]*)|\n" do
    local word = verdict:match "^%l+"
    if by:find "^tests/" then word = "found" end
    if by:find "^tests/" or by:find "^no" then
      word = WORDS[word] and word or "not read"
      n[word] = n[word] + 1
    end
  end
  local real = n.planted - n.equal
  local head, _, tail = parts(text, "sums")
  return head .. string.format("**%d** were planted. The quick tests found %d, the longer ones %d more; %d change " ..
    "nothing that is promised (equal).\nOf the other %d that is %.1f %%; with the %d for which a test was written " ..
    "since it is **%.1f %%**. Gaps: %d; not yet read: %d.\n", n.planted, n.quick, n.found, n.equal, real,
    100*(n.quick + n.found)/real, n.closed, 100*(n.quick + n.found + n.closed)/real, n.gap, n["not read"]) .. tail
end

function page.write(path, seed, defects, nobody)
  local quick, areas, missed = 0, {}, {}
  for _, d in ipairs(defects) do
    local name = d.file:match "^[^/]+"
    areas[name] = areas[name] or { planted = 0, quick = 0 }
    areas[name].planted = areas[name].planted + 1
    if d.quick ~= "-" then
      quick, areas[name].quick = quick + 1, areas[name].quick + 1
    else
      missed[#missed + 1] = string.format("| %d | %s:%d | %s | %s | %s |  |", seed, d.file, d.line, code(d.was),
        code(d.is), d.all == "-" and nobody or d.all)
    end
  end
  local row = string.format("| %d | %d | %d |", seed, #defects, quick)
  for _, name in ipairs { "generator", "templates", "src" } do
    local a = areas[name] or { planted = 0, quick = 0 }
    row = row .. string.format(" %d of %d |", a.quick, a.planted)
  end
  print(row)
  write(path, summed(merged(merged(slurp(path), "runs", seed, { row }), "missed", seed, missed)))
end

-- The verdicts of a file into the rows.
local function judged(text, file)
  for line in io.lines(file) do
    local seed, where, verdict = line:match "^(%d+)\t(%S+)\t(.+)$"
    assert(seed, "SEED, file:line, verdict, between tabs are wanted, got " .. line)
    local count = 0
    text = text:gsub("(\n| " .. seed .. " | " .. where:gsub("%p", "%%%0") .. " |[^\n]*| )[^|\n]*|\n", function(row)
      count = count + 1
      return row .. cell(verdict) .. " |\n"
    end)
    if count ~= 1 then print(string.format("%s %s: %d rows", seed, where, count)) end
  end
  return text
end

if arg and arg[0] and arg[0]:find "mutants/page%.lua$" then
  local text = slurp(PAGE)
  write(PAGE, summed(arg[1] and judged(text, arg[1]) or text))
end

return page
