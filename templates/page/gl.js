// gl.js -- a small renderer on WebGL 2: lit surfaces, and lines as ribbons of some pixels.
// SPDX-License-Identifier: MIT-0

const SOLID = {
  vertex: "#version 300 es\nlayout(location=0) in vec3 at; layout(location=1) in vec3 normal;" +
    "uniform mat4 camera, place; uniform vec3 scale; out vec3 n;" +
    "void main() { n = mat3(place)*(normal/(scale*scale)); gl_Position = camera*place*vec4(at, 1.0); }",
  fragment: "#version 300 es\nprecision mediump float; in vec3 n; uniform vec4 colour; out vec4 c;" +
    "void main() { vec3 u = normalize(gl_FrontFacing ? n : -n);" +
    "float light = 0.45 + 0.4*max(dot(u, normalize(vec3(0.4, -0.6, 0.8))), 0.0) + 0.15*max(u.z, 0.0);" +
    "c = vec4(colour.rgb*light, colour.a); }",
};
const RIBBON = {
  vertex: "#version 300 es\nlayout(location=0) in vec2 corner; layout(location=1) in vec3 a;" +
    "layout(location=2) in vec3 b; uniform mat4 camera, place; uniform vec2 pixel; uniform float width;" +
    "void main() { vec4 p = camera*place*vec4(a, 1.0), q = camera*place*vec4(b, 1.0);" +
    "vec2 way = (q.xy/q.w - p.xy/p.w)/pixel; float l = length(way); way = l > 0.0 ? way/l : vec2(1.0, 0.0);" +
    "vec4 base = corner.x < 0.5 ? p : q;" +
    "base.xy += (vec2(-way.y, way.x)*corner.y + way*(corner.x*2.0 - 1.0)*0.5)*width*pixel*base.w;" +
    "gl_Position = base; }",
  fragment: "#version 300 es\nprecision mediump float; uniform vec4 colour; out vec4 c; void main() { c = colour; }",
};

function programOf(gl, source) {
  const program = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, source.vertex], [gl.FRAGMENT_SHADER, source.fragment]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost())
    throw new Error("a shader does not compile: " + gl.getProgramInfoLog(program));
  const found = {}, n = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) || 0;
  for (let i = 0; i < n; i++) {
    const name = gl.getActiveUniform(program, i).name;
    found[name] = gl.getUniformLocation(program, name);
  }
  return { program, found };
}

// Does a program draw in the place of a graphics card?  Smooth edges cost it a quarter of the frame's time.
function drawnByProgram() {
  const gl = document.createElement("canvas").getContext("webgl2");
  const info = gl && gl.getExtension("WEBGL_debug_renderer_info");
  const name = info ? gl.getParameter(info.UNMASKED_RENDERER_WEBGL) : "";
  if (gl) gl.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
}

// A renderer, or null where there is no WebGL 2.
function rendererOf(canvas) {
  const wanted = { antialias: !drawnByProgram(), alpha: false, preserveDrawingBuffer: true };
  const gl = canvas.getContext("webgl2", wanted);
  if (!gl) return null;
  const solid = programOf(gl, SOLID), ribbon = programOf(gl, RIBBON), corners = gl.createBuffer();
  gl.bindBuffer(gl.ARRAY_BUFFER, corners);
  gl.bufferData(gl.ARRAY_BUFFER, new Float32Array([0, -0.5, 1, -0.5, 0, 0.5, 1, 0.5]), gl.STATIC_DRAW);
  let camera = null;

  function buffer(numbers) {
    const b = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, b);
    gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.STATIC_DRAW);
    return b;
  }

  function begin(matrix, paper) {
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    const w = Math.max(1, Math.round(canvas.clientWidth*ratio)), h = Math.max(1, Math.round(canvas.clientHeight*ratio));
    if (canvas.width !== w || canvas.height !== h) {
      canvas.width = w;
      canvas.height = h;
    }
    camera = matrix;
    gl.viewport(0, 0, w, h);
    gl.clearColor(paper[0], paper[1], paper[2], 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
  }

  function through(colour) {
    if (colour[3] < 1) {
      gl.enable(gl.BLEND);
      gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
      gl.depthMask(false);
    } else {
      gl.disable(gl.BLEND);
      gl.depthMask(true);
    }
  }

  // mesh: {buffer, n}; scale: the lengths of the columns of `place`, for the normals.
  function surface(mesh, place, scale, colour) {
    if (!mesh.n) return;
    gl.useProgram(solid.program);
    gl.uniformMatrix4fv(solid.found.camera, false, camera);
    gl.uniformMatrix4fv(solid.found.place, false, place);
    gl.uniform3fv(solid.found.scale, scale);
    gl.uniform4fv(solid.found.colour, colour);
    gl.bindBuffer(gl.ARRAY_BUFFER, mesh.buffer);
    for (const k of [0, 1]) {
      gl.enableVertexAttribArray(k);
      gl.vertexAttribDivisor(k, 0);
      gl.vertexAttribPointer(k, 3, gl.FLOAT, false, 24, 12*k);
    }
    gl.disableVertexAttribArray(2);
    through(colour);
    gl.drawArrays(gl.TRIANGLES, 0, mesh.n);
    gl.depthMask(true);
  }

  // line: {buffer, n points}; apart: pairs of points that are not joined to the next pair.
  function lines(line, place, colour, width, apart, first, count) {
    const n = apart ? line.n/2 : (count === undefined ? line.n : count) - 1, stride = apart ? 24 : 12;
    if (n < 1) return;
    gl.useProgram(ribbon.program);
    gl.uniformMatrix4fv(ribbon.found.camera, false, camera);
    gl.uniformMatrix4fv(ribbon.found.place, false, place);
    gl.uniform2f(ribbon.found.pixel, 2/canvas.width, 2/canvas.height);
    gl.uniform1f(ribbon.found.width, width*Math.min(window.devicePixelRatio || 1, 2));
    gl.uniform4fv(ribbon.found.colour, colour);
    gl.bindBuffer(gl.ARRAY_BUFFER, corners);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribDivisor(0, 0);
    gl.vertexAttribPointer(0, 2, gl.FLOAT, false, 8, 0);
    gl.bindBuffer(gl.ARRAY_BUFFER, line.buffer);
    for (const k of [1, 2]) {
      gl.enableVertexAttribArray(k);
      gl.vertexAttribDivisor(k, 1);
      gl.vertexAttribPointer(k, 3, gl.FLOAT, false, stride, 12*(first || 0) + 12*(k - 1));
    }
    through(colour);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, n);
    gl.vertexAttribDivisor(1, 0);
    gl.vertexAttribDivisor(2, 0);
    gl.depthMask(true);
  }

  return { gl, begin, surface, lines,
    mesh: (numbers) => ({ buffer: buffer(numbers), n: numbers.length/6 }),
    line: (numbers) => ({ buffer: buffer(numbers instanceof Float32Array ? numbers : new Float32Array(numbers)),
      n: numbers.length/3 }),
    drop: (thing) => thing && gl.deleteBuffer(thing.buffer) };
}
