-- compiler.lua -- is there a C compiler that works?  Asked after something did not compile, to tell whose fault it is.
--
-- The compiler is the user's: CC, else cc, gcc, clang (src/cli/host/process.c).
-- SPDX-License-Identifier: GPL-3.0-or-later

local compiler = {}

local probe = [[
#include <math.h>
double probe(double x);
double probe(double x) { return sin(x); }
]]

-- What is wrong with the compiler, with the packages that mend it, or nil.
function compiler.missing(host)
  local dir, why = host.tempdir()
  local ok = dir
  if dir then ok, why = host.write_file(dir .. "/probe.c", probe) end
  if not ok then return why end
  local made, said = host.compile(dir, { "probe.c" }, "probe.so", { flags = { "-shared", "-fPIC" }, libs = { "-lm" } })
  if made then return nil end
  if string.find(said, "^cannot run the C compiler") then return said end
  local first = string.match(said, "%S[^\n]*")
  return "the C compiler cannot compile a function that includes <math.h> (set CC, or install the packages gcc and " ..
    "libc6-dev)" .. (first and "; it says: " .. first or "")
end

return compiler
