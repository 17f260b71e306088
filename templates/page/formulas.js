// formulas.js -- the numbers in the formulas.  SPDX-License-Identifier: MIT-0

const RAISED = { "-": "⁻", 0: "⁰", 1: "¹", 2: "²", 3: "³", 4: "⁴", 5: "⁵", 6: "⁶", 7: "⁷", 8: "⁸", 9: "⁹" };

// Six digits; a power of ten where it is shorter.
function written(x) {
  if (!Number.isFinite(x)) return "not finite";
  const a = Math.abs(x), near = a === 0 || a >= 1e-3 && a < 1e6;
  const [digits, power] = near ? [Number(x.toPrecision(6)).toString(), ""] : x.toExponential(5).split("e");
  const raised = power && "·10" + [...String(Number(power))].map((c) => RAISED[c]).join("");
  return (near ? digits : String(Number(digits))).replace("-", "−") + raised;
}

// I: xx yy zz xy xz yz.
function fillFormulas(I) {
  const value = { Ixx: I[0], Iyy: I[1], Izz: I[2], Ixy: I[3], Ixz: I[4], Iyz: I[5], kx: (I[1] - I[2])/I[0],
    ky: (I[2] - I[0])/I[1], kz: (I[0] - I[1])/I[2] };
  for (const e of document.querySelectorAll("[data-value]")) e.textContent = written(value[e.dataset.value]);
}
