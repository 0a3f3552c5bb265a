// The worker: it answers the newest question and drops those that came before.
"use strict";

if (typeof document === "undefined") {
  let [newest, ready] = [0, null];
  const rest = () => new Promise((go) => setTimeout(go));

  self.onmessage = async ({ data }) => {
    if (data.spec) {
      ready = Engine.start(data.modules, data.spec.layout).then((engine) => ({
        engine,
        study: Study.of(engine, data.spec),
        spec: data.spec,
      }));
      return;
    }
    newest = Math.max(newest, data.id);
    const { engine, study, spec } = await ready;
    await rest(); // for newer questions
    for (const [name, question] of Object.entries(data.questions)) {
      if (data.id && data.id < newest) return; // 0 is no question about a shot
      const begun = performance.now();
      const answer = name === "fingerprint"
        ? Fingerprint.bytes(engine, spec.fixed, spec.presets[question.preset], spec.layout)
        : study[name](question);
      self.postMessage({ id: data.id, name, answer, milliseconds: performance.now() - begun });
      await rest();
    }
  };
}
