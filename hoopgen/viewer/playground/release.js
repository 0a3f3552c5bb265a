// Releases and their scatter, and kinds of shots, as hoopgen has them.
"use strict";

const Release = (() => {
  const ARGUMENTS = "speed elevation azimuth backspin sidespin height distance angle".split(" ");

  /** Return the states of releases, 9 numbers each, as `hoopgen.release` has them. Some arguments
   * have a column of values, the others are those of one release; lengths in m, angles in rad.
   * `about` has the ring's height, and the names of arguments that are never negative. */
  function states(release, columns, count, engine, { ring_height: ringHeight, from_zero: fromZero }) {
    const column = (name) => columns[name] ?? new Float64Array(count).fill(release[name]);
    const all = Object.fromEntries(ARGUMENTS.map((name) => [name, column(name)]));
    for (const name of fromZero) all[name] = all[name].map((value) => (value < 0 ? NaN : value));
    const heading = all.azimuth.map((azimuth, row) => release_heading(azimuth, all.angle[row])[0]);
    const turns = [heading, all.elevation, all.angle].flatMap((angle) => engine.compute("sine_cosine", angle));
    const { speed, backspin, sidespin, height, distance } = all;
    const found = new Float64Array(9 * count);
    for (let row = 0; row < count; row++) {
      const own = [speed[row], backspin[row], sidespin[row], height[row], distance[row]];
      const state = release_state(...own, ringHeight, ...turns.map((turn) => turn[row]));
      found.set(state.map((value) => value + 0), 9 * row); // no negative zeros
    }
    return found;
  }

  /** Return standard normal numbers as `hoopgen.Scatter` draws them: Philox 4×64 with ten rounds
   * (Salmon et al. 2011), keyed by the seed and a stream, and the quantile of each number. */
  function normals(count, seed, stream, engine) {
    const [mask, bits] = [(1n << 64n) - 1n, 64n];
    const [first, second] = [0xd2e7470ee14c6c93n, 0xca5a826395121157n];
    const [weyl, other] = [0x9e3779b97f4a7c15n, 0xbb67ae8584caa73bn];
    const numbers = new Float64Array(count);
    for (let block = 0; 4 * block < count; block++) {
      let [a, b, c, d] = [BigInt(block + 1), 0n, 0n, 0n];
      let [key, next] = [BigInt(seed), BigInt(stream)];
      for (let round = 0; round < 10; round++) {
        const [one, two] = [first * a, second * c];
        [a, b, c, d] = [(two >> bits) ^ b ^ key, two & mask, (one >> bits) ^ d ^ next, one & mask];
        [key, next] = [(key + weyl) & mask, (next + other) & mask];
      }
      [a, b, c, d].forEach((word, k) => {
        if (4 * block + k < count) numbers[4 * block + k] = (Number(word >> 12n) + 0.5) * 2 ** -52;
      });
    }
    return engine.compute("normal_quantile", numbers)[0];
  }

  /** Return the kind of each shot, by the table of hoopgen.hoop.kinds. */
  function kinds({ outcome, counts, first }, { table, bodies }) {
    const [ring, board, bridge] = ["ring", "backboard", "bridge"].map((name) => bodies.indexOf(name));
    return outcome.map((end, row) => {
      const touched = (body) => counts[bodies.length * row + body] > 0;
      const frame = touched(ring) || touched(bridge);
      return table[touched(board) * 1 + frame * 2 + (first[row] === board) * 4][end];
    });
  }

  return { ARGUMENTS, kinds, normals, states };
})();
