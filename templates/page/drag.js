// drag.js -- a pointer on the picture: it moves the camera, or turns the initial body, or its initial rates.
// SPDX-License-Identifier: MIT-0
//
// Who has no pointer has the keys here for the camera, and the sliders for all else.

const AROUND = 0.008; // rad of a turn for a pixel

// moved(way, dx, dy): what a drag other than the camera's does; way: () => "camera" | "attitude" | "rates".
function orbit(canvas, space, draw, way, moved) {
  let from = null;
  const limit = () => {
    space.height = Math.max(-1.5, Math.min(1.5, space.height));
    space.far = Math.max(1.5, Math.min(12, space.far));
    draw();
  };
  canvas.addEventListener("pointerdown", (e) => {
    from = [e.clientX, e.clientY];
    canvas.setPointerCapture(e.pointerId);
  });
  canvas.addEventListener("pointermove", (e) => {
    if (!from) return;
    const dx = e.clientX - from[0], dy = e.clientY - from[1];
    from = [e.clientX, e.clientY];
    if (way() !== "camera") return moved(way(), dx, dy);
    space.turn -= dx*AROUND;
    space.height += dy*AROUND;
    limit();
  });
  for (const name of ["pointerup", "pointercancel"]) canvas.addEventListener(name, () => { from = null; });
  canvas.addEventListener("keydown", (e) => {
    const turn = { ArrowLeft: -0.1, ArrowRight: 0.1 }[e.key], up = { ArrowUp: 0.1, ArrowDown: -0.1 }[e.key];
    if (turn) space.turn += turn;
    else if (up) space.height += up;
    else if (e.key === "+") space.far /= 1.1;
    else if (e.key === "-") space.far *= 1.1;
    else if (e.key === "0") Object.assign(space, { turn: 0.6, height: 0.35, far: FAR });
    else return;
    e.preventDefault();
    limit();
  });
}

// Directions of the screen in space: to the right and up.
function screenOf(space) {
  const a = space.turn, e = space.height;
  return { right: [-Math.sin(a), Math.cos(a), 0],
    up: [-Math.sin(e)*Math.cos(a), -Math.sin(e)*Math.sin(a), Math.cos(e)] };
}

// The rotation vector of the further turn after a drag: own, the scene's attitude; turn, the rotation vector before.
function draggedTurn(space, own, turn, dx, dy) {
  const { right, up } = screenOf(space), r = rotationOf(added(scaled(dx*AROUND, up), scaled(dy*AROUND, right)));
  const back = [own[0], -own[1], -own[2], -own[3]];
  return vectorOf(product(product(back, product(r, own)), rotationOf(turn)));
}

// Rates in body axes after a drag of the tip of w, at the attitude q; size: rad/s for a pixel.
function draggedRates(space, q, w, size, dx, dy) {
  const { right, up } = screenOf(space), tip = added(scaled(dx*size, right), scaled(-dy*size, up));
  return added(w, turned([q[0], -q[1], -q[2], -q[3]], tip));
}
