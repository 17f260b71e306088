#!/usr/bin/env lua5.4
-- stack.t - the worst stack along the graph of calls, from gcc's text and from a disassembly.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The texts are what gcc 12 and objdump print, shortened; the sums are made by hand.  That the bounds hold on a
-- processor is tests/target/promises.t.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local stack = require "generator.cost.stack"

local function by_name(list)
  local t = {}
  for _, f in ipairs(list) do t[f.name] = f end
  return t
end
local function joined(list) return list and table.concat(list, " ") or "" end

local CI = [[
graph: { title: "b.c"
node: { title: "b.c:leaf" label: "leaf\nb.c:26:12\n24 bytes (static)" }
node: { title: "b.c:wide" label: "wide\nb.c:30:12\n40 bytes (static)\n0 dynamic objects" }
edge: { sourcename: "b.c:wide" targetname: "b.c:leaf" label: "b.c:31:3" }
node: { title: "sqrt" label: "sqrt\n/usr/include/math.h:26:14" shape : ellipse }
edge: { sourcename: "b.c:wide" targetname: "sqrt" label: "b.c:32:3" }
node: { title: "b_step" label: "b_step\nb.c:50:6\n100 bytes (static)" }
edge: { sourcename: "b_step" targetname: "b.c:wide" label: "b.c:51:3" }
edge: { sourcename: "b_step" targetname: "b.c:leaf" label: "b.c:52:3" }
node: { title: "b_twice" label: "b_twice\nb.c:60:5\n120 bytes (static)" }
edge: { sourcename: "b_twice" targetname: "b_twice" label: "b.c:61:5" }
node: { title: "b_odd" label: "b_odd\nb.c:64:5\n8 bytes (static)" }
edge: { sourcename: "b_odd" targetname: "b_even" label: "b.c:65:5" }
node: { title: "b_even" label: "b_even\nb.c:67:5\n16 bytes (static)" }
edge: { sourcename: "b_even" targetname: "b_odd" label: "b.c:68:5" }
node: { title: "b_any" label: "b_any\nb.c:70:5\n8 bytes (static)" }
node: { title: "__indirect_call" label: "Indirect Call Placeholder" shape : ellipse }
edge: { sourcename: "b_any" targetname: "__indirect_call" label: "b.c:71:5" }
node: { title: "b_vla" label: "b_vla\nb.c:80:5\n8 bytes (dynamic)\n1 dynamic objects\n c b.c:4:20" }
node: { title: "b_uses" label: "b_uses\nb.c:90:5\n8 bytes (static)" }
edge: { sourcename: "b_uses" targetname: "b_vla" label: "b.c:91:5" }
edge: { sourcename: "b_uses" targetname: "b_even" label: "b.c:92:5" }
}
]]

do
  local f = by_name(stack.worst(stack.read(CI)))
  tap.is(f.b_step.bytes, 164, "100 + 40 + 24: the deepest chain, not the sum of all calls")
  tap.is(joined(f.b_step.path), "b_step wide leaf", "with its path")
  tap.is(joined(f.b_step.missing), "sqrt", "what has no frame is named")
  tap.ok(f.b_step.public and not f.wide.public and f.b_step.place == "b.c:50:6",
    "public or not, and its place")
  tap.is(joined(f.b_step.cycle) .. joined(f.b_step.dynamic) .. joined(f.b_step.indirect), "",
    "and nothing is against it")
  tap.is(by_name(stack.worst(stack.read(CI), { sqrt = 30 })).b_step.bytes, 170, "with known bytes another is deepest")
  tap.is(joined(f.b_twice.cycle), "b_twice", "a function that calls itself is a cycle")
  tap.is(joined(f.b_odd.cycle), "b_odd b_even", "so are two that call each other")
  tap.is(joined(f.b_uses.cycle), "b_odd b_even", "and who calls them inherits it")
  tap.is(joined(f.b_any.indirect), "b_any", "a call through a pointer is named")
  tap.is(joined(f.b_uses.dynamic), "b_vla", "a frame that is not static is named, by its callers too")
