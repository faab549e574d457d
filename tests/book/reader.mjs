// What a reader does with the book: types a guess, searches, prints; and what the pages weigh.
import { readFileSync, statSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { fetchShown } from "./in_page.mjs";

const mostOfLesson = 1.5e6; // [bytes]

/** What the driver has told the page of the lesson's answer. */
const answerOf = (tab) => tab.$eval(".guess", (form) => JSON.parse(form.dataset.answer));

/** A page whose answer is folded: no guess leaves it so; any number opens it, and is judged as the lesson does. */
async function checkGuesses(tab, address, check) {
  const judge = async (words) => {
    await tab.evaluate(() => localStorage.clear());
    await tab.goto("about:blank");
    await tab.goto(address);
    await tab.fill(".guess input", words);
    await tab.click(".guess button");
    return {
      isOpen: await tab.isVisible("details.fold h2"),
      said: (await tab.isVisible(".guess .verdict")) ? await tab.textContent(".guess .verdict") : "",
      judged: (await tab.isVisible(".guessed")) ? await tab.textContent(".guessed") : "",
    };
  };
  await tab.goto(address);
  const name = address.split("/").pop();
  const { right, tolerance, explanation, wrong } = await answerOf(tab);
  for (const empty of ["", "  "]) {
    const { isOpen, said } = await judge(empty);
    check(!isOpen && /number/.test(said), `${name}: an empty guess opens nothing, and says why`, said);
  }
  const words = await judge("rather fast");
  check(!words.isOpen && /no number/.test(words.said), `${name}: nor do words`, words.said);
  const hit = await judge(right.join(", "));
  check(hit.isOpen && hit.judged.startsWith("Right"), `${name}: the answer is right`, hit.judged);
  check(hit.judged.endsWith(explanation), `${name}: and explained`, hit.judged);
  const near = await judge(right.map((number) => String(number + 0.9 * tolerance).replace("-", "\u2212")).join());
  check(near.judged.startsWith("Right"), `${name}: what is as near as the lesson asks is right, too`, near.judged);
  const off = await judge(right.map((number) => number + 1.1 * tolerance + 0.01 * Math.abs(number) + 1e-3).join());
  check(off.isOpen && off.judged.startsWith("Not yet"), `${name}: what is further off is not`, off.judged);
  const many = await judge([...right, 1].join());
  check(many.judged.includes(`asks for ${right.length}`), `${name}: one number too many is told`, many.judged);
  for (const { least, most, why } of wrong) {
    const { judged } = await judge(least.map((number, i) => (number + most[i]) / 2).join());
    check(judged.includes(why), `${name}: a wrong guess that many make is told why`, judged);
  }
}

/** While one types, and however the words are joined. */
async function checkSearchAsOneTypes(tab, address, check) {
  await tab.goto(address);
  const found = () => tab.$$eval(".results a", (links) => links.map((link) => link.getAttribute("href")));
  await tab.focus(".search input");
  await tab.keyboard.type("warmst");
  const early = await found();
  await tab.keyboard.type("art");
  const whole = await found();
  check(early.length > 0 && whole.length > 0, "the search finds as one types", `${early.length}, ${whole.length}`);
  const apart = ["warm start", "warm-start"];
  for (const words of apart) {
    await tab.fill(".search input", words);
    const there = await found();
    check(there.includes("glossary.html#warm-start"), `"${words}" finds warm start`, there.slice(0, 3).join());
  }
  check(whole.includes("glossary.html#warm-start"), '"warmstart" finds warm start', whole.slice(0, 3).join());
  await tab.fill(".search input", "Jacobian");
  const count = await tab.textContent(".found");
  check(count.startsWith(`${(await found()).length} section`), "and counts what it lists", count);
}

/** The page, its style and script, and its pictures in one theme, also for dense screens: all that one may fetch. */
function checkWeight(book, name, check) {
  const html = readFileSync(join(book, name), "utf8");
  const pictures = new Set([...html.matchAll(/frames\/[^" ]+_light\.png/g)].map(([file]) => file));
  const files = [name, "book.css", "book.js", ...pictures];
  const bytes = files.reduce((sum, file) => sum + statSync(join(book, file)).size, 0);
  check(bytes <= mostOfLesson, `${name} with its pictures has at most ${mostOfLesson} bytes`, String(bytes));
  return bytes;
}

/** On paper: the answer on a page of its own, key frames as wide as the text, and no text below 6 points. */
async function checkPaper(tab, name, check) {
  await tab.emulateMedia({ media: "print" });
  await tab.evaluate(() => window.dispatchEvent(new Event("beforeprint")));
  const paper = await tab.evaluate(() => {
    const point = 96 / 72; // [px]
    const width = document.querySelector("main").clientWidth;
    const isSeen = (element) => element.getClientRects().length > 0;
    const frames = [...document.querySelectorAll(".frames li")].filter(isSeen);
    const small = [...document.querySelectorAll("main *")]
      .filter((each) => isSeen(each) && [...each.childNodes].some((node) => node.nodeType === 3 && node.data.trim()))
      .filter((each) => parseFloat(getComputedStyle(each).fontSize) < 6 * point)
      .map((each) => `${each.tagName} "${each.textContent.slice(0, 20)}"`);
    const fold = document.querySelector("details.fold");
    return {
      others: frames.filter((item) => !item.matches(".key")).length,
      narrow: frames.filter((item) => item.querySelector("img").clientWidth < width - 4).length,
      frames: frames.length,
      small: small.slice(0, 3).join("; "),
      isApart: !fold || (fold.open && getComputedStyle(fold).breakBefore === "page"),
    };
  });
  await tab.emulateMedia({ media: "screen" });
  const { others, narrow, frames, small, isApart } = paper;
  check(frames > 0 && others === 0, `${name} on paper: key frames, and no others`, JSON.stringify(paper));
  check(narrow === 0, `${name} on paper: they are as wide as the text`, String(narrow));
  check(small === "", `${name} on paper: no text is below 6 points`, small);
  check(isApart, `${name} on paper: the answer stands on a page of its own`);
}

/** The frames beside the text: as many pixels as a dense screen shows there, and no more on others. */
async function checkDense(browser, address, check) {
  const kinds = async (deviceScaleFactor) => {
    const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, deviceScaleFactor });
    const tab = await context.newPage();
    await tab.goto(address);
    await tab.evaluate(() => { for (const fold of document.querySelectorAll("details")) fold.open = true; });
    await tab.evaluate(fetchShown);
    const all = await tab.$$eval(".beside img", (images) => images.map((image) =>
      image.currentSrc.includes("_sharp_") ? "sharp" : "usual"));
    await context.close();
    return [...new Set(all)].join();
  };
  const dense = await kinds(2);
  const others = await kinds(1);
  check(dense === "sharp", `${address.split("/").pop()}: frames beside the text are sharp on a dense screen`, dense);
  check(others === "usual", "and take no more bytes than others can show", others);
}

/** All lessons of a book. */
export async function checkReaders(tab, book, lessons, check) {
  const address = (page) => pathToFileURL(join(book, page)).href;
  let heaviest = { bytes: 0, name: "" };
  for (const name of lessons) {
    const bytes = checkWeight(book, name, check);
    if (bytes > heaviest.bytes) heaviest = { bytes, name };
    await tab.goto(address(name));
    await checkPaper(tab, name, check);
    if (await tab.locator(".guess").count() > 0) await checkGuesses(tab, address(name), check);
  }
  const sharp = lessons.find((name) => readFileSync(join(book, name), "utf8").includes("_sharp_"));
  check(sharp !== undefined, "some lesson has pictures for dense screens");
  if (sharp) await checkDense(tab.context().browser(), address(sharp), check);
  console.log(`the heaviest lesson: ${heaviest.name}, ${(heaviest.bytes / 1e6).toFixed(2)} MB in one theme`);
  await checkSearchAsOneTypes(tab, address("search.html"), check);
}
