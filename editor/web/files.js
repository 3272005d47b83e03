// The user's files: what is opened is copied into the program's own file system, and what the program writes there goes to
// the file that was picked (File System Access), else it is downloaded. A folder is delivered as a .zip.
'use strict';

const Files = (() => {
  const kHome = '/home/web_user', kFolder = kHome + '/files', kExports = kHome + '/exports';
  // Where texture sets go, each in a folder: the one that was chosen, or those beside a draft and beside none.
  const kSets = [kExports, kFolder + '/textures', kHome + '/textures'];
  const kOwn = [kHome + '/settings', kHome + '/state', '/cache'];  // the program's, nobody else's
  let FS;
  const handles = new Map();   // path -> the picked file
  const opened = [];           // paths that the program is to open

  const pathOf = name => kFolder + '/' + name.replace(/[\/\\\0]/g, '_');
  async function bring(file) {
    const path = pathOf(file.name);
    FS.writeFile(path, new Uint8Array(await file.arrayBuffer()));
    return path;
  }

  function download(name, bytes) {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([bytes]));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
  }

  const crcs = Uint32Array.from({length: 256}, (_, n) => {
    for (let k = 0; k < 8; ++k) n = n & 1 ? 0xEDB88320 ^ (n >>> 1) : n >>> 1;
    return n;
  });
  function crc(bytes) {
    let sum = ~0;
    for (const b of bytes) sum = crcs[(sum ^ b) & 255] ^ (sum >>> 8);
    return ~sum >>> 0;
  }
  /// A .zip of [name, bytes], stored as they are: pictures do not become smaller.
  function zip(files) {
    const parts = [], list = [];
    let at = 0;
    const head = (signature, fields) => {
      const out = new DataView(new ArrayBuffer(fields.reduce((sum, [size]) => sum + size, 4)));
      out.setUint32(0, signature, true);
      let i = 4;
      for (const [size, value] of fields) {
        size === 2 ? out.setUint16(i, value, true) : out.setUint32(i, value, true);
        i += size;
      }
      return new Uint8Array(out.buffer);
    };
    for (const [name, bytes] of files) {
      const title = new TextEncoder().encode(name);
      const facts = [[2, 20], [2, 0x800], [2, 0], [2, 0], [2, 0x21], [4, crc(bytes)], [4, bytes.length],
                     [4, bytes.length], [2, title.length], [2, 0]];
      const local = head(0x04034b50, facts);
      list.push(head(0x02014b50, [[2, 20], ...facts, [2, 0], [2, 0], [2, 0], [4, 0], [4, at]]), title);
      parts.push(local, title, bytes);
      at += local.length + title.length + bytes.length;
    }
    const size = list.reduce((sum, one) => sum + one.length, 0);
    return new Blob([...parts, ...list, head(0x06054b50, [[2, 0], [2, 0], [2, files.length], [2, files.length], [4, size],
                                                         [4, at], [2, 0]])]);
  }

  function* below(folder, prefix) {
    for (const name of FS.readdir(folder)) {
      if (name === '.' || name === '..') continue;
      const path = folder + '/' + name;
      if (FS.isDir(FS.stat(path).mode)) yield* below(path, prefix + name + '/');
      else yield [prefix + name, FS.readFile(path)];
    }
  }

  const folderOf = path => path.slice(0, path.lastIndexOf('/')), nameOf = path => path.slice(path.lastIndexOf('/') + 1);

  /// A folder with a texture set, once nothing more comes into it: as "draft.zip", or "draft-target.zip" where there is one
  /// for each of several programs. It does not stay in the page's memory.
  const kSetMs = 1000;
  const sets = new Map();
  function deliverSet(folder) {
    clearTimeout(sets.get(folder));
    sets.set(folder, setTimeout(() => {
      const root = kSets.find(one => folder.startsWith(one + '/'));
      const name = root ? folder.slice(root.length + 1).replace(/\//g, '-') : nameOf(folder);
      const files = [...below(folder, '')];
      download(name + '.zip', zip(files.map(([file, bytes]) => [nameOf(folder) + '/' + file, bytes])));
      for (const [file] of files) FS.unlink(folder + '/' + file);
      FS.rmdir(folder);
      sets.delete(folder);
    }, kSetMs));
  }

  async function deliver(path) {
    const name = nameOf(path), bytes = FS.readFile(path), handle = handles.get(path);
    if (!handle) return download(name, bytes);
    try {
      const out = await handle.createWritable();
      await out.write(bytes);
      await out.close();
    } catch (error) {
      handles.delete(path);
      download(name, bytes);  // the permission was taken back
    }
  }

  function begin(fs) {
    FS = fs;
    FS.mkdirTree(kFolder);
    FS.mkdirTree(kExports);
    const rename = FS.rename;
    FS.rename = (from, to) => {
      rename(from, to);
      // What is written beside and renamed is whole.
      const full = to.startsWith('/') ? to : (FS.cwd() + '/' + to).replace(/^\/+/, '/');
      if (full.includes('.part-') || kOwn.some(one => full.startsWith(one + '/'))) return;
      if (FS.isDir(FS.stat(full).mode)) deliverSet(full);
      else if (sets.has(folderOf(full))) deliverSet(folderOf(full));
      else if (folderOf(full) === kFolder) deliver(full);
    };
    addEventListener('dragover', event => event.preventDefault(), true);
    addEventListener('drop', async event => {
      event.preventDefault();
      event.stopImmediatePropagation();
      for (const file of event.dataTransfer.files) opened.push(await bring(file));
    }, true);
  }

  // The dialog of the program (core/platform/web/file_dialog.cpp): asks, and is asked for its answer.
  let answer;  // undefined: no answer yet; '' if cancelled
  const endings = patterns => patterns.split(/\s+/).map(one => one.replace('*', '').toLowerCase())
    .filter((one, i, all) => /^\.\w+$/.test(one) && all.indexOf(one) === i);

  function pick(accept) {
    const input = document.createElement('input');
    input.type = 'file';
    input.accept = accept.join(',');
    input.oncancel = () => { answer = ''; };
    input.onchange = () => {
      if (!input.files.length) answer = '';
      else bring(input.files[0]).then(path => { answer = path; }, () => { answer = ''; });
    };
    input.click();
  }
  async function pickHandle(accept) {
    const [handle] = await showOpenFilePicker({types: [{description: 'Drafts', accept: {'application/octet-stream': accept}}]});
    const path = await bring(await handle.getFile());
    handles.set(path, handle);
    return path;
  }
  async function place(name, accept) {
    const handle = await showSaveFilePicker({suggestedName: name, types: accept.length ? [{accept: {'application/octet-stream': accept}}] : undefined});
    const path = pathOf(handle.name);
    handles.set(path, handle);
    return path;
  }
  function ask(what, title, start, patterns) {
    answer = undefined;
    const accept = endings(patterns), name = nameOf(start);
    const refused = error => {
      if (error.name === 'AbortError') answer = '';
      else what === 'open' ? pick(accept) : byName();
    };
    const byName = () => {
      const typed = prompt(title, name || 'untitled');
      answer = typed ? pathOf(typed) : '';
    };
    if (what === 'folder') answer = kExports;  // delivered as a .zip
    else if (what === 'open' && window.showOpenFilePicker) pickHandle(accept).then(path => { answer = path; }, refused);
    else if (what === 'open') pick(accept);
    else if (window.showSaveFilePicker) place(name, accept).then(path => { answer = path; }, refused);
    else byName();
  }

  return {begin, ask, take: () => answer, nextOpened: () => opened.shift(), pathOf, bring,
          open: path => opened.push(path)};
})();
