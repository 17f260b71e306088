local fit = require "tests.bench.laws_fit"
local page = {}
function page.write(list)
  for _, r in ipairs(list) do
    local s = string.format("%-10s %-5s %-6s %-22s h=%-7.5g n=%-8d %6.1fns ", r.regime, r.scene, r.real, r.method, r.h, r.steps, r.time or 0)
    for _, q in ipairs(fit.quantities) do
      local f = r.fits[q]
      s = s .. (f and string.format(" %s %.2f+-%.2f(%g)%s %.1e b%.1f", string.sub(q, 1, 1), f.p, f.error, f.law, f.agrees and "" or "!", f.last, f.bias) or " -")
    end
    print(s)
  end
end
return page
