// What outlives the page: files of the program's own file system, kept in the browser's IndexedDB and brought back before
// the program starts. Settings and the user's files are common to all tabs. Unsaved work belongs to one tab, whose lock
// tells the others that it lives; the work of a tab that died is taken over by the next that starts.
'use strict';

const Kept = (() => {
  const kFiles = '/home/web_user/files', kShared = ['/home/web_user/settings', kFiles], kWork = '/home/web_user/state';
  const kLookMs = 400, kMaxFile = 32 << 20;
  let base, tab, FS, tell = () => {};
  const known = new Map();  // path -> "time size", as kept

  function open() {
    return new Promise((done, failed) => {
      const asked = indexedDB.open('weftlight', 1);
      asked.onupgradeneeded = () => asked.result.createObjectStore('files');
      asked.onsuccess = () => done(asked.result);
      asked.onerror = () => failed(asked.error);
    });
  }

  const key = path => (path.startsWith(kWork + '/') ? tab : 'all') + '|' + path;

  /// All that is kept, as [key, bytes].
  function all() {
    return new Promise((done, failed) => {
      const found = [], walk = base.transaction('files').objectStore('files').openCursor();
      walk.onsuccess = () => {
        const at = walk.result;
        if (!at) return done(found);
        found.push([at.key, at.value]);
        at.continue();
      };
      walk.onerror = () => failed(walk.error);
    });
  }

  /// Changes in one step: [key, bytes], or [key] to forget.
  function write(changes) {
    return new Promise((done, failed) => {
      const step = base.transaction('files', 'readwrite'), store = step.objectStore('files');
      for (const [name, bytes] of changes) bytes ? store.put(bytes, name) : store.delete(name);
      step.oncomplete = done;
      step.onabort = step.onerror = () => failed(step.error);
    });
  }

  /// Holds a lock for as long as the page lives; false if another page has it.
  function hold(name) {
    if (!navigator.locks) return Promise.resolve(true);
    return new Promise(done => {
      navigator.locks.request('weftlight ' + name, {ifAvailable: true}, lock => {
        done(lock !== null);
        return lock && new Promise(() => {});
      });
    });
  }

  function* below(folder) {
    for (const name of FS.readdir(folder)) {
      if (name === '.' || name === '..') continue;
      const path = folder + '/' + name, facts = FS.stat(path);
      // The user's files lie in one folder; what is below it is on its way out (files.js).
      if (FS.isDir(facts.mode) && folder !== kFiles) yield* below(path);
      else if (FS.isFile(facts.mode)) yield [path, facts];
    }
  }

  function put(path, bytes) {
    FS.mkdirTree(path.slice(0, path.lastIndexOf('/')));
    FS.writeFile(path, bytes);
    const facts = FS.stat(path);
    known.set(path, facts.mtime.getTime() + ' ' + facts.size);
  }

  let writing = false, full = false;
  /// Keeps what has changed since it was last looked at.
  async function keep() {
    if (!base || writing) return;
    const changes = [], now = new Map();
    for (const folder of [...kShared, kWork]) {
      for (const [path, facts] of below(folder)) {
        const state = facts.mtime.getTime() + ' ' + facts.size;
        if (facts.size > kMaxFile) continue;
        now.set(path, state);
        if (known.get(path) !== state) changes.push([key(path), FS.readFile(path)]);
      }
    }
    for (const path of known.keys()) if (!now.has(path)) changes.push([key(path)]);
    if (!changes.length) return;
    writing = true;
    try {
      await write(changes);
      known.clear();
      for (const [path, state] of now) known.set(path, state);
      if (full) tell('');
      full = false;
    } catch (error) {
      full = true;
      tell('The browser keeps no more unsaved work (' + (error && error.name || 'storage is full') +
           '): save your drafts.');
    }
    writing = false;
  }

  /// Brings back what is kept, and keeps what changes from now on. `told` is given a problem, or '' when it is over.
  async function begin(fs, told) {
    FS = fs;
    tell = told;
    for (const folder of [...kShared, kWork]) FS.mkdirTree(folder);
    tab = Date.now().toString(36) + Math.random().toString(36).slice(2, 8);
    try {
      base = await open();
      await hold(tab);
      const found = await all(), dead = new Set();
      for (const owner of new Set(found.map(([name]) => name.split('|')[0])))
        if (owner === 'all' || await hold(owner)) dead.add(owner);
      const taken = [];
      for (const [name, bytes] of found) {
        const [owner, path] = name.split('|');
        if (!dead.has(owner)) continue;
        put(path, bytes);
        if (owner !== 'all') taken.push([name], [tab + '|' + path, bytes]);
      }
      if (taken.length) await write(taken);
      if (navigator.storage && navigator.storage.persist) navigator.storage.persist();
    } catch (error) {
      base = undefined;
      tell('This browser keeps no unsaved work and no settings (' + (error && error.name || error) +
           '); save your drafts before you leave the page.');
    }
    setInterval(keep, kLookMs);
    addEventListener('visibilitychange', keep);
    addEventListener('pagehide', keep);
  }

  return {begin, keep};
})();
