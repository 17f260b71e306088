-- A gyroscope's rotor, rim and web and shaft, driven by a control torque in body axes.
local rim_in, rim_out = param("rim_in", 30, "mm"), param("rim_out", 38, "mm")
local width = param("width", 14, "mm")
local steel, brass = quantity(7850, "kg/m^3"), quantity(8500, "kg/m^3")
local rim = solid.tube { r_in = rim_in, r_out = rim_out, h = width, density = brass }
local web = solid.cylinder { r = rim_in, h = quantity(3, "mm"), density = brass }
local shaft = solid.cylinder { r = 0.0025, h = 0.08, density = steel }
local bore = solid.cylinder { r = 0.0025, h = quantity(3, "mm"), density = brass }
return scene {
  name    = "gyroscope",
  body    = rim + (web - bore) + shaft,
  effects = { effect.control{} },
  initial = { omega = {0.2, 0, quantity(3000, "rpm")} },
  time    = { horizon = 2, step = 0.0001 },
}
