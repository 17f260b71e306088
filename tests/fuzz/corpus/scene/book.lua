-- A book thrown about its middle axis: the flip that every student can see.
local w = param("width", 150, "mm")
local l = param("length", 220, "mm")
local d = param("thickness", 25, "mm")
return scene {
  name    = "book",
  body    = solid.box { x = l, y = w, z = d, density = quantity(700, "kg/m^3") },
  initial = { omega = {0.05, 9, 0.02} },
  time    = { horizon = 5 },
}
