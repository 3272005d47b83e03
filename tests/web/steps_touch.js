// What fingers do, and whether they hit what they are to press, on a tablet held either way.
'use strict';

const fs = require('fs');
const path = require('path');
const {comesTrue, sleep} = require('./browser.js');
const {at_rest, open_file} = require('./looking.js');

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

  await page.touch('touchStart', [await page.cell('tieup', 3, 8)]);
  await sleep(800);
  await page.touch('touchEnd', []);
  await page.unsaved();
  t.check('a finger held still is the right button, which clears', true);
  await page.key('Ctrl+Z');
  await page.title('mine.wif');

  const pitch = async () => Math.abs((await page.map()).grids.find(one => one.name === 'drawdown').step_a[0]);
  const start = await pitch(), [x, y] = await page.cell('drawdown', 4, 4);
  const apart = by => [[x - by, y], [x + by, y]];
  await page.touch('touchStart', apart(20));
  for (let by = 25; by <= 80; by += 5) await page.touch('touchMove', apart(by));
  await page.touch('touchEnd', []);
  const wide = await comesTrue('the cells are larger', async () => await pitch() > start * 1.2 && pitch());
  t.check('a pinch enlarges the cells', true, start + ' to ' + wide + ' pixels');
  t.check('and paints nothing', !(await page.ask('document.title')).startsWith('\u25CF'));

  const at = async () => (await page.map()).grids.find(one => one.name === 'drawdown').origin;
  const [left, top] = await at(), both = d => [[x - 20 + d, y + d], [x + 20 + d, y + d]];
  await page.touch('touchStart', both(0));
  for (let d = 10; d <= 120; d += 10) await page.touch('touchMove', both(d));
  await page.touch('touchEnd', []);
  const moved = await comesTrue('the grid moved', async () => {
    const [a, b] = await at();
    return Math.hypot(a - left, b - top) > 20 && [a - left, b - top];
  });
  t.check('two fingers move the grid', true, moved.map(Math.round).join(', ') + ' pixels');

  await t.browser.close_page(page);
}

const kFinger = 44;  // points

/// The names of what is pressed and is lower than a finger needs; cells and threads are enlarged by a pinch.
async function too_small(page) {
  const {controls} = await page.map();
  const seen = /^(tip|question|view|draft\.heading|origin|analysis\.loom_sett|tab\.(shown|unsaved)|task|strip|lobes|scroll|floats\.count|plan\.(finished|weave|sett|in_reed|warp|bouts|groups|weft)|buy|sold)/;  // not pressed
  const pressed = controls.filter(one => one.h > 0 && !seen.test(one.name));  // an open menu has no place
  return pressed.filter(one => one.h < kFinger).map(one => one.name + ' ' + one.h);
}

async function tap(page, name) {
  await page.touch('touchStart', [await page.middle(name)]);
  await page.touch('touchEnd', []);
}

/// What can be pressed in the window now.
async function names(page) {
  return (await page.map()).controls.map(one => one.name).filter(name => !name.startsWith('tip')).join();
}

async function tablet(t) {
  for (const [width, height] of [[1024, 768], [768, 1024]]) {
    const held = width + 'x' + height, small = new Set();
    const look = async () => { for (const one of await too_small(page)) small.add(one); };
    const page = await t.browser.open(t.address, width, height, true);
    await open_file(page, t.mine);
    await tap(page, 'view');
    await comesTrue('the window is one for fingers', async () => (await page.control('menu:File')).h >= kFinger);
    await at_rest(page);
    await page.picture('build/web/pictures/tablet_' + held + '.png');
    const part = async name => (await page.map()).controls.find(one => one.name === name);
    const split = await part('split');
    t.check(held + ': the splitter is as wide as a finger', Math.min(split.w, split.h) >= kFinger);
    for (const tab of ['Yarns', 'Cloth', 'Analysis', 'Plan', 'Threads']) {  // the last one is open at the start
      const before = await names(page);
      await tap(page, 'inspector:' + tab);
      await comesTrue('the page ' + tab, async () => await names(page) !== before);
      await look();
      if (tab === 'Cloth') await page.picture('build/web/pictures/tablet_' + held + '_cloth.png');
    }
    for (const menu of ['File', 'Edit', 'View']) {
      await tap(page, 'menu:' + menu);
      await comesTrue('the menu ' + menu, async () => (await page.map()).controls.some(one => one.name.startsWith('menu.')));
      await look();
      if (menu === 'File') await page.picture('build/web/pictures/tablet_' + held + '_menu.png');
      await page.key('Escape');
      await comesTrue('the menu closes', async () => !(await page.map()).controls.some(one => one.name.startsWith('menu.')));
    }
    t.check(held + ': what is pressed is as high as a finger', !small.size, [...small].join(', '));
    await t.browser.close_page(page);
  }
}

module.exports = {fingers, tablet};
