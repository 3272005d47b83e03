// What a person does with files: opens, paints, saves, loses the tab, drops, sends a link, exports.
'use strict';

const fs = require('fs');
const path = require('path');
const zlib = require('zlib');
const {execFileSync} = require('child_process');
const {comesTrue} = require('./browser.js');
const {at_rest, difference, open_file, pixels_of} = require('./looking.js');

/// The grids have their place once the picture is finished: a second tab moves them down after the title has changed.
async function paint_a_cell(page) {
  await at_rest(page);
  await page.click(...await page.cell('tieup', 1, 1));
  await page.unsaved();
}

const bytes_of = (t, name) => fs.readFileSync(path.join(t.folder, name));

async function painted(t) {
  const page = await t.at_page();
  await open_file(page, t.mine);
  const before = await at_rest(page);
  await paint_a_cell(page);
  const after = await at_rest(page);
  t.check('a painted cell changes the picture of the cloth', difference(before, after) > 0.02,
          difference(before, after).toFixed(3) + ' of 255 a channel');
  await t.show('painted');
  await page.key('Ctrl+S');
  const saved = await t.browser.download('mine.wif');
  t.check('the saved file has the bytes of the desktop\'s', saved.equals(bytes_of(t, 'painted.wif')));
}

/// The first line in which two drafts differ, empty if there is none.
function difference_of(wanted, found) {
  const [one, other] = [wanted, found].map(bytes => bytes.toString('latin1').split('\n'));
  const at = one.findIndex((line, k) => line !== other[k]);
  return at < 0 ? '' : 'line ' + (at + 1) + ' is ' + JSON.stringify(other[at]) + ', not ' + JSON.stringify(one[at]);
}

/// The unsaved work that the browser keeps (editor/web/kept.js), and the locks that its pages hold.
const kKept = `(async () => {
  const base = await new Promise(done => { const asked = indexedDB.open('weftlight', 1); asked.onsuccess = () => done(asked.result); });
  const files = base.transaction('files').objectStore('files');
  const ask = what => new Promise(done => { what.onsuccess = () => done(what.result); });
  const names = await ask(files.getAllKeys());
  base.close();
  const {held} = await navigator.locks.query();
  return {work: names.filter(name => !name.startsWith('all|')).join(),
          locks: held.map(one => one.name)};
})()`;

/// A second edit, unsaved, and the tab dies.
async function killed(t) {
  const page = await t.at_page();
  await open_file(page, path.join(t.folder, 'painted.wif'));
  await paint_a_cell(page);
  const {locks} = await comesTrue('the edit is kept', async () => {
    const now = await page.ask(kKept);
    return now.work.includes('.journal') && now;
  });
  page.call('Page.crash').catch(() => {});
  await t.browser.close_page(page);
  const other = await t.browser.open(t.address.replace(/[^/]*$/, 'handbook/index.html'));
  await comesTrue('the browser gives the lock of the dead tab back', async () => {
    const held = await other.ask(`location.href !== 'about:blank' &&
      navigator.locks.query().then(now => now.held.map(lock => lock.name))`);
    return held && !held.some(name => locks.includes(name));
  });
  await t.browser.close_page(other);
  t.page = null;
  const next = await t.at_page();
  await next.press('dialog:Recover');
  await comesTrue('the work is back', () => next.ask('document.title.includes("painted.wif")'));
  await next.key('Ctrl+S');
  const again = await t.browser.download('painted.wif');
  t.check('unsaved work comes back after the tab died', again.equals(fs.readFileSync(t.mine)),
          difference_of(fs.readFileSync(t.mine), again));
}

async function dropped(t) {
  const page = await t.at_page();
  const file = path.join(t.folder, 'dropped.wif');
  fs.copyFileSync(t.mine, file);
  const [x, y] = await page.middle('view');
  await page.drop(x, y, [file]);
  await page.title('dropped.wif');
  await paint_a_cell(page);
  await page.key('Ctrl+S');
  const saved = await t.browser.download('dropped.wif');
  t.check('a dropped file opens, and is saved by its name', saved.equals(bytes_of(t, 'painted.wif')));
}

