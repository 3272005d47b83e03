// node u3m.js WEFTLIGHT AJV_FOLDER DRAFT...
// Validates exported .u3m files against the published schema in the folder $WEFTLIGHT_U3M, and the headers of .u3ma against its
// specification. Exits with 0, 1 (an issue) or 77 (schema or validator are missing).
'use strict';
const fs = require('fs');
const os = require('os');
const path = require('path');
const { execFileSync } = require('child_process');

function issues_of_json(ajv_folder, schemas, file) {
  const Ajv = require(ajv_folder);
  const ajv = new (Ajv.default || Ajv)({ strict: false, allErrors: true, formats: { 'date-time': /^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ$/ } });
  const schema = JSON.parse(fs.readFileSync(path.join(schemas, 'u3m_schema.json')));
  schema.$schema = 'http://json-schema.org/draft-07/schema#';
  const check = ajv.compile(schema);
  const root = JSON.parse(fs.readFileSync(file));
  const wrong = check(root) ? [] : check.errors.map((e) => `${file}: ${e.instancePath} ${e.message}`);
  for (const face of ['front', 'back']) {
    for (const [key, entry] of Object.entries(root.material[face])) {
      const image = entry && entry.texture && entry.texture.image;
      if (!image) continue;
      const at = path.join(path.dirname(file), image.path);
      if (!fs.existsSync(at)) { wrong.push(`${file}: ${face}.${key}: ${image.path} is not there`); continue; }
      const width = fs.readFileSync(at).readUInt32BE(16);
      if (Math.abs(image.dpi.x * image.width / 25.4 - width) > 0.5) wrong.push(`${file}: ${face}.${key}: dpi and millimetres do not give ${width} texels`);
    }
  }
  return wrong;
}

/// Checks every entry of the central directory and its local header.
function issues_of_archive(file) {
  const bytes = fs.readFileSync(file), wrong = [];
  const expect = (name, found, wanted) => { if (found !== wanted) wrong.push(`${file}: ${name} is ${found}, not ${wanted}`); };
  const end = bytes.length - 22;
  expect('end record', bytes.readUInt32LE(end), 0x06054b50);
  let at = bytes.readUInt32LE(end + 16);
  for (let i = 0; i < bytes.readUInt16LE(end + 10); ++i) {
    const name = bytes.readUInt16LE(at + 28), local = bytes.readUInt32LE(at + 42);
    expect('version made by', bytes.readUInt16LE(at + 4), 63);
    expect('version needed', bytes.readUInt16LE(at + 6), 20);
    expect('flags', bytes.readUInt16LE(at + 8), 1 << 11);
    expect('method', bytes.readUInt16LE(at + 10), 0);
    expect('extra field', bytes.readUInt16LE(at + 30), 0);
    expect('attributes', bytes.readUInt32LE(at + 38), 0);
    expect('local header', bytes.readUInt32LE(local), 0x04034b50);
    expect('local extra field', bytes.readUInt16LE(local + 28), 0);
    at += 46 + name;
  }
  expect('end of the directory', at, end);
  return wrong;
}

function main([weftlight, ajv_folder, ...drafts]) {
  const ajv = path.resolve(ajv_folder), schemas = process.env.WEFTLIGHT_U3M;  // read when run, not when configured
  if (!fs.existsSync(ajv)) { console.log('skipped: ajv is not installed (./check installs it with npm; was the network there?)'); return 77; }
  if (!schemas || !fs.existsSync(path.join(schemas, 'u3m_schema.json'))) { console.log('skipped: WEFTLIGHT_U3M does not name the folder of u3m_schema.json'); return 77; }
  if (!drafts.length) { console.error('no draft is named'); return 1; }
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'weftlight-u3m-'));
  let wrong = [];
  try {
    for (const draft of drafts) {
      const name = path.basename(draft, '.wif');
      execFileSync(weftlight, ['export', draft, '--target', 'u3m', '--size', '64', '-o', folder], { stdio: ['ignore', 'ignore', 'inherit'] });
      wrong = wrong.concat(issues_of_json(ajv, schemas, path.join(folder, name, `${name}.u3m`)), issues_of_archive(path.join(folder, name, `${name}.u3ma`)));
    }
  } finally {
    fs.rmSync(folder, { recursive: true, force: true });
  }
  wrong.forEach((w) => console.error(w));
  console.log(`${drafts.length} materials, ${wrong.length} issues`);
  return wrong.length ? 1 : 0;
}

process.exit(main(process.argv.slice(2)));
