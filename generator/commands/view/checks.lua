-- checks.lua -- what NAME_init refuses, in words: the numbered list that the emitted header states.
-- SPDX-License-Identifier: GPL-3.0-or-later

local checks = {}

-- The texts of the checks by their numbers, read from the contract of the set-up in the header.
function checks.texts(unit)
  local list, header = {}, ""
  for _, f in ipairs(unit.files) do
    if f.name == unit.model.name .. ".h" then header = f.text end
  end
  local block = string.match(header, "check that failed.-%*/") or ""
  for line in string.gmatch(block, "[^\n]+") do
    local number, said = string.match(line, "^ %*   ?(%d+)  (.*)")
    if number then
      list[tonumber(number)] = said
    elseif #list > 0 then
      local more = string.match(line, "^ %*%s+(.-)%s*%*?/?$")
      if more and more ~= "" then list[#list] = list[#list] .. " " .. more end
    end
  end
  return list
end

return checks
