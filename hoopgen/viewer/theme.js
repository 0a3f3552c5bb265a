// Light or dark: as the system is, until the reader says otherwise. On paper, light.
"use strict";

const Theme = (() => {
  const system = window.matchMedia("(prefers-color-scheme: dark)");
  const told = [];
  let own = null; // what the reader says
  let printing = false;

  const isDark = () => !printing && (own ?? system.matches);

  function show() {
    document.documentElement.dataset.theme = isDark() ? "dark" : "light";
    for (const tell of told) tell();
  }

  function toggle() {
    own = !isDark();
    show();
  }

  /** Have something called whenever the page's colours have changed. */
  function tell(what) {
    told.push(what);
  }

  system.addEventListener("change", show);
  for (const [event, now] of [["beforeprint", true], ["afterprint", false]]) {
    window.addEventListener(event, () => {
      printing = now;
      show();
    });
  }
  show();
  return { isDark, tell, toggle };
})();
