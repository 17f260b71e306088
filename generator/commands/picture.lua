-- picture.lua -- an SVG text as the file that is asked for: as it is, or as PNG or PDF by rsvg-convert.
-- SPDX-License-Identifier: GPL-3.0-or-later

local options = require "generator.commands.options"

local picture = {}

-- PNG at twice the pixels; PDF without the date of the day, so that the same picture has the same bytes.
local how = { png = { "rsvg-convert", "-z", "2" }, pdf = { "env", "SOURCE_DATE_EPOCH=0", "rsvg-convert", "-f", "pdf" } }

-- The text as the bytes of a format, or nil and why.
local function converted(host, text, format)
  local dir, why = host.tempdir()
  local ok = dir
  if dir then ok, why = host.write_file(dir .. "/picture.svg", text) end
  if not ok then return nil, why end
  local command, out = { table.unpack(how[format]) }, dir .. "/picture." .. format
  for _, word in ipairs { "-o", out, dir .. "/picture.svg" } do command[#command + 1] = word end
  local status, said = host.execute(command)
  if status == 0 then return host.read(out) end
  local missing = not status or status == 127 or not said or said == ""
  return nil, not missing and said or "FILE." .. format ..
    " needs the program rsvg-convert (Debian package librsvg2-bin); FILE.svg needs nothing"
end

-- Writes the picture to FILE.svg, FILE.png, FILE.pdf or standard output; the exit status.
function picture.write(host, command, file, text)
  local format = file and string.match(file, "%.(%a+)$")
  if how[format] then
    local why
    text, why = converted(host, text, format)
    if not text then return options.failed(host, command, "-o " .. file .. ": " .. why) end
  end
  return options.write(host, command, file, text)
end

return picture
