-- gltf.lua -- a motion as binary glTF 2.0 (.glb), which Blender and other programs read.
--
--     gltf.binary {name =, version =, shape = {faces, holes, lines, points: numbers}, times =,
--       attitude = {{w, x, y, z}, ..}, place = {{x, y, z}, ..} or nil} -> bytes
-- A file has a header, a chunk of JSON filled up with blanks and one of numbers; all lengths are multiples of 4.  In
-- glTF y is up and quaternions have their scalar last; neighbours have one sign, so that a player turns the short way.
-- Khronos, glTF 2.0 specification, 3.6 (accessors), 3.11 (animations), 4 (GLB).
-- SPDX-License-Identifier: GPL-3.0-or-later

local bytes = require "generator.page.bytes"

local gltf = {}

local FLOAT, ARRAY = 5126, 34962
local POINTS, LINES, TRIANGLES = 0, 1, 4
local HALF = math.sqrt(0.5)

local function narrow(x) return (string.unpack("<f", string.pack("<f", x))) end

-- A file that is being written: accessors, views and numbers.
local function new() return { accessors = {}, views = {}, data = {}, size = 0 } end

-- Numbers in groups of `width` as an accessor; its number.  bounded: with least and greatest, as the specification asks
-- of positions and times.
local function accessor(file, list, width, o)
  local words, low, high = {}, {}, {}
  for i, x in ipairs(list) do
    local k, v = (i - 1) % width + 1, narrow(x)
    low[k], high[k] = math.min(low[k] or v, v), math.max(high[k] or v, v)
    words[i] = string.pack("<f", x)
  end
  local text = table.concat(words)
  file.views[#file.views + 1] = { buffer = 0, byteOffset = file.size, byteLength = #text, target = o.target }
  file.data[#file.data + 1] = text
  file.size = file.size + #text
  file.accessors[#file.accessors + 1] = { bufferView = #file.views - 1, componentType = FLOAT, count = #list // width,
    type = ({ "SCALAR", false, "VEC3", "VEC4" })[width], min = o.bounded and low or nil,
    max = o.bounded and high or nil }
  return #file.accessors - 1
end

-- The normal of each corner of triangles, that of its face.
local function normals(list)
  local out = {}
  for i = 1, #list, 9 do
    local u, v = {}, {}
    for k = 0, 2 do u[k], v[k] = list[i + 3 + k] - list[i + k], list[i + 6 + k] - list[i + k] end
    local n = { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] }
    local size = math.sqrt(n[1] ^ 2 + n[2] ^ 2 + n[3] ^ 2)
    for _ = 1, 3 do
      for k = 1, 3 do out[#out + 1] = size > 0 and n[k] / size or k == 3 and 1.0 or 0.0 end
    end
  end
  return out
end

local function paint(alpha)
  return { baseColorFactor = { 0.34, 0.42, 0.5, alpha }, metallicFactor = 0.0, roughnessFactor = 0.6 }
end

local materials = { { name = "body", doubleSided = true, pbrMetallicRoughness = paint(1.0) },
  { name = "hole", doubleSided = true, alphaMode = "BLEND", pbrMetallicRoughness = paint(0.4) } }

local function primitives(file, shape)
  local list = {}
  local function put(numbers, mode, material)
    if #numbers == 0 then return end
    local attributes = { POSITION = accessor(file, numbers, 3, { target = ARRAY, bounded = true }) }
    if mode == TRIANGLES then attributes.NORMAL = accessor(file, normals(numbers), 3, { target = ARRAY }) end
    list[#list + 1] = { attributes = attributes, mode = mode, material = material }
  end
  put(shape.faces, TRIANGLES, 0)
  put(shape.holes, TRIANGLES, 1)
  put(shape.lines, LINES, 0)
  put(shape.points, POINTS, 0)
  return list
end

-- Quaternions with their scalar last, each on the side of the one before.
local function turns(attitude)
  local out, last = {}, nil
  for _, q in ipairs(attitude) do
    local side = last and q[1] * last[1] + q[2] * last[2] + q[3] * last[3] + q[4] * last[4] < 0 and -1 or 1
    local n = side / math.sqrt(q[1] ^ 2 + q[2] ^ 2 + q[3] ^ 2 + q[4] ^ 2)
    last = { n * q[1], n * q[2], n * q[3], n * q[4] }
    for _, k in ipairs { 2, 3, 4, 1 } do out[#out + 1] = last[k] end
  end
  return out
end

local function chunk(kind, text, fill)
  text = text .. string.rep(fill, -#text % 4)
  return string.pack("<I4", #text) .. kind .. text
end

function gltf.binary(o)
  local file, channels, samplers = new(), {}, {}
  local mesh = primitives(file, o.shape)
  local input = accessor(file, o.times, 1, { bounded = true })
  local function animated(path, numbers, width)
    samplers[#samplers + 1] = { input = input, output = accessor(file, numbers, width, {}), interpolation = "LINEAR" }
    channels[#channels + 1] = { sampler = #samplers - 1, target = { node = 1, path = path } }
  end
  animated("rotation", turns(o.attitude), 4)
  if o.place then
    local flat = {}
    for _, p in ipairs(o.place) do table.move(p, 1, 3, #flat + 1, flat) end
    animated("translation", flat, 3)
  end
  local text = bytes.json { asset = { version = "2.0", generator = o.version }, scene = 0,
    scenes = { { nodes = { 0 } } },
    nodes = { { name = "z is up", rotation = { -HALF, 0.0, 0.0, HALF }, children = { 1 } },
      { name = o.name, mesh = 0 } },
    meshes = { { name = o.name, primitives = mesh } }, materials = materials, accessors = file.accessors,
    animations = { { name = o.name, channels = channels, samplers = samplers } }, bufferViews = file.views,
    buffers = { { byteLength = file.size } } }
  local body = chunk("JSON", text, " ") .. chunk("BIN\0", table.concat(file.data), "\0")
  return "glTF" .. string.pack("<I4I4", 2, 12 + #body) .. body
end

return gltf
