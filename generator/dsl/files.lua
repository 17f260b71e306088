-- files.lua -- which files a scene may name: those in its own folder and below.
--
-- A scene is data that someone may have sent: it names files relative to itself, and nothing above, nor what a link
-- that came with it points to elsewhere.  Reading is the host's, which takes regular files of bounded size only.
-- SPDX-License-Identifier: GPL-3.0-or-later

local diag = require "generator.diag"

local files = {}

-- The rule that the name breaks, or nil.
local function rule_for(given)
  if type(given) ~= "string" or given == "" then return "file must be the name of a file" end
  if string.find(given, "%c") then return "file must not contain control characters" end
  if string.sub(given, 1, 1) == "/" then return "file must be relative to the scene's folder" end
  for part in string.gmatch(given, "[^/]+") do
    if part == ".." then return "file must be in the scene's folder or below it, without .." end
  end
  return nil
end

-- The path of the file that the scene calls `given`, or nil after an error on the line.  ctx.files becomes the list of
-- all of them, {name =, path =}, in the order of their first mention.
function files.resolve(ctx, line, what, given)
  local rule = rule_for(given)
  if rule then
    ctx.diag:error(line, what, rule, diag.show(given))
    return nil
  end
  local folder = string.match(ctx.diag.file, "^.*/") or ""
  if ctx.host.within and not ctx.host.within(folder == "" and "." or folder, folder .. given) then
    ctx.diag:error(line, what, "file must be in the scene's folder or below it, also where links lead",
      diag.show(given))
    return nil
  end
  ctx.files = ctx.files or {}
  if not ctx.files[given] then
    ctx.files[given] = true
    ctx.files[#ctx.files + 1] = { name = given, path = folder .. given }
  end
  return folder .. given
end

-- The text of that file and its path, or nil after an error on the line.  ctx: {diag =, host =}.
function files.read(ctx, line, what, given)
  local path = files.resolve(ctx, line, what, given)
  if not path then return nil end
  local text, why = ctx.host.read(path == "-" and "./-" or path) -- a file: standard input is not the scene's
  if not text then
    ctx.diag:error(line, what, why)
    return nil
  end
  return text, path
end

return files
