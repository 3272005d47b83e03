// node mips.js WEFTLIGHT THREE_FOLDER DRAFT...
// Reads prefiltered mipmaps with three.js: .ktx2 by the parser of its KTX2Loader, .dds by its DDSLoader. All levels must be
// there, with the same texels in both containers. Exits with 0, 1 or 77 (three is not installed).
'use strict';
const fs = require('fs');
const os = require('os');
const path = require('path');
const { execFileSync } = require('child_process');
const { pathToFileURL } = require('url');

const kSize = 128;

/// Red and blue are swapped in a .dds; DDSLoader swaps them back.
function differs(ktx, dds) {
  const wrong = [];
  if (ktx.levels.length !== 8 || dds.mipmaps.length !== 8) wrong.push(`${ktx.levels.length} and ${dds.mipmaps.length} levels`);
  ktx.levels.forEach((level, k) => {
    const a = level.levelData, b = dds.mipmaps[k] ? dds.mipmaps[k].data : [];
    if (a.length !== b.length || a.length !== 4 * (kSize >> k) ** 2) wrong.push(`level ${k}: ${a.length} and ${b.length} bytes`);
    else if (a.some((v, i) => v !== b[i])) wrong.push(`level ${k}: texels differ`);
  });
  return wrong;
}

async function main([weftlight, three, ...drafts]) {
  if (!fs.existsSync(three)) { console.log('skipped: three is not installed (./check installs it with npm; was the network there?)'); return 77; }
  const load = (file) => import(pathToFileURL(path.join(three, 'examples/jsm', file)).href);
  const { read } = await load('libs/ktx-parse.module.js');
  const { DDSLoader } = await load('loaders/DDSLoader.js');
  let far = 0;
  for (const draft of drafts) {
    const name = path.basename(draft, '.wif'), folder = fs.mkdtempSync(path.join(os.tmpdir(), 'weftlight-mips-'));
    try {
      for (const mips of ['ktx2', 'dds'])
        execFileSync(weftlight, ['export', draft, '--size', String(kSize), '--mips', mips, '-o', path.join(folder, mips)], { stdio: ['ignore', 'ignore', 'inherit'] });
      const listed = JSON.parse(fs.readFileSync(path.join(folder, 'dds', name, 'texture_set.json'))).maps.map((map) => map.file);
      for (const map of ['basecolor', 'orm', 'normal', 'anisotropy', 'sheen']) {
        const constant = map === 'anisotropy' || map === 'sheen';  // perhaps: then they are factors
        if (constant && !listed.includes(`${name}_${map}.png`)) continue;
        const file = (mips) => fs.readFileSync(path.join(folder, mips, name, `${name}_${map}.${mips}`));
        const ktx = read(new Uint8Array(file('ktx2')));
        const bytes = file('dds');
        const dds = new DDSLoader().parse(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length), true);
        const colour = map === 'basecolor' || map === 'sheen';
        const wrong = differs(ktx, dds);
        if (ktx.vkFormat !== (colour ? 43 : 37)) wrong.push(`format ${ktx.vkFormat}`);
        if (ktx.dataFormatDescriptor[0].transferFunction !== (colour ? 2 : 1)) wrong.push('wrong transfer function');
        for (const w of wrong) { console.error(`${name}_${map}: ${w}`); ++far; }
      }
    } finally {
      fs.rmSync(folder, { recursive: true, force: true });
    }
  }
  return far ? 1 : 0;
}

main(process.argv.slice(2)).then((code) => process.exit(code), (e) => { console.error(e); process.exit(1); });
