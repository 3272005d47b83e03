// A headless Chromium with one page, through the DevTools protocol: clicks, keys, downloads and pictures as a person's.
'use strict';

const {spawn, execFileSync} = require('child_process');
const fs = require('fs');
const os = require('os');
const path = require('path');
const WebSocket = require('ws');

const sleep = ms => new Promise(done => setTimeout(done, ms));

/// Waits until what is asked again and again is there.
async function comesTrue(what, ask, seconds = 60) {
  const end = Date.now() + seconds * 1000;
  for (;;) {
    const answer = await ask();
    if (answer) return answer;
    if (Date.now() > end) throw new Error('It did not come true in ' + seconds + ' s: ' + what);
    await sleep(60);
  }
}

class Browser {
  static async start(program) {
    const browser = new Browser();
    browser.folder = fs.mkdtempSync(path.join(os.tmpdir(), 'weftlight-web-'));
    browser.downloads = path.join(browser.folder, 'downloads');
    fs.mkdirSync(browser.downloads);
    browser.process = spawn(program, [
      '--headless=new', '--no-sandbox', '--remote-debugging-port=0', '--user-data-dir=' + path.join(browser.folder, 'profile'),
      '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist', '--window-size=1280,900',
      '--no-first-run', '--disable-extensions', '--disable-background-networking', 'about:blank'
    ], {stdio: ['ignore', 'ignore', 'pipe']});
    browser.address = await new Promise((done, failed) => {
      let said = '';
      browser.process.stderr.on('data', text => {
        said += text;
        const found = /DevTools listening on (\S+)/.exec(said);
        if (found) done(found[1]);
      });
      browser.process.on('exit', () => failed(new Error('Chromium ended:\n' + said)));
    });
    browser.socket = new WebSocket(browser.address, {perMessageDeflate: false, maxPayload: 256 << 20});
    await new Promise((done, failed) => browser.socket.on('open', done).on('error', failed));
    browser.calls = new Map();
    browser.next = 1;
    browser.listeners = [];
    browser.socket.on('message', text => {
      const said = JSON.parse(text);
      const call = browser.calls.get(said.id);
      if (call) {
        browser.calls.delete(said.id);
        said.error ? call.failed(new Error(call.method + ': ' + said.error.message)) : call.done(said.result);
      } else for (const listen of browser.listeners) listen(said);
    });
    return browser;
  }
  call(method, params = {}, sessionId) {
    const id = this.next++;
    return new Promise((done, failed) => {
      this.calls.set(id, {method, done, failed});
      this.socket.send(JSON.stringify({id, method, params, sessionId}));
    });
  }
  async open(address, width = 1280, height = 800, touch = false) {
    const {targetId} = await this.call('Target.createTarget', {url: 'about:blank'});
    const {sessionId} = await this.call('Target.attachToTarget', {targetId, flatten: true});
    const page = new Page(this, targetId, sessionId);
    await this.call('Browser.setDownloadBehavior', {behavior: 'allow', downloadPath: this.downloads});
    for (const domain of ['Page', 'Runtime', 'Log', 'DOM']) await page.call(domain + '.enable');
    await page.call('Emulation.setDeviceMetricsOverride', {width, height, deviceScaleFactor: 1, mobile: false});
    if (touch) await page.call('Emulation.setTouchEmulationEnabled', {enabled: true, maxTouchPoints: 2});
    // Headless, the dialogs of the File System Access API cannot be answered: files come and go as in other browsers.
    await page.call('Page.addScriptToEvaluateOnNewDocument',
      {source: 'delete window.showOpenFilePicker; delete window.showSaveFilePicker;'});
    page.opened = Date.now();
    await page.call('Page.navigate', {url: address});
    return page;
  }
  async close_page(page) { await this.call('Target.closeTarget', {targetId: page.target}); }
  /// The addresses of all pages.
  async addresses() {
    const {targetInfos} = await this.call('Target.getTargets');
    return targetInfos.filter(one => one.type === 'page').map(one => one.url);
  }
  async close_address(address) {
    const {targetInfos} = await this.call('Target.getTargets');
    for (const {targetId, url} of targetInfos) if (url === address) await this.call('Target.closeTarget', {targetId});
  }
  /// A file that was downloaded, once it is whole.
  async download(name, seconds = 30) {
    const file = path.join(this.downloads, name);
    await comesTrue('the download of ' + name, () => fs.existsSync(file), seconds);
    await sleep(100);
    const bytes = fs.readFileSync(file);
    fs.unlinkSync(file);
    return bytes;
  }
  async close() {
    try {
      await Promise.race([this.call('Browser.close'), sleep(3000)]);
    } catch (error) {
      // it is gone
    }
    this.process.kill('SIGKILL');
    await sleep(300);
    fs.rmSync(this.folder, {recursive: true, force: true, maxRetries: 5});
  }
}

