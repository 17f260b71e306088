#!/usr/bin/env lua5.4
-- sha256.t - host.sha256 against the examples of NIST, and against coreutils at every length around a block.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local dir = program.directory()

local function prints(name, text, want)
  local code, out, err = program.run(text, dir)
  return tap.ok(code == 0 and out == want, name, string.format("status %s\ngot  %s\nwant %s\n%s", code, out, want, err))
end

-- NIST, "Examples with intermediate values", SHA-256; the last from FIPS 180-2, B.3.
prints("one block", "say(host.sha256 'abc')", "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad\n")
prints("two blocks", "say(host.sha256 'abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq')",
  "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1\n")
prints("a million a", "say(host.sha256(string.rep('a', 1000000)))",
  "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0\n")
prints("nothing", "say(host.sha256 '')", "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855\n")

-- Lengths around one and two blocks, where the padding needs none or one more; all values of a byte.
local want = {}
for n = 0, 140 do
  local text = {}
  for i = 1, n do text[i] = string.char((i * 37 + n) % 256) end
  program.write(string.format("%s/n%03d", dir, n), table.concat(text))
end
local pipe = assert(io.popen("cd " .. dir .. " && sha256sum n*"))
for line in pipe:lines() do want[#want + 1] = line:match "^%x+" end
pipe:close()
tap.is(#want, 141, "sha256sum has 141 hashes")
prints("0 to 140 bytes, as a text and as a file: sha256sum's", [[
  for n = 0, 140 do
    local path = string.format("%s/n%03d", args[1], n)
    local hash = host.sha256(host.read(path))
    say(hash == host.sha256("", path) and hash)
  end]], table.concat(want, "\n") .. "\n")

pipe = assert(io.popen("cd " .. dir
  .. " && { printf begin; head -c 100000 /dev/zero | tee big; cat n077; } | sha256sum"))
local joined = pipe:read "a":match "^%x+"
pipe:close()
prints("a text and two files: as cat joins them",
  "say(host.sha256('begin', args[1] .. '/big', args[1] .. '/n077'))", joined .. "\n")
prints("a file that is not there", "say(host.sha256('', 'no/such'))",
  "nil cannot read no/such: No such file or directory\n")
prints("a folder, a device", "say(select(2, host.sha256('', '/dev'))) say(select(2, host.sha256('', '/dev/zero')))",
  "cannot read /dev: it is not a regular file\ncannot read /dev/zero: it is not a regular file\n")

program.finish()
tap.done()
