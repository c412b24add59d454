// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// Meshes made by a formula, as files: they go through the same door as files that are dropped.

type Vec = [number, number, number];

/// A subdivided icosahedron on the unit sphere.
function icosphere(level: number): { points: Vec[]; triangles: Vec[] } {
  const g = (1 + Math.sqrt(5)) / 2;
  let triangles: Vec[] = (
    "0 11 5,0 5 1,0 1 7,0 7 10,0 10 11,1 5 9,5 11 4,11 10 2,10 7 6,7 1 8," +
    "3 9 4,3 4 2,3 2 6,3 6 8,3 8 9,4 9 5,2 4 11,6 2 10,8 6 7,9 8 1"
  )
    .split(",")
    .map((t) => t.split(" ").map(Number) as Vec);
  const unit = (p: Vec): Vec => p.map((x) => x / Math.hypot(...p)) as Vec;
  const points: Vec[] = [];
  for (const [a, b] of [[-1, g], [1, g], [-1, -g], [1, -g]] as const) points.push(unit([a, b, 0]));
  for (const [a, b] of [[-1, g], [1, g], [-1, -g], [1, -g]] as const) points.push(unit([0, a, b]));
  for (const [a, b] of [[g, -1], [g, 1], [-g, -1], [-g, 1]] as const) points.push(unit([a, 0, b]));
  for (let i = 0; i < level; ++i) {
    const middle = new Map<number, number>();
    const between = (a: number, b: number): number => {
      const key = Math.min(a, b) * 1e7 + Math.max(a, b);
      let m = middle.get(key);
      if (m === undefined) {
        m = points.push(unit(points[a]!.map((x, k) => x + points[b]![k]!) as Vec)) - 1;
        middle.set(key, m);
      }
      return m;
    };
    triangles = triangles.flatMap(([a, b, c]) => {
      const [d, e, f] = [between(a, b), between(b, c), between(c, a)];
      return [
        [a, d, f],
        [d, b, e],
        [f, e, c],
        [d, e, f],
      ] as Vec[];
    });
  }
  return { points, triangles };
}

function off(points: Vec[], triangles: Vec[]): string {
  const rows = [...points.map((p) => p.join(" ")), ...triangles.map((t) => "3 " + t.join(" "))];
  return `OFF\n${points.length} ${triangles.length} 0\n${rows.join("\n")}\n`;
}

function deformed(level: number, move: (p: Vec) => Vec): string {
  const { points, triangles } = icosphere(level);
  return off(points.map(move), triangles);
}

const smooth = (t: number) => {
  const x = Math.min(1, Math.max(0, t));
  return x * x * (3 - 2 * x);
};

/// Eight arms that curl, and a head.
function octopus([x, y, z]: Vec): Vec {
  const angle = Math.atan2(z, x);
  const out = Math.hypot(x, z);
  const arm = Math.pow(0.5 + 0.5 * Math.cos(8 * angle), 1.5);
  const belt = smooth((0.2 - y) / 0.45) * smooth((y + 0.85) / 0.45); // where arms begin
  const head = smooth(y / 0.7);
  const radius = out * (0.62 + 0.2 * head + belt * (1.9 * arm - 0.12));
  const beyond = Math.max(0, radius - 0.62);
  const turn = angle + 0.5 * beyond;
  const height = y > 0 ? 1.5 * y : 0.5 * y;
  const wave = beyond * (0.62 * beyond - 0.75);
  return [radius * Math.cos(turn), height + belt * wave, radius * Math.sin(turn)];
}

/// Waves of all lengths, and craters.
function asteroid(p: Vec): Vec {
  let r = 1;
  for (let k = 1, size = 0.16; k <= 5; ++k, size *= 0.55) {
    const f = Math.pow(1.9, k);
    const [a, b, c] = [p[0] * f + 1.7 * k, p[1] * f - 2.3 * k, p[2] * f + 0.9 * k];
    r += size * (Math.sin(a) * Math.cos(b) + Math.sin(b) * Math.cos(c) + Math.sin(c) * Math.cos(a)) * 0.8;
  }
  for (let i = 0; i < 14; ++i) {
    const y = 1 - (2 * (i + 0.5)) / 14;
    const turn = 2.39996 * i * 1.7;
    const s = Math.sqrt(1 - y * y);
    const size = 0.16 + 0.2 * ((i * 7) % 5) * 0.2;
    const d = Math.acos(Math.min(1, p[0] * s * Math.cos(turn) + p[1] * y + p[2] * s * Math.sin(turn))) / size;
    r += size * (d < 1 ? 0.38 * (d * d - 1) + 0.1 : 0.1 * Math.exp(-6 * (d - 1) * (d - 1)));
  }
  return [1.25 * r * p[0], 0.9 * r * p[1], r * p[2]];
}

/// A bar with rounded edges, twisted and bent.
function bar([x, y, z]: Vec): Vec {
  const m = Math.pow(Math.pow(x, 8) + Math.pow(y, 8) + Math.pow(z, 8), 1 / 8);
  const [a, h, b] = [(0.42 * x) / m, (1.9 * y) / m, (0.42 * z) / m];
  const turn = 1.25 * h;
  const [c, s] = [Math.cos(turn), Math.sin(turn)];
  const [u, w] = [c * a - s * b, s * a + c * b];
  const bend = 0.42 * h;
  const radius = 2.4 + u;
  return [radius * Math.cos(bend) - 2.4, radius * Math.sin(bend), w];
}

export interface Example {
  name: string;
  file: string; // its name
  text(): string;
}

export const examples: Example[] = [
  { name: "Octopus", file: "octopus.off", text: () => deformed(5, octopus) },
  { name: "Asteroid", file: "asteroid.off", text: () => deformed(6, asteroid) },
  { name: "Twisted bar", file: "bar.off", text: () => deformed(5, bar) },
];

/// For tests: a closed mesh that is no sphere.
export function torus(n: number, m: number): string {
  const points: Vec[] = [];
  const triangles: Vec[] = [];
  for (let i = 0; i < n; ++i)
    for (let j = 0; j < m; ++j) {
      const [a, b] = [(2 * Math.PI * i) / n, (2 * Math.PI * j) / m];
      const r = 1 + 0.4 * Math.cos(b);
      points.push([r * Math.cos(a), 0.4 * Math.sin(b), -r * Math.sin(a)]);
      const [k, l] = [(i + 1) % n, (j + 1) % m];
      triangles.push([i * m + j, k * m + j, k * m + l], [i * m + j, k * m + l, i * m + l]);
    }
  return off(points, triangles);
}

/// For tests: a large mesh.
export const large = (level: number): string => deformed(level, asteroid);
