-- A tennis racket, head and handle: Dzhanibekov's flip of the handle-over-head spin.
local head = param("head", 0.13, "m")        -- radius of the head
local handle = param("handle", 0.33, "m")
local frame = wire.hoop { r = head, mass = quantity(140, "g") }
local strings = plate.disc { r = head, mass = quantity(18, "g") }
local grip = solid.cylinder { r = 0.016, h = handle, mass = quantity(160, "g") }
  :turned{ axis = "x", angle = pi/2 }
  :at{0, -head - handle/2, 0}
return scene {
  name    = "tennis_racket",
  body    = frame + strings + grip,
  initial = { omega = {8, 0.02, 0.01} },
  time    = { horizon = 5 },
}
