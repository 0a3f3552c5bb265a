// Pictures of many throws on canvases: the map, where flights come down to the ring, and where
// misses are caught.
"use strict";

const Charts = (() => {
  const style = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

  /** Return a canvas's context and its size in px, cleared, sharp on every screen. */
  function begin(canvas) {
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    const dense = Math.min(window.devicePixelRatio || 1, 2);
    [canvas.width, canvas.height] = [Math.round(width * dense), Math.round(height * dense)];
    const context = canvas.getContext("2d", { willReadFrequently: true }); // pixels are put there
    context.setTransform(dense, 0, 0, dense, 0, 0);
    context.font = "12px system-ui, sans-serif";
    return { context, width, height };
  }

  function circle(context, [x, y], radius, colour, wide) {
    context.beginPath();
    context.arc(x, y, radius, 0, 2 * Math.PI);
    context.strokeStyle = colour;
    context.lineWidth = wide;
    context.stroke();
  }

  function line(context, points, colour, wide) {
    context.beginPath();
    points.forEach(([x, y], k) => (k ? context.lineTo(x, y) : context.moveTo(x, y)));
    context.strokeStyle = colour;
    context.lineWidth = wide;
    context.stroke();
  }

  /** Put squares at places onto an empty canvas, layer over layer, see-through by a share: many on
   * each other are dense. A layer is {colour, wanted}, and `wanted` is told the place's row. They are
   * put as pixels, since thousands of shapes keep a browser busy. */
  function dots(context, places, { x: xOf, y: yOf }, size, share, layers) {
    const { width, height } = context.canvas;
    const { a: dense } = context.getTransform();
    const side = Math.round(size * dense);
    if (!width || !height) return; // it is not seen
    const image = new ImageData(width, height);
    const { data } = image;
    for (const { colour, wanted } of layers) {
      const ink = colour.match(/[\da-f]{2}/gi).map((digits) => Number.parseInt(digits, 16));
      for (let row = 0; row < places.length / 2; row++) {
        if (Number.isNaN(places[2 * row]) || !wanted(row)) continue;
        const left = Math.round(dense * xOf(places[2 * row + 1]) - side / 2);
        const top = Math.round(dense * yOf(places[2 * row]) - side / 2);
        for (let y = Math.max(top, 0); y < Math.min(top + side, height); y++) {
          for (let x = Math.max(left, 0); x < Math.min(left + side, width); x++) {
            const at = 4 * (y * width + x);
            const rest = (1 - share) * data[at + 3];
            const whole = 255 * share + rest;
            for (let k = 0; k < 3; k++) data[at + k] = (255 * share * ink[k] + rest * data[at + k]) / whole;
            data[at + 3] = whole;
          }
        }
      }
    }
    context.putImageData(image, 0, 0);
  }

  /** Return a view from above with the board at the top: x, y in m to px, to scale. */
  function above(width, height, [low, high]) {
    const scale = Math.min(height / (high - low), width / (high - low));
    const top = (height - scale * (high - low)) / 2;
    const [xOf, yOf] = [(y) => width / 2 + scale * y, (x) => top + scale * (x - low)];
    return { scale, x: xOf, y: yOf, project: (x, y) => [xOf(y), yOf(x)] };
  }

  function hoop(context, { project, scale }, sizes, sight) {
    const { board_distance: back, board_half_width: half, ring_radius: radius } = sizes;
    line(context, [project(-back, -half), project(-back, half)], style("--backboard-line"), 3);
    circle(context, project(0, 0), scale * radius, style("--ring"), sight);
  }

  /** Return how far from the ring's centre nearly all places are, m, or a bound on what is drawn. */
  function reachOf(places) {
    const away = places.filter((value) => !Number.isNaN(value)).map(Math.abs).sort();
    return Math.min(1.1 * (away[Math.floor(0.99 * away.length)] ?? 0), 4);
  }

  /** Draw where flights come down through the ring's plane as if they touched nothing. */
  function entries(canvas, { entries: places, outcome }, sizes, made) {
    const { context, width, height } = begin(canvas);
    const reach = Math.max(2.2 * sizes.ring_radius, reachOf(places));
    const seen = above(width, height, [-reach, reach]);
    dots(context, places, seen, 2, 0.5, [
      { colour: style("--ink-1"), wanted: (row) => outcome[row] !== made },
      { colour: style("--ink-0"), wanted: (row) => outcome[row] === made },
    ]);
    hoop(context, seen, sizes, 2.5);
  }

  /** Draw where misses come down to the height at which rebounds are caught. */
  function landings(canvas, { landings: places }, sizes, shooter, court) {
    const { context, width, height } = begin(canvas);
    const seen = above(width, height, [-1.6, 4.4]);
    dots(context, places, seen, 2, 0.35, [{ colour: style("--ink-1"), wanted: () => true }]);
    for (const drawn of court) {
      line(context, drawn.map(([x, y]) => seen.project(x, y)), style("--floor-line"), 1.25);
    }
    hoop(context, seen, sizes, 2);
    circle(context, seen.project(...shooter), 5, style("--path"), 2.5);
  }

  const PAD = { left: 46, right: 10, top: 8, bottom: 38 }; // px about the map

  /** Draw a map of classes; `inkOf(outcome, kind)` is [r, g, b, 255], `at` the shot's speed and
   * elevation, and `axes` have {name, symbol, size} for each axis. */
  function map(canvas, { window, size: [wide, high], outcome, kinds }, inkOf, at, axes) {
    const { context, width, height } = begin(canvas);
    const image = new ImageData(wide, high);
    outcome.forEach((end, row) => {
      const up = high - 1 - Math.floor(row / wide);
      image.data.set(inkOf(end, kinds[row]), 4 * (up * wide + (row % wide)));
    });
    const cells = document.createElement("canvas");
    [cells.width, cells.height] = [wide, high];
    cells.getContext("2d").putImageData(image, 0, 0);
    const box = [PAD.left, PAD.top, width - PAD.left - PAD.right, height - PAD.top - PAD.bottom];
    context.imageSmoothingEnabled = false;
    context.drawImage(cells, ...box);
    ticks(context, window, axes, box);
    const [x, y] = at.map((value, k) => {
      const share = (value - window[k][0]) / (window[k][1] - window[k][0]);
      return k ? box[1] + box[3] * (1 - share) : box[0] + box[2] * share;
    });
    circle(context, [x, y], 6, "#FFFFFF", 4);
    circle(context, [x, y], 6, "#000000", 1.75);
  }

  function ticks(context, window, axes, [left, top, width, height]) {
    context.fillStyle = context.strokeStyle = style("--soft");
    axes.forEach(({ name, symbol, size }, k) => {
      const [low, high] = window[k].map((value) => value / size);
      const step = nice((high - low) / 4);
      const text = `${name}, ${symbol}`;
      for (let value = Math.ceil(low / step) * step; value <= high; value += step) {
        const share = (value - low) / (high - low);
        const label = `${Number(value.toFixed(6))}`;
        context.textAlign = k ? "right" : "center";
        context.textBaseline = k ? "middle" : "top";
        if (k) context.fillText(label, left - 6, top + height * (1 - share));
        else context.fillText(label, left + width * share, top + height + 5);
      }
      context.save();
      context.textAlign = "center";
      context.textBaseline = k ? "top" : "bottom";
      if (k) context.translate(2, top + height / 2);
      else context.translate(left + width / 2, top + height + PAD.bottom - 1);
      if (k) context.rotate(-Math.PI / 2);
      context.fillText(text, 0, 0);
      context.restore();
    });
  }

  /** Return the nearest of 1, 2, 5, 10, ... to a step. */
  function nice(step) {
    const power = 10 ** Math.floor(Math.log10(step));
    return [1, 2, 5, 10].map((digit) => digit * power).find((one) => one >= step * 0.99);
  }

  /** Return the speed and the elevation at a place of a map's canvas, px; null beside it. */
  function mapAt(canvas, window, x, y) {
    const wide = canvas.clientWidth - PAD.left - PAD.right;
    const high = canvas.clientHeight - PAD.top - PAD.bottom;
    const shares = [(x - PAD.left) / wide, 1 - (y - PAD.top) / high];
    if (shares.some((share) => share < 0 || share > 1)) return null;
    return shares.map((share, k) => window[k][0] + share * (window[k][1] - window[k][0]));
  }

  return { entries, landings, map, mapAt };
})();
