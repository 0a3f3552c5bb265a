// Where we look from: directions that show a shot, and the distance that just holds it.
"use strict";

const Camera = (() => {
  const FIELDS = { Side: 5, Top: 5 }; // degrees, up and down: next to no perspective
  const FIELD = 28; // of the other views
  const ACROSS = 0.9; // rad round the hoop, from the line of the shot to the eye
  const VIEWS = ["3D", "Side", "Top", "Shooter", "Hoop"];

  /** Return the direction from the scene to the eye, for one of `VIEWS` and a release at x, y.
   * `side` is that of the side view, from which at a hoop the board is on the left. */
  function direction(view, x, y, aspect, side = [0, -1, 0]) {
    if (view === "Side") return new THREE.Vector3(...side);
    if (view === "Top") return towards(-Math.PI / 2, 1.5699); // a little aside: which way is up
    const away = Math.hypot(x, y) > 0 ? Math.atan2(y, x) : 0;
    if (view === "Shooter") return towards(away, 0.14);
    // On the side from which the board shows its front; less aside where there is little width.
    const turn = (aspect < 1 ? 0.55 : 1) * ACROSS;
    return towards(Math.abs(away) > 0.01 ? away - Math.sign(away) * turn : -turn, 0.3);
  }

  function towards(azimuth, elevation) {
    return new THREE.Vector3(
      Math.cos(elevation) * Math.cos(azimuth),
      Math.cos(elevation) * Math.sin(azimuth),
      Math.sin(elevation),
    );
  }

  /**
   * Place the camera in a direction so that all spheres are in the picture, as near as can be.
   * `target` becomes the point to turn about; `spheres` are [x, y, z, radius]; `margin` is the
   * share of the picture left free, across and up.
   */
  function fit(camera, target, spheres, eye, margin) {
    const back = eye.clone().normalize();
    const right = new THREE.Vector3(0, 0, 1).cross(back).normalize();
    const up = back.clone().cross(right);
    const tall = Math.tan(THREE.MathUtils.degToRad(camera.fov / 2));
    const slopes = [tall * camera.aspect * (1 - margin[0]), tall * (1 - margin[1])];
    const seen = spheres.map(([x, y, z, radius]) => {
      const point = new THREE.Vector3(x, y, z);
      return { at: [point.dot(right), point.dot(up)], depth: point.dot(back), radius };
    });
    // Each sphere bounds the four sides of the pyramid of sight; the two pairs of sides meet in
    // two lines across, and the eye is the further of them.
    const sides = slopes.map((slope, axis) => {
      const wide = Math.hypot(1, slope);
      const bounds = [-1, 1].map((sign) =>
        seen.reduce(
          (most, s) => Math.max(most, sign * s.at[axis] + slope * s.depth + s.radius * wide),
          -Infinity,
        ),
      );
      return { middle: (bounds[1] - bounds[0]) / 2, depth: (bounds[0] + bounds[1]) / (2 * slope) };
    });
    const depth = Math.max(sides[0].depth, sides[1].depth);
    const middle = sides.map((side) => side.middle);
    const centre = seen.reduce((sum, s) => sum + s.depth, 0) / seen.length;
    target.copy(right).multiplyScalar(middle[0]).addScaledVector(up, middle[1]);
    camera.position.copy(target).addScaledVector(back, depth);
    target.addScaledVector(back, centre);
  }

  /** Return the angle of sight of a view, degrees. */
  function field(view) {
    return FIELDS[view] ?? FIELD;
  }

  return { VIEWS, direction, field, fit };
})();
