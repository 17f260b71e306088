std = "lua54"
max_line_length = 120
-- Unused `self`-like arguments are written `_`; shadowing is refused.
files["bodies/*.lua"] = {
  read_globals = {
    "param", "scene", "solid", "shell", "plate", "rod", "wire", "points", "tensor", "effect",
    "extrude", "revolve", "region", "mesh",
  },
}
