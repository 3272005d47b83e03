// What Emscripten's GLFW 3 lacks, or leaves empty, of the functions that the window asks for; and what a page knows of its
// GL context. The page notes the last key, what was pasted, and how often its context was lost (editor/web/page.js).
mergeInto(LibraryManager.library, {
  weftlight_lost_contexts: function() { return Module['lostContexts'] | 0; },
  weftlight_context_is_lost__deps: ['$GL'],
  weftlight_context_is_lost: function() { return GL.currentContext && GL.currentContext.GLctx.isContextLost() ? 1 : 0; },

  glfwGetError: function(description) {
    if (description) {
      if (!Module['glfwProblem']) Module['glfwProblem'] = allocateUTF8('the browser gives no WebGL 2');
      {{{ makeSetValue('description', '0', 'Module["glfwProblem"]', 'i32') }}};
    }
    return 0x00010006; // GLFW_API_UNAVAILABLE
  },
  glfwWindowHintString: function(hint, text) {},

  // Pixels of the canvas in one of the page.
  glfwGetWindowContentScale: function(win, x, y) {
    var scale = window.devicePixelRatio || 1;
    if (x) {{{ makeSetValue('x', '0', 'scale', 'float') }}};
    if (y) {{{ makeSetValue('y', '0', 'scale', 'float') }}};
  },
  // The page changes the size of its canvas with it.
  glfwSetWindowContentScaleCallback: function(win, callback) { return 0; },
  // The page itself fits its canvas to the window of the browser.
  glfwGetMonitorWorkarea: function(monitor, x, y, width, height) {
    [x, y, width, height].forEach(function(at) { if (at) {{{ makeSetValue('at', '0', '0', 'i32') }}}; });
  },
  glfwGetGamepadState: function(joystick, state) { return 0; },

  // The letter on the key without Shift, as far as a browser tells.
  glfwGetKeyName: function(key, scancode) {
    var pressed = Module['lastKey'];
    if (!pressed || !pressed.key || pressed.key.length != 1) return 0;
    var name = pressed.key.toLowerCase();
    var digit = /^Digit([0-9])$/.exec(pressed.code || '');
    if (pressed.shift && digit) name = digit[1];
    var signs = {Minus: '-', Comma: ',', Period: '.', Slash: '/', Semicolon: ';', BracketLeft: '[', BracketRight: ']'};
    if (pressed.shift && /[<>?:_{}]/.test(name) && signs[pressed.code]) name = signs[pressed.code];
    if (!Module['keyName']) Module['keyName'] = _malloc(8);
    stringToUTF8(name, Module['keyName'], 8);
    return Module['keyName'];
  },

  glfwSetClipboardString: function(win, text) {
    Module['copied'] = UTF8ToString(text);
    Module['pasted'] = undefined;
    if (navigator.clipboard && navigator.clipboard.writeText)
      navigator.clipboard.writeText(Module['copied']).catch(function() {});
  },
  // What was pasted last, or copied here since.
  glfwGetClipboardString: function(win) {
    var text = Module['pasted'] !== undefined ? Module['pasted'] : Module['copied'];
    if (text === undefined) return 0;
    if (Module['clipboardText']) _free(Module['clipboardText']);
    Module['clipboardText'] = allocateUTF8(text);
    return Module['clipboardText'];
  },

  // A cursor is its own shape.
  glfwCreateStandardCursor: function(shape) { return shape; },
  glfwSetCursor: function(win, cursor) {
    var names = {0x36001: 'default', 0x36002: 'text', 0x36003: 'crosshair', 0x36004: 'pointer', 0x36005: 'ew-resize',
                 0x36006: 'ns-resize'};
    Module['canvas'].style.cursor = names[cursor] || 'default';
  },
});
