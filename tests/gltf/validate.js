// node validate.js WEFTLIGHT VALIDATOR_MODULE DRAFT
// Exports the draft on several meshes and validates every .glb with the Khronos validator. Exits with 0, 1 (an issue) or 77
// (the validator is not installed).
'use strict';
const fs = require('fs');
const os = require('os');
const path = require('path');
const { execFileSync } = require('child_process');

// The validator cannot look into these extensions, and says so as information; it still checks everything else.
const kUnknownToIt = ['KHR_materials_diffuse_transmission'];
const kSeverity = ['error', 'warning', 'information', 'hint'];
const kExports = [
  ['gltf', 'plane'],
  ['gltf', 'tablecloth'],
  ['blender', 'sphere'],
];

async function issues_of(validator, file) {
  const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), { uri: path.basename(file) });
  const known = report.issues.messages.filter((m) => m.code !== 'UNSUPPORTED_EXTENSION' || !kUnknownToIt.some((e) => m.message.includes(e)));
  for (const m of known) {
    console.error(`${file}: ${kSeverity[m.severity]} ${m.code} at ${m.pointer}: ${m.message}`);
  }
  const used = report.info.extensionsUsed || [];
  const lacking = ['KHR_materials_anisotropy', 'KHR_texture_transform', ...kUnknownToIt].filter((wanted) => !used.includes(wanted));
  for (const wanted of lacking) console.error(`${file}: lacks ${wanted}`);
  return known.length + lacking.length;
}

async function main([weftlight, module_path, draft]) {
  if (!fs.existsSync(module_path)) {
    console.log('skipped: gltf-validator is not installed (./check installs it with npm; was the network there?)');
    return 77;
  }
  const validator = require(module_path);
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'weftlight-gltf-'));
  let issues = 0;
  try {
    for (const [target, mesh] of kExports) {
      const out = path.join(folder, `${target}-${mesh}`);
      execFileSync(weftlight, ['export', draft, '--target', target, '--mesh', mesh, '--size', '128', '-o', out], { stdio: 'inherit' });
      const name = path.basename(draft, '.wif');
      issues += await issues_of(validator, path.join(out, name, `${name}.glb`));
    }
  } finally {
    fs.rmSync(folder, { recursive: true, force: true });
  }
  console.log(`${kExports.length} files, ${issues} issues`);
  return issues ? 1 : 0;
}

main(process.argv.slice(2)).then((code) => process.exit(code), (e) => {
  console.error(e);
  process.exit(1);
});
