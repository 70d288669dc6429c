// Writes the stress fields of the sample, invented: round a hole (Kirsch's, and a wave on top of them as the particles' error), or the same
// tension everywhere with next to no error.
//   node make_field.mjs sample/hole_sample/stress_field.json
//   node make_field.mjs sample/patch_sample/stress_field.json uniform

import { writeFileSync } from "node:fs";

function packed(values) {
  const scale = Math.max(...values.map(Math.abs)) / 32767 || 1;
  return { scale, data: Buffer.from(Int16Array.from(values.map((value) => Math.round(value / scale))).buffer).toString("base64") };
}

const uniform = process.argv[3] === "uniform";
const points = [];
for (let ring = 0; ring < (uniform ? 5 : 14); ++ring)
  for (let i = 0; i < 24; ++i)
    for (const z of [0.05, 0.15]) {
      const [r, angle] = [1.05 + 0.14 * ring, ((i + 0.5) / 24) * (Math.PI / 2)];
      points.push({ x: [r * Math.cos(angle), r * Math.sin(angle), z], r, angle, volume: 0.1 * r * 0.14 * (Math.PI / 48) });
    }

/// Kirsch 1898, a tension of 1 MPa along x, radius 1 m; then to the axes x and y.
function kirsch({ r, angle }) {
  const [c, s, q] = [Math.cos(2 * angle), Math.sin(2 * angle), 1 / r ** 2];
  const radial = 0.5e6 * (1 - q + (1 - 4 * q + 3 * q * q) * c);
  const hoop = 0.5e6 * (1 + q - (1 + 3 * q * q) * c);
  const shear = -0.5e6 * (1 + 2 * q - 3 * q * q) * s;
  const [mean, half] = [(radial + hoop) / 2, (radial - hoop) / 2];
  return [mean + half * c - shear * s, mean - half * c + shear * s, 0, 0, 0, half * s + shear * c];
}

const fem = points.map((point) => (uniform ? [1e6, 2e5, 0, 0, 0, 1e5] : kirsch(point)));
const size = uniform ? 1e-9 : 1;
const wave = ({ x, r }) => [3e4 * Math.sin(9 * x[0]) + 2e4 / r ** 4, 1e4 * Math.cos(7 * x[1]), 0, 0, 0, 1e4 * Math.sin(5 * x[0] * x[1])];
const difference = points.map((point) => wave(point).map((value) => size * value));
const particles = fem.map((stress, i) => stress.map((value, k) => value + difference[i][k]));
const principal = ([xx, yy, , , , xy]) => Math.max(0, (xx + yy) / 2 + Math.hypot((xx - yy) / 2, xy));
const volume = points.reduce((sum, one) => sum + one.volume, 0);
const rms = (values) => Math.sqrt(values.reduce((sum, value, i) => sum + points[i].volume * value ** 2, 0) / volume);

const measures = ["largest_principal", "xx", "yy", "zz", "yz", "xz", "xy"].map((name, k) => {
  const of = k === 0 ? principal : (stress) => stress[k - 1];
  const apart = particles.map((stress, i) => of(stress) - of(fem[i]));
  const sizes = apart.map(Math.abs);
  const largest = Math.max(...sizes);
  return { name, fem_rms: rms(fem.map(of)), difference_rms: rms(apart), difference_max: largest, at: points[sizes.indexOf(largest)].x };
});

const field = {
  schema: "cleave.stress_field/1",
  particles: "sph.corrected",
  fem: "fem.p2",
  total: points.length,
  shown: points.length,
  measures,
  position: packed(points.flatMap(({ x }) => x)),
  radius: packed(points.map((one) => Math.cbrt((3 * one.volume) / (4 * Math.PI)))),
  stress: packed(particles.flat()),
  difference: packed(difference.flat()),
};
writeFileSync(process.argv[2], JSON.stringify(field) + "\n");
