// The SHA-256 of the results of fixed shots, as `hoopgen hash` prints it.
"use strict";

const Fingerprint = (() => {
  const STRIDE = 8192; // shots of a call: little memory

  /**
   * Return the fixed releases: about each centre evenly spread numbers, fractions of multiples of
   * square roots, in operations that IEEE 754 defines, as hoopgen.simulation.hoop has them.
   */
  function releases({ kinds, primes, each }) {
    const steps = primes.map(Math.sqrt);
    const states = new Float64Array(kinds.length * each * steps.length);
    kinds.forEach(([centre, spread], kind) => {
      for (let row = 0; row < each; row++) {
        const at = (kind * each + row) * steps.length;
        steps.forEach((step, k) => {
          states[at + k] = centre[k] + spread[k] * ((((row + 1) * step) % 1) - 0.5);
        });
      }
    });
    return states;
  }

  /** Yield nothing after each step, and at last the bytes that are hashed: each result of all
   * shots, with one pattern for NaN. */
  function* steps(engine, fixed, parameters, layout) {
    const states = releases(fixed);
    const results = layout.results.map(([name]) => name);
    const parts = new Map(results.map((name) => [name, []]));
    for (let at = 0; at < states.length; at += STRIDE * layout.state) {
      const some = states.slice(at, at + STRIDE * layout.state);
      const { most, limit } = fixed;
      const found = engine.simulate(some, parameters, { most, limit, results });
      for (const name of results) parts.get(name).push(canonical(found[name]));
      yield;
    }
    const all = results.flatMap((name) => parts.get(name));
    const whole = new Uint8Array(all.reduce((sum, part) => sum + part.length, 0));
    let at = 0;
    for (const part of all) {
      whole.set(part, at);
      at += part.length;
    }
    yield whole;
  }

  /** Return an array's bytes; every NaN is 0x7ff8000000000000. */
  function canonical(array) {
    if (array instanceof Float64Array) {
      const words = new BigUint64Array(array.buffer);
      array.forEach((value, k) => {
        if (Number.isNaN(value)) words[k] = 0x7ff8000000000000n;
      });
    }
    return new Uint8Array(array.buffer);
  }

  /** Return the digest, in hexadecimal digits; null where the address is not secure. */
  async function sha256(data) {
    if (!globalThis.crypto?.subtle) return null;
    const digest = new Uint8Array(await crypto.subtle.digest("SHA-256", data));
    return [...digest].map((byte) => byte.toString(16).padStart(2, "0")).join("");
  }

  return { releases, sha256, steps };
})();
