// node three_js.js WEFTLIGHT THREE_FOLDER CHROMIUM DRAFT...
// Exports each draft as .glb on the plane, shows it in three.js in headless Chromium, and holds the mean radiance against
// what texture_set.json says that the material sends and that the cloth sends. Leaves with 0, 1 (too far apart) or 77
// (something is not installed). With --table it prints every figure.
'use strict';
const fs = require('fs');
const http = require('http');
const os = require('os');
const path = require('path');
const { execFile, execFileSync } = require('child_process');

const kEngineTolerance = 0.35;  // of the prediction, mean over azimuths: highlights differ by the mips that are seen
const kClothTolerance = [[60, 0.30], [75, 0.40], [90, 0.8]];  // of the cloth, mean over azimuths, up to so many degrees
const kWindowM = 0.12;          // of the plane that is seen
const kTypes = { '.html': 'text/html', '.js': 'text/javascript', '.json': 'application/json', '.glb': 'model/gltf-binary' };

function serve(folders) {
  const server = http.createServer((request, response) => {
    const name = decodeURIComponent(request.url.split('?')[0]);
    const file = folders(name);
    if (!file || !fs.existsSync(file)) { response.writeHead(404); response.end(); return; }
    response.writeHead(200, { 'Content-Type': kTypes[path.extname(file)] || 'application/octet-stream' });
    fs.createReadStream(file).pipe(response);
  });
  return new Promise((done) => server.listen(0, '127.0.0.1', () => done(server)));
}

function shown(chromium, port, profile) {
  const args = ['--headless', '--no-sandbox', '--disable-dev-shm-usage', '--use-angle=swiftshader',
    '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist', `--user-data-dir=${profile}`, '--virtual-time-budget=600000',
    '--dump-dom', `http://127.0.0.1:${port}/page.html`];
  return new Promise((done, fail) => execFile(chromium, args, { maxBuffer: 1 << 26, timeout: 300000 }, (error, out) => {
    const text = /<pre id="out">([^<]*)<\/pre>/.exec(out || '');
    if (!text || !text[1]) return fail(error || new Error('the page told nothing'));
    const result = JSON.parse(text[1]);
    return result.error ? fail(new Error(result.error)) : done(result);
  }));
}

const luminance = (c) => 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
const degrees = (v) => Math.acos(Math.min(1, v[2])) * 180 / Math.PI;

async function measure(weftlight, three, chromium, draft, folder) {
  const name = path.basename(draft, '.wif');
  execFileSync(weftlight, ['export', draft, '--mesh', 'plane', '--size', '512', '-o', folder], { stdio: ['ignore', 'ignore', 'inherit'] });
  const set = path.join(folder, name);
  const list = JSON.parse(fs.readFileSync(path.join(set, 'texture_set.json')));
  const pairs = list.fit.front.radiance;
  fs.writeFileSync(path.join(folder, 'query.json'), JSON.stringify({ window_m: kWindowM, pairs }));
  const server = await serve((url) => url.startsWith('/three/') ? path.join(three, path.normalize(url.slice(7)))
    : url === '/cloth.glb' ? path.join(set, `${name}.glb`)
      : url === '/query.json' ? path.join(folder, 'query.json') : path.join(__dirname, path.basename(url)));
  try {
    const seen = await shown(chromium, server.address().port, path.join(folder, 'profile'));
    return { name, coverage: list.coverage, rows: pairs.map((p, i) => ({ angle: degrees(p.view), view: p.view, cloth: luminance(p.cloth), engine: luminance(p.engine), three: luminance(seen[i]) })) };
  } finally {
    server.close();
  }
}

function judge(result) {
  let far = 0;
  for (const angle of new Set(result.rows.map((r) => r.angle.toFixed(0)))) {
    const rows = result.rows.filter((r) => r.angle.toFixed(0) === angle);
    const ratio = rows.reduce((s, r) => s + r.three, 0) / rows.reduce((s, r) => s + r.engine, 0);
    if (Math.abs(ratio - 1) > kEngineTolerance) {
      console.error(`${result.name}: ${angle} degrees: three.js sends ${ratio.toFixed(3)} of what was foretold`);
      ++far;
    }
  }
  for (const [most, tolerance] of kClothTolerance) {
    const rows = result.rows.filter((r) => r.angle <= most && r.angle > most - 30);
    const ratio = rows.reduce((s, r) => s + r.three, 0) / Math.max(rows.reduce((s, r) => s + r.cloth, 0), 1e-9);
    console.log(`${result.name}: to ${most} degrees three.js sends ${ratio.toFixed(3)} of the cloth`);
    if (rows.length && Math.abs(ratio - 1) > tolerance) ++far;
  }
  return far;
}

async function main(args) {
  const table = args[0] === '--table';
  const [weftlight, three, chromium, ...drafts] = table ? args.slice(1) : args;
  if (!fs.existsSync(three)) { console.log('skipped: three is not installed (./check installs it with npm; was the network there?)'); return 77; }
  if (!chromium || !fs.existsSync(chromium)) { console.log('skipped: Chromium is not installed'); return 77; }
  let far = 0;
  for (const draft of drafts) {
    const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'weftlight-three-'));
    try {
      const result = await measure(weftlight, three, chromium, draft, folder);
      if (table) for (const r of result.rows) console.log([result.name, r.angle.toFixed(1), r.view.map((x) => x.toFixed(2)).join(' '), r.cloth.toFixed(5), r.engine.toFixed(5), r.three.toFixed(5)].join(','));
      far += judge(result);
    } finally {
      fs.rmSync(folder, { recursive: true, force: true });
    }
  }
  return far ? 1 : 0;
}

main(process.argv.slice(2)).then((code) => process.exit(code), (e) => { console.error(e); process.exit(1); });
