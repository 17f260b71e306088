-- svg.lua -- a small writer of SVG: shapes, text, charts' frames.  It knows nothing of bodies.
--
--     local doc = svg.new(320, 240, { title = "what it is", about = "a sentence for those who cannot see it" })
--     doc:line(x1, y1, x2, y2, "axis")   doc:path(points, "curve a")   doc:math(x, y, "r_in", "label", "middle")
--     local text = svg.text(doc)
--
-- The same calls give the same bytes: numbers have at most two decimals, styles stand in the order of the palette and
-- only those that are used.  A style is a class with its CSS for light paper and, where it differs, for a dark screen;
-- print is always light.  The picture paints its own paper, so it is legible on any page.
-- SPDX-License-Identifier: GPL-3.0-or-later

local svg = {}

local doc = {}
doc.__index = doc

-- {class, CSS, CSS on a dark screen}; a document may bring more (options.palette).
local base = {
  { "paper", "fill:#fff", "fill:#15181d" },
  { "axis", "stroke:#555;stroke-width:1;fill:none", "stroke:#aab" },
  { "grid", "stroke:#ddd;stroke-width:.6;fill:none", "stroke:#333a44" },
  { "frame", "stroke:#555;stroke-width:1;fill:none", "stroke:#aab" },
  { "arrow", "fill:#555", "fill:#aab" },
  { "tick", "font:11px sans-serif;fill:#444", "fill:#c3c8d0" },
  { "label", "font:13px sans-serif;fill:#222", "fill:#dde1e7" },
  { "small", "font:11px sans-serif;fill:#444", "fill:#c3c8d0" },
  { "title", "font:bold 14px sans-serif;fill:#222", "fill:#e6e9ee" },
  { "math", "font:italic 15px serif;fill:#222", "fill:#e6e9ee" },
  { "curve", "fill:none;stroke:#222;stroke-width:1.6;stroke-linejoin:round;stroke-linecap:round", "stroke:#e6e9ee" },
  { "a", "stroke:#1f6fb2", "stroke:#6db3f2" },
  { "b", "stroke:#c2571a", "stroke:#f0975a" },
  { "c", "stroke:#3b8a3e", "stroke:#7cc47f" },
  { "d", "stroke:#8a4fa3", "stroke:#c493dc" },
  { "e", "stroke:#8a6d00", "stroke:#d9bb4a" },
  { "dashed", "stroke-dasharray:5 3" },
  { "dot", "fill:#222", "fill:#e6e9ee" },
  { "dot-a", "fill:#1f6fb2", "fill:#6db3f2" },
  { "dot-b", "fill:#c2571a", "fill:#f0975a" },
  { "dot-c", "fill:#3b8a3e", "fill:#7cc47f" },
  { "dot-d", "fill:#8a4fa3", "fill:#c493dc" },
  { "area-a", "fill:#cfe2f3", "fill:#1d3a55" },
  { "area-b", "fill:#f8dcc8", "fill:#57321a" },
  { "area-c", "fill:#d5ead3", "fill:#234126" },
  { "area-d", "fill:#e8d9ef", "fill:#402a4b" },
  { "area-n", "fill:#e9e9e9", "fill:#2a2f37" },
}

-- At most two decimals, no trailing zeros, no minus zero.
function svg.number(x)
  if x ~= x or x == math.huge or x == -math.huge then error("svg: a coordinate is not finite", 2) end
  local s = string.format("%.2f", x)
  s = string.gsub(string.gsub(s, "0+$", ""), "%.$", "")
  s = string.gsub(s, "^(%-?)0%.", "%1.")
  return (s == "-0" or s == "-" or s == "") and "0" or s
end
local num = svg.number

local entity = { ["&"] = "&amp;", ["<"] = "&lt;", [">"] = "&gt;", ['"'] = "&quot;" }
function svg.escape(s) return (string.gsub(s, '[&<>"]', entity)) end

