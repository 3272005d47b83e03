// What belongs to the page and its host: the handbook beside it, and a host that sends no headers.
'use strict';

const fs = require('fs');
const http = require('http');
const path = require('path');
const {comesTrue} = require('./browser.js');

const kPage = 'build/web/page';

async function handbook(t) {
  if (!fs.existsSync(path.join(kPage, 'handbook/index.html')))
    return t.tell('the handbook was not built (python3-markdown is missing)');
  const page = await t.at_page();
  await page.control('view');
  await page.key('Shift+F1');
  const found = await comesTrue('the handbook', async () =>
    (await t.browser.addresses()).find(one => one.endsWith('/handbook/index.html')));
  t.check('Shift+F1 opens the handbook beside the page', true, found);
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

module.exports = {handbook, without_headers};
