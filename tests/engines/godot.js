// node godot.js WEFTLIGHT GODOT_FOLDER CHROMIUM DRAFT...
// Exports each draft for Godot and lights it flat in Godot's own web engine (Compatibility renderer) in headless Chromium.
// Compares the mean radiance of the covered part, front and back, with the prediction and the cloth of texture_set.json.
// Of open cloth also two layers of the glTF set, one over the other: how much they cover.
// GODOT_FOLDER holds index.js and index.wasm. Exits with 0, 1 (difference too large) or 77 (something is not installed).
// --table prints all values.
'use strict';
const crypto = require('crypto');
const fs = require('fs');
const os = require('os');
const path = require('path');
const { execFileSync } = require('child_process');
const { shown } = require('./three_js.js');

const kWindowM = 0.12, kPixels = 139;  // 0.86 mm a pixel, as at the metre for which sets are fitted
const kEngineTolerance = 0.11;         // against the prediction, mean over azimuths: mips average narrow highlights
// Against the cloth, in the same way. Gaps of open cloth close at oblique views, those in an engine do not.
const of_cloth = (angle, open) => open ? 0.36 : angle <= 60 ? 0.12 : 0.25;
const kClothError = 0.3;               // RMS of the difference over the RMS of the cloth, to 60 degrees
const kCoverTolerance = 0.05;
const kFold = { window_m: kWindowM, pixels: kPixels, gap_m: 0.02, aside_m: 0.0037 };

/// A package of Godot 4 (version 2 of the format) with these files: {name: Buffer}.
function packed(files) {
  const entries = Object.entries(files).map(([name, data]) => {
    const text = Buffer.from(`res://${name}`), room = Math.ceil((text.length + 1) / 4) * 4;
    return { text, room, data };
  });
  const header = Buffer.alloc(96);
  header.write('GDPC');
  [2, 4].forEach((value, i) => header.writeUInt32LE(value, 4 + 4 * i));
  const list = Buffer.alloc(4 + entries.reduce((sum, e) => sum + 4 + e.room + 36, 0));
  list.writeUInt32LE(entries.length, 0);
  let at = 4, where = header.length + list.length;
  for (const { text, room, data } of entries) {
    list.writeUInt32LE(room, at);
    text.copy(list, at + 4);
    list.writeBigUInt64LE(BigInt(where), at + 4 + room);
    list.writeBigUInt64LE(BigInt(data.length), at + 12 + room);
    crypto.createHash('md5').update(data).digest().copy(list, at + 20 + room);
    at += 4 + room + 36;
    where += data.length;
  }
  return Buffer.concat([header, list, ...entries.map((e) => e.data)]);
}

const kProject = `config_version=5
[application]
run/main_scene="res://main.tscn"
[rendering]
renderer/rendering_method="gl_compatibility"
renderer/rendering_method.web="gl_compatibility"
`;
const kScene = `[gd_scene load_steps=2 format=3]
[ext_resource type="Script" path="res://main.gd" id="1"]
[node name="Main" type="Node"]
script = ExtResource("1")
`;

/// The result of godot.gd for a query about a set, whose images it adds; more: further files of the project.
async function told_by_godot(godot, chromium, set, name, query, folder, more = {}) {
  const material = fs.readFileSync(path.join(set, `${name}.tres`), 'utf8');
  const images = [...material.matchAll(/path="([^"]*\.png)"/g)].map((match) => match[1]);
  const pack = path.join(folder, 'cloth.pck');
  fs.writeFileSync(pack, project(set, { ...query, material: `${name}.tres`, images }, more));
  const folders = (url) => url.startsWith('/godot/') ? path.join(godot, path.normalize(url.slice(7))) : url === '/cloth.pck' ? pack : path.join(__dirname, 'godot.html');
  return shown(chromium, folders, path.join(folder, 'profile'));
}

/// The set in a project whose script answers the query.
function project(set, query, more) {
  const files = {
    ...more,
    'project.godot': Buffer.from(kProject), 'main.tscn': Buffer.from(kScene), 'query.json': Buffer.from(JSON.stringify(query)),
    'main.gd': fs.readFileSync(path.join(__dirname, 'godot.gd')),
  };
  for (const file of fs.readdirSync(set)) if (/\.(png|dds|tres|gdshader)$/.test(file)) files[`set/${file}`] = fs.readFileSync(path.join(set, file));
  return packed(files);
}

const luminance = (c) => 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
const degrees = (v) => Math.acos(Math.min(1, Math.abs(v[2]))) * 180 / Math.PI;

/// What a set says of both faces. Images of the back have the coordinates of the front: its directions are mirrored in z alone.
function pairs_of(list) {
  return ['front', 'back'].flatMap((side) => list.fit[side].radiance.map((p) => {
    const turned = (v) => side === 'front' ? v : [v[0], v[1], -v[2]];
    return { side, view: turned(p.view), light: turned(p.light), cloth: p.cloth, engine: p.engine, pixels: kPixels, expected: Math.max(...p.engine) };
  }));
}

