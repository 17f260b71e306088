-- files.lua - attempts with files: what a scene may name, and what may be given as one.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Rows as in words.lua; `first` is a command in the scene's folder, `file` what is given to the program instead.

local function mesh(name)
  return string.format("return scene { name = 's', body = mesh { file = %q, mass = 1 } }", name)
end
local outside, link = "in the scene's folder or below it, without ..", "also where links lead"
local TETRA = "printf 'v 0 0 0\\nv 1 0 0\\nv 0 1 0\\nv 0 0 1\\nf 1 3 2\\nf 1 2 4\\nf 1 4 3\\nf 2 3 4\\n' > "

return {
  about = "files",
  { "a mesh above the folder", mesh "../../../etc/passwd", outside },
  { "a mesh above, hidden in the middle", mesh "a/../../b.stl", outside },
  { "a mesh at an absolute path", mesh "/etc/passwd", "must be relative" },
  { "a mesh behind a link", mesh "l.stl", link, first = "ln -s /etc/passwd l.stl" },
  { "a mesh behind a linked folder", mesh "etc/passwd", link, first = "ln -s /etc etc" },
  { "an inertial behind a link", "return scene { name = 's', body = inertial { file = 'l.urdf', link = 'a' } }", link,
    first = "ln -s /etc/passwd l.urdf" },
  { "a mesh that is /dev/zero", mesh "z.stl", link, first = "ln -s /dev/zero z.stl" },
  { "a mesh that is a fifo", mesh "f.stl", "not a regular file", first = "mkfifo f.stl" },
  { "a mesh that is a directory", mesh "d.stl", "not a regular file", first = "mkdir d.stl" },
  { "a mesh that links to itself", mesh "r.stl", "cannot read", first = "ln -s r.stl r.stl" },
  { "a mesh of a gigabyte of zeros", mesh "g.stl", "mesh: ", first = "truncate -s 1G g.stl" },
  { "a mesh with a name of 100000 letters", mesh(("a"):rep(100000)), "cannot read" },
  { "a mesh with a zero byte in its name", mesh "a.stl\0.txt", "control characters" },
  { "a mesh that says it has 4e9 triangles", mesh "b.stl", "mesh: ",
    first = "{ head -c 80 /dev/zero; printf '\\377\\377\\377\\377'; head -c 100 /dev/zero; } > b.stl" },
  { "a mesh whose name ends a comment", mesh "*INJECTED.obj", true, first = TETRA .. "'*INJECTED.obj'" },
  { "a mesh whose name is a trigraph", mesh "a??/.obj", true, first = "mkdir 'a??' && " .. TETRA .. "'a??/.obj'" },
  { "an XML bomb", "return scene { name = 's', body = inertial { file = 'b.urdf', link = 'a' } }", "document type",
    first = "printf '<!DOCTYPE r [<!ENTITY a \"aaaa\"><!ENTITY b \"&a;&a;\">]><robot>&b;</robot>' > b.urdf" },
  { "XML that is deep", "return scene { name = 's', body = inertial { file = 'd.urdf', link = 'a' } }", "inertial: ",
    first = "yes '<a>' | head -100000 > d.urdf" },
  { "the scene is /dev/zero", file = "/dev/zero", "not a regular file", status = 2 },
  { "the scene is standard input", file = "/dev/stdin", "not a regular file", status = 2 },
  { "the scene is a fifo", file = "fifo", "not a regular file", first = "mkfifo fifo", status = 2 },
  { "the scene is a directory", file = ".", "it is a directory", status = 2 },
  { "the scene is not there", file = "nothing.lua", "No such file", status = 2 },
  { "the scene is 4 MiB of zeros", file = "z.lua", "", first = "truncate -s 4M z.lua" },
  { "the scene is a gigabyte", file = "g.lua", "larger than 4 MiB", first = "truncate -s 1G g.lua", status = 2 },
  { "the scene grows while it is read", file = "w.lua", "the script must",
    first = "{ (i=0; while [ $i -lt 300 ]; do echo 'x = 1'; i=$((i + 1)); done) >> w.lua; }" },
}
