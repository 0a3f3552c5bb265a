// Numbered badges over the picture: each near the contact it names, over no other.
"use strict";

const Badges = (() => {
  const SVG = "http://www.w3.org/2000/svg";
  const HERE = 0.75; // ball radii: contacts on one surface nearer together share a badge
  const [HEIGHT, GLYPH, PAD] = [20, 7.2, 8]; // px
  const [EDGE, TOP] = [6, 60]; // px left free at the edges, and for the buttons at the top
  const OFF = [30, 44, 62, 84, 110]; // px from an anchor to a place tried
  const FAR = [140, 175, 215, 260, 310, 365]; // where each of those is over another badge
  const OVER = 1e3; // what it costs to be over another badge, or out of the picture
  const ROUND = Array.from({ length: 16 }, (_, k) => (2 * Math.PI * (k + 0.5)) / 16);

  /** Return an event's number among the impacts, or what else it is. */
  function label(event) {
    return event.number ? `${event.number}` : { roll: "rolls", leave: "leaves", end: "end" }[event.kind];
  }

  /** Return what badges name: the release, runs of contacts at one place, and the end. */
  function marks(shot) {
    const found = [{ label: "release", surface: "release", at: shot.flights[0].slice(1, 4) }];
    shot.events.forEach((event) => {
      const last = found.at(-1);
      const reach = HERE * shot.parameters.ball_radius;
      const here = last.surface === event.surface && distance(last.at, event.at) < reach;
      if (here && last.to && event.number) {
        last.to = event.number;
        last.label = `${last.from}–${last.to}`;
      } else {
        const { surface, at, number } = event;
        found.push({ label: label(event), surface, at, from: number, to: number });
      }
    });
    return found;
  }

  function distance(a, b) {
    return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  }

  /**
   * Draw badges into an SVG element of the picture's size. `project` takes a point of the scene
   * to pixels, or to null behind the eye; `avoid` are pixels better left visible; `paint` gives an
   * element the colour of a surface. What is out of the picture has no badge.
   */
  function draw(svg, shown, project, avoid, paint) {
    const { clientWidth: width, clientHeight: height } = svg.parentElement;
    svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    const boxes = shown.flatMap((mark) => {
      const anchor = project(mark.at) ?? [-1, -1];
      const seen = [width, height].every((size, k) => 0 < anchor[k] && anchor[k] < size);
      const wide = Math.max(HEIGHT, GLYPH * mark.label.length + PAD);
      return seen ? [{ ...mark, anchor, wide }] : [];
    });
    place(boxes, avoid, width, height);
    const parts = [leader, badge].flatMap((make) => boxes.map((box) => paint(make(box), box.surface)));
    svg.replaceChildren(...parts);
  }

  /** Give each box a place: of those around its anchor, the one that covers least. */
  function place(boxes, avoid, width, height) {
    const placed = [];
    for (const box of boxes) {
      let least = Infinity;
      for (const off of [...OFF, ...FAR]) {
        if (off > OFF.at(-1) && least < OVER) break;
        for (const angle of ROUND) {
          const centre = [
            box.anchor[0] + (off + box.wide / 2 - HEIGHT / 2) * Math.cos(angle),
            box.anchor[1] + off * Math.sin(angle),
          ];
          const cost = off / HEIGHT + price(centre, box, placed, avoid, width, height);
          if (cost < least) [least, box.centre] = [cost, centre];
        }
      }
      placed.push(box);
    }
  }

  function price(centre, box, placed, avoid, width, height) {
    const covers = (point, wide, tall) =>
      Math.abs(point[0] - centre[0]) < wide && Math.abs(point[1] - centre[1]) < tall;
    const half = box.wide / 2;
    let cost = 0;
    if (centre[0] < half + EDGE || centre[0] > width - half - EDGE) cost += 1e6;
    if (centre[1] < TOP || centre[1] > height - HEIGHT / 2 - EDGE) cost += 1e6;
    for (const other of placed) {
      if (covers(other.centre, half + other.wide / 2 + 3, HEIGHT + 3)) cost += OVER;
      if (covers(other.anchor, half + 6, HEIGHT / 2 + 6)) cost += 20;
    }
    for (const point of avoid) if (covers(point, half + 3, HEIGHT / 2 + 3)) cost += 2;
    return cost;
  }

  function leader({ anchor, centre, surface }) {
    const group = element("g", { class: `leader ${surface}` });
    const [[x1, y1], [x2, y2]] = [anchor, centre];
    group.append(element("line", { x1, y1, x2, y2 }), element("circle", { cx: x1, cy: y1, r: 4 }));
    return group;
  }

  function badge({ centre, surface, label, wide }) {
    const group = element("g", { class: `badge ${surface}` });
    const [x, y] = [centre[0] - wide / 2, centre[1] - HEIGHT / 2];
    group.append(element("rect", { x, y, width: wide, height: HEIGHT, rx: rounding(surface) }));
    const text = element("text", { x: centre[0], y: centre[1] });
    text.textContent = label;
    group.append(text);
    return group;
  }

  /** A surface is told by the shape of its badge as well as by its colour. */
  function rounding(surface) {
    if (surface.startsWith("body-")) return HEIGHT / 2;
    return { ring: HEIGHT / 2, backboard: 0, bridge: 5 }[surface] ?? 5;
  }

  function element(name, attributes) {
    const made = document.createElementNS(SVG, name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    return made;
  }

  return { label, draw, marks };
})();
