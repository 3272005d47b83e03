// Drives the editor in headless Chromium by real clicks, keys, fingers and dropped files: page.js ADDRESS PROGRAM FOLDER.
// FOLDER holds mine.wif, painted.wif (the same with a cell painted by the desktop's core) and pictures/ of drafts, each of
// which looks in the page as PROGRAM, the desktop's, renders it. With STEPS="drop link" in the environment only those run.
'use strict';

const path = require('path');
const fs = require('fs');
const {Browser} = require('./browser.js');

const [address, program, folder] = process.argv.slice(2);
const {first_picture, ...seen} = require('./steps_pictures.js');
const kSteps = {first_picture, ...require('./steps_files.js'), ...seen, ...require('./steps_touch.js'),
                ...require('./steps_host.js')};
const kPictures = 'build/web/pictures';  // for whoever wants to look

async function main() {
  fs.mkdirSync(kPictures, {recursive: true});
  const browser = await Browser.start(process.env.CHROMIUM || 'chromium');
  const chosen = process.env.STEPS ? process.env.STEPS.split(' ') : Object.keys(kSteps);
  let failed = 0;
  const t = {
    browser, address: address + '?ui-map=/ui.json', program, folder, page: null,
    mine: path.join(folder, 'mine.wif'),
    check(what, holds, detail = '') {
      failed += holds ? 0 : 1;
      console.log((holds ? 'ok    ' : 'FAILED ') + what + (detail ? ': ' + detail : ''));
    },
    tell(what) { console.log('      ' + what); },
    /// The page of the steps so far, or a new one.
    async at_page() { return this.page ??= await browser.open(this.address); },
    show(name) { return this.page.picture(path.join(kPictures, name + '.png')); },
  };
  for (const name of chosen) {
    const before = failed, begun = Date.now();
    try {
      await kSteps[name](t);
    } catch (error) {
      t.check(name + ': ' + error.message, false);
      if (t.page) await t.show('failed_' + name).catch(() => {});
    }
    if (process.env.STEPS) t.tell(name + ' took ' + ((Date.now() - begun) / 1000).toFixed(1) + ' s');
    if (failed === before) continue;
    if (t.page) console.log(t.page.said.slice(-20).join('\n'));
    if (t.page) await browser.close_page(t.page).catch(() => {});
    t.page = null;  // the next step begins anew
  }
  await browser.close();
  process.exit(failed ? 1 : 0);
}

main();
