-- integrals.lua -- the integral from which a shape's moment about its axis z comes, where its limits are simple.
--
-- {where, integral, result, name} in the notation of formula/read.lua; m_s, l_x, r_s, h_s are mass, edges, radius and
-- height of the shape itself.  All other shapes: the integral over the body.
-- SPDX-License-Identifier: GPL-3.0-or-later

local turn = "int<0;2 pi>"
local flat = "int<-l_x/2;l_x/2> int<-l_y/2;l_y/2>"
local height = "int<-h_s/2;h_s/2>"

return {
  ["solid.box"] = { "mass $m_s$, edges $l_x$, $l_y$, $l_z$",
    "{m_s|l_x l_y l_z} " .. flat .. " int<-l_z/2;l_z/2> ( xi^2 + eta^2 ) dzeta deta dxi",
    "{m_s|12} ( l_x^2 + l_y^2 )", "A box" },
  ["solid.sphere"] = { "mass $m_s$, radius $r_s$; spherical coordinates $s$, $theta$, $phi$",
    "{3 m_s|4 pi r_s^3} int<0;r_s> int<0;pi> " .. turn .. " s^4 sin^3(theta) dphi dtheta ds", "{2|5} m_s r_s^2",
    "A sphere" },
  ["solid.cylinder"] = { "mass $m_s$, radius $r_s$, height $h_s$; cylindrical coordinates $s$, $phi$, $z$",
    "{m_s|pi r_s^2 h_s} " .. height .. " " .. turn .. " int<0;r_s> s^3 ds dphi dz", "{1|2} m_s r_s^2",
    "A cylinder" },
  ["solid.cone"] = { "mass $m_s$, radius $r_s$, height $h_s$; $s$, $phi$, $z$ cylindrical, $z$ from the tip",
    "{3 m_s|pi r_s^2 h_s} int<0;h_s> " .. turn .. " int<0;r_s z/h_s> s^3 ds dphi dz", "{3|10} m_s r_s^2",
    "A cone" },
  ["shell.sphere"] = { "mass $m_s$, radius $r_s$; spherical coordinates",
    "{m_s|4 pi} int<0;pi> " .. turn .. " r_s^2 sin^3(theta) dphi dtheta", "{2|3} m_s r_s^2",
    "A spherical shell" },
  ["plate.disc"] = { "mass $m_s$, radius $r_s$; polar coordinates $s$, $phi$",
    "{m_s|pi r_s^2} " .. turn .. " int<0;r_s> s^3 ds dphi", "{1|2} m_s r_s^2", "A disc" },
  ["plate.rectangle"] = { "mass $m_s$, edges $l_x$, $l_y$",
    "{m_s|l_x l_y} " .. flat .. " ( xi^2 + eta^2 ) deta dxi", "{m_s|12} ( l_x^2 + l_y^2 )", "A rectangle" },
  ["wire.hoop"] = { "mass $m_s$, radius $r_s$; polar coordinates", "{m_s|2 pi} " .. turn .. " r_s^2 dphi",
    "m_s r_s^2", "A hoop" },
}
