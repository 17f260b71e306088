-- page.lua - docs/mutants.md: what became of the planted defects.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     page.write(path, seed, defects)     a row for the run, and one for each defect that the quick tests let pass
--
-- Rows of the same seed are replaced; a verdict that was written by hand stays as long as its row stays the same.

local page = {}

local function cell(text) return (text:gsub("|", "\\|")) end

local function code(text)
  if text == "" then return "" end
  if #text > 160 then text = text:sub(1, 157) .. "..." end
  return "`" .. cell(text) .. "`"
end

-- Puts the new rows into the table behind a mark, instead of those with the same first cell.
local function merged(text, mark, seed, rows)
  local head, old, tail = text:match("^(.-<!%-%- " .. mark .. " %-%->\n[^\n]*\n[^\n]*\n)(.-)(\n?<!%-%- end %-%->.*)$")
  assert(head, "the page has no mark " .. mark)
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
  return head .. table.concat(kept, "\n") .. tail
end

function page.write(path, seed, defects)
  local quick, all, areas, missed, asked = 0, 0, {}, {}, true
  for _, d in ipairs(defects) do
    local name = d.file:match "^[^/]+"
    areas[name] = areas[name] or { planted = 0, quick = 0 }
    areas[name].planted = areas[name].planted + 1
    if d.quick ~= "-" then quick, areas[name].quick = quick + 1, areas[name].quick + 1 end
    if d.all ~= "-" then all = all + 1 end
    asked = asked and d.all ~= nil
    if d.quick == "-" then
      missed[#missed + 1] = string.format("| %d | %s:%d | %s | %s | %s |  |", seed, d.file, d.line, code(d.was),
        code(d.is), d.all == "-" and "no test" or d.all or "not asked")
    end
  end
  local row = string.format("| %d | %d | %d | %s | %s |", seed, #defects, quick, asked and math.tointeger(all) or "-",
    asked and string.format("%.0f %%", 100*quick/math.max(all, 1)) or "-")
  local by = {}
  for _, name in ipairs { "generator", "templates", "src" } do
    local a = areas[name] or { planted = 0, quick = 0 }
    by[#by + 1] = string.format(" %d of %d |", a.quick, a.planted)
  end
  row = row .. table.concat(by)
  print(row)
  local file = assert(io.open(path))
  local text = file:read "a"
  file:close()
  text = merged(text, "runs", seed, { row })
  text = merged(text, "missed", seed, missed)
  file = assert(io.open(path, "w"))
  file:write(text)
  file:close()
end

return page
