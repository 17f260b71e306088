-- layout.lua -- what is called for, and nothing else: of all that the templates say, the parts that the asked functions
-- need, each in the file of its purpose.
--
--     layout.sort(name, real, fragments, asked, room, keeps) -> sorted
--     real: what the code calls its type; keeps: all names keep the prefix, and the type too
--     fragments: list of {header =, source =, room =, general = is it equal for every body?}, texts whose parts are
--       those of units.lua, in the order of the C
--     asked(function) -> bool: is it called for?  room(function, fragment's room) -> the file that it belongs to
--     sorted: { functions = list of {name =, room =, asked = bool, lines =} of all public ones, rooms = { [room] =
--       {header =, source =, calls = {[room] = true}, reads_private = bool} }, private = text | "", read = set of the
--       identifiers in all that is kept but NAME_init }
-- A function that is needed but not asked for is static.  What several files share is private.  Arithmetic that is
-- equal for every body is private, too.  Two exceptions: there is only one file, or only the motion's file needs it.
-- What is private is static inline if several files read it.
-- Names of what is static lose the scene's prefix, and NAME_real is `real`, unless the plain name has another use.
-- BELOW the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local columns = require "generator.emit.columns"
local plain = require "generator.emit.plain"
local units = require "generator.emit.units"

local layout = {}

-- All parts: of headers and of sources, each with its fragment's room and its heading.
local function parts(fragments)
  local declared, defined = {}, {}
  local function read(text, list, fragment)
    local heading
    for _, u in ipairs(units.parse(text or "")) do
      if u.kind == "heading" then
        heading = u
      else
        u.heading, u.room, u.general = heading, fragment.room, fragment.general
        list[#list + 1] = u
      end
    end
  end
  for _, f in ipairs(fragments) do
    read(f.header, declared, f)
    read(f.source, defined, f)
  end
  return declared, defined
end

-- By name what gives it: definitions, and the types and macros of headers.
local function givers(declared, defined)
  local by_name = {}
  local function put(u)
    for _, n in ipairs(u.names) do
      by_name[n] = by_name[n] or {}
      table.insert(by_name[n], u)
    end
  end
  for _, u in ipairs(declared) do if not u.prototype then put(u) end end
  for _, u in ipairs(defined) do put(u) end
  return by_name
end

-- Marks what `u` reaches for the room.  At a function that is asked for it goes no further: calls gets its name.
local function follow(u, room, by_name, public, calls)
  u.rooms = u.rooms or {}
  if u.rooms[room] then return end
  u.rooms[room] = true
  for _, n in ipairs(u.uses) do
    if public[n] and public[n].asked then
      calls[n] = true
    else
      local givers_of = by_name[n]
      for i = 1, givers_of and #givers_of or 0 do
        if givers_of[i] ~= u then follow(givers_of[i], room, by_name, public, calls) end
      end
    end
  end
end

-- Words of C and C++, and functions of their libraries.
local RESERVED = {}
for word in string.gmatch([[auto break case char const continue default do double else enum extern float for goto if
  inline int long register restrict return short signed sizeof static struct switch typedef union unsigned void
  volatile while bool class delete explicit export false friend mutable namespace new operator private protected
  public template this throw true try typename using virtual and or not xor asm catch fabs copysign sqrt cbrt floor
  frexp ldexp sin cos tan exp sinh cosh tanh log pow atan atan2 asin acos fma huge signbit index round trunc ceil
  fmod hypot gamma nan abs acosh asinh atanh div erf erfc exp2 expm1 fdim fmax fmin ilogb labs lgamma log10 log1p
  log2 logb lrint lround modf nearbyint nextafter remainder remquo rint scalbln scalbn tgamma j0 j1 jn y0 y1 yn drem
  finite significand abort abs atexit atof atoi atol bsearch calloc exit free getenv malloc qsort rand realloc srand
  strtod strtol system memchr memcmp memcpy memmove memset strcat strchr strcmp strcpy strlen remove rename clock
  time difftime raise signal printf puts read write open close link pause min max]], "%S+") do
  RESERVED[word] = true
end

-- The identifiers that the texts of each room use.
local function taken_names(kept)
  local taken = {}
  for _, u in ipairs(kept) do
    for r in pairs(u.rooms) do -- a set: any order
      taken[r] = taken[r] or {}
      for _, n in ipairs(u.uses) do taken[r][n] = true end
    end
  end
  return taken
end

-- The plain names of what is static, by the names with the prefix, which macros have in capitals.  One that several
-- rooms can see must be free in all of them.
local function plain_names(name, kept, public)
  local map, taken = {}, taken_names(kept)
  local starts = { [name .. "_"] = "^%l", [string.upper(name) .. "_"] = "^%u" }
  local function free(u, short)
    for r, used in pairs(taken) do -- a set: any order
      if used[short] and (u.rooms[r] or u.shown) then return false end
    end
    return not RESERVED[short]
  end
  for _, u in ipairs(kept) do
    for _, n in ipairs(u.names) do
      local own = not u.declared and not (public[n] and public[n].asked)
      for prefix, kind in pairs(starts) do -- a set: any order
        local short = string.sub(n, 1, #prefix) == prefix and string.sub(n, #prefix + 1)
        if own and short and string.find(short, kind) and free(u, short) then map[n] = short end
      end
    end
  end
  return map
end

-- The texts of the parts with their headings, blank lines between; change(u): the text of a part, if it is another;
-- shape(text) -> text, single (columns.part).
local function joined(list, change, shape)
  local out, n, heading, before = {}, 0, nil, true
  local function put(text, single)
    out[n + 1] = n > 0 and not (single and before) and "\n" or ""
    out[n + 2], out[n + 3] = text, "\n"
    n, before = n + 3, single
  end
  for _, u in ipairs(list) do
    if u.heading and u.heading ~= heading then put(shape and shape(u.heading.text) or u.heading.text, false) end
    heading = u.heading or heading
    local text = change and change(u) or u.text
    if shape then put(shape(text)) else put(text, false) end
  end
  return table.concat(out)
end

local function identifiers(kept, but)
  local set = {}
  for _, u in ipairs(kept) do
    for _, n in ipairs(u.names[1] ~= but and u.uses or {}) do set[n] = true end
  end
  return set
end

-- What several sources include must be inline, or each would warn of what it does not call.
local function private_text(u)
  if not u.shown or string.find(units.bare(u.text), "^%s*static inline") then return u.text end
  local text = string.gsub(u.text, "^static ", "static inline ", 1)
  if text == u.text then text = string.gsub(u.text, "\nstatic ", "\nstatic inline ", 1) end
  return string.find(units.bare(u.text), "^%s*static[^=]*%(") and text or u.text
end

-- The head of a function that is now static, as a declaration for those before it.
local function forward(u, prototypes)
  local p = prototypes[u.names[1]]
  local code = string.gsub(string.gsub(p.text, "^%s*/%*.-%*/%s*", ""), "^%s+", "")
  return "static " .. code
end

-- Nothing that is kept may call what is not there: a mistake of selection.lua's, not of the scene.  A local name or a
-- member may begin with the scene's: s_odd in a scene s.
local function complete(name, kept, by_name, public)
  local own, prefix = { [name .. "_model"] = true, [name .. "_real"] = true }, "^" .. name .. "_%l"
  for _, u in ipairs(kept) do
    for _, n in ipairs(u.uses) do
      local there = own[n] or by_name[n] or public[n] and public[n].asked
      if not there and string.find(n, prefix) and not string.find(u.text, "%f[%w_]" .. n .. " = ") and
        not string.find(u.text, "[>%.]" .. n .. "%f[^%w_]") then
        error(u.names[1] .. " needs " .. n .. ", which is not made")
      end
    end
  end
end

-- The public functions by name and in their order, and their prototypes.
local function publics(declared, defined, asked, room)
  local public, prototypes, functions = {}, {}, {}
  for _, u in ipairs(declared) do
    u.declared = true
    if u.prototype then
      local n = u.names[1]
      prototypes[n] = u
      local f = { name = n, asked = asked(n), room = room(n, u.room), of = u.room }
      public[n], functions[#functions + 1] = f, f
    end
  end
  for _, u in ipairs(defined) do -- what the program itself calls is not static, and no header declares it
    local n = u.names[1]
    if u.global and n and not public[n] then
      local f = { name = n, asked = true, room = room(n, u.room), of = u.room }
      public[n], functions[#functions + 1] = f, f
    end
  end
  return public, prototypes, functions
end

-- The rooms that the functions asked for open, in their order; marks in every part the rooms that reach it.
local function reached(functions, public, prototypes, by_name)
  local rooms, order = {}, {}
  local function open(r)
    if not rooms[r] then
      rooms[r] = { calls = {}, declared = {}, defined = {} }
      order[#order + 1] = r
    end
    return rooms[r]
  end
  for _, f in ipairs(functions) do
    if f.asked then
      for _, u in ipairs(by_name[f.name] or {}) do
        local calls = {}
        follow(u, f.room, by_name, public, calls)
        for other in pairs(calls) do open(f.room).calls[public[other].room] = true end -- a set: any order
      end
      local prototype = prototypes[f.name]
      if prototype then follow(prototype, f.room, by_name, public, {}) end
      open(f.room)
    end
  end
  return rooms, order
end

-- Puts the definitions that are reached into their rooms.  Returns all of them, and the private ones; shown: several
-- rooms see them.
local function place_defined(defined, rooms, order, public)
  local kept, private, readers = {}, {}, 0
  for _, u in ipairs(defined) do
    if u.rooms then
      kept[#kept + 1] = u
      local owner = u.names[1] and public[u.names[1]]
      local several = next(u.rooms, (next(u.rooms))) ~= nil
      local apart = u.general and #order > 1 and not u.rooms.motion
      if (several or apart) and not (owner and owner.asked) then
        private[#private + 1] = u
        for r in pairs(u.rooms) do -- a set: any order
          readers = readers + (rooms[r].reads_private and 0 or 1)
          rooms[r].reads_private = true
        end
      else
        table.insert(rooms[owner and owner.asked and owner.room or next(u.rooms)].defined, u)
      end
    end
  end
  for _, u in ipairs(private) do u.shown = readers > 1 end
  return kept, private
end

-- Puts the declarations into their rooms; macros under the heading of a function that is asked for stay with it.
local function place_declared(declared, rooms, public)
  local headed = {}
  for _, u in ipairs(declared) do
    local f = u.prototype and public[u.names[1]]
    if u.heading and f and f.asked then headed[u.heading] = f.room end
  end
  for _, u in ipairs(declared) do
    local f = u.prototype and public[u.names[1]]
    local macro = u.heading and headed[u.heading] and string.find(u.text, "#define", 1, true)
    if f and f.asked then
      table.insert(rooms[f.room].declared, u)
    elseif not f and (u.rooms or macro) then
      local own = rooms[u.room] and u.room or u.rooms and next(u.rooms) or headed[u.heading]
      table.insert(rooms[own].declared, u)
    end
  end
end

function layout.sort(name, real, fragments, asked, room, keeps)
  local declared, defined = parts(fragments)
  local by_name = givers(declared, defined)
  local public, prototypes, functions = publics(declared, defined, asked, room)
  local rooms, order = reached(functions, public, prototypes, by_name)
  local kept, private = place_defined(defined, rooms, order, public)
  place_declared(declared, rooms, public)
  complete(name, kept, by_name, public)
  local map = keeps and {} or plain_names(name, kept, public)
  if keeps then map.real = real == "real" and name .. "_real" or nil else map[name .. "_real"] = real end
  local function change(u)
    local owner = u.names[1] and public[u.names[1]]
    if not owner or owner.asked or u.static then return u.text end
    local comment, head = string.match(u.text, "^(/%*.-%*/\n)(.*)$")
    return (comment or "") .. "static " .. (head or u.text)
  end
  local function shape(text) -- names of the map begin so, but for `real`
    if map.real then text = string.gsub(text, "%f[%w_]real%f[^%w_]", map.real) end
    return columns.part(plain.renamed(plain.renamed(text, name .. "_", map), string.upper(name) .. "_", map))
  end
  for _, r in ipairs(order) do
    local own, heads = rooms[r], {}
    local used = {} -- by what stands before
    for _, u in ipairs(own.defined) do
      local owner = u.names[1] and public[u.names[1]]
      if owner and not owner.asked and used[owner.name] then heads[#heads + 1] = forward(u, prototypes) end
      for _, n in ipairs(u.uses) do used[n] = true end
    end
    own.plain, own.source, own.header = joined(own.defined, change), joined(own.defined, change, shape),
      joined(own.declared, nil, columns.part)
    if #heads > 0 then
      own.plain = table.concat(heads, "\n") .. "\n\n" .. own.plain
      for i, head in ipairs(heads) do heads[i] = shape(head) end
      own.source = table.concat(heads, "\n") .. "\n\n" .. own.source
    end
  end
  for _, f in ipairs(functions) do
    local u = (by_name[f.name] or {})[1]
    f.lines = u and #plain.lines(u.text) or 0
    f.uses = u and u.uses or {}
  end
  local function inside(u) return private_text { text = change(u), shown = u.shown } end
  return { functions = functions, rooms = rooms, order = order, read = identifiers(kept, name .. "_init"),
    plain_private = joined(private, inside),
    private = joined(private, inside, shape), real = keeps and name .. "_real" or real }
end

return layout