-- "r_in" and "10^{-3}" as text with lowered and raised parts; a single letter or digit needs no braces, a word after
-- _ neither.  Between U+27E8 and U+27E9 stands what is in italics whatever the class: a quantity before its unit.
-- A blank at the end of a raised part is kept by xml:space alone: some readers trim U+00A0, too.
local function rich(s)
  local out, at = {}, 1
  while at <= #s do
    local from, to, mark, part = string.find(s, "([_^]){([^}]*)}", at)
    local f2, t2, m2, p2 = string.find(s, "([_^])(%w+)", at)
    if f2 and (not from or f2 < from) then from, to, mark, part = f2, t2, m2, p2 end
    out[#out + 1] = svg.escape(string.sub(s, at, (from or #s + 1) - 1))
    if not from then break end
    local shift = mark == "_" and 4 or -6
    out[#out + 1] = '<tspan dy="' .. shift .. '" font-size="75%">' .. svg.escape(part) .. "</tspan>"
    at = to + 1
    if at <= #s then -- the line goes back with the next character
      local next_one = string.match(s, "^ ?" .. utf8.charpattern, at)
      local keep = string.sub(next_one, 1, 1) == " " and ' xml:space="preserve"' or ""
      out[#out + 1] = '<tspan dy="' .. -shift .. '"' .. keep .. ">" .. svg.escape(next_one) .. "</tspan>"
      at = at + #next_one
    end
  end
  return (string.gsub(string.gsub(table.concat(out), "⟨", '<tspan font-style="italic">'), "⟩", "</tspan>"))
end

-- options: {title =, about =, palette = more styles}
function svg.new(width, height, options)
  options = options or {}
  local d = setmetatable({ width = width, height = height, title = options.title, about = options.about, parts = {},
    used = {}, palette = {}, depth = 0 }, doc)
  for _, p in ipairs(base) do d.palette[#d.palette + 1] = p end
  for _, p in ipairs(options.palette or {}) do d.palette[#d.palette + 1] = p end
  d:rect(0, 0, width, height, "paper")
  return d
end

function doc:put(s) self.parts[#self.parts + 1] = s end

-- ' class="a b" style="..."', and the classes are remembered.
function doc:attributes(class, style)
  for word in string.gmatch(class or "", "%S+") do self.used[word] = true end
  return (class and class ~= "" and ' class="' .. class .. '"' or "")
    .. (style and ' style="' .. svg.escape(style) .. '"' or "")
end

local function coordinates(points)
  local list = {}
  for i, p in ipairs(points) do list[i] = num(p[1]) .. "," .. num(p[2]) end
  return table.concat(list, " ")
end

-- Path data through points {{x, y}, ...}; several of them may be joined with .. to one path.
function svg.through(points, closed) return "M" .. coordinates(points) .. (closed and "Z" or "") end

-- what: path data, or points that are joined by lines.
function doc:path(what, class, style)
  local d = type(what) == "table" and svg.through(what) or what
  self:put("<path" .. self:attributes(class, style) .. ' d="' .. d .. '"/>')
end

function doc:polygon(points, class, style)
  self:put("<polygon" .. self:attributes(class, style) .. ' points="' .. coordinates(points) .. '"/>')
end

function doc:line(x1, y1, x2, y2, class, style)
  self:put("<line" .. self:attributes(class, style) .. ' x1="' .. num(x1) .. '" y1="' .. num(y1) .. '" x2="'
    .. num(x2) .. '" y2="' .. num(y2) .. '"/>')
end

function doc:rect(x, y, width, height, class, style)
  self:put("<rect" .. self:attributes(class, style) .. ' x="' .. num(x) .. '" y="' .. num(y) .. '" width="'
    .. num(width) .. '" height="' .. num(height) .. '"/>')
end

function doc:circle(x, y, r, class, style)
  self:put("<circle" .. self:attributes(class, style) .. ' cx="' .. num(x) .. '" cy="' .. num(y) .. '" r="' .. num(r)
    .. '"/>')
end

local function text(self, x, y, inner, class, anchor, turn)
  local at = ' x="' .. num(x) .. '" y="' .. num(y) .. '"'
  if anchor and anchor ~= "start" then at = at .. ' text-anchor="' .. anchor .. '"' end
  if turn then at = at .. ' transform="rotate(' .. num(turn) .. " " .. num(x) .. " " .. num(y) .. ')"' end
  self:put("<text" .. self:attributes(class) .. at .. ">" .. inner .. "</text>")
end

-- s as it stands; anchor: start (default), middle, end; turn: degrees clockwise about (x, y).
function doc:text(x, y, s, class, anchor, turn) text(self, x, y, svg.escape(s), class or "label", anchor, turn) end

-- s with subscripts and superscripts, "r_in", "h^2", in italics unless the class says otherwise.
function doc:math(x, y, s, class, anchor, turn) text(self, x, y, rich(s), class or "math", anchor, turn) end

-- Everything fn(doc) draws is one group: doc:group("class", function(g) ... end).
function doc:group(class, fn, transform)
  local moved = transform and ' transform="' .. svg.escape(transform) .. '"' or ""
  self:put("<g" .. self:attributes(class) .. moved .. ">")
  fn(self)
  self:put("</g>")
end

-- A line from (x1, y1) to (x2, y2) with a head at its end.
function doc:arrow(x1, y1, x2, y2, class, head)
  self:line(x1, y1, x2, y2, class or "axis")
  local length = math.sqrt((x2 - x1) ^ 2 + (y2 - y1) ^ 2)
  if length == 0 then return end
  local ux, uy, s = (x2 - x1) / length, (y2 - y1) / length, head or 6
  self:polygon({ { x2 + ux, y2 + uy }, { x2 - s * ux - 0.4 * s * uy, y2 - s * uy + 0.4 * s * ux },
    { x2 - s * ux + 0.4 * s * uy, y2 - s * uy - 0.4 * s * ux } }, "arrow")
end

function svg.text(d)
  local size = num(d.width) .. '" height="' .. num(d.height)
  local out = { '<svg xmlns="http://www.w3.org/2000/svg" role="img" width="' .. size .. '" viewBox="0 0 '
    .. num(d.width) .. " " .. num(d.height) .. '">' }
  if d.title then out[#out + 1] = "<title>" .. svg.escape(d.title) .. "</title>" end
  if d.about then out[#out + 1] = "<desc>" .. svg.escape(d.about) .. "</desc>" end
  local light, dark = {}, {}
  for _, p in ipairs(d.palette) do
    if d.used[p[1]] then
      light[#light + 1] = "." .. p[1] .. "{" .. p[2] .. "}"
      if p[3] then dark[#dark + 1] = "." .. p[1] .. "{" .. p[3] .. "}" end
    end
  end
  out[#out + 1] = "<style>" .. table.concat(light)
  out[#out + 1] = "@media screen and (prefers-color-scheme:dark){" .. table.concat(dark) .. "}</style>"
  for _, s in ipairs(d.parts) do out[#out + 1] = s end
  out[#out + 1] = "</svg>"
  return table.concat(out, "\n") .. "\n"
end

-- ---- charts ----

-- Round values in [lo, hi], about `count` of them: {{value, text}, ...}.  A step is 1, 2 or 5 times a power of ten, and
-- a value is a whole number of steps, so 0.3 is never 0.30000000000000004.
function svg.ticks(lo, hi, count)
  local raw = (hi - lo) / (count or 6)
  local power = math.floor(math.log(raw, 10) + 1e-9)
  local list, m = {}, raw / 10.0 ^ power
  local unit = m <= 1.0000001 and 1 or m <= 2.0000001 and 2 or m <= 5.0000001 and 5 or 10
  local function value(i) return power >= 0 and i * unit * 10.0 ^ power or i * unit / 10.0 ^ -power end
  local slack = 1e-9 * (hi - lo) / value(1)
  for i = math.ceil(lo / value(1) - slack), math.floor(hi / value(1) + slack) do
    list[#list + 1] = { value(i), (string.gsub(string.format("%.10g", value(i)), "^%-", "−")) }
  end
  return list
end

-- Powers of ten in [lo, hi]; where these are fewer than two also 2 and 5 times them.
function svg.log_ticks(lo, hi)
  local from, to = math.log(lo, 10), math.log(hi, 10)
  local steps = to - from < 2 and { 1, 2, 5 } or { 1 }
  local every = math.max(1, math.ceil((to - from) / 9))
  local list = {}
  for k = math.floor(from), math.ceil(to) do
    for _, m in ipairs(steps) do
      local v = k >= 0 and m * 10.0 ^ k or m / 10.0 ^ -k
      local inside = v >= lo * (1 - 1e-9) and v <= hi * (1 + 1e-9)
      if inside and k % every == 0 then
        local plain = math.abs(k) <= 3 or #steps > 1
        list[#list + 1] = { v, plain and string.format("%.10g", v)
          or "10^{" .. (string.gsub(string.format("%d", k), "^%-", "−")) .. "}" }
      end
    end
  end
  return list
end

local function ticks_of(range, log, pixels)
  if log then return svg.log_ticks(range[1], range[2]) end
  local count = math.max(2, pixels / 60)
  local list = svg.ticks(range[1], range[2], count)
  return #list > 1 and list or svg.ticks(range[1], range[2], 2 * count)
end

-- How far left of the frame the y axis has its label: beyond its ticks, of which a letter is 6.2 pixels wide.
function svg.label_room(range, log, pixels)
  local most = 0
  for _, t in ipairs(ticks_of(range, log, pixels)) do
    if not string.find(t[2], "{", 1, true) then most = math.max(most, utf8.len(t[2])) end
  end
  return math.max(42, 6.2 * most + 8)
end

-- Draws the frame of a chart and returns its scale {x = function, y = function, at = function(x, y) -> px, py}.
-- f: {x0, y0, x1, y1: the box in the picture, y0 above; xrange = {lo, hi}, yrange = {lo, hi}, xlabel =, ylabel =
-- (subscripts as in doc:math), xlog =, ylog = true for a logarithmic axis, grid = false to leave it out}
function svg.frame(d, f)
  local function map(range, log, from, to)
    local lo, hi = range[1], range[2]
    if log then lo, hi = math.log(lo), math.log(hi) end
    return function(v) return from + ((log and math.log(v) or v) - lo) / (hi - lo) * (to - from) end
  end
  local scale = { x = map(f.xrange, f.xlog, f.x0, f.x1), y = map(f.yrange, f.ylog, f.y1, f.y0) }
  function scale.at(x, y) return scale.x(x), scale.y(y) end
  for _, t in ipairs(ticks_of(f.xrange, f.xlog, f.x1 - f.x0)) do
    local x = scale.x(t[1])
    if f.grid ~= false then d:line(x, f.y0, x, f.y1, "grid") end
    d:line(x, f.y1, x, f.y1 - 4, "axis")
    d:math(x, f.y1 + 15, t[2], "tick", "middle")
  end
  for _, t in ipairs(ticks_of(f.yrange, f.ylog, f.y1 - f.y0)) do
    local y = scale.y(t[1])
    if f.grid ~= false then d:line(f.x0, y, f.x1, y, "grid") end
    d:line(f.x0, y, f.x0 + 4, y, "axis")
    d:math(f.x0 - 6, y + 4, t[2], "tick", "end")
  end
  d:rect(f.x0, f.y0, f.x1 - f.x0, f.y1 - f.y0, "frame")
  if f.xlabel then d:math((f.x0 + f.x1) / 2, f.y1 + 33, f.xlabel, "label", "middle") end
  local room = svg.label_room(f.yrange, f.ylog, f.y1 - f.y0)
  if f.ylabel then d:math(f.x0 - room, (f.y0 + f.y1) / 2, f.ylabel, "label", "middle", -90) end
  return scale
end

return svg
