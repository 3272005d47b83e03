// What is seen: the first picture, finished pictures beside the desktop's, other shapes, and what fingers do.
'use strict';

const fs = require('fs');
const path = require('path');
const {execFileSync} = require('child_process');
const {comesTrue, sleep} = require('./browser.js');
const {at_rest, difference, open_file, pixels_of} = require('./looking.js');

async function first_picture(t) {
  const page = await t.at_page();
  await page.control('view');
  const shown = Date.now();
  await page.control('view.picture');
  const seconds = from => ((from - page.opened) / 1000).toFixed(1) + ' s';
  t.tell('the window after ' + seconds(shown) + ', its first picture of the cloth after ' + seconds(Date.now()));
  await t.show('first');
}

/// Finished pictures of drafts, small ones: a card in software has the time for all samples of the threads then.
async function pictures(t) {
  const page = await t.browser.open(t.address, 760, 520);
  for (const name of fs.readdirSync(path.join(t.folder, 'pictures')).sort()) {
    const file = path.join(t.folder, 'pictures', name);
    await open_file(page, file);
    const {w, h} = await page.control('view'), width = Math.round(w), height = Math.round(h);
    // Between what stands over the picture, at its top and at its foot.
    const middle = rgb => rgb.subarray(3 * width * Math.round(0.2 * height), 3 * width * Math.round(0.86 * height));
    const here = middle(await at_rest(page)), made = path.join(t.folder, 'desktop.png');
    execFileSync(t.program, ['render', file, '-o', made, '--size', width + 'x' + height], {stdio: 'ignore'});
    const there = middle(pixels_of(made));
    await page.picture('build/web/pictures/' + name + '.png');
    fs.copyFileSync(made, 'build/web/pictures/' + name + '_desktop.png');
    t.check('the picture of ' + name + ' is the desktop\'s', here.length === there.length && difference(here, there) < 3,
            here.length === there.length ? difference(here, there).toFixed(2) + ' of 255 a channel' : 'another size');
  }
  await t.browser.close_page(page);
}

/// A shape that did not come with the program is fetched from beside the page.
async function other_shape(t) {
  const page = await t.at_page();
  await open_file(page, t.mine);
  const before = await at_rest(page);
  const size = () => page.ask(`(() => { try { return Weftlight.program.FS.stat('/weftlight/presets/meshes/cushion.glb').size; }
                                        catch { return 0; } })()`);
  t.check('a shape that no draft shows is not there yet', await size() === 0);
  await page.press('inspector:Scene');
  await page.press('scene.mesh');
  await page.press('mesh:cushion');
  await page.unsaved();
  const after = await at_rest(page);
  t.check('the shape is fetched when it is chosen', await size() === fs.statSync('presets/meshes/cushion.glb').size);
  t.check('and shown', difference(before, after) > 1, difference(before, after).toFixed(1) + ' of 255 a channel');
  await t.show('cushion');
  await page.key('Ctrl+Z');
}

async function fingers(t) {
  const page = await t.browser.open(t.address, 1180, 820, true);
  await open_file(page, t.mine);
  await at_rest(page);
  const cell = await page.cell('tieup', 1, 1);
  await page.touch('touchStart', [cell]);
  await page.touch('touchEnd', []);
  await page.unsaved();
  await page.key('Ctrl+S');
  const saved = await t.browser.download('mine.wif');
  t.check('a finger paints a cell', saved.equals(fs.readFileSync(path.join(t.folder, 'painted.wif'))));

  const pitch = async () => Math.abs((await page.map()).grids.find(one => one.name === 'drawdown').step_a[0]);
  const start = await pitch(), [x, y] = await page.cell('drawdown', 4, 4);
  const apart = by => [[x - by, y], [x + by, y]];
  await page.touch('touchStart', [apart(20)[0]]);
  await page.touch('touchStart', apart(20));
  for (let by = 25; by <= 80; by += 5) await page.touch('touchMove', apart(by));
  await page.touch('touchEnd', []);
  const wide = await comesTrue('the cells are larger', async () => await pitch() > start * 1.2 && pitch());
  t.check('a pinch enlarges the cells', true, start + ' to ' + wide + ' pixels');
  t.check('and paints nothing', !(await page.ask('document.title')).startsWith('\u25CF'));

  const at = async () => (await page.map()).grids.find(one => one.name === 'drawdown').origin;
  const [left, top] = await at(), both = d => [[x - 20 + d, y + d], [x + 20 + d, y + d]];
  await page.touch('touchStart', [both(0)[0]]);
  await page.touch('touchStart', both(0));
  for (let d = 10; d <= 120; d += 10) await page.touch('touchMove', both(d));
  await page.touch('touchEnd', []);
  const moved = await comesTrue('the grid moved', async () => {
    const [a, b] = await at();
    return Math.hypot(a - left, b - top) > 20 && [a - left, b - top];
  });
  t.check('two fingers move the grid', true, moved.map(Math.round).join(', ') + ' pixels');

  await page.touch('touchStart', [await page.cell('drawdown', 3, 3)]);
  await sleep(800);
  await page.touch('touchEnd', []);
  await comesTrue('a menu', async () => (await page.map()).controls.some(one => one.name.startsWith('context.')));
  t.check('a finger held still opens the menu', true);
  await page.picture('build/web/pictures/tablet.png');
  await t.browser.close_page(page);
}

module.exports = {first_picture, pictures, other_shape, fingers};
