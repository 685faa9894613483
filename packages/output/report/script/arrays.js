// SPDX-License-Identifier: BSD-3-Clause
// Arrays of the page, and colours.

const unpacked = new Map();
/** The bytes of an array of the page. */
function bytesOf(name) {
  if (!unpacked.has(name)) unpacked.set(name, unpack(document.getElementById(name).textContent));
  return unpacked.get(name);
}
async function unpack(base64) {
  const text = atob(base64), bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Viridis (S. van der Walt and N. Smith, CC0), in 16 equal parts: light grows evenly, for all kinds of sight.
const viridis = ("440154 48186a 472d7b 424086 3b528b 33638d 2c728e 26828e 21918c 1fa088 28ae80 3fbc73 5ec962 84d44b addc30 " +
  "d8e219 fde725").split(" ").map((hex) => [0, 2, 4].map((at) => parseInt(hex.slice(at, at + 2), 16)));
const colours = Array.from({ length: 256 }, (_, i) => {
  const place = (i / 255) * 16, n = Math.min(15, Math.floor(place));
  return viridis[n].map((low, c) => Math.round(low + (viridis[n + 1][c] - low) * (place - n)));
});
const gradient = `linear-gradient(to right, ${viridis.map((c) => `rgb(${c})`).join(", ")})`;
// Materials, after M. Okabe and K. Ito: told apart by all kinds of sight, by light too.
const materialColours = [[233, 222, 196], [204, 85, 34], [0, 114, 178], [0, 158, 115], [204, 121, 167], [86, 180, 233], [240, 228, 66], [90, 90, 90]];
const materialColour = (m) => materialColours[m % materialColours.length];