class Page {
  constructor(browser, target, session) {
    Object.assign(this, {browser, target, session, said: []});
    browser.listeners.push(({method, params, sessionId}) => {
      if (sessionId !== session) return;
      if (method === 'Runtime.consoleAPICalled')
        this.said.push(params.type + ': ' + params.args.map(one => one.value ?? one.description).join(' '));
      if (method === 'Log.entryAdded') this.said.push('log: ' + params.entry.text);
      if (method === 'Runtime.exceptionThrown')
        this.said.push('exception: ' + (params.exceptionDetails.exception?.description ?? params.exceptionDetails.text));
      if (method === 'Page.javascriptDialogOpening') {
        const answer = this.answers?.shift();
        this.call('Page.handleJavaScriptDialog', {accept: answer !== undefined, promptText: answer});
      }
      if (method === 'Page.fileChooserOpened')
        this.call('DOM.setFileInputFiles', {files: [this.picks], backendNodeId: params.backendNodeId});
    });
  }
  call(method, params) { return this.browser.call(method, params, this.session); }
  async ask(expression) {
    const {result, exceptionDetails} = await this.call('Runtime.evaluate', {expression, returnByValue: true, awaitPromise: true});
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }
  /// Where the controls and grids are, as --ui-map tells.
  async map() {
    const text = await this.ask(`(() => { try { return Weftlight.program.FS.readFile('/ui.json', {encoding: 'utf8'}); }
                                          catch { return ''; } })()`);
    return text ? JSON.parse(text) : {controls: [], grids: []};
  }
  async control(name) {
    return comesTrue('the control ' + name, async () => (await this.map()).controls.find(one => one.name === name));
  }
  async cell(grid, a, b) {
    const g = await comesTrue('the grid ' + grid, async () => (await this.map()).grids.find(one => one.name === grid));
    return [0, 1].map(i => g.origin[i] + (a - 1) * g.step_a[i] + (b - 1) * g.step_b[i]);
  }
  async click(x, y, button = 'left') {
    const mouse = type => this.call('Input.dispatchMouseEvent', {type, x, y, button, clickCount: type === 'mouseMoved' ? 0 : 1});
    await this.call('Input.dispatchMouseEvent', {type: 'mouseMoved', x, y});
    await sleep(60);
    await mouse('mousePressed');
    await sleep(60);
    await mouse('mouseReleased');
  }
  /// The middle of a control that stays where it is.
  async middle(name) {
    let last;
    return comesTrue('the control ' + name + ' at rest', async () => {
      const {x, y, w, h} = await this.control(name), now = [x + w / 2, y + h / 2];
      const still = last && last[0] === now[0] && last[1] === now[1];
      last = now;
      await sleep(80);
      return still && now;
    });
  }
  async press(name) { await this.click(...await this.middle(name)); }
  /// An item of a menu.
  async choose(menu, item) {
    await this.press('menu:' + menu);
    await this.press('menu.' + item);
  }
  /// Files of this machine, dropped there.
  async drop(x, y, files) {
    const data = {items: [], files, dragOperationsMask: 1};
    for (const type of ['dragEnter', 'dragOver', 'drop'])
      await this.call('Input.dispatchDragEvent', {type, x, y, data});
  }
  /// Fingers on the glass: where each is, in order; an empty list lifts them.
  async touch(kind, points) {
    const touchPoints = points.map(([x, y], id) => ({x, y, id, radiusX: 4, radiusY: 4, force: 1}));
    await this.call('Input.dispatchTouchEvent', {type: kind, touchPoints});
    await sleep(40);
  }
  async title(begins) {
    await comesTrue('the title begins with ' + begins,
                    () => this.ask(`document.title.startsWith(${JSON.stringify(begins)})`));
  }
  unsaved() { return this.title('\u25CF'); }
  /// A key with Ctrl or Shift: "Ctrl+S".
  async key(name) {
    const parts = name.split('+'), key = parts.pop();
    const modifiers = (parts.includes('Ctrl') ? 2 : 0) | (parts.includes('Shift') ? 8 : 0);
    const codes = {Enter: 13, Escape: 27, F1: 112};
    const code = codes[key] ?? key.toUpperCase().charCodeAt(0);
    const event = {modifiers, key: codes[key] ? key : key.toLowerCase(), code: codes[key] ? key : 'Key' + key,
                   windowsVirtualKeyCode: code, nativeVirtualKeyCode: code};
    for (const part of parts)
      await this.call('Input.dispatchKeyEvent', {type: 'rawKeyDown', key: part === 'Ctrl' ? 'Control' : 'Shift',
                                                 windowsVirtualKeyCode: part === 'Ctrl' ? 17 : 16, modifiers});
    await this.call('Input.dispatchKeyEvent', {type: 'rawKeyDown', ...event});
    await sleep(60);
    await this.call('Input.dispatchKeyEvent', {type: 'keyUp', ...event});
    for (const part of parts)
      await this.call('Input.dispatchKeyEvent', {type: 'keyUp', key: part === 'Ctrl' ? 'Control' : 'Shift',
                                                 windowsVirtualKeyCode: part === 'Ctrl' ? 17 : 16});
  }
  async picture(file) {
    const {data} = await this.call('Page.captureScreenshot', {format: 'png'});
    fs.writeFileSync(file, Buffer.from(data, 'base64'));
    return file;
  }
  /// Pixels of a part of the page, three bytes each.
  async pixels({x, y, w, h}) {
    const file = await this.picture(path.join(this.browser.folder, 'part.png'));
    return execFileSync('convert', [file, '-crop', `${Math.round(w)}x${Math.round(h)}+${Math.round(x)}+${Math.round(y)}`, '-depth', '8', 'rgb:-'], {maxBuffer: 64 << 20});
  }
}

module.exports = {Browser, comesTrue, sleep};