end

-- ---- functions of the C library: a disassembly ----

local DIS = [[

00000100 <outer>:
     100:	b570      	push	{r4, r5, r6, lr}
     102:	ed2d 8b04 	vpush	{d8-d9}
     106:	b082      	sub	sp, #8
     108:	f7ff fffe 	bl	200 <inner>
     10c:	d0fa      	beq.n	106 <outer+0x6>
     10e:	ecbd 8b04 	vpop	{d8-d9}
     112:	bd70      	pop	{r4, r5, r6, pc}

00000200 <inner>:
     200:	f84d ed08 	str.w	lr, [sp, #-8]!
     204:	f5ad 7d10 	sub.w	sp, sp, #576	; 0x240
     208:	f2ad 5d14 	subw	sp, sp, #1300	; 0x514
     20c:	f000 b804 	b.w	300 <tail>
     210:	bf00      	nop

00000300 <tail>:
     300:	e92d 4010 	stmdb	sp!, {r4, lr}
     304:	e8bd 8010 	ldmia.w	sp!, {r4, pc}
     308:	b500      	push	{lr}

00000310 <next>:
     310:	4c01      	ldr	r4, [pc, #4]	; (318 <next+0x8>)
     312:	44a5      	add	sp, r4
     314:	4770      	bx	lr
     316:	0000      	movs	r0, r0
     318:	fffffdf0 	.word	0xfffffdf0

00000320 <wild>:
     320:	ebad 0d03 	sub.w	sp, sp, r3
     324:	4798      	blx	r3
     326:	f7ff fffb 	bl	320 <wild>
     32a:	4770      	bx	lr
]]
local NM = "00000100 T outer\n00000310 T next\n00000310 W other\n00000200 t inner\n"

do
  local f = by_name(stack.worst(stack.disassembly(DIS, NM)))
  tap.is(f.next.bytes, 528, "a frame from a constant behind the code: 0xfffffdf0 is -528")
  tap.is(f.tail.bytes, 12 + 528, "r4 lr, another lr, and on into the next function, for want of a return")
  tap.is(f.inner.bytes, 8 + 576 + 1300 + f.tail.bytes, "lr with a gap, two subtractions, a call in the tail")
  tap.is(f.outer.bytes, 16 + 16 + 8 + f.inner.bytes, "four registers, two doubles, eight bytes; popping takes nothing")
  tap.is(f.outer.cycle, nil, "a loop is no recursion")
  tap.is(f.other.bytes, f.next.bytes, "a second name of the same address")
  tap.is(joined(f.wild.dynamic) .. joined(f.wild.indirect) .. joined(f.wild.cycle), "wildwildwild",
    "a register taken from sp, a call by register and a call of its own are seen")
end

do
  local graph = stack.read(CI)
  stack.disassembly("\n00000400 <sqrt>:\n     400:\tb082      \tsub\tsp, #64\n     402:\t4770      \tbx\tlr\n" ..
    "\n00000410 <b_step>:\n     410:\tb082      \tsub\tsp, #8\n     412:\t4770      \tbx\tlr\n", "", graph)
  local f = by_name(stack.worst(graph))
  tap.is(f.b_step.bytes, 204, "both in one graph: 100 + 40 + 64; what gcc has said stays")
  stack.disassembly("\n00000410 <wide>:\n     410:\tb082      \tsub\tsp, #16\n     412:\tb082      \tsub\tsp, #40\n" ..
    "     414:\t4770      \tbx\tlr\n", "", graph)
  tap.is(by_name(stack.worst(graph)).b_step.bytes, 220, "unless the code takes more than gcc says: 100 + 56 + 64")
  tap.is(#f.b_step.missing, 0, "and nothing is missing")
end

tap.done()
