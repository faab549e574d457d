// The lesson book at work: the choice of light or dark, the guess, the frames one at a time, the search.
// Without it the pages follow the system's theme, the answer is folded, and all frames stand one below the other.
(() => {
  "use strict";
  const root = document.documentElement;
  const system = window.matchMedia("(prefers-color-scheme: dark)");
  const secondsPerFrame = 1.5;

  // A browser may refuse to keep anything for a page that is a file.
  const kept = (name) => {
    try { return localStorage.getItem(name); } catch { return null; }
  };
  const guessOf = (page) => kept("cairn-guess-" + page) ?? "";
  const keep = (name, value) => {
    try { localStorage.setItem(name, value); } catch { /* then it holds for this page */ }
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
      keep("cairn-theme", theme);
      applyTheme(theme);
      name();
    });
    system.addEventListener("change", name);
    applyTheme(kept("cairn-theme"));
    name();
  }

  // Opens whatever the element is folded into.
  function reveal(element) {
    for (let at = element.parentElement; at; at = at.parentElement) {
      if (at.matches("details")) at.open = true;
    }
  }
  function followAddress() {
    const element = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    if (!element) return;
    reveal(element);
    element.scrollIntoView({ block: "start" });
  }

  // Numbers between commas, also 1/3; null where one is none.
  function numbersIn(words) {
    const number = /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i;
    const numbers = words.replace(/\u2212/g, "-").split(",").map((word) => {
      const parts = word.trim().split("/");
      return parts.length > 2 || !parts.every((part) => number.test(part)) ? NaN : parts[0] / (parts[1] ?? 1);
    });
    return numbers.every(Number.isFinite) ? numbers : null;
  }
  // Four digits, as the lessons print them.
  function shortNumber(number) {
    const size = Math.abs(number);
    if (size > 0 && (size < 1e-3 || size >= 1e5)) return number.toExponential(1).replace("-", "\u2212");
    return String(Number(number.toPrecision(4))).replace("-", "\u2212");
  }
  const listed = (numbers) => numbers.map(shortNumber).join(", ");

  // What the lesson would say of a guess: right where it is as near as the lesson asks, or is printed alike; a wrong
  // one that many make is told why.
  function judged(guess, { right, tolerance, explanation, wrong }) {
    const told = listed(right) + ". " + explanation;
    if (guess.length !== right.length) {
      return `Not yet: you said ${listed(guess)}, and the question asks for ${
        right.length === 1 ? "1 number" : right.length + " numbers"}. It is ${told}`;
    }
    const isRight = (number, i) =>
      Math.abs(number - right[i]) <= tolerance || shortNumber(number) === shortNumber(right[i]);
    if (guess.every(isRight)) return `Right, you said ${listed(guess)}. It is ${told}`;
    const isAmong = ({ least, most }) =>
      least.length === guess.length && guess.every((number, i) => number >= least[i] && number <= most[i]);
    const why = wrong.find(isAmong)?.why;
    return `Not yet: you said ${listed(guess)}. ${why ? why + " " : ""}It is ${told}`;
  }

  // The page ends at its question until somebody has guessed. What comes of the guess stands beside the answer, also
  // next time.
  function setUpFold(fold) {
    const form = document.querySelector(".guess");
    const field = form.querySelector("input");
    const verdict = form.querySelector(".verdict");
    const right = JSON.parse(form.dataset.answer);
    const answer = fold.querySelector("h2");
    const page = location.pathname.split("/").pop();
    const note = document.createElement("p");
    note.className = "guessed";
    answer.after(note);
    const compare = () => {
      const guess = numbersIn(field.value);
      verdict.textContent = field.value.trim() === ""
        ? "Type a number first, however rough: then the answer opens."
        : "That is no number: a comma stands between numbers, a point before decimals.";
      verdict.hidden = guess !== null;
      note.textContent = guess && right.right ? judged(guess, right) : "";
      note.hidden = note.textContent === "";
      return guess !== null;
    };
    field.value = guessOf(page);
    fold.classList.add("works");
    fold.open = compare();
    verdict.hidden = true;
    form.hidden = false;
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      if (!compare()) return field.focus();
      keep("cairn-guess-" + page, field.value);
      fold.open = true;
      answer.tabIndex = -1;
      answer.focus();
    });
    // On paper the answer begins a page of its own.
    window.addEventListener("beforeprint", () => { fold.open = true; });
  }

  function setUpPlayer(player) {
    const items = [...player.querySelectorAll(".frames > li")];
    const slider = player.querySelector("input");
    const play = player.querySelector(".play");
    const enlarge = player.querySelector(".enlarge");
    const full = player.querySelector(".full");
    const caption = player.querySelector(".caption");
    const spoken = player.querySelector(".spoken");
    const last = items.length - 1;
    let at = 0;
    let timer = 0;
    let isDescribed = false;

    // A frame is fetched before its turn comes.
    function fetchFrame(item) {
      for (const image of item?.querySelectorAll("img") ?? []) image.loading = "eager";
    }
    function show(index) {
      at = Math.min(Math.max(index, 0), last);
      for (const near of [at, at + 1, at - 1]) fetchFrame(items[near]);
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
      spoken.textContent = [...items[at].querySelectorAll("img")].map((image) => image.alt).join("");
      history.replaceState(null, "", "#" + items[at].id);
    }
    function fillScreen() {
      if (document.fullscreenElement) document.exitFullscreen();
      else player.requestFullscreen();
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
    function showAddress() {
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
    full.hidden = !document.fullscreenEnabled;
    full.addEventListener("click", fillScreen);
    slider.addEventListener("input", () => choose(Number(slider.value)));
    player.addEventListener("keydown", (event) => {
      if (event.key === "f" && !full.hidden) fillScreen();
      const steps = { ArrowLeft: at - 1, ArrowRight: at + 1, Home: 0, End: last };
      if (!(event.key in steps) || event.altKey || event.ctrlKey || event.metaKey) return;
      event.preventDefault();
      choose(steps[event.key]);
    });
    window.addEventListener("hashchange", showAddress);
    if (!showAddress()) show(0);
  }

  // Sections that have every word, those first that have them in their heading.
  function search(words) {
    const found = [];
    for (const [address, title, heading, text, isFolded] of cairnSections) {
      const head = (title + " " + heading).toLowerCase();
      const body = text.toLowerCase();
      // "warmstart" is found where "warm start" stands.
      const inOne = (head + " " + body).replace(/[\s-]+/g, "");
      const has = (word) => head.includes(word) || body.includes(word) || (word.length > 5 && inOne.includes(word.replace(/-/g, "")));
      if (!words.every(has)) continue;
      const isTerm = heading.toLowerCase() === words.join(" ") ? 1000 : 0;
      const score = words.reduce((sum, word) => sum + (head.includes(word) ? 20 : 0) + body.split(word).length, isTerm);
      found.push({ score, address, title: heading ? title + " · " + heading : title, text, isFolded });
    }
    return found.sort((a, b) => b.score - a.score).slice(0, 30);
  }
  function setUpSearch(list) {
    const field = document.querySelector(".search input");
    field.value = new URLSearchParams(location.search).get("q") ?? "";
    field.addEventListener("input", () => {
      history.replaceState(null, "", "?q=" + encodeURIComponent(field.value));
      showFound(list, field.value);
    });
    showFound(list, field.value);
  }
  function showFound(list, query) {
    const words = query.toLowerCase().split(/\s+/).filter(Boolean);
    const found = words.length > 0 ? search(words) : [];
    list.replaceChildren();
    const count = found.length === 1 ? "1 section" : `${found.length} sections`;
    document.querySelector(".found").textContent =
      words.length === 0 ? "Type what you look for above." : `${count} with “${query}”`;
    for (const { address, title, text, isFolded } of found) {
      const item = list.appendChild(document.createElement("li"));
      const link = item.appendChild(document.createElement("a"));
      link.href = address;
      link.textContent = title;
      const at = Math.max(0, text.toLowerCase().indexOf(words[0]) - 80);
      const isHidden = isFolded && !guessOf(address.split("#")[0]);
      item.appendChild(document.createElement("p")).textContent =
        isHidden ? "Behind the question of this lesson." : "… " + text.slice(at, at + 220) + " …";
    }
  }

  // A symbol of a formula leads to what it means. MathML has no links that screen readers allow in it.
  document.addEventListener("click", (event) => {
    const symbol = event.target.closest("mi[data-symbol]");
    if (symbol) location.href = symbol.dataset.symbol;
  });
  applyTheme(kept("cairn-theme"));
  document.addEventListener("DOMContentLoaded", () => {
    setUpTheme();
    document.querySelectorAll("details.fold").forEach(setUpFold);
    window.addEventListener("hashchange", followAddress);
    followAddress();
    document.querySelectorAll(".player").forEach(setUpPlayer);
    document.querySelectorAll(".results").forEach(setUpSearch);
  });
})();
