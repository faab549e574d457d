// What the playground looks like at three widths, light and dark.
import { join } from "node:path";
import { check, drawn, goTo, inTab, screenshots } from "./browser_tab.mjs";

const widths = [1280, 820, 390];
const themes = ["light", "dark"];

/** What reaches beyond the page. */
const overflow = () => {
  const width = document.documentElement.clientWidth;
  return [...document.querySelectorAll("body *")]
    .filter((element) => element.getClientRects().length > 0 && !element.closest(".skip"))
    .filter((element) => element.getBoundingClientRect().right > width + 1)
    .map((element) => element.tagName + "#" + element.id)
    .slice(0, 3)
    .join(" ");
};

/** Text that is small, cut off, or hardly stands out: less than 4.5 : 1 (WCAG 2.2, 1.4.3). */
const badText = () => {
  const channels = (color) => color.match(/[\d.]+/g).map(Number);
  const light = ([r, g, b]) =>
    [r, g, b]
      .map((c) => c / 255)
      .map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4))
      .reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0);
  const behind = (element) => {
    for (let at = element; at; at = at.parentElement) {
      const color = channels(getComputedStyle(at).backgroundColor);
      if (color.length < 4 || color[3] === 1) return light(color);
    }
    return 1;
  };
  const ratio = (element) => {
    const pair = [light(channels(getComputedStyle(element).color)), behind(element)].sort((a, b) => b - a);
    return (pair[0] + 0.05) / (pair[1] + 0.05);
  };
  const isCut = (element) =>
    element.matches("button, .tools span, label, p") && element.scrollWidth > element.clientWidth + 1;
  return [
    ...document.querySelectorAll(
      "p, a, h1, h2, label, button, span, summary, select, textarea, input[type=text], dt, dd",
    ),
  ]
    .filter((element) => element.getClientRects().length > 0 && !element.closest(".unseen, .skip"))
    .filter((each) => ratio(each) < 4.5 || parseFloat(getComputedStyle(each).fontSize) < 12 || isCut(each))
    .map((each) => `${each.tagName}#${each.id} "${each.textContent.slice(0, 20)}"`)
    .slice(0, 4)
    .join("; ");
};

/** Controls without a name. */
const unnamed = () =>
  [...document.querySelectorAll("button, select, input, textarea, canvas, a")]
    .filter((each) => {
      const labels = each.labels ? [...each.labels].map((label) => label.textContent).join("") : "";
      return !(each.ariaLabel || labels || each.textContent.trim());
    })
    .map((each) => each.outerHTML.slice(0, 60))
    .join(" ");

/** Where Run is on the screen, and where it would be without the window's edge. */
const placesOfRun = () => {
  const bars = document.querySelector(".bars");
  const { top, bottom } = document.getElementById("run").getBoundingClientRect();
  const isSeen = top >= 0 && bottom <= window.innerHeight;
  bars.style.position = "static";
  const inPage = Math.round(document.getElementById("run").getBoundingClientRect().top);
  bars.style.position = "";
  return { isSeen, inPage };
};

async function checkText(tab, where, what) {
  check(
    (await tab.evaluate(overflow)) === "",
    `${where}: nothing overflows, ${what}`,
    await tab.evaluate(overflow),
  );
  const bad = await tab.evaluate(badText);
  check(bad === "", `${where}: text is readable, ${what}`, bad);
}

async function look(tab, width, theme) {
  const where = `${width} px, ${theme}`;
  const shoot = async (name, fullPage = true) => {
    if (screenshots)
      await tab.screenshot({ path: join(screenshots, `${name}_${width}_${theme}.png`), fullPage });
  };
  const good = (what) => checkText(tab, where, what);
  const scroll = await tab.evaluate(
    () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
  );
  check(scroll <= 0, `${where}: the page does not scroll sideways`, String(scroll));
  await good("as it begins");
  const runs = await tab.evaluate(placesOfRun);
  check(runs.isSeen, `${where}: Run is in sight as the page begins`);
  await shoot("start");
  for (let i = 0; i < 12; ++i) await tab.click("#row");
  await tab.selectOption("#set-other", "pgs");
  await tab.fill("#set-sweeps", "5");
  await tab.press("#set-sweeps", "Enter");
  await tab.click("#row");
  await tab.click("#question-next");
  await tab.evaluate(() => window.scrollTo(0, 0));
  const then = await tab.evaluate(placesOfRun);
  check(then.inPage === runs.inPage, `${where}: and stays where it is`, `${runs.inPage}, ${then.inPage}`);
  for (const part of ["#settings-rest", "#scene-file", "#plan-part"]) await tab.click(part + " > summary");
  await tab.evaluate(() => document.activeElement.blur());
  await drawn(tab);
  await good("with all parts unfolded");
  check(
    (await tab.evaluate(unnamed)) === "",
    `${where}: every control has a name`,
    await tab.evaluate(unnamed),
  );
  await shoot("unfolded");
  await tab.selectOption("#set-other", "none");
  await tab.click("#question-try");
  await drawn(tab);
  await good("with a question");
  await shoot("question");
  await tab.click("#keys");
  await good("with the dialog");
  await shoot("keys", false);
  await lookAtRefusals(tab, shoot, good);
}

/** On the way to a step, and with a text that was not run. */
async function lookAtRefusals(tab, shoot, good) {
  await goTo(tab, "#scene=stack&at=100000");
  await drawn(tab);
  await good("on the way to a step");
  await shoot("going", false);
  await tab.keyboard.press("Escape");
  await tab.click("#scene-file summary");
  await tab.evaluate(() => {
    const text = document.getElementById("text");
    text.value = "# a long text\n".repeat(90_000);
    text.dispatchEvent(new Event("input"));
  });
  await tab.click("#run-text");
  await drawn(tab);
  await good("with a text that is too long");
  await tab.locator("#text-refusal").scrollIntoViewIfNeeded();
  await shoot("refused", false);
}

export async function checkLooks(browser) {
  for (const theme of themes) {
    for (const width of widths) {
      const context = { viewport: { width, height: width === 390 ? 844 : 800 }, colorScheme: theme };
      await inTab(browser, `${width} px, ${theme}`, { hash: "#scene=stack", context }, (tab) =>
        look(tab, width, theme),
      );
    }
  }
}
