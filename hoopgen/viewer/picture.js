// The picture: the scene of the chosen shot, drawn anew whenever something has changed.
"use strict";

const Picture = (() => {
  const NEAR_PATH = 12; // px from a path within which a click chooses its shot
  const MARGIN = 44; // px left free on each side, for badges and buttons
  const LAST = 9; // of what is drawn, but for the net, which may hang before it
  const TURN = 0.08; // rad, for a press of an arrow key
  const KEYS = {
    ArrowLeft: (controls) => controls.rotateLeft(TURN),
    ArrowRight: (controls) => controls.rotateLeft(-TURN),
    ArrowUp: (controls) => controls.rotateUp(TURN),
    ArrowDown: (controls) => controls.rotateUp(-TURN),
    "+": (controls) => controls.dollyIn(0.9),
    "-": (controls) => controls.dollyOut(0.9),
  };

  /** Set up the picture of a page's shots; `pick` is told the index of one whose path is clicked.
   * Without a scenery, which other scenes have, there is a hoop; a ghost is not simulated. The step
   * of the floor's grid, m, is that which `grid` returns. */
  function create(stage, canvas, svg, shots, page, paint, pick, grid) {
    const { ring_height: ringHeight, scenery, outcomes } = page;
    let { ghost } = page;
    const renderer = new THREE.WebGLRenderer({
      canvas,
      antialias: true,
      alpha: true,
      preserveDrawingBuffer: true, // for print
    });
    renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    renderer.shadowMap.enabled = true;
    renderer.shadowMap.type = THREE.PCFShadowMap;
    const scene = new THREE.Scene();
    const camera = new THREE.PerspectiveCamera();
    camera.up.set(0, 0, 1);
    const controls = new THREE.OrbitControls(camera, canvas);
    const size = scenery ? Math.hypot(...scenery.room[0].map((v, k) => scenery.room[1][k] - v)) : 3;
    Object.assign(controls, { minDistance: 0.1 * size, maxDistance: 100 * size });

    const extra = outcomes.map((_, k) => `ink-${k}`);
    if (scenery) extra.push(...scenery.bodies.map((_, k) => `face-${k}`));
    let colour = Scene.colours(extra);
    const inkOf = (outcome) => colour[`ink-${outcomes.indexOf(outcome)}`];
    const middle = [0, 1, 2].map((k) => (scenery ? (scenery.room[0][k] + scenery.room[1][k]) / 2 : 0));
    let beat = Scene.beatOf(shots);
    const paths = shots.map((shot) => Flight.pathOf(shot, scenery ? Math.min(0.02, shot.duration / 150) : 0.02));
    const things = {}; // what is in the scene, by what it is
    const gone = []; // what was there when it was last drawn
    let chosen = shots[0];
    let shown = shots.map((_, k) => k);
    let view = scenery ? scenery.views[0] : "3D";
    let together = false; // all shots, and not the chosen one alone
    let now = 0; // s
    let turned = false; // by the reader, who then keeps what is seen
    let drawing = false; // asked for already
    let marks = []; // of the chosen shot
    let marked = false; // where they are now

    /** Put objects into the scene in place of those of this name. What the old ones hold on the
     * graphics card is freed after the next picture: a program that nothing uses is thrown away, and
     * to compile it again takes half a second on some machines. */
    function put(name, ...objects) {
      if (things[name]) {
        things[name].removeFromParent();
        gone.push(things[name]);
      }
      things[name] = new THREE.Group();
      for (const object of objects) things[name].add(object);
      scene.add(things[name]);
    }

    // What is shown

    function choose(shot) {
      const sizes = JSON.stringify(shot.parameters);
      if (things.hoop?.userData.sizes !== sizes) {
        const drawn = scenery ? Scene.bodies(scenery, colour) : Scene.hoop(shot.parameters, colour);
        put("hoop", drawn);
        put("ball", Scene.ball(shot.parameters.ball_radius, colour, scenery?.plain));
        things.hoop.userData.sizes = sizes;
      }
      const path = paths[shots.indexOf(shot)];
      const ink = shots.length > 1 ? inkOf(shot.outcome) : colour.path;
      const parts = path.length > 1 ? strokes(path, ink) : [];
      const pixels = (shots.length > 1 ? 9 : 7) * renderer.getPixelRatio();
      parts.push(Scene.beats(shot, beat, ink, pixels));
      const fall = Flight.fallOf(shot);
      if (fall.length) parts.push(Scene.dashes(fall, ink));
      parts.forEach((part, k) => (part.renderOrder = k + 1)); // over the others
      put("path", ...parts);
      things.path.userData.turned = Scene.orientations(shot);
      chosen = shot;
      marks = Badges.marks(shot);
      update();
    }

    /** Return a path's line; among others, bold and with a light edge. */
    function strokes(path, ink) {
      if (shots.length === 1) return [Scene.line(path, { color: ink, linewidth: 2.75 })];
      const edge = { color: colour.paper, linewidth: 7.5, opacity: 0.8, depthWrite: false };
      return [
        Scene.line(path, edge),
        Scene.line(path, { color: ink, linewidth: 4, opacity: 1 }),
      ];
    }

    function filter(indices) {
      shown = indices;
      const there = [...new Set(shots.map((shot) => shot.outcome))];
      const lines = there.flatMap((outcome) => {
        const own = shown.filter((k) => shots[k].outcome === outcome && paths[k].length > 1);
        const ink = { color: inkOf(outcome), linewidth: 1.25, opacity: 0.4, depthWrite: false };
        return own.length ? [Scene.lines(own.map((k) => paths[k]), ink)] : [];
      });
      if (shots.length > 1) put("crowd", ...lines);
      for (const name of ["path", "ball"]) {
        if (things[name]) things[name].visible = shown.length > 0;
      }
      crowd();
      update();
    }

    /** Draw what is now the only shot of `shots`, about another hoop's net and court lines. */
    function replace(around) {
      ghost = around;
      beat = Scene.beatOf(shots);
      paths[0] = Flight.pathOf(shots[0]);
      chosen = shots[0];
      setting();
      choose(chosen);
      if (!turned) look(view);
    }

    /** Draw everything anew, in the colours that the page has now. */
    function repaint() {
      colour = Scene.colours(extra);
      delete things.hoop?.userData.sizes;
      setting();
      choose(chosen);
      if (together) put("others", Others.create(shots, inkOf));
      filter(shown);
      move(chosen, now);
      draw(); // at once: it may be for a printer
    }

    /** Put what no shot changes into the scene: the floor, and what is not simulated. */
    function setting() {
      const around = scenery ? [...paths, Scene.room(scenery)] : paths;
      const below = scenery && !ghost ? scenery.room[0][2] - 0.02 * size : -ringHeight;
      put("floor", Scene.floor(around, below, colour, grid()));
      const seen = things.ghost?.visible ?? true;
      if (!ghost) return;
      const drawn = Scene.ghost(ghost, colour);
      for (const part of drawn) part.renderOrder = LAST + 1;
      put("ghost", ...drawn);
      things.ghost.visible = seen;
    }

    /** Lay the floor anew, whose grid may have another step now. */
    function lay() {
      setting();
      update();
    }

    /** Show what is not simulated, or leave it out. */
    function haunt(seen) {
      if (things.ghost) things.ghost.visible = seen;
      update();
    }

    /** Have the balls of all shots, or of the chosen one alone. */
    function gather(all) {
      together = all;
      put("others", ...(all ? [Others.create(shots, inkOf)] : []));
      crowd();
      update();
    }

    /** Place the other balls, and the chosen one before them: it is drawn after the pale ones. */
    function crowd() {
      if (together) Others.move(things.others.children[0], shots, shown, chosen, now);
      const [ball] = things.ball.children;
      [ball.material.transparent, ball.renderOrder] = [together, together ? LAST : 0];
    }

    /** Return where the balls are that are seen, the chosen one among them, by their shots. */
    function balls() {
      const others = together ? things.others.children[0].children : [];
      const there = shots.map((shot, k) => (shot === chosen ? things.ball : others[k]));
      return shown
        .filter((k) => there[k]?.visible)
        .map((k) => [k, ...there[k].position.toArray()]);
    }

    function move(shot, asked) {
      now = asked;
      crowd();
      const time = Math.min(now, Flight.lasts(shot));
      const [x, y, z] = Flight.stateAt(shot, time);
      const k = Flight.indexAt(shot.flights, time);
      const turn = Scene.turn(things.path.userData.turned[k], shot, k, time - shot.flights[k][0]);
      things.ball.position.set(x, y, z);
      things.ball.quaternion.copy(turn);
      ask();
    }

    // From where

    function look(name) {
      [view, turned] = [name, false];
      const { clientWidth: width, clientHeight: height } = stage;
      const places = (shown.length ? shown : [shots.indexOf(chosen)]).map((k) => paths[k]);
      const own = [paths[shots.indexOf(chosen)]];
      const starts = (view === "Shooter" ? own : places).map(([start]) => start);
      const mean = (axis) => starts.reduce((sum, at) => sum + at[axis], 0) / starts.length;
      const [east, north] = [0, 1].map((k) => mean(k) - middle[k]);
      const eye = Camera.direction(view, east, north, camera.aspect, scenery?.side);
      const margin = [width, height].map((size) => Math.min((2 * MARGIN) / size, 0.5));
      const radius = chosen.parameters.ball_radius;
      const there = shown.length ? shown.map((k) => shots[k]) : [chosen];
      const falls = ["3D", "Side"].includes(view) ? there.flatMap((shot) => Flight.fallOf(shot, 1)) : [];
      const flown = view === "Hoop" ? [] : [...places.flat(), ...falls];
      const spheres = [
        ...flown.map((point) => [...point, radius]),
        ...(scenery ? Scene.room(scenery) : Scene.corners(chosen.parameters)).map((p) => [...p, 0]),
      ];
      camera.fov = Camera.field(view);
      Camera.fit(camera, controls.target, spheres, eye, margin);
      controls.update();
      update();
    }

    function resize() {
      const { clientWidth: width, clientHeight: height } = stage;
      if (!width || !height) return;
      renderer.setSize(width, height, false);
      camera.aspect = width / height;
      if (turned) update();
      else look(view);
      draw(); // at once: the new size has wiped the picture
    }

    function key(name) {
      const act = KEYS[name === "=" ? "+" : name];
      if (!act) return false;
      turned = true;
      act(controls);
      return true;
    }

    // Drawing

    function update() {
      marked = false;
      ask();
    }

    function ask() {
      if (!drawing) requestAnimationFrame(draw);
      drawing = true;
    }

    function draw() {
      drawing = false;
      camera.near = controls.getDistance() / 50;
      camera.far = controls.getDistance() + 100 * Math.max(1, size / 3);
      camera.updateProjectionMatrix();
      renderer.render(scene, camera);
      gone.splice(0).forEach(Scene.dispose);
      canvas.dataset.triangles = renderer.info.render.triangles;
      if (marked) return;
      marked = true;
      const drawn = scenery ? Scene.edges(scenery, chosen) : Scene.outline(chosen);
      const obstacles = [...paths[shots.indexOf(chosen)], ...drawn];
      Badges.draw(svg, shown.length ? marks : [], project, obstacles.map(project).filter(Boolean), paint);
    }

    /** Return where a point of the scene is in the picture, px; null behind the eye. */
    function project(point) {
      const { x, y, z } = new THREE.Vector3(...point).project(camera);
      if (z > 1) return null;
      return [(stage.clientWidth * (1 + x)) / 2, (stage.clientHeight * (1 - y)) / 2];
    }

    function pathAt(x, y) {
      let [least, found] = [NEAR_PATH, -1];
      for (const k of shown) {
        const points = paths[k].map(project);
        for (let i = 1; i < points.length; i++) {
          if (!points[i - 1] || !points[i]) continue;
          const away = distance([x, y], points[i - 1], points[i]);
          if (away < least) [least, found] = [away, k];
        }
      }
      return found;
    }

    let pressed = [0, 0];
    canvas.addEventListener("pointerdown", (event) => {
      pressed = [event.offsetX, event.offsetY];
    });
    canvas.addEventListener("click", ({ offsetX: x, offsetY: y }) => {
      if (shots.length < 2 || Math.hypot(x - pressed[0], y - pressed[1]) > 4) return;
      const k = pathAt(x, y);
      if (k >= 0) pick(k);
    });
    controls.addEventListener("start", () => (turned = true));
    controls.addEventListener("change", update);
    if (scenery) {
      scene.add(...Scene.lights(size / 2, middle));
    } else {
      scene.add(...Scene.lights());
    }
    setting();
    choose(chosen);
    new ResizeObserver(resize).observe(stage);
    resize();
    return { balls, choose, filter, gather, haunt, key, lay, look, move, repaint, replace };
  }

  /** Return the distance from a point to a stretch between two others, px. */
  function distance(point, start, end) {
    const along = [end[0] - start[0], end[1] - start[1]];
    const to = [point[0] - start[0], point[1] - start[1]];
    const square = along[0] ** 2 + along[1] ** 2;
    const share = square ? (to[0] * along[0] + to[1] * along[1]) / square : 0;
    const part = Math.min(Math.max(share, 0), 1);
    return Math.hypot(to[0] - part * along[0], to[1] - part * along[1]);
  }

  return { create };
})();
