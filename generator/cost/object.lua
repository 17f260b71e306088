-- object.lua -- what an ELF file says of itself: its sections' bytes and its symbols.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     local o = object.read(bytes)      bytes of a file, 32 or 64 bits, little-endian; nil if it is none
--     o.flash, o.ram                    code, constants and what variables start from; variables (NOBITS included)
--     o.symbols[name]                   {value = address, bytes = size}; of several with one name the first
-- By the ELF specification (TIS 1.2), figures 1-3, 1-8, 1-15 and their 64 bit forms.  flash + NOBITS is what size(1)
-- calls dec.

local object = {}

local SYMTAB, NOBITS = 2, 8
local WRITE, ALLOC = 1, 2

local function name_at(bytes, at) return (string.match(bytes, "^[^\0]*", at)) end

-- Some of the fields that string.unpack finds: chosen by their numbers.
local function fields(format, bytes, at, ...)
  local all, some = { string.unpack(format, bytes, at) }, {}
  for i, n in ipairs { ... } do some[i] = all[n] end
  return table.unpack(some)
end

-- The section headers: {type =, flags =, at = (offset, from 1), bytes =, link =, each =}.
local function sections(bytes, wide)
  local header = wide and "<I8 I4 I2 I2 I2 I2 I2" or "<I4 I4 I2 I2 I2 I2 I2"
  local shoff, size, count = fields(header, bytes, wide and 41 or 33, 1, 6, 7)
  local list = {}
  local format = wide and "<I4 I4 I8 I8 I8 I8 I4 I4 I8 I8" or "<I4 I4 I4 I4 I4 I4 I4 I4 I4 I4"
  for i = 0, count - 1 do
    local kind, flags, offset, length, link, each = fields(format, bytes, shoff + i * size + 1, 2, 3, 5, 6, 7, 10)
    list[i] = { type = kind, flags = flags, at = offset + 1, bytes = length, link = link, each = each }
  end
  return list, count
end

-- table_of: the section of symbols; names: the one of their names.  Section 0 is that of symbols defined elsewhere.
local function symbols(bytes, wide, table_of, names)
  local found = {}
  for at = table_of.at, table_of.at + table_of.bytes - 1, table_of.each do
    local name, value, size, section
    if wide then
      name, section, value, size = fields("<I4 B B I2 I8 I8", bytes, at, 1, 4, 5, 6)
    else
      name, value, size, section = fields("<I4 I4 I4 B B I2", bytes, at, 1, 2, 3, 6)
    end
    local text = name_at(bytes, names.at + name)
    if section ~= 0 and text ~= "" and not found[text] then found[text] = { value = value, bytes = size } end
  end
  return found
end

function object.read(bytes)
  local class, order = string.match(bytes, "^\127ELF([\1\2])([\1\2])")
  if not class or order ~= "\1" then return nil end
  local wide = class == "\2"
  local list, count = sections(bytes, wide)
  local o = { flash = 0, ram = 0, symbols = {} }
  for i = 0, count - 1 do
    local s = list[i]
    if s.flags & ALLOC ~= 0 then
      if s.type ~= NOBITS then o.flash = o.flash + s.bytes end
      if s.flags & WRITE ~= 0 then o.ram = o.ram + s.bytes end
    end
    if s.type == SYMTAB then o.symbols = symbols(bytes, wide, s, list[s.link]) end
  end
  return o
end

return object
