-- written.lua -- `fit -o`: the scene's own text with the estimates as the values of its parameters.
--
--     written.check(job, free) -> what hinders it, or nil
--     written.text(job, unknowns, result) -> the text
-- A parameter's value is replaced where it stands as a number in param("NAME", number, ..); nothing else is touched.
-- SPDX-License-Identifier: GPL-3.0-or-later

local diag = require "generator.diag"

local written = {}

-- The places first, last of the number in param("NAME", number.., in the text; nil if it is not written so.
local function place(text, name)
  for _, quote in ipairs { "\"", "'" } do
    local from, to, number = string.find(text, "param%s*%(%s*" .. quote .. name .. quote ..
      "%s*,%s*([%w%.%+%-]+)%s*[,%)]")
    if from then
      local at = string.find(text, number, from + #name + 7, true)
      return tonumber(number) and to and at, at + #number - 1
    end
  end
  return nil
end

function written.check(job, free)
  if free.initial then return "-o: the initial state is no parameter of the scene (name its numbers by param)" end
  for _, p in ipairs(free.params) do
    if not place(job.text, p.name) then
      return "-o: the scene must write the value of " .. p.name .. " as a number, param(\"" .. p.name .. "\", 1.5)"
    end
  end
  return nil
end

function written.text(job, unknowns, result)
  local text = job.text
  for i, u in ipairs(unknowns) do
    local first, last = place(text, u.name)
    text = string.sub(text, 1, first - 1) .. diag.show(result.theta[i] / u.factor) .. string.sub(text, last + 1)
  end
  return text
end

return written
