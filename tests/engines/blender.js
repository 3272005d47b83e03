// node blender.js [--table] [--eevee] WEFTLIGHT BLENDER DRAFT...
// Exports each draft for Blender on the plane and renders it in Cycles (or EEVEE) under one sun with the script of the set
// (blender.py).
// Compares the mean radiance of the covered area with the radiance of the cloth in texture_set.json, the covered fraction for
// pixels of 0.5 to 20 mm with the coverage of the cloth, and the transmission of the threads. Exits with 0, 1 (difference too
// large) or 77 (Blender is not installed, or cannot read .glb; EEVEE has no display). --table prints all values.
'use strict';
const fs = require('fs');
const os = require('os');
const path = require('path');
const { execFileSync, spawnSync } = require('child_process');

// Tolerance against the cloth at each elevation, mean over the azimuths of views and lights.
const of_cloth = (angle, open) => open ? 0.28 : angle <= 60 ? 0.12 : 0.25;  // open: gaps of cloth close at oblique views, those in Blender do not
const error_of_cloth = (open) => open ? 0.3 : 0.26;  // RMS of the difference over the RMS of the cloth, to 60 degrees
const kCoverTolerance = 0.05, kCoverPixels = [240, 60, 6];
const kWindowM = 0.12;
const kBeside = 0.375 ** 0.5;            // light from the diagonal, 60 degrees from the normal: off the highlights of warp and weft
const kCycles = { id: 'CYCLES', title: 'Cycles', target: 'blender', samples: 48, pixels: 48 };
const kEevee = { id: 'BLENDER_EEVEE', title: 'EEVEE', target: 'eevee', samples: 16, pixels: 24, screen: true };  // it draws by OpenGL

const luminance = (c) => 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
const sum = (rows, of) => rows.reduce((s, r) => s + of(r), 0);

/// Radiance in Blender for the pairs of directions; null if Blender cannot read the set.
function shown(engine, blender, set, name, pairs, folder) {
  const out = path.join(folder, 'seen.json'), query = path.join(folder, 'query.json');
  fs.writeFileSync(query, JSON.stringify({ glb: path.join(set, `${name}.glb`), script: path.join(set, `${name}.py`), engine: engine.id, window_m: kWindowM, pixels: engine.pixels, samples: engine.samples, pairs, out }));
  // Blender of Debian uses the modules of the system's Python.
  const [program, ...before] = engine.screen ? ['xvfb-run', '-a', blender] : [blender];
  const ran = spawnSync(program, [...before, '-b', '--factory-startup', '-P', path.join(__dirname, 'blender.py'), '--', query],
    { env: { ...process.env, PATH: `/usr/bin:/bin:${process.env.PATH}` }, encoding: 'utf8' });
  if (/No module named 'numpy'/.test(ran.stdout + ran.stderr)) return null;
  if (!fs.existsSync(out)) throw new Error(ran.stdout + ran.stderr);
  return JSON.parse(fs.readFileSync(out));
}

function measure(engine, weftlight, blender, draft, folder) {
  const name = path.basename(draft, '.wif');
  execFileSync(weftlight, ['export', draft, '--target', engine.target, '--mesh', 'plane', '--size', '512', '-o', folder], { stdio: ['ignore', 'ignore', 'inherit'] });
  const set = path.join(folder, name);
  const list = JSON.parse(fs.readFileSync(path.join(set, 'texture_set.json'))), pairs = list.fit.front.radiance;
  const cover = list.alpha === 'opaque' ? [] : kCoverPixels.map((pixels) => ({ view: [0, 0, 1], light: [0, 0, 1], pixels }));
  const behind = [1, -1].map((z) => ({ view: [0, 0, 1], light: [kBeside, kBeside, 0.5 * z] }));
  const through = +/^THROUGH = (\S+)/m.exec(fs.readFileSync(path.join(set, `${name}.py`), 'utf8'))[1];
  const seen = shown(engine, blender, set, name, [...pairs, ...cover, ...behind], folder);
  return seen && { name, through, behind: luminance(seen.at(-1)) / luminance(seen.at(-2)), rows: pairs.map((p, i) => ({ angle: Math.acos(Math.min(1, p.view[2])) * 180 / Math.PI, cloth: luminance(p.cloth), blender: luminance(seen[i]) / Math.max(seen[i][3], 1e-3) })),
    cover: cover.map((p, i) => ({ mm: 1000 * kWindowM / p.pixels, wanted: list.coverage, blender: seen[pairs.length + i][3] })) };
}

function judge(engine, { name, rows, cover, through, behind }) {
  let far = 0;
  for (const angle of new Set(rows.map((r) => r.angle.toFixed(0)))) {
    const part = rows.filter((r) => r.angle.toFixed(0) === angle);
    const ratio = sum(part, (r) => r.blender) / sum(part, (r) => r.cloth);
    console.log(`${name}: ${angle} degrees: radiance in ${engine.title} is ${ratio.toFixed(3)} of that of the cloth`);
    if (Math.abs(ratio - 1) > of_cloth(+angle, cover.length > 0)) ++far;
  }
  const flat = rows.filter((r) => r.angle <= 60);
  const error = Math.sqrt(sum(flat, (r) => (r.blender - r.cloth) ** 2) / sum(flat, (r) => r.cloth ** 2));
  console.log(`${name}: RMS error up to 60 degrees is ${error.toFixed(3)}`);
  if (error > error_of_cloth(cover.length > 0)) ++far;
  console.log(`${name}: radiance lit from behind, off the highlights, is ${behind.toFixed(3)} of that lit from the front; the diffuse transmission of its threads is ${through}`);
  if (behind < 0.55 * through || behind > 1.05 * through) ++far;  // what is reflected contains a little of the highlights
  for (const c of cover) {
    console.log(`${name}: coverage for pixels of ${c.mm} mm is ${c.blender.toFixed(3)}, that of the cloth ${c.wanted.toFixed(3)}`);
    if (Math.abs(c.blender - c.wanted) > kCoverTolerance) ++far;
  }
  return far;
}

function main(args) {
  const table = args.includes('--table'), engine = args.includes('--eevee') ? kEevee : kCycles;
  const [weftlight, blender, ...drafts] = args.filter((a) => !a.startsWith('--'));
  if (!blender || !fs.existsSync(blender)) { console.log('skipped: Blender is not installed'); return 77; }
  let far = 0;
  for (const draft of drafts) {
    const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'weftlight-blender-'));
    try {
      const result = measure(engine, weftlight, blender, draft, folder);
      if (!result) { console.log('skipped: Blender has no numpy and cannot read .glb (python3-numpy)'); return 77; }
      if (table) for (const r of result.rows) console.log([result.name, r.angle.toFixed(1), r.cloth.toFixed(5), r.blender.toFixed(5)].join(','));
      far += judge(engine, result);
    } finally {
      fs.rmSync(folder, { recursive: true, force: true });
    }
  }
  return far ? 1 : 0;
}

process.exit(main(process.argv.slice(2)));