async function linked(t) {
  const page = await t.at_page();
  await open_file(page, t.mine);
  await page.choose('File', 'copy_link');
  const link = await comesTrue('a link', async () => {
    const copied = await page.ask('Weftlight.program.copied || ""');
    return copied.includes('#draft=') && copied;
  });
  const inside = zlib.inflateRawSync(Buffer.from(link.replace(/.*#draft=/, ''), 'base64url'));
  const other = await t.browser.open(link);
  await other.title('from a link.wif');
  await other.key('Ctrl+S');
  const saved = await t.browser.download('from a link.wif');
  t.check('whoever opens the link has the draft', saved.equals(inside), link.length + ' characters');
  const file = path.join(t.folder, 'linked.wif');
  fs.writeFileSync(file, saved);
  const cells = of => execFileSync(t.program, ['drawdown', of]).toString();
  t.check('it weaves as the draft it was made from', cells(file) === cells(t.mine));
  // Another link into the same page is another draft beside it.
  await other.ask(`location.hash = ${JSON.stringify(a_link_to(t, 'twill_2_2_cell.wif'))}`);
  await other.title('from a link 2.wif');
  t.check('a second link is a second draft', true);
  await t.browser.close_page(other);

  const damaged = await t.browser.open(link.slice(0, link.length - 40));
  await damaged.control('view');
  const says = await damaged.ask('document.getElementById("toast").textContent');
  t.check('a damaged link is a sentence', /damaged/.test(says), says);
  t.check('and a new draft beside it', !(await damaged.ask('document.title')).includes('link'));
  await t.browser.close_page(damaged);
}
function a_link_to(t, name) {
  const bytes = fs.readFileSync(path.join(t.folder, 'pictures', name));
  return '#draft=' + zlib.deflateRawSync(bytes).toString('base64url');
}

/// Whether two values of JSON are the same but for the last digits of numbers, the sizes of files (other libraries make the
/// .png) and the key by which the command knows a set again.
function alike(a, b) {
  if (typeof a === 'number' && typeof b === 'number') return Math.abs(a - b) <= 1e-5 * Math.max(1, Math.abs(a));
  if (!a || !b || typeof a !== 'object' || typeof b !== 'object') return a === b;
  const keys = of => Object.keys(of).filter(key => !['bytes', 'fnv1a', 'key'].includes(key));
  return keys(a).join() === keys(b).join() && keys(a).every(key => alike(a[key], b[key]));
}

/// A texture set comes as a .zip: the desktop's files, with the desktop's pixels.
async function exported(t) {
  const page = await t.at_page();
  await open_file(page, t.mine);
  await page.key('Ctrl+E');
  await page.press('export.size:512');
  await page.press('dialog:Export');
  const zip = path.join(t.folder, 'set.zip'), here = path.join(t.folder, 'set'), there = path.join(t.folder, 'desktop');
  fs.writeFileSync(zip, await t.browser.download('mine.zip', 120));
  await t.show('exported');
  await page.press('dialog:Close');
  execFileSync('python3', ['-m', 'zipfile', '-e', zip, here]);
  execFileSync(t.program, ['export', t.mine, '--target', 'gltf', '-o', there, '--size', '512', '--mesh', 'tablecloth'],
               {stdio: 'ignore'});
  const names = of => fs.readdirSync(path.join(of, 'mine')).sort(), files = names(there);
  t.check('the .zip holds the files of the desktop\'s set', files.join() === names(here).join(), files.length + ' files');
  const differ = files.filter(name => {
    const [a, b] = [here, there].map(where => path.join(where, 'mine', name));
    if (name === 'contact_sheet.png') return false;  // without OpenImageIO it has no lettering
    if (name.endsWith('.glb')) return false;         // which holds the .png
    if (name.endsWith('.png')) return !(difference(pixels_of(a), pixels_of(b)) < 0.01);
    const [x, y] = [a, b].map(file => fs.readFileSync(file));
    return /\.(json|gltf)$/.test(name) ? !alike(JSON.parse(x), JSON.parse(y)) : !x.equals(y);
  });
  t.check('each with what the desktop\'s holds', !differ.length, differ.join(', '));
}

module.exports = {painted, killed, dropped, linked, exported};
