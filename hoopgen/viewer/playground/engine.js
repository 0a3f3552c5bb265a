// The C engine as WebAssembly: arrays of releases in, arrays of results out, as hoop.h says.
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
   * bytes}; `layout` names the scene, and the parameters and the results in the order of C.
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

    /** Return where an array begins that C is given; `call` frees it. */
    function put(held, array) {
      const at = room(held, array.byteLength);
      view(array.constructor, at, array.length).set(array);
      return at;
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
      const held = [];
      try {
        return run(held, states, parameters, { most, limit, results, record });
      } finally {
        held.forEach(c.free);
      }
    }

    function run(held, states, parameters, { most, limit, results, record }) {
      const shots = states.length / layout.state;
      const given = layout.parameters.map((name) => parameters[name]);
      const values = given.map((value) => put(held, Float64Array.from([value].flat())));
      const steps = given.map((value) => BigInt(Array.isArray(value)));
      const places = layout.results.map(([name, type, width]) =>
        results.includes(name) ? room(held, shots * width * NUMBERS[type].BYTES_PER_ELEMENT) : 0,
      );
      const rows = layout.log_rows * most + 1; // of a shot's event log
      const log = record ? room(held, shots * rows * EVENT * 8) : 0;
      const counts = record ? room(held, shots * 4) : 0;
      const code = c[`${layout.scene}_simulate`](
        shots,
        put(held, states),
        put(held, Uint32Array.from(values)),
        put(held, BigInt64Array.from(steps)),
        0, // the ball leaves no surface
        most,
        limit,
        about.lanes,
        0, // nobody stops it
        put(held, Uint32Array.from([...places, log, counts])),
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

    /** Return the results of an elementary function of arrays: the bits of Python. */
    function compute(name, ...columns) {
      const held = [];
      try {
        const size = columns[0].length;
        const given = columns.map((column) => put(held, Float64Array.from(column)));
        const results = layout.functions[name].map(() => room(held, 8 * size));
        const [from, to] = [given, results].map((places) => put(held, Uint32Array.from(places)));
        const number = Object.keys(layout.functions).indexOf(name);
        if (c.elementary_compute(number, size, from, to, 0) < 0) throw new Error(`no ${name}`);
        return results.map((place) => view(Float64Array, place, size).slice());
      } finally {
        held.forEach(c.free);
      }
    }

    return { ...about, simulate, compute };
  }

  return { bytesOf, start };
})();
