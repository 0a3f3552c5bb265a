// What is said of shots, in words and numbers.
"use strict";

const Words = (() => {
  const seconds = (time) => `${time.toFixed(3)} s`;
  const capital = (words) => words[0].toUpperCase() + words.slice(1);

  function fixed(value, digits) {
    return (Number(value.toFixed(digits)) + 0).toFixed(digits).replace("-", "−");
  }

  /** Return what says things of a page's shots; `scenery` is of any scene but the hoop. How
   * quantities are shown in either system of units is in `units`, a table of hoopgen's. */
  function of({ scenery, surfaces, ring_height: ringHeight, units, system: begun }) {
    let system = begun;

    /** Say values of a kind of quantity, given in SI. */
    function say(kind, ...values) {
      const { symbol, size, decimals } = units[system][kind];
      const said = values.map((value) => fixed(value / size, decimals)).join(", ");
      return /^\p{L}/u.test(symbol) ? `${said} ${symbol}` : `${said}${symbol}`;
    }

    /** Return how a kind of quantity is shown now: symbol, size, decimals. */
    const unit = (kind) => units[system][kind];

    const length = (...values) => say("length", ...values);
    const trimmed = (text) => text.replace(/\.?0+(?=\s)/, ""); // zeros that say nothing
    const round = (value) => trimmed(length(value));
    const speed = (value) => say("speed", value);
    const spin = (value) => say("spin", value);

    /** Return the step of the floor's grid, m: a round number in the units that are shown. */
    function grid() {
      const step = scenery?.step ?? 1;
      if (system === "si") return step;
      return step < 1 ? 40 * step * unit("short").size : 3 * step * unit("length").size;
    }

    /** Say the step of the floor's grid: of less than a foot in inches. */
    function gridSaid() {
      const small = system === "us" && grid() < unit("length").size;
      return trimmed(say(small ? "short" : "length", grid()));
    }

    /** Return the system of units that is not shown now. */
    function next() {
      return Object.keys(units).find((name) => name !== system);
    }

    function convert() {
      system = next();
    }

    /** Return what the button says with which units are changed. */
    function other() {
      return `Show ${units[next()].length.symbol}`;
    }

    const said = (word) => word.replaceAll("_", scenery ? " " : ", ");

    /** Return what a surface is called: of other scenes, `body-0` and so on stand for the bodies. */
    function named(surface) {
      if (surface === "end") return scenery ? "end" : "end plane";
      return scenery ? surfaces[surface.slice(5)] : surface;
    }

    function outcome(shot) {
      const [, x, y] = shot.flights.at(-1);
      const contacts = countOf(shot);
      const many = `${contacts} contact${contacts === 1 ? "" : "s"}`;
      const words = {
        capped: `${many}, and not yet at the end plane`,
        short: "never comes down through the end plane",
        lodged: `at rest or wedged after ${seconds(shot.duration)}`,
        endless: `still moving after ${seconds(shot.duration)}`,
      };
      if (scenery) {
        const ended = shot.events.at(-1)?.surface === "end";
        return ended ? `after ${seconds(shot.duration)}` : `after ${many}, ${seconds(shot.duration)}`;
      }
      const away = `${length(Math.hypot(x, y))} from the ring’s centre`;
      return words[shot.outcome] ?? `${away} after ${seconds(shot.duration)}`;
    }

    function countOf(shot) {
      return shot.events.filter((event) => event.number).length;
    }

    function kind(shot) {
      return shot.kind === "none" ? "" : ` (${said(shot.kind)})`;
    }

    /** Return what happens at a stop, the release or one of a shot's events; or after the end. */
    function stop(shot, k, time = 0) {
      if (time > shot.duration && Flight.lasts(shot) > shot.duration) {
        return "After the end: falls to the floor, not simulated";
      }
      if (k === 0) return `Release, ${seconds(0)}`;
      const { kind: what, number, surface, time: when } = shot.events[k - 1];
      const name = named(surface);
      const words = {
        roll: `Rolls on the ${name}`,
        leave: `Leaves the ${name}`,
        end: capital(surface === "end" ? name : `end, on the ${name}`),
      };
      const struck = `Contact ${number} of ${countOf(shot)}: ${name}`;
      return `${number ? struck : words[what]}, ${seconds(when)}`;
    }

    function release(shot) {
      const [, x, y, z, vx, vy, vz, wx, wy, wz] = shot.flights[0];
      const level = Math.hypot(vx, vy);
      if (scenery) {
        return [
          ["Speed", speed(Math.hypot(level, vz))],
          [`From ${scenery.axes.join(", ")}`, length(x, y, z)],
          ["Spin", spin(Math.hypot(wx, wy, wz))],
        ];
      }
      const rows = [
        ["Speed", speed(Math.hypot(level, vz))],
        ["Elevation", say("angle", Math.atan2(vz, level))],
        ["Height, distance", length(z + ringHeight, Math.hypot(x, y))],
      ];
      // Backspin turns about the level axis across the line of flight, as in hoopgen.release.
      const back = level > 0 ? (wx * vy - wy * vx) / level : 0;
      if (back) rows.push([back > 0 ? "Backspin" : "Topspin", spin(Math.abs(back))]);
      if (wz) rows.push(["Sidespin", spin(wz)]);
      return rows;
    }

    function now(shot, time) {
      const [x, y, z, vx, vy, vz, ...turning] = Flight.stateAt(shot, time);
      const above = [["Above the floor", length(z + ringHeight)]];
      return [
        [scenery ? scenery.axes.join(", ") : "x, y, z", length(x, y, z)],
        ...(scenery ? [] : above),
        ["Speed", speed(Math.hypot(vx, vy, vz))],
        ["Spin", spin(Math.hypot(...turning))],
      ];
    }

    const telling = { kind, length, named, now, other, outcome, release, round, said, say, stop, unit };
    return { ...telling, convert, grid, gridSaid };
  }

  return { capital, of, seconds };
})();
