-- plugins.lua -- the table of functions that the program polhode loads of an emitted scene, and what other integrators
-- need of it (bench).  Not emitted for users.
-- SPDX-License-Identifier: GPL-3.0-or-later

local template = require "generator.emit.template"

local GROUP = template.group("host/plugin.c", "host/plugin.h", "host/peers.c", "page/glue.c")

local plugins = {}

-- made: from code.of; asked: true, {peers = bool}, or {page = true}: what a page calls instead of the table
function plugins.files(job, made, asked)
  local peers = type(asked) == "table" and asked.peers and job.real == "double" or false
  local v = { has_peers = peers, orders = {}, steppers = made.parts.stepper.list, has_rates = job.model.has.rates,
    has_integral = job.conserved.rate ~= nil, has_closed = job.closed.kind ~= nil, has_full = job.closed.full or false,
    has_centre = job.closed.centre or false, has_speed = job.closed.slides or false,
    has_contact = job.equations.touch and true or false, has_landing = job.model.record.landing and true or false }
  for i, n in ipairs(job.orders or {}) do v.orders[i] = string.format("%d", n) end
  local render, list = GROUP(job.templates, made.base, v), {}
  if type(asked) == "table" and asked.page then return { { name = "page.c", text = render "page/glue.c" } } end
  if peers then list[1] = { name = "peers.c", text = render "host/peers.c" } end
  list[#list + 1] = { name = "plugin.c", text = render "host/plugin.c" }
  list[#list + 1] = { name = "plugin.h", text = render "host/plugin.h" }
  return list
end

return plugins
