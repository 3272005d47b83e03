// node slurm.js WEFTLIGHT DRAFT
// The array job of docs/engines.md on a temporary Slurm on this machine: munge, controller and node in a temporary folder. It
// must give the same bytes as one run. Exits with 0, 1 or 77 (Slurm is not installed, or not usable by this user).
'use strict';
const fs = require('fs');
const net = require('net');
const os = require('os');
const path = require('path');
const { spawn, spawnSync } = require('child_process');

const kDrafts = 6;
const kTimeoutMs = 120000;
const kArguments = ['--target', 'gltf', '--size', '16', '-o'];
const kDaemons = ['munged', 'slurmctld', 'slurmd'];

const wait = (ms) => new Promise((done) => setTimeout(done, ms));
const found = (name) => [...(process.env.PATH || '').split(':'), '/usr/sbin', '/usr/bin'].map((folder) => path.join(folder, name)).find((file) => fs.existsSync(file));

/// A free port.
function free_port() {
  return new Promise((done) => {
    const server = net.createServer().listen(0, '127.0.0.1', () => {
      const { port } = server.address();
      server.close(() => done(port));
    });
  });
}

async function configuration(folder) {
  const host = os.hostname().split('.')[0];
  const text = `ClusterName=weftlight
SlurmctldHost=${host}(127.0.0.1)
SlurmctldPort=${await free_port()}
SlurmdPort=${await free_port()}
SlurmUser=${os.userInfo().username}
SlurmdUser=${os.userInfo().username}
AuthType=auth/munge
AuthInfo=socket=${folder}/munge.socket
StateSaveLocation=${folder}/state
SlurmdSpoolDir=${folder}/spool
SlurmctldPidFile=${folder}/slurmctld.pid
SlurmdPidFile=${folder}/slurmd.pid
SlurmctldLogFile=${folder}/slurmctld.log
SlurmdLogFile=${folder}/slurmd.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
MpiDefault=none
SchedulerType=sched/builtin
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
NodeName=${host} NodeAddr=127.0.0.1 CPUs=${os.cpus().length} RealMemory=${Math.floor(os.totalmem() / 2 ** 21)}
PartitionName=all Nodes=${host} Default=YES MaxTime=INFINITE State=UP
`;
  for (const name of ['state', 'spool']) fs.mkdirSync(path.join(folder, name));
  fs.writeFileSync(path.join(folder, 'slurm.conf'), text);
  fs.writeFileSync(path.join(folder, 'cgroup.conf'), 'CgroupPlugin=cgroup/v1\nCgroupAutomount=no\n');
  fs.writeFileSync(path.join(folder, 'munge.key'), require('crypto').randomBytes(1024), { mode: 0o400 });
}

/// Starts the three daemons in the foreground, so that they end with this process.
function started(folder) {
  const at = (name) => path.join(folder, name);
  const commands = [
    [found('munged'), '--foreground', '--force', `--key-file=${at('munge.key')}`, `--socket=${at('munge.socket')}`, `--pid-file=${at('munged.pid')}`, `--log-file=${at('munged.log')}`, `--seed-file=${at('munged.seed')}`],
    [found('slurmctld'), '-D', '-c', '-f', at('slurm.conf')],
    [found('slurmd'), '-D', '-c', '-f', at('slurm.conf')],
  ];
  return commands.map(([program, ...rest]) => spawn(program, rest, { stdio: 'ignore', env: { ...process.env, SLURM_CONF: at('slurm.conf') } }));
}

/// Repeats the command until `ready` accepts its output.
async function until(folder, command, ready) {
  const env = { ...process.env, SLURM_CONF: path.join(folder, 'slurm.conf') };
  for (const end = Date.now() + kTimeoutMs; Date.now() < end; await wait(300)) {
    const asked = spawnSync(command[0], command.slice(1), { env, encoding: 'utf8' });
    if (asked.status === 0 && ready(asked.stdout)) return asked.stdout;
  }
  const logs = ['munged.log', 'slurmctld.log', 'slurmd.log'].map((name) => path.join(folder, name)).filter((file) => fs.existsSync(file));
  throw new Error(`${command.join(' ')}: not in time\n${logs.map((file) => fs.readFileSync(file, 'utf8').slice(-1500)).join('\n')}`);
}

/// The job of docs/engines.md.
function job(weftlight, drafts, sets) {
  return `#!/bin/bash
#SBATCH --cpus-per-task=1 --time=00:10:00
drafts=("${drafts}"/*.wif)
exec "${weftlight}" export "\${drafts[$SLURM_ARRAY_TASK_ID]}" ${kArguments.join(' ')} "${sets}" --resume
`;
}

/// Every file below a folder, with its bytes.
function bytes_below(folder) {
  const out = new Map();
  if (!fs.existsSync(folder)) return out;
  for (const name of fs.readdirSync(folder, { recursive: true }).map(String)) {
    const at = path.join(folder, name);
    if (fs.statSync(at).isFile()) out.set(name, fs.readFileSync(at));
  }
  return out;
}

async function main([weftlight, draft]) {
  if (!kDaemons.every(found) || !found('sbatch')) { console.log('skipped: Slurm is not installed (slurm-wlm)'); return 77; }
  if (process.getuid() !== 0) { console.log('skipped: Slurm needs root to start jobs'); return 77; }
  // The path of a socket has at most 107 bytes.
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'weftlight-slurm-')), at = (name) => path.join(folder, name);
  let daemons = [];
  try {
    fs.mkdirSync(at('drafts'));
    for (let k = 0; k < kDrafts; ++k) fs.copyFileSync(draft, at(`drafts/draft_${k}.wif`));
    const program = path.resolve(weftlight);
    const plain = spawnSync(program, ['export', at('drafts'), ...kArguments, at('one')], { encoding: 'utf8' });
    if (plain.status) throw new Error(plain.stderr);
    await configuration(folder);
    daemons = started(folder);
    await until(folder, [found('sinfo'), '-h', '-o', '%T'], (text) => /idle|mixed/.test(text));
    fs.writeFileSync(at('export.sh'), job(program, at('drafts'), at('many')), { mode: 0o755 });
    await until(folder, [found('sbatch'), '--parsable', `--array=0-${kDrafts - 1}`, `--output=${at('task_%a.log')}`, at('export.sh')], () => true);
    await until(folder, [found('squeue'), '-h', '-r'], (text) => text.trim() === '');
    const a = bytes_below(at('one')), b = bytes_below(at('many'));
    const apart = [...a.keys()].filter((name) => !b.has(name) || !a.get(name).equals(b.get(name)));
    apart.forEach((name) => console.error(`${name} differs under Slurm`));
    console.log(`${a.size} files of ${kDrafts} array tasks, ${apart.length} differ`);
    return apart.length || a.size !== b.size ? 1 : 0;
  } finally {
    const ended = daemons.map((child) => new Promise((done) => (child.exitCode !== null ? done() : child.on('exit', done))));
    for (const child of daemons.reverse()) child.kill('SIGTERM');
    const late = setTimeout(() => daemons.forEach((child) => child.kill('SIGKILL')), 8000);
    await Promise.all(ended);
    clearTimeout(late);
    fs.rmSync(folder, { recursive: true, force: true });
  }
}

main(process.argv.slice(2)).then((code) => process.exit(code), (e) => { console.error(e.message); process.exit(1); });
