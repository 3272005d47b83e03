// What belongs to the page and its host: the handbook beside it, a host that sends no headers, and a graphics driver
// that is reset.
'use strict';

const fs = require('fs');
const http = require('http');
const path = require('path');
const {comesTrue} = require('./browser.js');
const {at_rest, difference, open_file} = require('./looking.js');

const kPage = 'build/web/page';
const kAll = {x: 0, y: 0, w: 1280, h: 800};

async function handbook(t) {
  if (!fs.existsSync(path.join(kPage, 'handbook/index.html')))
    return t.tell('the handbook was not built (python3-markdown is missing)');
  const page = await t.at_page();
  await page.control('view');
  await page.key('Shift+F1');
  const found = await comesTrue('the handbook', async () =>
    (await t.browser.addresses()).find(one => one.endsWith('/handbook/index.html')));
  t.check('Shift+F1 opens the handbook beside the page', true, found);
  await t.browser.close_address(found);  // and the page has the front again
}

/// Serves the page as a host does that knows nothing of threads.
function bare_host() {
  const kinds = {'.html': 'text/html', '.js': 'text/javascript', '.wasm': 'application/wasm'};
  const server = http.createServer((asked, answer) => {
    const name = path.normalize(decodeURI(asked.url.replace(/[?#].*/, ''))).replace(/\/$/, '/index.html');
    const file = path.join(kPage, name);
    if (!fs.existsSync(file)) return answer.writeHead(404).end();
    answer.writeHead(200, {'Content-Type': kinds[path.extname(file)] || 'application/octet-stream'});
    fs.createReadStream(file).pipe(answer);
  });
  return new Promise(done => server.listen(0, '127.0.0.1', () => done(server)));
}

async function without_headers(t) {
  const server = await bare_host();
  const page = await t.browser.open('http://localhost:' + server.address().port + '/?ui-map=/ui.json');
  await page.control('view');
  t.check('a host without headers serves it: the page\'s worker adds them', await page.ask('crossOriginIsolated'));
  await t.browser.close_page(page);
  server.close();
  server.closeAllConnections?.();
}

/// The page loses its GL context, as where a driver is reset; it is given back, and the window goes on where it was.
async function lost_context(t) {
  const page = await t.at_page();
  await open_file(page, t.mine);
  await page.click(...await page.cell('tieup', 1, 1));
  await page.unsaved();
  const before = await at_rest(page), window_before = await page.pixels(kAll);
  await t.show('before_loss');
  const notice = () => page.ask('document.getElementById("notice").hidden ? "" : document.getElementById("words").textContent');
  await page.ask(`window.lost = document.getElementById('canvas').getContext('webgl2').getExtension('WEBGL_lose_context');
                  window.stays = true;
                  lost.loseContext();`);
  const says = await comesTrue('the page says that the context is lost', notice);
  t.check('a lost context is a sentence', /driver was reset/.test(says), says);
  await page.ask('lost.restoreContext()');
  await comesTrue('the window is back', async () => !await notice());
  const after = await at_rest(page), window_after = await page.pixels(kAll);
  await t.show('after_loss');
  t.check('the cloth is drawn anew', difference(before, after) < 0.5, difference(before, after).toFixed(2) + ' of 255 a channel');
  t.check('and all of the window', difference(window_before, window_after) < 0.5,
          difference(window_before, window_after).toFixed(2) + ' of 255 a channel');
  t.check('in the same page', await page.ask('window.stays === true'));
  await page.key('Ctrl+Z');
  await page.title('mine.wif');
  t.check('undo goes on where it was', true);
}

module.exports = {lost_context, handbook, without_headers};
