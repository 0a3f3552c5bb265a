// The balls of all shots but the chosen one, in the colours of their outcomes, when all are played.
"use strict";

const Others = (() => {
  const [ROUND, UP] = [24, 16]; // faces of a ball: enough where many are seen
  const [FLYING, ENDED] = [0.65, 0.25]; // how dense: the chosen ball is seen through them

  /** Return balls for shots; `inkOf` gives an outcome's colour. */
  function create(shots, inkOf) {
    const geometry = new THREE.SphereGeometry(1, ROUND, UP);
    const skins = new Map();
    const group = new THREE.Group();
    for (const shot of shots) {
      const ink = inkOf(shot.outcome);
      if (!skins.has(ink)) skins.set(ink, [skin(ink, FLYING), skin(ink, ENDED)]);
      const ball = new THREE.Mesh(geometry, skins.get(ink)[0]);
      ball.userData.skins = skins.get(ink);
      ball.scale.setScalar(shot.parameters.ball_radius);
      group.add(ball);
    }
    return group;
  }

  function skin(color, opacity) {
    const clear = { transparent: true, opacity, depthWrite: false };
    return new THREE.MeshStandardMaterial({ color, roughness: 0.75, ...clear });
  }

  /** Place the balls of the shown shots, all released at time 0, and hide the others. Each is paler
   * once its shot has ended. */
  function move(group, shots, shown, chosen, time) {
    for (const ball of group.children) ball.visible = false;
    for (const k of shown) {
      if (shots[k] === chosen) continue;
      const ball = group.children[k];
      const ended = time >= shots[k].duration;
      ball.visible = true;
      ball.position.set(...Flight.stateAt(shots[k], time).slice(0, 3));
      ball.material = ball.userData.skins[Number(ended)];
    }
  }

  return { create, move };
})();
