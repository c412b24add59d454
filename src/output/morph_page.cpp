// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "output/morph_page.h"

#include "input/binary.h"

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace tool {
namespace {

/// What draws: reads `page`, { vertices, faces, frames, data }. Data are the frames, three 16-bit numbers per vertex,
/// then three 32-bit numbers per face, the lowest bytes first.
const char* const script = R"(
const bytes = Uint8Array.from(atob(page.data), c => c.charCodeAt(0)).buffer;
const frameSize = 3 * page.vertices;
const frames = [];
for (let k = 0; k < page.frames; ++k) frames.push(new Uint16Array(bytes, 2 * k * frameSize, frameSize));
const indexStart = 4 * Math.ceil(page.frames * frameSize / 2);
const indices = new Uint32Array(bytes, indexStart, 3 * page.faces);
const canvas = document.querySelector('canvas');
const slider = document.querySelector('input');
const gl = canvas.getContext('webgl2');
if (!gl) document.body.textContent = 'This page needs WebGL 2.';
const shader = (type, text) => {
  const s = gl.createShader(type);
  gl.shaderSource(s, text);
  gl.compileShader(s);
  return s;
};
const program = gl.createProgram();
gl.attachShader(program, shader(gl.VERTEX_SHADER, `#version 300 es
  in vec3 a, b;
  uniform float t, aspect;
  uniform mat3 turn;
  out vec3 place;
  void main() {
    place = turn * (2.0 * mix(a, b, t) - 1.0);
    gl_Position = vec4(place.x / max(aspect, 1.0), place.y * min(aspect, 1.0), -place.z / 4.0, 1.2);
  }`));
gl.attachShader(program, shader(gl.FRAGMENT_SHADER, `#version 300 es
  precision highp float;
  in vec3 place;
  out vec4 colour;
  void main() {
    vec3 n = normalize(cross(dFdx(place), dFdy(place)));
    float light = 0.25 + 0.75 * max(0.0, dot(n, normalize(vec3(0.3, 0.5, 1.0))));
    colour = vec4(light * vec3(0.85, 0.78, 0.66), 1.0);
  }`));
gl.linkProgram(program);
gl.useProgram(program);
gl.enable(gl.DEPTH_TEST);
const buffers = frames.map(f => {
  const buffer = gl.createBuffer();
  gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
  gl.bufferData(gl.ARRAY_BUFFER, f, gl.STATIC_DRAW);
  return buffer;
});
gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.STATIC_DRAW);
const times = (p, q) => p.map((_, i) => [0, 1, 2].reduce((s, k) => s + p[i % 3 + 3 * k] * q[k + 3 * Math.floor(i / 3)], 0));
let turn = [1, 0, 0, 0, 1, 0, 0, 0, 1];
canvas.onpointerdown = e => canvas.setPointerCapture(e.pointerId);
canvas.onpointermove = e => {
  if (!e.buttons) return;
  const [cx, sx, cy, sy] = [Math.cos(e.movementX / 150), Math.sin(e.movementX / 150),
                            Math.cos(e.movementY / 150), Math.sin(e.movementY / 150)];
  turn = times([cx, 0, -sx, 0, 1, 0, sx, 0, cx], times([1, 0, 0, 0, cy, sy, 0, -sy, cy], turn));
};
let isPlaying = true;
slider.oninput = () => { isPlaying = false; };
document.querySelector('button').onclick = () => { isPlaying = !isPlaying; };
const draw = now => {
  if (isPlaying) slider.value = (1 - Math.cos(now / 1500)) / 2;
  canvas.width = canvas.clientWidth * devicePixelRatio;
  canvas.height = canvas.clientHeight * devicePixelRatio;
  gl.viewport(0, 0, canvas.width, canvas.height);
  gl.clearColor(1, 1, 1, 1);
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  const at = slider.value * (page.frames - 1);
  const k = Math.min(Math.floor(at), page.frames - 2);
  ['a', 'b'].forEach((name, i) => {
    const place = gl.getAttribLocation(program, name);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffers[k + i]);
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, 3, gl.UNSIGNED_SHORT, true, 0, 0);
  });
  gl.uniform1f(gl.getUniformLocation(program, 't'), at - k);
  gl.uniform1f(gl.getUniformLocation(program, 'aspect'), canvas.width / canvas.height);
  gl.uniformMatrix3fv(gl.getUniformLocation(program, 'turn'), false, turn);
  gl.drawElements(gl.TRIANGLES, 3 * page.faces, gl.UNSIGNED_INT, 0);
  requestAnimationFrame(draw);
};
requestAnimationFrame(draw);
)";

} // namespace

void write_morph_page(std::ostream& out, const std::string& title, const Mesh& mesh,
                      const std::vector<std::vector<Point>>& frames)
{
  std::array<double, 3> low, high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for(const auto& points : frames)
    for(const Point& p : points)
      for(std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], p[k]);
        high[k] = std::max(high[k], p[k]);
      }
  const double size = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2], 1e-300});
  std::string bytes;
  const auto add = [&bytes](long number, int length) {
    for(int byte = 0; byte < length; ++byte)
      bytes += static_cast<char>(number >> 8 * byte & 255);
  };
  for(const auto& points : frames)
    for(const Point& p : points)
      for(std::size_t k = 0; k < 3; ++k)
        add(std::lround(65535 * (0.5 + (p[k] / 2 - low[k] / 4 - high[k] / 4) * 2 / size)), 2);
  bytes.append((4 - bytes.size() % 4) % 4, '\0');
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    for(int v : mesh.triangle(f))
      add(v, 4);

  std::string name = title;
  for(const auto& [from, to] : {std::pair("&", "&amp;"), std::pair("<", "&lt;"), std::pair(">", "&gt;")})
    boost::replace_all(name, from, to);
  out << "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>" << name
      << "</title>\n<style>\n"
         "body { margin: 0; font: 14px sans-serif }\n"
         "canvas { display: block; width: 100vw; height: calc(100vh - 40px) }\n"
         "footer { height: 40px; display: flex; gap: 1em; align-items: center; padding: 0 1em }\n"
         "input { flex: 1 }\n"
         "</style>\n<canvas></canvas>\n<footer>"
      << name
      << "<button>play / stop</button><input type=\"range\" min=\"0\" max=\"1\" step=\"any\" value=\"0\" "
         "aria-label=\"time\"></footer>\n<script>\nconst page = { vertices: "
      << mesh.number_of_vertices() << ", faces: " << mesh.number_of_faces() << ", frames: " << frames.size()
      << ", data: '" << to_base64(bytes) << "' };" << script << "</script>\n</html>\n";
}

} // namespace tool
