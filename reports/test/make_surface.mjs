// Writes sample/scenes/halves/surface.glb: a block whose halves part after half a second. Two materials; each half appears by a stepped scale.
//   node make_surface.mjs OUT.glb

import { writeFileSync } from "node:fs";

const chunks = [];
const views = [];
const accessors = [];
let length = 0;

function add(array, type, componentType, extra = {}) {
  const bytes = Buffer.from(array.buffer);
  views.push({ buffer: 0, byteOffset: length, byteLength: bytes.length });
  chunks.push(bytes);
  length += bytes.length;
  const width = { SCALAR: 1, VEC3: 3 }[type];
  accessors.push({ bufferView: views.length - 1, componentType, type, count: array.length / width, ...extra });
  return accessors.length - 1;
}

const float = 5126;
const index = 5125;
const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [0.5 * (i & 1), (i >> 1) & 1, (i >> 2) & 1]);
const position = add(new Float32Array(corners.flat()), "VEC3", float, { min: [0, 0, 0], max: [0.5, 1, 1] });
const crack = add(new Uint32Array([0, 4, 6, 0, 6, 2]), "SCALAR", index); // x = 0
const outer = add(
  new Uint32Array([1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6]),
  "SCALAR",
  index,
);
const times = add(new Float32Array([0, 0.5, 1]), "SCALAR", float, { min: [0], max: [1] });
const move = (x) => add(new Float32Array([0, 0, 0, 0, 0, 0, x, 0.1, 0]), "VEC3", float);
const appear = add(new Float32Array([0, 0, 0, 1, 1, 1, 1, 1, 1]), "VEC3", float);
const primitive = (indices, material) => ({ attributes: { POSITION: position }, indices, material });
const samplers = [
  { input: times, output: move(0.3), interpolation: "LINEAR" },
  { input: times, output: move(-0.3), interpolation: "LINEAR" },
  { input: times, output: appear, interpolation: "STEP" },
];
const channel = (sampler, node, path) => ({ sampler, target: { node, path } });
const grey = { pbrMetallicRoughness: { baseColorFactor: [0.7, 0.72, 0.75, 1], metallicFactor: 0 }, doubleSided: true };
const red = { pbrMetallicRoughness: { baseColorFactor: [0.8, 0.25, 0.15, 1], metallicFactor: 0 }, doubleSided: true };
const document = {
  asset: { version: "2.0" },
  scene: 0,
  scenes: [{ nodes: [0] }],
  nodes: [{ children: [1, 3] }, { mesh: 0 }, { mesh: 0, rotation: [0, 1, 0, 0], translation: [0, 0, 1] }, { children: [2] }],
  meshes: [{ primitives: [primitive(outer, 0), primitive(crack, 1)] }],
  materials: [grey, red],
  animations: [{ samplers, channels: [channel(0, 1, "translation"), channel(1, 3, "translation"), channel(2, 1, "scale"), channel(2, 3, "scale")] }],
  buffers: [{ byteLength: length }],
  bufferViews: views,
  accessors,
};

function chunk(type, bytes, filler) {
  const padded = Buffer.concat([bytes, Buffer.alloc((4 - (bytes.length % 4)) % 4, filler)]);
  const head = Buffer.alloc(8);
  head.writeUInt32LE(padded.length, 0);
  head.write(type, 4, "latin1");
  return Buffer.concat([head, padded]);
}

const body = Buffer.concat([chunk("JSON", Buffer.from(JSON.stringify(document)), " "), chunk("BIN\0", Buffer.concat(chunks), 0)]);
const head = Buffer.alloc(12);
head.write("glTF", 0, "latin1");
head.writeUInt32LE(2, 4);
head.writeUInt32LE(12 + body.length, 8);
writeFileSync(process.argv[2], Buffer.concat([head, body]));