async function measure(weftlight, godot, chromium, draft, folder) {
  const name = path.basename(draft, '.wif'), set = path.join(folder, name);
  execFileSync(weftlight, ['export', draft, '--target', 'godot', '--size', '512', '-o', folder], { stdio: ['ignore', 'ignore', 'inherit'] });
  const list = JSON.parse(fs.readFileSync(path.join(set, 'texture_set.json')));
  const pairs = pairs_of(list);
  const seen = await told_by_godot(godot, chromium, set, name, { window_m: kWindowM, pairs }, folder);
  return { name, open: list.alpha !== 'opaque', coverage: list.alpha === 'opaque' ? 1 : list.coverage,
    rows: pairs.map((p, i) => ({ ...p, angle: degrees(p.view).toFixed(0), godot: seen[i].slice(0, 3), cover: seen[i][3] })) };
}

const mean = (rows, who) => rows.reduce((sum, r) => sum + luminance(r[who]), 0) / rows.length;
const hue = (rows, who) => rows.reduce((sum, r) => sum + r[who][0], 0) / rows.reduce((sum, r) => sum + r[who][2], 0);

function judge(result) {
  let far = 0;
  for (const side of ['front', 'back']) for (const angle of new Set(result.rows.map((r) => r.angle))) {
    const rows = result.rows.filter((r) => r.side === side && r.angle === angle);
    const predicted = mean(rows, 'godot') / mean(rows, 'engine'), cloth = mean(rows, 'godot') / mean(rows, 'cloth');
    const cover = rows.reduce((sum, r) => sum + r.cover, 0) / rows.length;
    console.log(`${result.name}, ${side}: ${angle} degrees: radiance in Godot is ${cloth.toFixed(3)} of that of the cloth, ${predicted.toFixed(3)} of the prediction; `
      + `red over blue ${hue(rows, 'godot').toFixed(3)}, in the cloth ${hue(rows, 'cloth').toFixed(3)}; coverage ${cover.toFixed(3)}`);
    if (Math.abs(predicted - 1) > kEngineTolerance || Math.abs(cloth - 1) > of_cloth(+angle, result.open)) ++far;
    if (Math.abs(cover - result.coverage) > kCoverTolerance) ++far;
  }
  const flat = result.rows.filter((r) => r.side === 'front' && +r.angle <= 60);
  const error = Math.sqrt(flat.reduce((sum, r) => sum + (luminance(r.godot) - luminance(r.cloth)) ** 2, 0)
    / flat.reduce((sum, r) => sum + luminance(r.cloth) ** 2, 0));
  console.log(`${result.name}: RMS error up to 60 degrees is ${error.toFixed(3)}`);
  return far + (error > kClothError ? 1 : 0);
}

/// Two layers of an open cloth in glTF, as in a fold: the nearer one is blended over the farther one. Where one of them hid the
/// other or was left out, two would cover as much as one.
async function folded(weftlight, godot, chromium, draft, folder) {
  const name = path.basename(draft, '.wif'), sets = path.join(folder, 'gltf'), set = path.join(sets, name);
  execFileSync(weftlight, ['export', draft, '--target', 'gltf', '--size', '512', '-o', sets], { stdio: ['ignore', 'ignore', 'inherit'] });
  const { coverage } = JSON.parse(fs.readFileSync(path.join(set, 'texture_set.json')));
  const glb = fs.readFileSync(path.join(set, `${name}.glb`));
  const [one, two] = await told_by_godot(godot, chromium, path.join(folder, name), name, { layers: kFold }, folder, { 'cloth.glb': glb });
  const both = 1 - (1 - one) ** 2;
  console.log(`${name}, glTF: coverage ${one.toFixed(3)} of one layer, in the set ${coverage.toFixed(3)}; ${two.toFixed(3)} of two, expected ${both.toFixed(3)}`);
  return (Math.abs(one - coverage) > kCoverTolerance ? 1 : 0) + (Math.abs(two - both) > kCoverTolerance ? 1 : 0);
}

async function main(args) {
  const table = args[0] === '--table';
  const [weftlight, godot, chromium, ...drafts] = table ? args.slice(1) : args;
  if (!fs.existsSync(godot)) { console.log('skipped: Godot\'s web engine is not installed (./check installs it with npm; was the network there?)'); return 77; }
  if (!chromium || !fs.existsSync(chromium)) { console.log('skipped: Chromium is not installed'); return 77; }
  let far = 0;
  for (const draft of drafts) {
    const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'weftlight-godot-'));
    try {
      const result = await measure(weftlight, godot, chromium, draft, folder);
      if (table) for (const r of result.rows) console.log([result.name, r.side, r.view, r.light, ...[r.cloth, r.engine, r.godot].map((c) => luminance(c).toFixed(5))].join(','));
      far += judge(result);
      if (result.open) far += await folded(weftlight, godot, chromium, draft, folder);
    } finally {
      fs.rmSync(folder, { recursive: true, force: true, maxRetries: 20, retryDelay: 100 });
    }
  }
  return far ? 1 : 0;
}

module.exports = { told_by_godot };
if (require.main === module) main(process.argv.slice(2)).then((code) => process.exit(code), (e) => { console.error(e); process.exit(1); });
