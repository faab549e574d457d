// The lesson book at work: the choice of light or dark, and the frames one at a time.
// Without it the pages follow the system's theme and show all frames one below the other.
(() => {
  "use strict";
  const root = document.documentElement;
  const system = window.matchMedia("(prefers-color-scheme: dark)");
  const secondsPerFrame = 1.5;

  // A browser may refuse to keep anything for a page that is a file.
  const kept = () => {
    try { return localStorage.getItem("cairn-theme"); } catch { return null; }
  };
  const keep = (theme) => {
    try { localStorage.setItem("cairn-theme", theme); } catch { /* then it holds for this page */ }
  };
  const isDark = () => (root.dataset.theme ? root.dataset.theme === "dark" : system.matches);

  // The style sheet follows data-theme; dark pictures stand in <source media>, and are switched here. Paper is light.
  function applyTheme(theme) {
    if (theme !== "light" && theme !== "dark") return;
    root.dataset.theme = theme;
    for (const source of document.querySelectorAll("picture > source")) {
      source.media = theme === "dark" ? "screen" : "not all";
    }
  }

  function setUpTheme() {
    const button = document.querySelector("button.theme");
    const name = () => { button.textContent = isDark() ? "Light pages" : "Dark pages"; };
    button.hidden = false;
    button.addEventListener("click", () => {
      const theme = isDark() ? "light" : "dark";
      keep(theme);
      applyTheme(theme);
      name();
    });
    system.addEventListener("change", name);
    applyTheme(kept());
    name();
  }

  function setUpPlayer(player) {
    const items = [...player.querySelectorAll(".frames > li")];
    const slider = player.querySelector("input");
    const play = player.querySelector(".play");
    const enlarge = player.querySelector(".enlarge");
    const caption = player.querySelector(".caption");
    const last = items.length - 1;
    let at = 0;
    let timer = 0;
    let isDescribed = false;

    function show(index) {
      at = Math.min(Math.max(index, 0), last);
      items.forEach((item, i) => item.classList.toggle("shown", i === at));
      const words = items[at].querySelector("figcaption");
      caption.innerHTML = words.innerHTML;
      const details = caption.querySelector("details");
      details.open = isDescribed;
      details.addEventListener("toggle", () => { isDescribed = details.open; });
      slider.value = at;
      slider.setAttribute("aria-valuetext", words.querySelector("p").textContent);
    }
    function stop() {
      window.clearInterval(timer);
      timer = 0;
      play.textContent = "Play";
    }
    // The reader's own choice: it ends the film, and the address follows.
    function choose(index) {
      stop();
      show(index);
      history.replaceState(null, "", "#" + items[at].id);
    }
    function tick() {
      show(at + 1);
      if (at === last) stop();
    }
    function start() {
      if (at === last) show(0);
      play.textContent = "Pause";
      timer = window.setInterval(tick, 1000 * secondsPerFrame);
    }
    function followAddress() {
      const index = items.findIndex((item) => "#" + item.id === location.hash);
      if (index < 0) return false;
      stop();
      show(index);
      player.scrollIntoView({ block: "start" });
      return true;
    }

    player.classList.add("works");
    player.querySelector(".controls").hidden = false;
    caption.hidden = false;
    player.querySelector(".previous").addEventListener("click", () => choose(at - 1));
    player.querySelector(".next").addEventListener("click", () => choose(at + 1));
    play.addEventListener("click", () => (timer ? stop() : start()));
    enlarge.addEventListener("click", () => {
      enlarge.setAttribute("aria-pressed", String(player.classList.toggle("enlarged")));
    });
    slider.addEventListener("input", () => choose(Number(slider.value)));
    player.addEventListener("keydown", (event) => {
      const steps = { ArrowLeft: at - 1, ArrowRight: at + 1, Home: 0, End: last };
      if (!(event.key in steps) || event.altKey || event.ctrlKey || event.metaKey) return;
      event.preventDefault();
      choose(steps[event.key]);
    });
    window.addEventListener("hashchange", followAddress);
    if (!followAddress()) show(0);
  }

  applyTheme(kept());
  document.addEventListener("DOMContentLoaded", () => {
    setUpTheme();
    document.querySelectorAll(".player").forEach(setUpPlayer);
  });
})();
