// The playground in a real browser, from a file and without a network.
//   node browser.mjs [FILE] [SCREENSHOTS]
// playwright-core is looked for in the folder where it is started. The last line is "N passed, N failed". With a folder
// it leaves screenshots there, to be looked at.
import { existsSync, mkdirSync, statSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { check, count, file, screenshots } from "./browser_tab.mjs";
import { checkAllControls } from "./browser_controls.mjs";
import { checkChange } from "./browser_change.mjs";
import { checkFirst } from "./browser_first.mjs";
import { checkGiven } from "./browser_given.mjs";
import { checkLife } from "./browser_life.mjs";
import { checkLooks } from "./browser_looks.mjs";
import { checkMouse } from "./browser_mouse.mjs";
import { checkOwn } from "./browser_own.mjs";
import { checkPlot } from "./browser_plot.mjs";
import { checkQuestions } from "./browser_questions.mjs";
import { checkStill } from "./browser_still.mjs";
import { checkView } from "./browser_view.mjs";
import { checkWays } from "./browser_ways.mjs";

const { chromium } = createRequire(join(process.cwd(), "web"))("playwright-core");
const largest = 1.6e6; // [bytes]

const browserPath = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find(
  existsSync,
);
if (!browserPath || !existsSync(file)) {
  console.log(`There is no ${browserPath ? file : "chromium here"}.\n0 passed, 1 failed`);
  process.exit(1);
}
if (screenshots) mkdirSync(screenshots, { recursive: true });
const browser = await chromium.launch({
  executablePath: browserPath,
  args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});
try {
  check(statSync(file).size <= largest, `the file has at most ${largest} bytes`, String(statSync(file).size));
  await checkAllControls(browser);
  await checkChange(browser);
  await checkFirst(browser);
  await checkGiven(browser);
  await checkLife(browser);
  await checkMouse(browser);
  await checkOwn(browser);
  await checkPlot(browser);
  await checkQuestions(browser);
  await checkStill(browser);
  await checkView(browser);
  await checkWays(browser);
  await checkLooks(browser);
} catch (error) {
  check(false, "the test runs to its end", error.message);
} finally {
  await browser.close();
}
console.log(`${count.passed} passed, ${count.failed} failed`);
process.exit(count.failed === 0 ? 0 : 1);
