-- page.lua -- one HTML file from the page's sources, the scene's facts and the WebAssembly of its code.
--
--     page.html(templates, hash, {facts =, shape =, formulas = (HTML), code, ground = (WebAssembly) or nil}) -> text
-- ground: of a body that flies and lands the code on the plane, code then that in the air.
-- hash: text -> SHA-256 in hexadecimal.  Without code the facts have a recorded motion.  The page may load nothing: its
-- policy names the script and the style by their hashes and forbids the rest.  Same scene, same bytes.
-- SPDX-License-Identifier: GPL-3.0-or-later

local bytes = require "generator.page.bytes"

local page = {}

-- In the order in which they stand in the one script.
local SCRIPTS = { "vectors", "code", "touch", "phases", "recorded", "motion", "shape", "gl", "poinsot", "ground",
  "space",
  "plot", "accuracy", "controls", "drag", "presets", "formulas", "start" }

local function packed(member)
  local by = {}
  for i, d in ipairs(member.by) do by[i] = { parameter = d.parameter, rate = bytes.floats(d.rate) } end
  return { at = bytes.floats(member.at), by = by }
end

local function policy_of(hash, script, style)
  local function named(text) return "'sha256-" .. bytes.base64(bytes.of_hex(hash(text))) .. "'" end
  return "default-src 'none'; script-src " .. named(script) .. " 'wasm-unsafe-eval'; style-src " .. named(style) ..
    "; img-src data: blob:; base-uri 'none'; form-action 'none'"
end

local function escaped(s) return (string.gsub(s, "[&<>\"]", { ["&"] = "&amp;", ["<"] = "&lt;", [">"] = "&gt;",
  ['"'] = "&quot;" })) end

function page.html(templates, hash, given)
  local list = { '"use strict";' }
  for _, name in ipairs(SCRIPTS) do list[#list + 1] = templates["templates/page/" .. name .. ".js"] end
  local script, style = "\n" .. table.concat(list, "\n"), "\n" .. templates["templates/page/page.css"]
  local drawn = { fixed = given.shape.fixed }
  for _, kind in ipairs { "faces", "holes", "lines", "points" } do drawn[kind] = packed(given.shape[kind]) end
  local values = { title = escaped(given.facts.name), policy = policy_of(hash, script, style),
    style = style, script = script,
    facts = bytes.json(given.facts), shape = bytes.json(drawn), code = given.code and bytes.base64(given.code) or "",
    ground = given.ground and bytes.base64(given.ground) or "",
    formulas = given.formulas, license = templates["templates/LICENSE"], version = escaped(given.facts.version) }
  return (string.gsub(templates["templates/page/page.html"], "@(%l+)@", values))
end

return page
