-- forms.lua: scenes around one thing that is wrong, for the tables of messages; and the rules that many messages share.
-- SPDX-License-Identifier: GPL-3.0-or-later

local forms = {
  BOX = "solid.box { x = 1, y = 2, z = 3, mass = 1 }",
  keyword = "must not be a word of C or C++",
  identifier = "must be a C identifier (a letter, then letters, digits, _)",
  number = "must be a number such as \"0.1\", \"1e-3\" or \"1/3\"",
}

-- A shape, on line 2.
function forms.body(shape) return 'return scene { name = "s",\n  body = ' .. shape .. '\n}\n' end

-- Further keys of a scene, on line 3.
function forms.with(keys) return 'return scene { name = "s", body = ' .. forms.BOX .. ',\n\n  ' .. keys .. '\n}\n' end

-- A statement, on line 1, before a scene that is right.
function forms.after(statement) return statement .. "\n" .. forms.body(forms.BOX) end

-- A box's edge, on line 2.
function forms.box(x) return forms.body("solid.box { x = " .. x .. ", y = 2, z = 3, mass = 1 }") end

return forms
