// What is seen: the first picture, finished pictures beside the desktop's, and other shapes.
'use strict';

const fs = require('fs');
const path = require('path');
const {execFileSync} = require('child_process');
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

/// The means of squares of k by k pixels.
function blocks(rgb, width, k) {
  const height = rgb.length / 3 / width, out = [];
  for (let y = 0; y + k <= height; y += k)
    for (let x = 0; x + k <= width; x += k)
      for (let c = 0; c < 3; ++c) {
        let sum = 0;
        for (let j = 0; j < k; ++j) for (let i = 0; i < k; ++i) sum += rgb[3 * ((y + j) * width + x + i) + c];
        out.push(sum / k / k);
      }
  return out;
}

/// Finished pictures of drafts. The window draws the samples of the threads in passes, and as many as there is time for, so
/// that single pixels differ there; `yarn` is held against the desktop's by squares of four pixels.
async function pictures(t) {
  const page = await t.browser.open(t.address, 760, 520);
  for (const name of fs.readdirSync(path.join(t.folder, 'pictures')).sort()) {
    const file = path.join(t.folder, 'pictures', name);
    await open_file(page, file);
    const made = path.join(t.folder, 'desktop.png');
    const [k, most] = name.includes('_yarn') ? [4, 2.5] : [1, 1.5];
    // On a busy machine a draft that was just opened may be drawn later than at_rest() waits for it to begin, and so may the
    // row of tabs, which makes the view lower.
    let here = [], there = [], size = '', apart = Infinity;
    for (const end = Date.now() + 120e3; apart >= most && Date.now() < end;) {
      const seen = await at_rest(page);
      const {w, h} = await page.control('view'), width = Math.round(w), height = Math.round(h);
      // The cloth alone, without the ground around it.
      const middle = rgb => rgb.subarray(3 * width * Math.round(0.35 * height), 3 * width * Math.round(0.6 * height));
      if (size !== width + 'x' + height) {
        size = width + 'x' + height;
        execFileSync(t.program, ['render', file, '-o', made, '--size', size], {stdio: 'ignore'});
        there = middle(pixels_of(made));
        fs.copyFileSync(made, 'build/web/pictures/' + name + '_desktop.png');
      }
      here = middle(seen);
      apart = seen.length === 3 * width * height ? difference(blocks(here, width, k), blocks(there, width, k)) : Infinity;
    }
    await page.picture('build/web/pictures/' + name + '.png');
    t.check('the picture of ' + name + ' is the desktop\'s', here.length === there.length && apart < most,
            apart.toFixed(2) + ' of 255 a channel');
  }
  await t.browser.close_page(page);
}

/// A shape that did not come with the program is fetched from beside the page.
async function other_shape(t) {
  const page = await t.at_page();
  await open_file(page, t.mine);
  const before = await at_rest(page);
  const kMeshes = '/weftlight/presets/meshes';
  const skirts = () => page.ask(`Weftlight.program.FS.readdir('${kMeshes}').filter(one => one.startsWith('skirt'))`);
  t.check('a shape that no draft shows is not there yet', !(await skirts()).length);
  await page.press('inspector:Cloth');
  await page.press('scene.mesh');
  await page.press('mesh:skirt');
  await page.unsaved();
  const after = await at_rest(page);
  const names = await skirts();
  const whole = await Promise.all(names.map(async one =>
    await page.ask(`Weftlight.program.FS.stat('${kMeshes}/${one}').size`) === fs.statSync('presets/meshes/' + one).size));
  t.check('the shape is fetched when it is chosen', names.length && !whole.includes(false), names.join(', '));
  t.check('and shown', difference(before, after) > 1, difference(before, after).toFixed(1) + ' of 255 a channel');
  await t.show('skirt');
  await page.key('Ctrl+Z');
}

module.exports = {first_picture, pictures, other_shape};
