-- page.lua -- docs/hard.md: the catalogue of hard cases with what was measured, and its map.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     page(files, "docs/hard.md", "docs/hard.svg")      files as map.lua has them
--
-- The page's head and foot, written by hand, stand in tests/hard/{head,foot}.md.

local map = require "tests.hard.map"

local function slurp(path)
  local file = assert(io.open(path, "rb"))
  local text = file:read "a"
  file:close()
  return text
end

local function write(path, text)
  local file = assert(io.open(path .. ".new", "wb"))
  assert(file:write(text))
  assert(file:close())
  assert(os.rename(path .. ".new", path))
end

-- Two digits; what is lost is said.
local function short(x)
  if x == nil then return "" end
  if x == math.huge then return "no number" end
  if x == 0 then return "0" end
  if x >= 1e4 or x < 1e-3 then
    return (string.gsub(string.gsub(string.format("%.1e", x), "e%+0*", "e"), "e%-0*", "e-"))
  end
  return string.format(x < 9.95 and "%.2g" or "%.0f", x)
end

local function ratio(v, real) return v.worst[real] and short(v.worst[real].ratio) or "" end

return function(files, path, picture)
  local out, count, quick, worst = {}, 0, 0, { double = { ratio = 0 }, float = { ratio = 0 } }
  local function put(...) out[#out + 1] = string.format(...) end
  for _, file in ipairs(files) do
    put("## %s\n", file.title)
    put("%s\n", file.about)
    put("| case | double | float | library | who is worst: error, bound | naive |\n|---|---|---|---|---|---|")
    for _, case in ipairs(file.cases) do
      local v = case.verdict
      local w, unit = v.worst.all, v.worst.double or v.worst.all
      count, quick = count + 1, quick + (case.fast and 1 or 0)
      for real, best in pairs(worst) do -- the order does not matter: each has its own
        local this = v.worst[real]
        if this and this.ratio >= best.ratio then best.ratio, best.name = this.ratio, case.name end
      end
      put("| %s%s | %s | %s | %s | %s, %s: %s, %s | %s |", case.name, case.fast and "" or " (long)", ratio(v, "double"),
        ratio(v, "float"), ratio(v, "long double"), w.who, w.real, short(w.error), short(w.bound),
        short(case.result.naive / unit.bound))
    end
    put("")
    for _, case in ipairs(file.cases) do
      put("- **%s**: %s. *Naive*: %s. *Oracle*: %s. *Bound*: %s.%s", case.name, case.why, case.naive, case.oracle,
        case.bound, case.only and string.format(" Only in %s: %s.", case.only, case.because) or "")
    end
    put("")
  end
  local summary = string.format("**%d cases**, %d of them in `make check-all`. The worst error of all is %s of its " ..
    "bound " ..
    "in double (%s) and %s in float (%s).", count, quick, short(worst.double.ratio), worst.double.name,
    short(worst.float.ratio), worst.float.name)
  local head = string.gsub(slurp "tests/hard/head.md", "@SUMMARY@", function() return summary end)
  write(path, head .. "\n" .. table.concat(out, "\n") .. "\n" .. slurp "tests/hard/foot.md")
  write(picture, map.svg(files))
end
