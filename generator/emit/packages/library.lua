-- library.lua -- what the packages of other ecosystems share: the emitted files where such a library has them, and the
-- README with a section of its own.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local number = require "generator.emit.number"

local library = {}

local FOLDER = "templates/projects/"

-- Values for the templates of libraries: the example prints 21 rows over the horizon, or over 4096 steps of it.
local function fill(job, v)
  local m, columns, enums = job.model, {}, {}
  for i, s in ipairs(job.states) do columns[i], enums[i] = s.name, v.upper .. "_" .. string.upper(s.name) end
  v.columns, v.state_names = table.concat(columns, ","), enums
  local steps = R.toint(R.floor(m:number(m.horizon) / m:number(m.step)))
  local every = math.max(1, math.min(steps, 4096) // 20)
  v.example_rows, v.example_every = "21", string.format("%d", every)
  v.million = number.text(R.new(1000000), job.real)
end

-- A package from a description {where = {header =, source =, test =} folders, files = {{template, name}, ..},
-- once = {[template] = true} (the user edits it), about = rows of the README's table, use = lines of its section};
-- names
-- and lines may have NAME and UPPER in them.
function library.package(d)
  local package = { real = d.real, check = d.check }

  local function named(s, v) return (string.gsub(string.gsub(s, "NAME", v.name), "UPPER", v.upper)) end

  function package.files(job, v, render)
    fill(job, v)
    v.project_files, v.project_use = {}, {}
    for i, row in ipairs(d.about) do v.project_files[i] = { name = named(row[1], v), about = named(row[2], v) } end
    for i, line in ipairs(d.use) do v.project_use[i] = named(line, v) end
    local out = {}
    for i, f in ipairs(d.files) do out[i] = { name = named(f[2], v), text = render(FOLDER .. f[1]), package = true,
      once = d.once and d.once[f[1]] } end
    out[#out + 1] = { name = "README.md", text = render "templates/projects/README.md" }
    return out
  end

  -- What stands in no folder yet is the scene's: headers, private ones with the sources, the self-test.
  function package.arrange(files)
    for _, f in ipairs(files) do
      local folder = string.find(f.name, "_test%.c$") and d.where.test or
        (string.find(f.name, "%.c$") or string.find(f.name, "_private%.h$")) and d.where.source or
        string.find(f.name, "%.h$") and d.where.header
      if folder and not f.package then f.name = folder .. "/" .. f.name end
    end
    return files
  end

  return package
end

return library
