// node usd.js WEFTLIGHT TINYUSDZ_FOLDER DRAFT...
// Reads exported .usdz and curves with tinyusdz, checks the alignment of the .usdz, and that the .mtlx is well formed: every node that is
// referenced exists. Exits with 0, 1 or 77 (tinyusdz is not installed).
'use strict';
const fs = require('fs');
const os = require('os');
const path = require('path');
const { execFileSync } = require('child_process');
const { pathToFileURL } = require('url');

function issues_of_archive(file) {
  const bytes = fs.readFileSync(file), wrong = [];
  let first = null;
  for (let at = 0; bytes.readUInt32LE(at) === 0x04034b50;) {
    const name = bytes.readUInt16LE(at + 26), extra = bytes.readUInt16LE(at + 28), data = at + 30 + name + extra;
    first = first || bytes.toString('utf8', at + 30, at + 30 + name);
    if (data % 64) wrong.push(`${file}: data of an entry begins at ${data}`);
    if (bytes.readUInt16LE(at + 8)) wrong.push(`${file}: an entry is compressed`);
    at = data + bytes.readUInt32LE(at + 18);
  }
  if (!/\.usd[ac]?$/.test(first || '')) wrong.push(`${file}: its first file is ${first}`);
  return wrong;
}

function issues_of_mtlx(file) {
  const text = fs.readFileSync(file, 'utf8'), wrong = [], open = [];
  for (const [, close, tag, , self] of text.matchAll(/<(\/?)([a-z_0-9]+)((?:\s+[a-z_0-9]+="[^"<]*")*)\s*(\/?)>/g)) {
    if (close) { if (open.pop() !== tag) wrong.push(`${file}: </${tag}> closes nothing`); } else if (!self) open.push(tag);
  }
  if (open.length) wrong.push(`${file}: <${open.pop()}> is not closed`);
  const names = new Set([...text.matchAll(/ name="([^"]+)"/g)].map((m) => m[1]));
  for (const [, name] of text.matchAll(/ (?:nodename|nodegraph|output)="([^"]+)"/g)) if (!names.has(name)) wrong.push(`${file}: refers to ${name}, which is missing`);
  for (const [, image] of text.matchAll(/type="filename" value="([^"]+)"/g)) if (!fs.existsSync(path.join(path.dirname(file), image))) wrong.push(`${file}: ${image} is missing`);
  return wrong;
}

/// tinyusdz is built for browsers: defines the globals that it needs.
async function reader(folder) {
  process.type = 'renderer';
  globalThis.window = globalThis;
  globalThis.document = globalThis.document || { currentScript: { src: '' } };
  const module = await import(pathToFileURL(path.join(folder, 'tinyusdz.js')));
  return module.default({ wasmBinary: fs.readFileSync(path.join(folder, 'tinyusdz.wasm')) });
}

function issues_of_stage(tiny, file) {
  const loader = new tiny.TinyUSDZLoaderNative();
  if (!loader.loadFromBinary(new Uint8Array(fs.readFileSync(file)), path.basename(file))) return [`${file}: tinyusdz: ${loader.error ? loader.error() : 'not read'}`];
  const wrong = [];
  if (loader.numMeshes() < 2) wrong.push(`${file}: has ${loader.numMeshes()} meshes`);
  return wrong;
}

/// The lists of each BasisCurves have the lengths that its counts ask for, and tinyusdz reads the stage.
function issues_of_curves(tiny, file) {
  const text = fs.readFileSync(file, 'utf8'), wrong = [];
  const loader = new tiny.TinyUSDZLoaderNative();
  if (!loader.loadFromBinary(new Uint8Array(fs.readFileSync(file)), path.basename(file))) wrong.push(`${file}: tinyusdz: ${loader.error()}`);
  const prims = text.split('def BasisCurves').slice(1);
  if (prims.length < 2) wrong.push(`${file}: has ${prims.length} BasisCurves`);
  for (const prim of prims) {
    const list = (name) => prim.split(`${name} = [`)[1].split(']')[0];
    const counts = list('curveVertexCounts').split(', ').map(Number), vertices = counts.reduce((a, b) => a + b, 0);
    const lengths = { points: vertices, widths: vertices, 'primvars:displayColor': counts.length, 'primvars:thread': counts.length };
    for (const [name, length] of Object.entries(lengths)) {
      const found = list(name).split(name === 'points' || name === 'primvars:displayColor' ? '), ' : ', ').length;
      if (found !== length) wrong.push(`${file}: ${name} has ${found} entries instead of ${length}`);
    }
    if (counts.some((n) => n < 4)) wrong.push(`${file}: a cubic curve needs four points`);
  }
  return wrong;
}

async function main([weftlight, tinyusdz, ...drafts]) {
  if (!fs.existsSync(tinyusdz)) { console.log('skipped: tinyusdz is not installed (./check installs it with npm; was the network there?)'); return 77; }
  const tiny = await reader(tinyusdz);
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'weftlight-usd-'));
  let wrong = [];
  try {
    for (const draft of drafts) {
      const name = path.basename(draft, '.wif'), base = path.join(folder, name, name);
      execFileSync(weftlight, ['export', draft, '--target', 'materialx', '--size', '64', '-o', folder], { stdio: ['ignore', 'ignore', 'inherit'] });
      const curves = path.join(folder, `${name}.usda`);
      execFileSync(weftlight, ['curves', draft, '--patch', '4x4', '--as', 'fibres', '-o', curves], { stdio: ['ignore', 'ignore', 'inherit'] });
      wrong = wrong.concat(issues_of_curves(tiny, curves));
      wrong = wrong.concat(issues_of_archive(`${base}.usdz`), issues_of_mtlx(`${base}.mtlx`), issues_of_stage(tiny, `${base}.usdz`));
    }
  } finally {
    fs.rmSync(folder, { recursive: true, force: true });
  }
  wrong.forEach((w) => console.error(w));
  console.log(`${drafts.length} stages, ${wrong.length} issues`);
  return wrong.length ? 1 : 0;
}

main(process.argv.slice(2)).then((code) => process.exit(code), (e) => { console.error(e); process.exit(1); });
