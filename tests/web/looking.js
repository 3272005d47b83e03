// How the steps look at the picture of the cloth.
'use strict';

const path = require('path');
const {execFileSync} = require('child_process');
const {comesTrue} = require('./browser.js');

/// The mean difference of two pictures, of 255 a channel.
function difference(a, b) {
  let sum = 0;
  for (let i = 0; i < a.length; ++i) sum += Math.abs(a[i] - b[i]);
  return sum / a.length;
}

/// Three bytes a pixel.
function pixels_of(file) {
  return execFileSync('convert', [file, '-alpha', 'off', '-depth', '8', 'rgb:-'], {maxBuffer: 256 << 20});
}

/// The picture of the cloth, once it is finished: nothing is computed, and all its samples are drawn.
async function at_rest(page) {
  const kBeginsMs = 3000, kOften = 5;  // an edit that was just made is seen by then; so often it is finished
  const end = Date.now() + kBeginsMs;
  let begun = false, often = 0;
  const view = await comesTrue('the picture of the cloth is finished', async () => {
    const {controls} = await page.map();
    const has = name => controls.some(one => one.name === name);
    const done = has('view.picture') && !has('view.busy') && !has('view.refining');
    begun ||= !done || Date.now() > end;
    often = begun && done ? often + 1 : 0;
    return often === kOften && controls.find(one => one.name === 'view');
  }, 240);
  return page.pixels(view);
}

async function open_file(page, file) {
  await page.control('view');  // it listens
  await page.call('Page.setInterceptFileChooserDialog', {enabled: true});
  page.picks = path.resolve(file);
  await page.key('Ctrl+O');
  await page.title(path.basename(file));
}

module.exports = {at_rest, difference, open_file, pixels_of};
