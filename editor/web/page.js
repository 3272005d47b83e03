// The page: loads the program, gives it the canvas, its kept files and the draft of a link, and says what is wrong where
// it cannot run.
'use strict';

(() => {
  const canvas = document.getElementById('canvas'), notice = document.getElementById('notice');
  const words = document.getElementById('words'), bar = document.querySelector('#bar div');
  const toast = document.getElementById('toast'), reload = document.getElementById('reload');

  function stop(text) {
    words.textContent = text;
    bar.parentNode.hidden = true;
    notice.hidden = false;
  }
  /// A problem that lasts, until it is told that it is over.
  function tell(text) {
    toast.textContent = text;
    toast.hidden = !text;
  }
  function say(text) {
    tell(text);
    setTimeout(() => { if (toast.textContent === text) tell(''); }, 4000);
  }

  /// Adds to every answer the headers that threads need, where the server does not send them.
  async function isolate() {
    if (crossOriginIsolated || !window.isSecureContext || !navigator.serviceWorker) return false;
    if (sessionStorage.getItem('isolated')) return false;
    sessionStorage.setItem('isolated', '1');
    await navigator.serviceWorker.register('isolate.js');
    await navigator.serviceWorker.ready;
    location.reload();
    return true;
  }

  /// "#draft=" and a WIF, deflated, in base64 for addresses.
  async function draftOfLink() {
    const found = /[#&]draft=([A-Za-z0-9_-]+)/.exec(location.hash);
    if (!found) return null;
    const kMaxBytes = 4 << 20;
    try {
      const packed = Uint8Array.from(atob(found[1].replace(/-/g, '+').replace(/_/g, '/')), c => c.charCodeAt(0));
      const reader = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate-raw')).getReader();
      const parts = [];
      let size = 0;
      for (;;) {
        const {done, value} = await reader.read();
        if (done) break;
        size += value.length;
        if (size > kMaxBytes) throw new Error('too large');
        parts.push(value);
      }
      return new Uint8Array(await new Blob(parts).arrayBuffer());
    } catch (error) {
      tell('The draft in this link is damaged: perhaps the address was cut off. Ask for it again.');
      addEventListener('pointerdown', () => tell(''), {once: true});
      return null;
    }
  }
  /// Puts it among the files, beside drafts of other links, and gives its path.
  function keepDraftOfLink(FS, draft) {
    for (let n = 1;; ++n) {
      const path = Files.pathOf('from a link' + (n > 1 ? ' ' + n : '') + '.wif');
      const there = FS.analyzePath(path).exists && FS.readFile(path);
      const same = there && there.length === draft.length && there.every((byte, i) => byte === draft[i]);
      if (!there) FS.writeFile(path, draft);
      if (!there || same) return path;
    }
  }
  async function copyLink(bytes) {
    const kMaxLink = 30000;  // what browsers and programs for mail let through
    const packed = new Blob([bytes]).stream().pipeThrough(new CompressionStream('deflate-raw'));
    const all = new Uint8Array(await new Response(packed).arrayBuffer());
    let text = '';
    for (const b of all) text += String.fromCharCode(b);
    const link = location.href.replace(/#.*/, '') + '#draft=' +
      btoa(text).replace(/\+/g, '-').replace(/\//g, '_').replace(/=/g, '');
    if (link.length > kMaxLink) return say('This draft is too large for a link: save it and send the file.');
    program.copied = link;
    program.pasted = undefined;
    try {
      await navigator.clipboard.writeText(link);
      say('A link to this draft is on the clipboard (' + link.length + ' characters).');
    } catch (error) {
      prompt('The browser keeps its clipboard to itself. Copy the link:', link);
    }
  }

  // The program asks WebGL for what it needs: a canvas without transparency that is painted whole, and the driver's name.
  const getContext = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function(kind, wanted) {
    const context = getContext.call(this, kind, {...wanted, alpha: false, antialias: false, depth: false, stencil: false,
                                                 powerPreference: 'high-performance'});
    if (context && context.getExtension) context.getExtension('WEBGL_debug_renderer_info');
    return context;
  };

  const program = {
    canvas,
    arguments: [],
    locateFile: file => file,
    setStatus: text => {
      const part = /\((\d+)\/(\d+)\)/.exec(text);
      if (part) bar.style.width = 100 * part[1] / part[2] + '%';
    },
    print: text => console.log(text),
    printErr: text => console.warn(text),
    onAbort: why => stop('Weftlight has stopped: ' + why + '. Reload the page; unsaved work comes back.'),
    preRun: [module => {
      const {FS} = module;
      module.addRunDependency('kept');
      Files.begin(FS);
      Kept.begin(FS, tell).then(async () => {
        const draft = await draftOfLink();
        if (draft) program.arguments.push(keepDraftOfLink(FS, draft));
        const map = new URLSearchParams(location.search).get('ui-map');  // for tests, as the option --ui-map
        if (map) program.arguments.push(...(program.arguments.length ? [] : ['']), map);
        module.removeRunDependency('kept');
      });
    }],
  };

  // The keys that the program takes; the rest stay the browser's.
  function noteKey(event) {
    program.lastKey = {key: event.key, code: event.code, shift: event.shiftKey};
    if (event.isTrusted) program.controlDown = event.ctrlKey;
    const command = event.ctrlKey || event.metaKey;
    if (command && /^[cvx]$/i.test(event.key)) return;               // the browser tells by an event of its own
    if (command && /^[wtnr]$/i.test(event.key) && !event.altKey) return;  // tabs, and a reload
    if (command || event.altKey || /^(F([1-9]|10)|Tab|Escape|Arrow.*|Page.*|Home|End)$/.test(event.key))
      event.preventDefault();
  }

  function fit() {
    const ratio = window.devicePixelRatio || 1;
    const width = Math.max(1, Math.round(canvas.clientWidth * ratio));
    const height = Math.max(1, Math.round(canvas.clientHeight * ratio));
    if (program.setCanvasSize && (canvas.width !== width || canvas.height !== height)) program.setCanvasSize(width, height);
  }

  // What browsers call a turn of the wheel, as the program's window library does; a pinch on a touchpad comes as a turn
  // with Ctrl, which is not down then.
  const turned = new WeakSet();
  function turnWheel(event) {
    if (event.target !== canvas || turned.has(event)) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    if (event.type === 'mousewheel') return;
    const unit = [100, 3, 1][event.deltaMode];
    const again = new WheelEvent('wheel', {bubbles: true, cancelable: true, clientX: event.clientX, clientY: event.clientY,
                                           deltaX: -event.deltaX / unit, deltaY: -event.deltaY / unit});
    turned.add(again);
    const pinch = event.ctrlKey && !program.controlDown;
    if (pinch) key('keydown');
    canvas.dispatchEvent(again);
    if (pinch) key('keyup');
  }
  function key(kind) {
    window.dispatchEvent(new KeyboardEvent(kind, {keyCode: 17, key: 'Control', code: 'ControlLeft'}));
  }

  // The graphics driver was reset, or the browser needs its memory. The window stands still until the context is back, and
  // makes all anew in it (Window::can_draw); who does not want to wait loads the page again.
  const kPatienceMs = 8000;
  let patience;
  function loseContext(event) {
    event.preventDefault();  // else it does not come back
    program.lostContexts = (program.lostContexts || 0) + 1;
    Kept.keep();
    stop('The graphics driver was reset. Your work is kept, and the window comes back with the driver.');
    patience = setTimeout(() => {
      words.textContent = 'The graphics driver was reset and has not come back. Reload the page; unsaved work comes back.';
      reload.hidden = false;
    }, kPatienceMs);
  }
  function takeContextBack() {
    clearTimeout(patience);
    const context = canvas.getContext('webgl2');
    for (const name of context.getSupportedExtensions()) context.getExtension(name);  // as when it was made
    reload.hidden = notice.hidden = true;
    canvas.focus();
  }

  async function start() {
    if (await isolate()) return;
    if (!window.crossOriginIsolated)
      return stop('This address cannot run Weftlight: it needs https or localhost, and a server that sends the headers ' +
                  'Cross-Origin-Opener-Policy: same-origin and Cross-Origin-Embedder-Policy: require-corp.');
    if (!document.createElement('canvas').getContext('webgl2'))
      return stop('Weftlight needs WebGL 2, which this browser or its graphics driver does not give. Try another browser, ' +
                  'or turn hardware acceleration on in its settings.');
    addEventListener('keydown', noteKey, true);
    addEventListener('keyup', event => { if (event.isTrusted) program.controlDown = event.ctrlKey; }, true);
    for (const kind of ['wheel', 'mousewheel']) addEventListener(kind, turnWheel, {capture: true, passive: false});
    addEventListener('contextmenu', event => event.preventDefault());
    addEventListener('paste', event => { program.pasted = event.clipboardData.getData('text/plain'); });
    addEventListener('hashchange', async () => {
      const draft = await draftOfLink();
      if (draft) Files.open(keepDraftOfLink(program.FS, draft));
    });
    canvas.addEventListener('webglcontextlost', loseContext);
    canvas.addEventListener('webglcontextrestored', takeContextBack);
    const handbook = fetch('handbook/index.html', {method: 'HEAD'}).then(answer => answer.ok, () => false);
    Touch.begin(canvas);
    await weftlight(program);
    handbook.then(there => {
      if (!there) return;
      program.FS.mkdirTree('/weftlight/handbook');
      program.FS.writeFile('/weftlight/handbook/index.html', '');
    });
    reload.onclick = () => location.reload();
    fit();
    new ResizeObserver(fit).observe(canvas);
    canvas.focus();
    notice.hidden = true;
    performance.mark('weftlight-started');
  }

  window.Weftlight = {program, copyLink, stop};
  start().catch(error => stop('Weftlight could not be loaded: ' + error.message + '. Reload the page.'));
})();
