// What is seen: hoop, floor, ball and paths, to scale, in metres, z up, for three.js.
"use strict";

const Scene = (() => {
  const GLASS = 0.0127; // m, thickness of the board as drawn where the model knows its front only
  const TARGET = { halfWidth: 0.3048, height: 0.4572, stroke: 0.0508 }; // m, 24 in × 18 in
  const BEAT = 0.1; // s between the dots on a path; more where they would be too many
  const BEATS = 100;
  const LINES = 100; // of the floor's grid on each side of the middle

  /** Return the colours of the page's style, as they are now, by name; those of a list too. */
  function colours(others) {
    const style = getComputedStyle(document.documentElement);
    const names = "path ball seam plain-ball plain-ball-edge ring backboard bridge end floor glass";
    return Object.fromEntries(
      [...names.split(" "), "faint", "paper", ...others].map((name) => [name, style.getPropertyValue(`--${name}`).trim()]),
    );
  }

  /** Return the ring, the backboard, the bridge and the ring in the end plane. */
  function hoop(parameters, colour) {
    const group = new THREE.Group();
    group.add(ring(parameters, colour), ...board(parameters, colour), bridge(parameters, colour));
    const rim = circle(parameters.ring_radius, -parameters.end_depth);
    group.add(line(rim, { color: colour.end, linewidth: 1.25, opacity: 0.7 }));
    return group;
  }

  /** Return the bodies of any other scene, each a mesh seen from the side that is touched. */
  function bodies(scenery, colour) {
    const group = new THREE.Group();
    for (const [k, body] of scenery.bodies.entries()) {
      const ink = colour[`face-${k}`];
      const corners = body.points.map((point) => new THREE.Vector3(...point));
      const geometry = new THREE.BufferGeometry().setFromPoints(corners);
      geometry.setIndex(body.triangles);
      geometry.computeVertexNormals();
      const mesh = solid(geometry, ink, 0.6);
      if (body.flat) {
        const pale = { transparent: true, opacity: 0.22, depthWrite: false };
        mesh.material = new THREE.MeshBasicMaterial({ color: ink, ...pale });
        mesh.renderOrder = -1; // under what stands on it
      }
      if (body.inside) mesh.material.color.lerp(new THREE.Color(colour.paper), 0.3); // paths before it
      if (body.flat || body.inside) mesh.castShadow = mesh.receiveShadow = false;
      if (body.points.length) group.add(mesh);
      if (body.rims.length) group.add(lines(body.rims, { color: ink, linewidth: 1 }));
      if (body.lines.length) group.add(lines(body.lines, { color: ink, linewidth: 3 }));
    }
    const faint = { color: colour.end, linewidth: 1.25, opacity: 0.7 };
    if (scenery.ends.length) group.add(lines(scenery.ends, faint));
    return group;
  }

  /** Return the net and the court's lines, faint and dashed: nothing simulates them. */
  function ghost({ net, lines: floor }, colour) {
    const faint = { color: colour.faint, depthWrite: false };
    const cords = lines(net, { ...faint, linewidth: 1, opacity: 0.6 });
    const dashes = { dashed: true, dashSize: 0.12, gapSize: 0.08 }; // m
    const marks = lines(floor, { ...faint, linewidth: 1.5, opacity: 0.9, ...dashes });
    marks.computeLineDistances();
    return [cords, marks];
  }

  function ring(parameters, colour) {
    const { ring_radius: radius, wire_radius: wire } = parameters;
    return solid(new THREE.TorusGeometry(radius, wire, 20, 160), colour.ring, 0.45);
  }

  function board(parameters, colour) {
    const { board_distance: distance, board_half_width: half } = parameters;
    const { board_bottom: bottom, board_top: top, wire_radius: wire } = parameters;
    const { board_thickness: thickness = GLASS } = parameters;
    const box = new THREE.BoxGeometry(thickness, 2 * half, top - bottom);
    box.translate(-distance - thickness / 2, 0, (bottom + top) / 2);
    const glass = new THREE.Mesh(
      box,
      new THREE.MeshStandardMaterial({
        color: colour.glass,
        roughness: 0.3,
        transparent: true,
        opacity: 0.55,
        depthWrite: false,
      }),
    );
    glass.receiveShadow = true;
    const front = -distance + 0.001;
    const parts = [glass, band(half, bottom, top, 0.025, front, colour.backboard)];
    if (wire + TARGET.height < top && TARGET.halfWidth < half) {
      const { halfWidth, height, stroke } = TARGET;
      parts.push(band(halfWidth, wire, wire + height, stroke, front, colour.backboard));
    }
    return parts;
  }

  /** Return a rectangular band on the board, seen from both sides. */
  function band(half, bottom, top, stroke, x, colour) {
    const outline = rectangle(half, bottom, top);
    outline.holes.push(rectangle(half - stroke, bottom + stroke, top - stroke));
    const geometry = new THREE.ShapeGeometry(outline);
    geometry.applyMatrix4(
      // The shape's plane, x right and y up, stands on the board: y right and z up.
      new THREE.Matrix4().set(0, 0, 1, x, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1),
    );
    const material = new THREE.MeshBasicMaterial({ color: colour, side: THREE.DoubleSide });
    material.polygonOffset = true; // before the glass, however far the eye
    material.polygonOffsetFactor = material.polygonOffsetUnits = -2;
    return new THREE.Mesh(geometry, material);
  }

  function rectangle(half, bottom, top) {
    const corners = [[-half, bottom], [half, bottom], [half, top], [-half, top]];
    return new THREE.Shape(corners.map(([x, y]) => new THREE.Vector2(x, y)));
  }

  /** Return the bridge from the board to the wire: as thick as that where it is a plate. */
  function bridge(parameters, colour) {
    const { bridge_half_width: half, ring_radius: radius, wire_radius: wire } = parameters;
    const { bridge_depth: depth = 2 * wire } = parameters;
    const outline = [new THREE.Vector2(-parameters.board_distance, half)];
    outline.push(new THREE.Vector2(-parameters.board_distance, -half));
    for (let i = 0; i <= 16; i++) {
      const y = -half + (2 * half * i) / 16;
      outline.push(new THREE.Vector2(-Math.sqrt(Math.max(radius ** 2 - y ** 2, 0)), y));
    }
    const plate = new THREE.ExtrudeGeometry(new THREE.Shape(outline), {
      depth,
      bevelEnabled: false,
    });
    plate.translate(0, 0, wire - depth);
    return solid(plate, colour.bridge, 0.6);
  }

  function solid(geometry, colour, roughness) {
    const material = new THREE.MeshStandardMaterial({ color: colour, roughness });
    const mesh = new THREE.Mesh(geometry, material);
    mesh.castShadow = mesh.receiveShadow = true;
    return mesh;
  }

  /** Return a ball with seams, or a plain one with a line around it: its spin is seen. */
  function ball(radius, colour, plain = false) {
    const inks = plain ? ["plain-ball", "plain-ball-edge"] : ["ball", "seam"];
    const texture = new THREE.CanvasTexture(skin(...inks.map((name) => colour[name]), plain));
    texture.colorSpace = THREE.SRGBColorSpace;
    texture.anisotropy = 4;
    const material = new THREE.MeshStandardMaterial({ map: texture, roughness: 0.75 });
    const mesh = new THREE.Mesh(new THREE.SphereGeometry(radius, 64, 48), material);
    mesh.castShadow = true;
    return mesh;
  }

  /** Paint a ball's skin, longitude across and latitude up: of a basketball two great circles and
   * two loops, of a plain ball one great circle. */
  function skin(base, seam, plain) {
    const [width, height] = [1024, 512];
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [width, height];
    const context = canvas.getContext("2d");
    const image = context.createImageData(width, height);
    const [light, dark] = [base, seam].map((name) => {
      const { r, g, b } = new THREE.Color(name).convertLinearToSRGB();
      return [r, g, b].map((part) => 255 * part);
    });
    const [HALF, SOFT] = [0.022, 0.012]; // of a seam, in ball radii
    for (let row = 0; row < height; row++) {
      const up = Math.PI * ((row + 0.5) / height);
      for (let column = 0; column < width; column++) {
        const round = 2 * Math.PI * ((column + 0.5) / width);
        const x = Math.sin(up) * Math.cos(round);
        const y = Math.cos(up);
        const z = Math.sin(up) * Math.sin(round);
        const loop = Math.abs(Math.abs(x) - 0.53 - 0.3 * y * y) / Math.hypot(1, 0.6 * y);
        const gap = plain ? Math.abs(y) : Math.min(Math.abs(y), Math.abs(z), loop);
        const share = Math.min(Math.max((gap - HALF) / SOFT, 0), 1);
        const at = 4 * (row * width + column);
        for (let k = 0; k < 3; k++) image.data[at + k] = dark[k] + share * (light[k] - dark[k]);
        image.data[at + 3] = 255;
      }
    }
    context.putImageData(image, 0, 0);
    return canvas;
  }

  /** Return the ball's orientation at the start of each flight. */
  function orientations(shot) {
    const turned = [new THREE.Quaternion()];
    for (let k = 0; k + 1 < shot.flights.length; k++) {
      turned.push(turn(turned[k], shot, k, shot.flights[k + 1][0] - shot.flights[k][0]));
    }
    return turned;
  }

  /** Return an orientation after so many seconds of a shot's flight. */
  function turn(orientation, shot, k, seconds) {
    const axis = new THREE.Vector3(...Flight.spinOver(shot, k, seconds));
    const rate = axis.length();
    if (rate === 0) return orientation.clone();
    const rotation = new THREE.Quaternion();
    rotation.setFromAxisAngle(axis.divideScalar(rate), rate * seconds);
    return rotation.multiply(orientation);
  }

  /** Return a line through points (x, y, z), some pixels wide. */
  function line(points, options) {
    const geometry = new THREE.LineGeometry().setPositions(points.flat());
    return new THREE.Line2(geometry, stroke(options));
  }

  /** Return a dashed line through points, for what is not simulated. */
  function dashes(points, color) {
    const dashed = { dashed: true, dashSize: 0.08, gapSize: 0.06 }; // m
    const drawn = line(points, { color, linewidth: 1.75, opacity: 0.8, ...dashed });
    drawn.computeLineDistances();
    return drawn;
  }

  /** Return many such lines as one object. */
  function lines(paths, options) {
    const ends = paths.flatMap((points) =>
      points.slice(1).flatMap((point, i) => [...points[i], ...point]),
    );
    const geometry = new THREE.LineSegmentsGeometry().setPositions(ends);
    return new THREE.LineSegments2(geometry, stroke(options));
  }

  function stroke(options) {
    return new THREE.LineMaterial({ transparent: "opacity" in options, ...options });
  }

  function circle(radius, z, x = 0, y = 0) {
    return Array.from({ length: 97 }, (_, i) => {
      const angle = (2 * Math.PI * i) / 96;
      return [x + radius * Math.cos(angle), y + radius * Math.sin(angle), z];
    });
  }

  /** Return the least of 1, 2, 5, 10, 20, ... times a step with which `most` of them reach. */
  function stepTo(reach, step, most) {
    for (let power = 1; power < 1e300; power *= 10) {
      for (const digit of [1, 2, 5]) {
        if (digit * power * step * most >= reach) return digit * power * step;
      }
    }
    return reach;
  }

  /** Return the seconds between the dots on the paths of shots. */
  function beatOf(shots) {
    return stepTo(shots.reduce((most, { duration }) => Math.max(most, duration), 0), BEAT, BEATS);
  }

  /** Return dots on a shot's path, one every `beat` seconds, so many pixels wide. */
  function beats(shot, beat, colour, pixels) {
    const dots = [];
    for (let k = 1; k * beat < shot.duration; k++) {
      dots.push(new THREE.Vector3(...Flight.stateAt(shot, k * beat).slice(0, 3)));
    }
    const material = new THREE.PointsMaterial({
      color: colour,
      size: pixels,
      sizeAttenuation: false,
      map: new THREE.CanvasTexture(disc()),
      transparent: true,
      alphaTest: 0.1,
    });
    return new THREE.Points(new THREE.BufferGeometry().setFromPoints(dots), material);
  }

  function disc() {
    const canvas = document.createElement("canvas");
    canvas.width = canvas.height = 32;
    const context = canvas.getContext("2d");
    context.fillStyle = "#FFFFFF";
    context.arc(16, 16, 15, 0, 2 * Math.PI);
    context.fill();
    return canvas;
  }

  /** Return a grid of a step, or of more for a wide one, under the scene and all paths. */
  function floor(paths, level, colour, least) {
    const reach = paths
      .flat()
      .reduce((most, [x, y]) => Math.max(most, Math.abs(x), Math.abs(y)), 0);
    const step = stepTo(reach, least, LINES - 3);
    const end = step * (Math.ceil(reach / step) + 3);
    const grid = [];
    for (let k = -end; k <= end; k += step) {
      grid.push([[k, -end, level], [k, end, level]], [[-end, k, level], [end, k, level]]);
    }
    return lines(grid, { color: colour.floor, linewidth: 1 });
  }

  /** Return the corners of the board and points round the ring, for what must be in sight. */
  function corners(parameters) {
    const { board_distance: distance, board_half_width: half } = parameters;
    const { board_bottom: bottom, board_top: top } = parameters;
    const board = [-half, half].flatMap((y) => [bottom, top].map((z) => [-distance, y, z]));
    return [...board, ...circle(parameters.ring_radius + parameters.wire_radius, 0)];
  }

  /** Return the corners of another scene's room. */
  function room({ room: [low, high] }) {
    const ends = low.map((value, axis) => [value, high[axis]]);
    return ends[0].flatMap((x) => ends[1].flatMap((y) => ends[2].map((z) => [x, y, z])));
  }

  /** Return points all along the lines of another scene, and the ball at release. */
  function edges(scenery, shot) {
    const along = scenery.bodies.flatMap((body) => [...body.rims, ...body.lines].flat());
    const every = Math.ceil(along.length / 300) || 1;
    return [...along.filter((_, k) => k % every === 0), ...ballPoints(shot)];
  }

  /** Return points all over ring, bridge and the ball at release, better not covered by words. */
  function outline(shot) {
    const { board_distance: distance, ring_radius: radius } = shot.parameters;
    const steps = Array.from({ length: 9 }, (_, k) => -distance + ((distance - radius) * k) / 8);
    return [...circle(radius, 0), ...steps.map((back) => [back, 0, 0]), ...ballPoints(shot)];
  }

  function ballPoints(shot) {
    const { ball_radius: ball } = shot.parameters;
    const [, x, y, z] = shot.flights[0];
    return [-0.8, -0.4, 0, 0.4, 0.8].flatMap((up) =>
      circle(ball * Math.sqrt(1 - up ** 2), z + ball * up, x, y),
    );
  }

  /** Return lights for a hoop, or for a scene so many times as large round another middle. */
  function lights(size = 1, middle = [0, 0, 0]) {
    const sun = new THREE.DirectionalLight("#ffffff", 2.0);
    const target = new THREE.Vector3(...middle);
    sun.position.set(1.6, 0.9, 3.2).multiplyScalar(size).add(target);
    sun.target.position.copy(target);
    sun.castShadow = true;
    sun.shadow.mapSize.set(1024, 1024);
    sun.shadow.radius = 5;
    sun.shadow.bias = -0.002;
    const reach = 1.4 * size;
    Object.assign(sun.shadow.camera, { left: -reach, right: reach, top: reach, bottom: -reach });
    Object.assign(sun.shadow.camera, { near: 0.5 * size, far: 6 * size });
    return [new THREE.HemisphereLight("#ffffff", "#d8d2ca", 2.3), sun, sun.target];
  }

  /** Free what an object holds on the graphics card. */
  function dispose(object) {
    object.traverse((part) => {
      part.geometry?.dispose();
      part.material?.map?.dispose();
      part.material?.dispose();
    });
  }

  return {
    ball, beatOf, beats, bodies, colours, corners, dashes, dispose, edges, floor, ghost, hoop, lights, line,
    lines, orientations, outline, room, turn,
  };
})();
