-- fit.lua -- the shared object that `polhode fit` compiles and loads; gen --project does not offer it.
-- SPDX-License-Identifier: GPL-3.0-or-later

local fitted = require "generator.emit.fitted"

local fit = { whole = true }

function fit.files(job, made)
  return { { name = "fitted.c", text = fitted.fill(job, made) },
    { name = "fitted.h", text = job.templates["templates/fit/fitted.h"] } }
end

return fit
