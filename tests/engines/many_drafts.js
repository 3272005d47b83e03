// node many_drafts.js WEFTLIGHT DRAFT [parallel|memory]
// The examples of docs/engines.md for many drafts: memory does not grow with their number in a run over a folder, and jobs
// under GNU parallel give the same bytes as one run. Exits with 0, 1 or 77 (a requirement is missing).
'use strict';
const fs = require('fs');
const os = require('os');
const path = require('path');
const { spawn, spawnSync } = require('child_process');

// Measured with 200 (WEFTLIGHT_DRAFTS=200): 175 MB after 40, 176 MB at the end.
const kDrafts = { parallel: 4, memory: Number(process.env.WEFTLIGHT_DRAFTS || 24) };
const kEarly = 12;        // number of sets after which memory must not grow
const kMaxGrowth = 1.1;
const kArguments = ['--target', 'gltf', '--size', '16', '-o'];

/// Peak memory of a process so far, kB; 0 if it has ended.
function peak_kb(pid) {
  try {
    return Number(/VmHWM:\s+(\d+)/.exec(fs.readFileSync(`/proc/${pid}/status`, 'utf8'))[1]);
  } catch { return 0; }
}

/// Peak memory after `kEarly` sets and at the end.
function peaks_of_run(weftlight, drafts, sets) {
  const child = spawn(weftlight, ['export', drafts, '--jobs', '1', ...kArguments, sets], { stdio: ['ignore', 'ignore', 'inherit'] });
  const seen = { early: 0, last: 0 };
  const timer = setInterval(() => {
    const now = peak_kb(child.pid);
    if (!now) return;
    seen.last = now;
    if (!seen.early && fs.existsSync(sets) && fs.readdirSync(sets).length >= kEarly) seen.early = now;
  }, 20);
  return new Promise((done, fail) => child.on('exit', (code) => {
    clearInterval(timer);
    return code ? fail(new Error(`export exits with ${code}`)) : done(seen);
  }));
}

async function memory(weftlight, drafts, folder) {
  const sets = path.join(folder, 'sets');
  const seen = await peaks_of_run(weftlight, drafts, sets);
  const count = fs.readdirSync(sets).filter((name) => fs.existsSync(path.join(sets, name, 'texture_set.json'))).length;
  console.log(`${count} sets; ${(seen.early / 1024).toFixed(0)} MB after ${kEarly}, ${(seen.last / 1024).toFixed(0)} MB at the end`);
  return count === kDrafts.memory && seen.early > 0 && seen.last < kMaxGrowth * seen.early ? 0 : 1;
}

/// Every file below a folder, with its bytes.
function bytes_below(folder) {
  const out = new Map();
  for (const name of fs.readdirSync(folder, { recursive: true }).map(String)) {
    const at = path.join(folder, name);
    if (fs.statSync(at).isFile()) out.set(name, fs.readFileSync(at));
  }
  return out;
}

function parallel(weftlight, drafts, folder) {
  const [one, many] = ['one', 'many'].map((name) => path.join(folder, name));
  const plain = spawnSync(weftlight, ['export', drafts, ...kArguments, one]);
  const jobs = spawnSync('bash', ['-c', `ls "${drafts}"/*.wif | parallel -j2 "${weftlight}" export {} ${kArguments.join(' ')} "${many}" --resume`]);
  if (plain.status || jobs.status) { console.error(String(plain.stderr), String(jobs.stderr)); return 1; }
  const a = bytes_below(one), b = bytes_below(many);
  const apart = [...a.keys()].filter((name) => !b.has(name) || !a.get(name).equals(b.get(name)));
  apart.forEach((name) => console.error(`${name} differs under parallel`));
  console.log(`${a.size} files, ${apart.length} differ`);
  return apart.length || a.size !== b.size ? 1 : 0;
}

async function main([weftlight, draft, what]) {
  if (what === 'parallel' && spawnSync('parallel', ['--version']).status !== 0) { console.log('skipped: GNU parallel is not installed'); return 77; }
  if (what === 'memory' && !peak_kb(process.pid)) { console.log('skipped: this system does not report the peak memory of a process'); return 77; }
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'weftlight-many-')), drafts = path.join(folder, 'drafts');
  try {
    fs.mkdirSync(drafts);
    for (let k = 0; k < kDrafts[what]; ++k) fs.copyFileSync(draft, path.join(drafts, `draft_${String(k).padStart(3, '0')}.wif`));
    return await (what === 'memory' ? memory : parallel)(path.resolve(weftlight), drafts, folder);
  } finally {
    fs.rmSync(folder, { recursive: true, force: true });
  }
}

main(process.argv.slice(2)).then((code) => process.exit(code), (e) => { console.error(e); process.exit(1); });
