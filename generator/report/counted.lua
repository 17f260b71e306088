-- counted.lua -- the counted cost sheet (commands/measure.lua) as text: of the emitted README and of explain.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     counted.markdown(sheet)   lines; counted.text(sheet)   list of {title =, lines =}; counted.json(sheet, object)

local counted = {}

local function cell(n, least) return n and string.format("%d", n) .. (least and " +" or "") or "-" end

local function cells(row) return cell(row.count), cell(row.flash), cell(row.stack, row.least) end

local function any(target, field)
  for _, row in ipairs(target.functions) do
    if row[field] then return true end
  end
  return false
end

-- What the numbers are: sentences.
local function notes(sheet, target)
  if target.failed then return { "Not counted: " .. target.failed .. "." } end
  local list = {}
  local function put(...) list[#list + 1] = string.format(...) end
  put("Compiled by %s %s %s.", target.compiler, target.flags, sheet.options)
  if target.cycles then
    put("Cycles, not instructions, of one call with its arguments, by %s.", target.emulator)
  else
    put("Instructions, not cycles, of one call with its arguments, counted under %s.", target.emulator)
  end
  put("Called with the scene's initial state, t = %s s, h = %s s; runs and `advance` over one h, to 1e-6.", sheet.when,
    sheet.step)
  put("Flash: bytes of code and constants that a linker keeps for that function alone, the C library's included.")
  if target.bound then
    put("Stack: bytes of the deepest chain of calls, whichever way the numbers go%s.",
      any(target, "least") and "; +: at least, for part of it is not known" or "")
  else
    put("Stack: bytes used in this run; other numbers may take more.")
  end
  local orbit = target.orbit and string.format(", orbit %d", target.orbit) or ""
  local more = target.library > 0 and string.format(", and of the C library %d", target.library) or ""
  put("RAM: model %d bytes, state %d%s; static: %d%s%s.", target.model, target.state, orbit, target.ram, more,
    target.copies and ", the C library's and the constants included" or "")
  put("All functions together: %d bytes of flash.", target.flash)
  return list
end

local function unit(target) return target.cycles and "cycles" or "instructions" end

function counted.markdown(sheet)
  local lines = {}
  local function put(...) lines[#lines + 1] = string.format(...) end
  for _, target in ipairs(sheet.targets) do
    put("**%s**, %s.", target.name, sheet.real)
    for _, note in ipairs(notes(sheet, target)) do put("%s", note) end
    put ""
    if target.functions then
      put("| function | %s | flash | stack |", unit(target))
      put "|---|---|---|---|"
      for _, row in ipairs(target.functions) do put("| %s | %s | %s | %s |", row.name, cells(row)) end
      put ""
    end
  end
  return lines
end

function counted.text(sheet)
  local list = {}
  for i, target in ipairs(sheet.targets) do
    local lines = notes(sheet, target)
    if target.functions then
      lines[#lines + 1] = string.format("%-24s %12s %8s %8s", "", unit(target), "flash", "stack")
    end
    for _, row in ipairs(target.functions or {}) do
      lines[#lines + 1] = string.format("%-24s %12s %8s %8s", row.name, cells(row))
    end
    list[i] = { title = "Counted on " .. target.name .. ", in " .. sheet.real, lines = lines }
  end
  return list
end

function counted.json(sheet, object, null)
  local targets = {}
  for i, t in ipairs(sheet.targets) do
    local functions = {}
    for k, row in ipairs(t.functions or {}) do
      functions[k] = object { { "function", row.name }, { unit(t), row.count or null }, { "flash", row.flash },
        { "stack", row.stack or null }, { "stack_is_bound", t.bound and row.stack ~= nil and not row.least } }
    end
    targets[i] = t.failed and object { { "name", t.name }, { "failed", t.failed } } or object { { "name", t.name },
      { "compiler", t.compiler }, { "flags", t.flags .. " " .. sheet.options },
      { "emulator", t.emulator }, { "flash", t.flash }, { "ram", t.ram }, { "ram_of_library", t.library },
      { "model", t.model }, { "state", t.state },
      { "orbit", t.orbit or null }, { "functions", functions } }
  end
  return object { { "real", sheet.real }, { "t", sheet.when }, { "h", sheet.step }, { "targets", targets } }
end

return counted
