#!/usr/bin/env lua5.4
-- glb.t - polhode view --format glb: the structure that the glTF 2.0 specification asks for, and what the file shows.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The file is read here by the specification alone.  Shapes are compared with textbook volumes, by the divergence
-- theorem on the triangles; motions with the printed rows of `polhode run`.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local json = require "tests.json"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"

local function run(arguments)
  return program.output(string.format("/usr/bin/env PATH=%s/none %s %s", dir, binary, arguments))
end

-- The JSON of a file and a function that reads an accessor: a list of rows.  Everything is checked on the way.
local function opened(name, more)
  local status, text, err = run("view " .. name .. " --format glb -o -" .. (more or ""))
  tap.ok(status == 0 and err == "", name .. ": a file, without any program", err)
  local magic, version, length = string.unpack("<c4I4I4", text)
  tap.ok(magic == "glTF" and version == 2 and length == #text, name .. ": a header with the length")
  local size, kind, at = string.unpack("<I4c4", text, 13)
  local doc = json.read(text:sub(at, at + size - 1))
  tap.ok(kind == "JSON" and size % 4 == 0, name .. ": a chunk of JSON")
  local bytes, second, start = string.unpack("<I4c4", text, at + size)
  tap.ok(second == "BIN\0" and bytes % 4 == 0 and start + bytes - 1 == #text, name .. ": a chunk of numbers, no more")
  local buffer = doc.buffers[1].byteLength
  tap.ok(doc.asset.version == "2.0" and #doc.buffers == 1 and buffer <= bytes and bytes - buffer < 4,
    name .. ": which is as long as it says")
  local widths, sound = { SCALAR = 1, VEC3 = 3, VEC4 = 4 }, true
  local function read(n)
    local a = doc.accessors[n + 1]
    local view, width, rows = doc.bufferViews[a.bufferView + 1], widths[a.type], {}
    sound = sound and a.componentType == 5126 and view.byteOffset % 4 == 0 and
      view.byteLength == 4 * width * a.count and view.byteOffset + view.byteLength <= buffer
    for i = 1, a.count do
      rows[i] = { string.unpack("<" .. string.rep("f", width), text, start + view.byteOffset + 4 * width * (i - 1)) }
      rows[i][width + 1] = nil
      for k = 1, width do sound = sound and rows[i][k] - rows[i][k] == 0 end
    end
    for k = 1, a.min and width or 0 do
      local low, high = math.huge, -math.huge
      for _, row in ipairs(rows) do low, high = math.min(low, row[k]), math.max(high, row[k]) end
      sound = sound and low == a.min[k] and high == a.max[k]
    end
    return rows, a.min ~= nil
  end
  for n = 0, #doc.accessors - 1 do read(n) end
  tap.ok(sound, name .. ": accessors lie in their views, these in the buffer; bounds are the numbers' own")
  return doc, read, text
end

-- Volume of the triangles of the body, and whether each normal is one of a face that looks outwards.
local function volume(doc, read)
  local sum, fine = 0.0, true
  for _, p in ipairs(doc.meshes[1].primitives) do
    if p.mode == 4 and p.material == 0 then
      local x, bounded = read(p.attributes.POSITION)
      local n = read(p.attributes.NORMAL)
      fine = fine and bounded and #x == #n and #x % 3 == 0
      for i = 1, #x, 3 do
        local a, b, c = x[i], x[i + 1], x[i + 2]
        local cross = { b[2] * c[3] - b[3] * c[2], b[3] * c[1] - b[1] * c[3], b[1] * c[2] - b[2] * c[1] }
        sum = sum + (a[1] * cross[1] + a[2] * cross[2] + a[3] * cross[3]) / 6
        local m = n[i]
        fine = fine and math.abs(m[1] ^ 2 + m[2] ^ 2 + m[3] ^ 2 - 1) < 1e-6 and
          a[1] * m[1] + a[2] * m[2] + a[3] * m[3] > -1e-9
      end
    end
  end
  return sum, fine
end

local rounding = "corners are floats: 6e-8 of each"

-- The rows of an animation: times, and by path.
local function animation(doc, read)
  local out, a = {}, doc.animations[1]
  for _, c in ipairs(a.channels) do
    local s = a.samplers[c.sampler + 1]
    out[c.target.path] = read(s.output)
    local bounded
    out.times, bounded = read(s.input)
    tap.ok(c.target.node == 1 and s.interpolation == "LINEAR" and bounded and #out.times == #out[c.target.path],
      doc.nodes[2].name .. ": a channel of " .. c.target.path)
  end
  return out
end

-- ---- what each file has, against run ----

for _, case in ipairs { { "bodies/brick.lua" }, { "bodies/thrown_book.lua", place = { "rx", "ry", "rz" } },
  { "bodies/turntable_ball.lua", place = { "com_x", "com_y", "com_z" }, columns = "t,q,com" } } do
  local name = case[1]
  local doc, read, text = opened(name)
  local _, again = run("view " .. name .. " --format glb -o -")
  tap.ok(text == again, name .. ": the same bytes twice")
  local a = animation(doc, read)
  local ascending, near, q = true, true, a.rotation
  for i = 2, #a.times do
    ascending = ascending and a.times[i][1] > a.times[i - 1][1]
    near = near and q[i][1] * q[i - 1][1] + q[i][2] * q[i - 1][2] + q[i][3] * q[i - 1][3] + q[i][4] * q[i - 1][4] > 0
  end
  tap.ok(ascending and a.times[1][1] == 0 and #a.times > 600, name .. ": times ascend from 0")
  tap.ok(near, name .. ": neighbours have one sign, for the short way round")
  tap.is(a.translation ~= nil, case.place ~= nil, name .. ": it moves if the body does")
  local worst, off, size = 0.0, 0.0, 0.0
  local last, places = a.times[#a.times][1], #a.times - 1
  for _, i in ipairs { 0, places // 3, places } do -- row i is at the time i/n of the whole
    local _, out = run(string.format("run %s --at %.17g%s", name, last * (i / places), case.columns and
      " --columns " .. case.columns or ""))
    local head, numbers = out:match "^([^\n]+)\n([^\n]+)"
    local names, got, k = {}, {}, 0
    for column in head:gmatch "[^,]+" do names[#names + 1] = column end
    for number in numbers:gmatch "[^,]+" do
      k = k + 1
      got[names[k]] = tonumber(number)
    end
    local row, dot = q[i + 1], 0.0
    for n, column in ipairs { "qx", "qy", "qz", "qw" } do dot = dot + row[n] * got[column] end
    worst = math.max(worst, 1 - math.abs(dot))
    for n, column in ipairs(case.place or {}) do
      off = math.max(off, math.abs(a.translation[i + 1][n] - got[column]))
      size = math.max(size, math.abs(got[column]))
    end
  end
  tap.near(worst, 0, 0, 1e-6, name .. ": attitudes of run, the scalar last", "floats, whose rounding is 6e-8 of each")
  tap.ok(off <= 1e-6 * size, name .. ": and its places", off .. " of " .. size)
  local root, body = doc.nodes[1], doc.nodes[2]
  local x, _, _, w = table.unpack(root.rotation)
  -- turned by -90 degrees about x, z becomes y: (0, 0, 1) -> (0, 1, 0)
  tap.ok(math.abs(-2 * x * w - 1) < 1e-7 and root.children[1] == 1 and body.mesh == 0 and doc.scenes[1].nodes[1] == 0,
    name .. ": z is up")
end

-- ---- shapes ----

do
  local doc, read = opened "bodies/brick.lua"
  local v, fine = volume(doc, read)
  tap.near(v, 0.2 * 0.1 * 0.05, 1e-6, 0, "the brick has its volume", rounding)
  tap.ok(fine, "and normals that look outwards")
  -- bodies/rattleback.lua touches the plane with an ellipsoid of the half axes 0.2, 0.03 and 0.02
  doc, read = opened "bodies/rattleback.lua"
  v, fine = volume(doc, read)
  -- 40 segments a turn: the polyhedron is smaller by 1 % at most, 2/3 (pi/40)^2 about
  tap.near(v, 4 / 3 * math.pi * 0.2 * 0.03 * 0.02, 0.012, 0, "a body without a shape is its contact surface", "facets")
  tap.ok(fine, "which looks outwards, too")
  program.write(dir .. "/tensor.lua", [[return scene { name = "t", body = tensor { mass = 2, xx = 5, yy = 8, zz = 9,
    xy = 1 }, initial = { omega = { 1, 2, 3 } } }]])
  doc, read = opened(dir .. "/tensor.lua")
  v = volume(doc, read)
  -- of an ellipsoid a^2 = 5/2 (I2 + I3 - I1)/m; principal moments 13/2 -+ sqrt(13)/2 and 9
  local I = { (13 - math.sqrt(13)) / 2, (13 + math.sqrt(13)) / 2, 9 }
  local product = 1.0
  for k = 1, 3 do product = product * math.sqrt(5 / 2 * (I[1] + I[2] + I[3] - 2 * I[k]) / 2) end
  tap.near(v, 4 / 3 * math.pi * product, 0.012, 0, "a tensor is the ellipsoid of its moments", "facets")
end

-- ---- contact is lost: tests/plot/touch.t derives the time, 0.051456 s; rows are 2/600 s apart ----

do
  program.write(dir .. "/hop.lua", [[return scene { name = "hop",
    body = tensor { mass = 1, xx = 0.001, yy = 0.001, zz = 0.001 },
    effects = { effect.plane { surface = contact.sphere { r = 0.1, at = { 0, 0, 0.05 } }, law = "smooth",
      gravity = 9.81 } }, initial = { omega = { 60, 0, 0 } }, time = { horizon = 2 } }]])
  local status, text, err = run("view " .. dir .. "/hop.lua --format glb -o -")
  local doc = json.read(text:sub(21, 20 + string.unpack("<I4", text, 13)))
  local last = doc.accessors[doc.animations[1].samplers[1].input + 1].max[1]
  tap.ok(status == 0 and err:find("contact is lost before t = ", 1, true) and last < 0.051456 and last > 0.048,
    "the animation ends where contact is lost, and a warning says so", last .. " " .. err)
end

-- ---- messages ----

for _, c in ipairs {
  { "view brick --format glb -o x.html", "-o must end in .glb, or be -, got x.html" },
  { "view brick -o x.glb", "-o must end in .html, or be -, got x.glb" },
  { "view brick --format gltf", "--format must be html or glb" },
  { "view foucault --format glb -o -", "this body is a point" },
  { "view brick --format glb --real float -o -", "--real: it is the type of the emitted code" },
} do
  local status, out, err = run(c[1])
  tap.ok(status == 2 and out == "" and err:find(c[2], 1, true), c[1] .. ": says what is wrong", err)
end

program.finish()
tap.done()
