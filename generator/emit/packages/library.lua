-- library.lua -- what the packages of other ecosystems share: the emitted files where such a library has them, and the
-- README with a section of its own.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local number = require "generator.emit.number"

local readme = require "generator.emit.readme"
local template = require "generator.emit.template"

-- The templates of all such packages: their examples have the same values.
local GROUP = template.group("projects/cmake.txt", "projects/arduino.properties", "projects/arduino_keywords.txt",
  "projects/arduino.ino", "projects/platformio.json", "projects/platformio.ini", "projects/motion.c",
  "projects/zephyr_module.yml", "projects/zephyr_kconfig.txt", "projects/zephyr_cmake.txt",
  "projects/zephyr_sample_cmake.txt", "projects/zephyr_sample.yaml", "projects/zephyr_prj.conf",
  "projects/zephyr_main.c")

local library = {}

-- The example prints 21 rows over the horizon, or over 4096 steps of it.
local function values_of(job, made)
  local m, columns, enums = job.model, {}, {}
  for i, s in ipairs(job.states) do columns[i], enums[i] = s.name, made.base.upper .. "_" .. string.upper(s.name) end
  local steps = R.toint(R.floor(m:number(m.horizon) / m:number(m.step)))
  return { columns = table.concat(columns, ","), state_names = enums, example_rows = "21",
    example_every = string.format("%d", math.max(1, math.min(steps, 4096) // 20)),
    million = number.text(R.new(1000000), job.real), sources = made.names.sources, headers = made.names.public,
    own_libm = made.ctx.own, dollar = "$" } -- for CMake's own ${}
end

-- A package from a description {where = {header =, source =, test =} folders, files = {{template, name}, ..},
-- once = {[template] = true} (the user edits it), about = rows of the README's table, use = lines of its section};
-- names and lines may have NAME and UPPER in them.
function library.package(d)
  local package = { real = d.real, check = d.check }

  function package.files(job, made)
    local base, about, out = made.base, { files = {}, use = {} }, {}
    local function named(s) return (string.gsub(string.gsub(s, "NAME", base.name), "UPPER", base.upper)) end
    for i, row in ipairs(d.about) do about.files[i] = { name = named(row[1]), about = named(row[2]) } end
    for i, line in ipairs(d.use) do about.use[i] = named(line) end
    local render = GROUP(job.templates, base, values_of(job, made))
    for i, f in ipairs(d.files) do
      out[i] = { name = named(f[2]), text = render("projects/" .. f[1]), package = true,
        once = d.once and d.once[f[1]] }
    end
    out[#out + 1] = { name = "README.md", text = readme.render(job, made, about) }
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
