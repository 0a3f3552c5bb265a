// The C engine and the drawing of releases as WebAssembly: arrays in, arrays out, as hoop.h and
// elementary.c say.
"use strict";

const Engine = (() => {
  const NUMBERS = {
    bool: Uint8Array,
    float64: Float64Array,
    int32: Int32Array,
    int8: Int8Array,
    uint8: Uint8Array,
  };
  const EVENT = 22; // numbers of 8 bytes: shot, surface, time, before 9, after 9, kind

  /** Return the bytes that a text in base 64 has, compressed by gzip. */
  async function bytesOf(text) {
    const packed = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  }

  /**
   * Start the first of a scene's modules that this browser takes. `modules` are {name, lanes,
   * bytes}; `layout` names the scene, and arguments, parameters and results in the order of C.
   */
  async function start(modules, layout) {
    for (const { name, lanes, bytes } of modules) {
      if (!WebAssembly.validate(bytes)) continue;
      const { instance } = await WebAssembly.instantiate(bytes);
      instance.exports._initialize();
      return of(instance.exports, layout, { name, lanes });
    }
    throw new Error("this browser runs no WebAssembly");
  }

  function of(c, layout, about) {
    const view = (type, at, size) => new type(c.memory.buffer, at, size);

    /** Return what work gives; it puts the arrays that C is given, and these are freed. */
    function using(work) {
      const held = [];
      try {
        return work(held);
      } finally {
        held.forEach(c.free);
      }
    }

    /** Return where an array begins that C is given. */
    function put(held, array) {
      const at = room(held, array.byteLength);
      view(array.constructor, at, array.length).set(array);
      return at;
    }

    /** Return where C finds values, each a number for all or an array of one for each, and how far
     * it goes on from one to the next. */
    function columns(held, values) {
      const alone = values.map((value) => typeof value === "number");
      const places = values.map((value, k) => put(held, Float64Array.from(alone[k] ? [value] : value)));
      const strides = BigInt64Array.from(alone, (one) => (one ? 0n : 1n));
      return [put(held, Uint32Array.from(places)), put(held, strides)];
    }

    function room(held, bytes) {
      const at = c.malloc(Math.max(bytes, 8));
      if (!at) throw new Error("there is no memory for so many shots");
      held.push(at);
      return at;
    }

    /**
     * Simulate shots. `states` has 9 numbers for each; `parameters` by name a number, or one for
     * each shot. Returns the wanted results by name, and with `record` the event log.
     */
    function simulate(states, parameters, { most, limit = Infinity, results, record = false }) {
      return using((held) => run(held, states, parameters, { most, limit, results, record }));
    }

    function run(held, states, parameters, { most, limit, results, record }) {
      const shots = states.length / layout.state;
      const places = layout.results.map(([name, type, width]) =>
        results.includes(name) ? room(held, shots * width * NUMBERS[type].BYTES_PER_ELEMENT) : 0,
      );
      const rows = layout.log_rows * most + 1; // of a shot's event log
      const log = record ? room(held, shots * rows * EVENT * 8) : 0;
      const counts = record ? room(held, shots * 4) : 0;
      const code = c[`${layout.scene}_simulate`](
        shots,
        put(held, states),
        ...columns(held, layout.parameters.map((name) => parameters[name])),
        0, // the ball leaves no surface
        most,
        limit,
        about.lanes,
        0, // nobody stops it
        put(held, Uint32Array.from([...places, log, counts, 0])),
      );
      if (code !== about.lanes) throw new Error(`the engine returned ${code}`);
      const found = layout.results.map(([name, type, width], k) =>
        [name, places[k] ? view(NUMBERS[type], places[k], shots * width).slice() : null],
      );
      const all = Object.fromEntries(found.filter(([, array]) => array));
      if (record) all.events = Array.from({ length: shots }, (_, k) => events(k, rows, log, counts));
      return all;
    }

    /** Return the rows of a shot's event log. */
    function events(shot, rows, log, counts) {
      const used = view(Int32Array, counts, shot + 1)[shot];
      return Array.from({ length: used }, (_, row) => {
        const at = log + 8 * EVENT * (shot * rows + row);
        const whole = (k) => Number(view(BigInt64Array, at + 8 * k, 1)[0]);
        const numbers = [...view(Float64Array, at, EVENT)];
        return {
          surface: whole(1),
          time: numbers[2],
          before: numbers.slice(3, 12),
          after: numbers.slice(12, 21),
          kind: whole(21),
        };
      });
    }

    /** Return the noise of independent variables, an array each, of shots from the first one on:
     * deviations times normal numbers of the variables' streams. */
    function noise(streams, deviations, seed, count) {
      return using((held) => {
        const factor = deviations.flatMap((_, row) => deviations.map((_, k) => Number(k === row)));
        const arrays = [BigUint64Array.from(streams, BigInt), ...[factor, deviations].map((one) => Float64Array.from(one))];
        const rows = deviations.map(() => room(held, 8 * count));
        const given = arrays.map((array) => put(held, array));
        const places = put(held, Uint32Array.from(rows));
        c.elementary_noise(rows.length, ...given, BigInt(seed), 0n, count, places, 0);
        return rows.map((row) => view(Float64Array, row, count).slice());
      });
    }

    /** Return the states of releases. `given` has by name a number, or one for each. */
    function releases(given, count, ringHeight) {
      return using((held) => {
        const size = layout.state * count;
        const states = room(held, 8 * size);
        const places = columns(held, layout.arguments.map((name) => given[name]));
        c.elementary_release_states(count, ...places, ringHeight, states, 0);
        return view(Float64Array, states, size).slice();
      });
    }

    return { ...about, noise, releases, simulate };
  }

  return { bytesOf, start };
})();
