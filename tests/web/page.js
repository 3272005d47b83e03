// Drives the editor in headless Chromium by real clicks: page.js ADDRESS DRAFT PAINTED PROGRAM DRAFTS... DRAFT is opened, a
// cell of its tie-up painted and the file saved, which then has the bytes of PAINTED, made by the desktop's core; the tab is
// killed and the work comes back. Each of DRAFTS looks as PROGRAM, the desktop's, renders it, within a tolerance.
'use strict';

const fs = require('fs');
const path = require('path');
const {execFileSync} = require('child_process');
const {Browser, comesTrue, sleep} = require('./browser.js');

const [address, draft, painted, program, ...drafts] = process.argv.slice(2);
const results = [];
function check(what, holds, detail = '') {
  results.push(holds);
  console.log((holds ? 'ok    ' : 'FAILED ') + what + (detail ? ': ' + detail : ''));
}

/// How many colours a picture has, which tells a cloth from a sentence.
function colors(rgb) {
  const seen = new Set();
  for (let i = 0; i + 2 < rgb.length; i += 3) seen.add((rgb[i] >> 3) << 10 | (rgb[i + 1] >> 3) << 5 | rgb[i + 2] >> 3);
  return seen.size;
}
const kCloth = 150;
function difference(a, b) {
  let sum = 0;
  for (let i = 0; i < a.length; ++i) sum += Math.abs(a[i] - b[i]);
  return sum / a.length;
}

/// The draft that is shown has a cloth, which no longer changes.
async function atRest(page) {
  const view = await page.control('view');
  let last;
  return comesTrue('the picture of the cloth comes to rest', async () => {
    const now = await page.pixels(view);
    const still = last && Buffer.compare(last, now) === 0 && colors(now) > kCloth;
    last = now;
    await sleep(700);
    return still && now;
  }, 120);
}

async function openFile(page, file) {
  await page.call('Page.setInterceptFileChooserDialog', {enabled: true});
  page.picks = path.resolve(file);
  await page.key('Ctrl+O');
  const name = path.basename(file);
  await comesTrue(name + ' is open', () => page.ask(`document.title.startsWith(${JSON.stringify(name)})`));
}

async function main() {
  const browser = await Browser.start(process.env.CHROMIUM || 'chromium');
  let page;
  try {
    page = await browser.open(address + '?ui-map=/ui.json');
    const view = await page.control('view');
    const shown = Date.now();
    await comesTrue('a first picture', async () => colors(await page.pixels(view)) > kCloth, 120);
    console.log(`      the window after ${((shown - page.opened) / 1000).toFixed(1)} s, its first picture of the cloth after ` +
                `${((Date.now() - page.opened) / 1000).toFixed(1)} s`);
    await page.picture('build/web/first.png');

    await openFile(page, draft);
    const before = await atRest(page);
    await page.picture('build/web/opened.png');
    await page.click(...await page.cell('tieup', 1, 1));
    await comesTrue('the draft is unsaved', () => page.ask('document.title.startsWith("\\u25CF")'));
    const after = await atRest(page);
    check('a painted cell changes the picture of the cloth', difference(before, after) > 0.02,
          difference(before, after).toFixed(3) + ' of 255 a channel');
    await page.picture('build/web/painted.png');

    await page.key('Ctrl+S');
    const saved = await browser.download(path.basename(draft));
    check('the saved file has the bytes of the desktop\'s', saved.equals(fs.readFileSync(painted)));

    // A second edit, unsaved, and the tab dies.
    await page.click(...await page.cell('tieup', 1, 1));
    await comesTrue('the draft is unsaved', () => page.ask('document.title.startsWith("\\u25CF")'));
    await sleep(1500);
    page.call('Page.crash').catch(() => {});
    await sleep(500);
    await browser.call('Target.closeTarget', {targetId: page.target});
    page = await browser.open(address + '?ui-map=/ui.json');
    await page.press('dialog:Recover');
    await comesTrue('the work is back', () => page.ask(`document.title.includes(${JSON.stringify(path.basename(draft))})`));
    await page.key('Ctrl+S');
    const again = await browser.download(path.basename(draft));
    check('unsaved work comes back after the tab died', again.equals(fs.readFileSync(draft)));

    for (const file of drafts) {
      await openFile(page, file);
      const {w, h} = await page.control('view'), width = Math.round(w), height = Math.round(h);
      // Between what stands over the picture, at its top and at its foot.
      const middle = rgb => rgb.subarray(3 * width * Math.round(0.12 * height), 3 * width * Math.round(0.92 * height));
      const here = middle(await atRest(page)), made = path.join(browser.folder, 'desktop.png');
      execFileSync(program, ['render', file, '-o', made, '--size', width + 'x' + height], {stdio: 'ignore'});
      const there = middle(execFileSync('convert', [made, '-depth', '8', 'rgb:-'], {maxBuffer: 64 << 20}));
      const name = path.basename(file);
      await page.picture('build/web/' + name + '.png');
      check('the picture of ' + name + ' is the desktop\'s', here.length === there.length && difference(here, there) < 3,
            here.length === there.length ? difference(here, there).toFixed(2) + ' of 255 a channel' : 'another size');
    }
  } catch (error) {
    check(error.message, false);
    if (page) await page.picture('build/web/failed.png').catch(() => {});
  }
  if (results.includes(false) && page) console.log(page.said.slice(-20).join('\n'));
  await browser.close();
  process.exit(results.includes(false) ? 1 : 0);
}

main();
