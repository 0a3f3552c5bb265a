// The floor plan: the court from above with the shooter, who is dragged or moved by arrow keys.
"use strict";

const Plan = (() => {
  const SVG = "http://www.w3.org/2000/svg";
  const STEP = 0.1; // m, of an arrow key
  const SEEN = { back: -1.9, front: 10.2, half: 7.8 }; // m
  const KEYS = { ArrowUp: [-1, 0], ArrowDown: [1, 0], ArrowLeft: [0, -1], ArrowRight: [0, 1] };

  function element(name, attributes) {
    const made = document.createElementNS(SVG, name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    return made;
  }

  /** Set up a plan; `move(x, y, done)` is told where the shooter goes, m. The board is at the top. */
  function create(svg, move) {
    const { back, front, half } = SEEN;
    svg.setAttribute("viewBox", `${-half} ${back} ${2 * half} ${front - back}`);
    const [lines, hoop] = [element("g", { class: "lines" }), element("g", { class: "hoop" })];
    const shooter = element("g", { class: "shooter" });
    const ball = element("circle", { r: 0.36 });
    const aim = element("line", { class: "aim" });
    shooter.append(element("circle", { r: 1.1, class: "grip" }), ball);
    svg.append(lines, hoop, aim, shooter);
    let at = [0, 0];

    function place(event) {
      const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
      return [Math.min(Math.max(y, back + 0.2), front - 0.2), Math.min(Math.max(x, 0.2 - half), half - 0.2)];
    }

    svg.addEventListener("pointerdown", (event) => {
      svg.setPointerCapture(event.pointerId);
      svg.focus();
      event.preventDefault();
      move(...place(event), false);
    });
    svg.addEventListener("pointermove", (event) => {
      if (svg.hasPointerCapture(event.pointerId)) move(...place(event), false);
    });
    svg.addEventListener("pointerup", (event) => move(...place(event), true));
    svg.addEventListener("keydown", (event) => {
      const way = KEYS[event.key];
      if (!way || event.shiftKey) return;
      event.preventDefault();
      event.stopPropagation();
      move(at[0] + STEP * way[0], at[1] + STEP * way[1], true);
    });

    /** Draw the shooter at x, y, m, the line of the throw, and the court. */
    function draw([x, y], heading, sizes, court) {
      at = [x, y];
      const path = (points) => points.map(([px, py], k) => `${k ? "L" : "M"}${py} ${px}`).join("");
      lines.replaceChildren(...court.map((points) => element("path", { d: path(points) })));
      const { board_distance: distance, board_half_width: wide, ring_radius: r } = sizes;
      hoop.replaceChildren(
        element("path", { d: `M${-wide} ${-distance}H${wide}`, class: "board" }),
        element("circle", { r, class: "rim" }),
      );
      shooter.setAttribute("transform", `translate(${y} ${x})`);
      const reach = Math.hypot(x, y);
      const [x2, y2] = [y - reach * Math.sin(heading), x - reach * Math.cos(heading)];
      for (const [key, value] of Object.entries({ x1: y, y1: x, x2, y2 })) aim.setAttribute(key, value);
    }

    return { draw };
  }

  return { create };
})();
