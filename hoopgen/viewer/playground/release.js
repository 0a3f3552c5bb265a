// Releases and their scatter, kinds of shots, and the interval of a share: as hoopgen has them.
"use strict";

const Release = (() => {
  const ARGUMENTS = "speed elevation azimuth backspin sidespin height distance angle".split(" ");

  /** Return the states of releases, 9 numbers each: `hoopgen.release`, its operations in their
   * order. Some arguments have a column of values, the others are those of one release; lengths
   * in m, angles in rad. */
  function states(release, columns, count, engine, ringHeight) {
    const column = (name) => columns[name] ?? new Float64Array(count).fill(release[name]);
    const all = Object.fromEntries(ARGUMENTS.map((name) => [name, column(name)]));
    const heading = all.azimuth.map((azimuth, row) => azimuth + all.angle[row]);
    const [aside, before] = engine.compute("sine_cosine", heading);
    const [rise, flat] = engine.compute("sine_cosine", all.elevation);
    const [left, front] = engine.compute("sine_cosine", all.angle);
    const found = new Float64Array(9 * count);
    for (let row = 0; row < count; row++) {
      const [speed, spin, distance] = [all.speed[row], all.backspin[row], all.distance[row]];
      const [aheadX, aheadY] = [-before[row], -aside[row]];
      const fast = speed < 0 ? NaN : speed; // an angle gives the direction
      const far = distance < 0 ? NaN : distance;
      const level = fast * flat[row];
      const state = [far * front[row], far * left[row], all.height[row] - ringHeight];
      state.push(level * aheadX, level * aheadY, fast * rise[row]);
      state.push(spin * aheadY, spin * -aheadX, all.sidespin[row]);
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

  /** Return the ends of Wilson's score interval of a share; z is the normal quantile. */
  function wilson(made, shots, z) {
    if (!shots) return [0, 1];
    const half = z * Math.sqrt((made * (shots - made)) / shots + 0.25 * z * z);
    const [middle, whole] = [made + 0.5 * z * z, shots + z * z];
    return [made > 0 ? (middle - half) / whole : 0, made < shots ? (middle + half) / whole : 1];
  }

  return { ARGUMENTS, kinds, normals, states, wilson };
})();
