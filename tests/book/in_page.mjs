// What the test asks a page of the book. Each of these runs in the browser, and sees nothing of this file.

export const overflow = () => {
  const width = document.documentElement.clientWidth;
  const isClipped = (element) => {
    for (let at = element; at; at = at.parentElement) if (getComputedStyle(at).overflowX === "auto") return true;
    return false;
  };
  const wide = [...document.querySelectorAll("body *")].filter((element) => {
    const box = element.getBoundingClientRect();
    return box.width > 0 && box.right > width + 1 && !isClipped(element);
  });
  return wide.map((element) => element.tagName + "." + element.className).slice(0, 3).join(" ");
};

// Pictures further down are fetched when somebody comes there.
export const fetchShown = () => Promise.all([...document.images]
  .filter((image) => image.getClientRects().length > 0)
  .map((image) => {
    image.loading = "eager";
    return image.decode().catch(() => {});
  }));

// Of two that lie upon each other the upper one says what both show.
export const brokenPictures = (theme) => [...document.images].filter((image) => {
  const isShown = image.getClientRects().length > 0;
  const isBelow = image.matches(".layers > picture:first-child > img");
  return Boolean(image.alt) === isBelow || (isShown && (!image.naturalWidth || !image.currentSrc.includes(`_${theme}.png`)));
}).length;

// Text against what is behind it: at least 4.5 : 1 (WCAG 2.2, 1.4.3).
export const paleText = () => {
  const channels = (color) => color.match(/[\d.]+/g).map(Number);
  const light = ([r, g, b]) => [r, g, b].map((c) => c / 255)
    .map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4))
    .reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0);
  const behind = (element) => {
    for (let at = element; at; at = at.parentElement) {
      const color = channels(getComputedStyle(at).backgroundColor);
      if (color.length < 4 || color[3] === 1) return light(color);
    }
    return 1;
  };
  const texts = [...document.querySelectorAll("p, li, a, h1, h2, h3, td, th, code, button, summary, figcaption")];
  const ratio = (element) => {
    const pair = [light(channels(getComputedStyle(element).color)), behind(element)].sort((a, b) => b - a);
    return (pair[0] + 0.05) / (pair[1] + 0.05);
  };
  return texts.filter((element) => element.getClientRects().length > 0 && ratio(element) < 4.5)
    .map((element) => `${element.tagName} "${element.textContent.slice(0, 30)}" ${ratio(element).toFixed(2)}`)
    .slice(0, 3).join("; ");
};

// What the player of a page says of itself.
export const playerState = () => {
  const shown = [...document.querySelectorAll(".frames > li")].filter((item) => item.getClientRects().length > 0);
  return {
    shown: shown.map((item) => item.id).join(" "),
    slider: Number(document.querySelector(".controls input").value),
    spoken: document.querySelector(".controls input").getAttribute("aria-valuetext"),
    caption: document.querySelector(".caption p").textContent,
    hash: location.hash,
  };
};
