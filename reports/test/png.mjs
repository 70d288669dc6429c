// Just enough PNG (8 bits, RGB or RGBA, not interlaced) to tell a drawn page from a blank one.

import { inflateSync } from "node:zlib";

function paeth(a, b, c) {
  const p = a + b - c;
  const [pa, pb, pc] = [Math.abs(p - a), Math.abs(p - b), Math.abs(p - c)];
  return pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
}

/// One row of bytes: adds to each the guess of the row's filter, made from the bytes to its left and above.
function unfilter_row(filter, row, above, channels) {
  for (let x = 0; x < row.length; ++x) {
    const left = x >= channels ? row[x - channels] : 0;
    if (filter === 1) row[x] += left;
    else if (filter === 2) row[x] += above[x];
    else if (filter === 3) row[x] += (left + above[x]) >> 1;
    else if (filter === 4) row[x] += paeth(left, above[x], x >= channels ? above[x - channels] : 0);
  }
}

function rows_of(bytes, width, height, channels) {
  const stride = width * channels;
  const rows = [];
  let above = new Uint8Array(stride);
  for (let y = 0; y < height; ++y) {
    const row = new Uint8Array(bytes.subarray(y * (stride + 1) + 1, (y + 1) * (stride + 1)));
    unfilter_row(bytes[y * (stride + 1)], row, above, channels);
    rows.push(row);
    above = row;
  }
  return rows;
}

/// { width, height, colours, drawn }: number of different colours, and the share of pixels that are not of the commonest one
/// (every second pixel of every second row is looked at).
export function describe_png(file) {
  const [width, height, depth, kind] = [file.readUInt32BE(16), file.readUInt32BE(20), file[24], file[25]];
  if (depth !== 8 || (kind !== 2 && kind !== 6)) throw new Error(`unexpected PNG: depth ${depth}, colour type ${kind}`);
  const parts = [];
  for (let at = 8; at < file.length; at += 12 + file.readUInt32BE(at)) {
    if (file.toString("latin1", at + 4, at + 8) === "IDAT") parts.push(file.subarray(at + 8, at + 8 + file.readUInt32BE(at)));
  }
  const channels = kind === 2 ? 3 : 4;
  const counts = new Map();
  let seen = 0;
  for (const row of rows_of(inflateSync(Buffer.concat(parts)), width, height, channels).filter((_, y) => y % 2 === 0)) {
    for (let i = 0; i < row.length; i += 2 * channels, ++seen) {
      const colour = (row[i] << 16) | (row[i + 1] << 8) | row[i + 2];
      counts.set(colour, (counts.get(colour) ?? 0) + 1);
    }
  }
  return { width, height, colours: counts.size, drawn: 1 - Math.max(...counts.values()) / seen };
}
