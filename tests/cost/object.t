#!/usr/bin/env lua5.4
-- object.t - ELF files as objdump(1) and nm(1) see them; frames of RISC-V functions from their machine code.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"
local frames = require "generator.cost.frames"
local object = require "generator.cost.object"
local stack = require "generator.cost.stack"

local dir = program.directory()
program.write(dir .. "/a.c", [[
static int counter = 5;
int zeros[100];
const char table[37] = "abc";
int next(void) { return counter++ + zeros[3]; }
int main(void) { return next() - 5 + table[9]; }
]])

local function output(command)
  local pipe = io.popen("cd " .. dir .. " && " .. command)
  local text = pipe:read "a"
  pipe:close()
  return text
end

for _, name in ipairs { "a.o", "a" } do
  program.shell("cd " .. dir .. " && cc -O0 " .. (name == "a" and "" or "-c ") .. "a.c -o " .. name)
  local o = object.read(program.read(dir .. "/" .. name))
  local flash, ram = 0, 0
  local line = "\n%s*%d+ %S+%s+(%x+)%s+%x+%s+%x+%s+%x+%s+%S+%s+([^\n]*)"
  for bytes, flags in output("objdump -h -w " .. name):gmatch(line) do
    if flags:find "ALLOC" then
      if flags:find "CONTENTS" then flash = flash + tonumber(bytes, 16) end
      if not flags:find "READONLY" then ram = ram + tonumber(bytes, 16) end
    end
  end
  tap.is(o.flash, flash, name .. ": bytes of sections that are loaded")
  tap.is(o.ram, ram, name .. ": bytes of sections that are written")
  tap.ok(flash > 37 and ram >= 404, name .. ": there are some")
  for value, size, symbol in output("nm -S " .. name):gmatch "(%x+) (%x+) %a (%S+)" do
    if symbol == "zeros" or symbol == "table" or symbol == "next" or symbol == "counter" then
      local s = o.symbols[symbol] or {}
      tap.is(s.value, tonumber(value, 16), name .. ": address of " .. symbol)
      tap.is(s.bytes, tonumber(size, 16), name .. ": bytes of " .. symbol)
    end
  end
end
tap.is(object.read "MZ and something", nil, "what is no ELF file is none")

-- What objdump writes for four functions of a C library; __nesf2 is __eqsf2's second name.
local TEXT = [[
80000000 <__addsf3>:
80000000:	1141                	add	sp,sp,-16
80000002:	c606                	sw	ra,12(sp)
80000004:	2c4d                	jal	80000020 <__clzsi2>
80000006:	0141                	add	sp,sp,16
80000008:	8082                	ret

80000010 <_sin>:
80000010:	4f2022ef          	jal	t0,80000040 <__riscv_save_0>
80000014:	1101                	add	sp,sp,-32
80000016:	2c15                	jal	80000000 <__addsf3>
80000018:	bf01                	j	80000014 <_sin+0x4>

80000020 <__clzsi2>:
80000020:	ff010113          	add	a5,a5,-16 # ff <_sin+0xef>
80000024:	8082                	ret

80000030 <__eqsf2>:
80000030:	4f2022ef          	jal	t0,80000050 <__riscv_save_5>
80000034:	8082                	ret

80000060 <_large>:
80000060:	72fd                	lui	t0,0xfffff
80000062:	9116                	add	sp,sp,t0
80000064:	8082                	ret
]]
local graph = frames.riscv(TEXT, "80000030 T __eqsf2\n80000030 T __nesf2\n", { order = {}, nodes = {} })
local worst = {}
for _, f in ipairs(stack.worst(graph)) do
  worst[f.name] = f.bytes
  tap.is(f.dynamic ~= nil, f.name == "_large", f.name .. ": a frame from a register is said to be no bound")
  tap.is(#f.missing, 0, f.name .. ": all that it calls is known")
end
tap.is(worst.__clzsi2, 0, "a leaf without a frame")
tap.is(worst.__addsf3, 16, "a frame")
tap.is(worst._sin, 16 + 32 + 16, "saved registers, a frame, and what is called")
tap.is(worst.__eqsf2, 64, "four registers or more are saved through 64 bytes")
tap.is(worst.__nesf2, 64, "a second name")

program.finish()
tap.done()
