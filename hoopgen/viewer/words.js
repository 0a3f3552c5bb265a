// What is said of shots, in words and numbers.
"use strict";

const Words = (() => {
  const seconds = (time) => `${time.toFixed(3)} s`;
  const metres = (length) => `${length.toFixed(2)} m`;
  const hertz = (rate) => `${(rate / (2 * Math.PI)).toFixed(2)} Hz`;
  const degrees = (angle) => `${((180 / Math.PI) * angle).toFixed(1)}°`;
  const place = (point) => `${point.map((value) => fixed(value, 3)).join(", ")} m`;
  const capital = (words) => words[0].toUpperCase() + words.slice(1);

  function fixed(value, digits) {
    return (Number(value.toFixed(digits)) + 0).toFixed(digits).replace("-", "−");
  }

  /** Return what says things of a page's shots; `scenery` is of any scene but the hoop. */
  function of({ scenery, surfaces, ring_height: ringHeight }) {
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
      };
      if (scenery) {
        const ended = shot.events.at(-1)?.surface === "end";
        return ended ? `after ${seconds(shot.duration)}` : `after ${many}, ${seconds(shot.duration)}`;
      }
      const away = `${Math.hypot(x, y).toFixed(3)} m from the ring’s centre`;
      return words[shot.outcome] ?? `${away} after ${seconds(shot.duration)}`;
    }

    function countOf(shot) {
      return shot.events.filter((event) => event.number).length;
    }

    function kind(shot) {
      return shot.kind === "none" ? "" : ` (${said(shot.kind)})`;
    }

    /** Return what happens at a stop: the release, or one of a shot's events. */
    function stop(shot, k) {
      if (k === 0) return `Release, ${seconds(0)}`;
      const { kind: what, number, surface, time } = shot.events[k - 1];
      const name = named(surface);
      const words = {
        roll: `Rolls on the ${name}`,
        leave: `Leaves the ${name}`,
        end: capital(surface === "end" ? name : `end, on the ${name}`),
      };
      const struck = `Contact ${number} of ${countOf(shot)}: ${name}`;
      return `${number ? struck : words[what]}, ${seconds(time)}`;
    }

    function release(shot) {
      const [, x, y, z, vx, vy, vz, wx, wy, wz] = shot.flights[0];
      const level = Math.hypot(vx, vy);
      if (scenery) {
        return [
          ["Speed", `${Math.hypot(level, vz).toFixed(3)} m/s`],
          [`From ${scenery.axes.join(", ")}`, place([x, y, z])],
          ["Spin", hertz(Math.hypot(wx, wy, wz))],
        ];
      }
      const rows = [
        ["Speed", `${Math.hypot(level, vz).toFixed(3)} m/s`],
        ["Elevation", degrees(Math.atan2(vz, level))],
        ["Height, distance", `${metres(z + ringHeight)}, ${metres(Math.hypot(x, y))}`],
      ];
      // Backspin turns about the level axis across the line of flight, as in hoopgen.release.
      const back = level > 0 ? (wx * vy - wy * vx) / level : 0;
      if (back) rows.push([back > 0 ? "Backspin" : "Topspin", hertz(Math.abs(back))]);
      if (wz) rows.push(["Sidespin", hertz(wz)]);
      return rows;
    }

    function now(shot, time) {
      const [x, y, z, vx, vy, vz, ...spin] = Flight.stateAt(shot, time);
      const above = [["Above the floor", metres(z + ringHeight)]];
      return [
        [scenery ? scenery.axes.join(", ") : "x, y, z", place([x, y, z])],
        ...(scenery ? [] : above),
        ["Speed", `${Math.hypot(vx, vy, vz).toFixed(2)} m/s`],
        ["Spin", hertz(Math.hypot(...spin))],
      ];
    }

    return { kind, named, now, outcome, release, said, stop };
  }

  return { capital, of, seconds };
})();
