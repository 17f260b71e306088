#!/usr/bin/env lua5.4
-- package.t - make dist and make deb: the same commit gives the same archive; lintian accepts the packages; what they
-- install runs outside of the sources; versions agree everywhere.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- It works in a clone of HEAD.  What is needed for packages and missing is skipped (.ci/setup package).

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local dir = program.directory()
local root = io.popen("pwd"):read "l"

local function shell(command)
  local status = program.shell(string.format("cd %s && { %s\n} >out 2>&1", dir, command))
  return status, program.read(dir .. "/out")
end

-- ---- versions ----

local version = program.read "Makefile":match "\nVERSION = (%S+)"
local released = program.read "Makefile":match "\nRELEASED = ([%d-]+)"
tap.ok(version and version:find "^%d+%.%d+%.%d+$" and released, "the Makefile has a version and its day")
for path, pattern in pairs { ["docs/CITATION.cff"] = "\nversion: (%S+)",
  [".ci/debian/changelog"] = "^polhode %((%S+)%)",
  ["src/runtime/polhode.h"] = '#define PH_VERSION "([^"]+)"', ["docs/changelog.md"] = "\n## (%d%S+)",
  ["README.md"] = "%*, version (%d[%d.]*%d)" } do
  tap.is(program.read(path):match(pattern), version, path .. " has the version of the Makefile")
end

-- ---- archive and packages ----

local function has(words)
  for word in words:gmatch "%S+" do
    if shell("command -v " .. word) ~= 0 then return false end
  end
  return true
end

if not has "git" or shell(string.format("git -c safe.directory='*' clone -q %s clone", root)) ~= 0 then
  tap.skip("make dist twice: the same bytes", "no git tree here")
  tap.done(program.finish())
  return
end
local status, text = shell(string.format("make -s -C clone dist && cp clone/build/polhode-%s.tar.gz one && " ..
  "sleep 1 && make -s -C clone dist && cmp one clone/build/polhode-%s.tar.gz", version, version))
tap.ok(status == 0, "make dist twice: the same bytes", text)

if not has "dpkg-buildpackage dh fakeroot lintian" then
  tap.skip("make deb", "no debhelper or lintian here")
  tap.done(program.finish())
  return
end
status, text = shell "POLHODE_NO_INSTALL=1 make -s -C clone deb"
tap.ok(status == 0, "make deb", text)
status, text = shell "lintian --allow-root --fail-on error,warning clone/build/deb/*.changes"
tap.ok(status == 0, "lintian finds no error and no warning", text)
status, text = shell("for p in polhode libpolhode-dev; do dpkg-deb -x clone/build/deb/${p}_*.deb there; done; " ..
  "find there")
tap.ok(status == 0, "the packages are unpacked", text)
for _, file in ipairs { "bin/polhode", "share/polhode/bodies/brick.lua", "share/man/man1/polhode-gen.1.gz",
  "share/man/man3/polhode.3.gz", "share/man/man5/polhode-scene.5.gz", "share/bash-completion/completions/polhode",
  "share/zsh/vendor-completions/_polhode", "share/fish/vendor_completions.d/polhode.fish", "include/polhode.h",
  "share/doc/polhode/README.md", "share/doc/polhode/docs/README.md" } do
  tap.ok(text:find("there/usr/" .. file .. "\n", 1, true), "they have " .. file)
end
status, text = shell("rm -rf clone && env -i PATH=$PWD/there/usr/bin:/usr/bin:/bin HOME=$PWD sh -c " ..
  "'polhode --version && polhode explain brick >/dev/null && polhode gen brick -o brick && make -s -C brick check'")
tap.ok(status == 0 and text:find("polhode " .. version .. "\n", 1, true) and text:find "ok 1 ",
  "the installed program generates from an installed scene, and the code passes its test", text)

tap.done(program.finish())
