-- zip.lua -- a zip archive of files that are only stored: strings in, a string out.
--
-- PKWARE, APPNOTE.TXT 6.3.3: local headers (4.3.7), central directory (4.3.12), its end (4.3.16).  Every file has the
-- earliest date that the format knows, 1 January 1980, and no attributes of a system: same input, same bytes.
-- SPDX-License-Identifier: GPL-3.0-or-later

local zip = {}

-- CRC-32 (IEEE 802.3, polynomial 0xEDB88320 reflected), a byte at a time.
local crc_of = {}
for n = 0, 255 do
  local c = n
  for _ = 1, 8 do c = c % 2 == 1 and (c >> 1) ~ 0xEDB88320 or c >> 1 end
  crc_of[n] = c
end

function zip.crc32(text)
  local c = 0xFFFFFFFF
  for i = 1, #text do c = (c >> 8) ~ crc_of[(c ~ string.byte(text, i)) & 0xFF] end
  return c ~ 0xFFFFFFFF
end

local version, stored, time, date = 20, 0, 0, 0x0021 -- date: year - 1980 << 9 | month << 5 | day
local utf8_names = 0x0800                             -- general purpose bit 11

-- What local header and central directory say of a file in the same words.
local function entry(f)
  return string.pack("<I2I2I2I2I2I4I4I4I2I2", version, utf8_names, stored, time, date, zip.crc32(f.text), #f.text,
    #f.text, #f.name, 0)
end

-- files: a list of {name = path with slashes, text =}, below 4 GiB in all.
function zip.archive(files)
  local out, directory, at = {}, {}, 0
  for i, f in ipairs(files) do
    local head = entry(f)
    out[i] = "PK\3\4" .. head .. f.name .. f.text
    directory[i] = "PK\1\2" .. string.pack("<I2", version) .. head ..
      string.pack("<I2I2I2I4I4", 0, 0, 0, 0, at) .. f.name
    at = at + #out[i]
  end
  local index = table.concat(directory)
  out[#out + 1] = index
  out[#out + 1] = "PK\5\6" .. string.pack("<I2I2I2I2I4I4I2", 0, 0, #files, #files, #index, at, 0)
  return table.concat(out)
end

return zip
