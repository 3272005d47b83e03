// Fingers and pencils as the pointer that the program knows: one finger is the pointer with its button down, held still it
// is the other button; two fingers move (as a wheel does) and pinch (as a wheel with Ctrl does). A finger presses only when
// it moves, leaves or no other has followed, so that the first of two paints nothing.
'use strict';

const Touch = (() => {
  const kPressMs = 120, kHoldMs = 550, kStill = 9;  // pixels of the page
  const kMoveStep = 28, kPinch = 1.19;              // a step of the wheel makes the cells so much larger
  let canvas, seen = matchMedia('(pointer: coarse)').matches;
  const fingers = new Map();
  let state = 'none';  // none, waits, one, two, done
  let waits, held, from, middle, apart, left = [0, 0];

  function mouse(kind, at, button, buttons) {
    canvas.dispatchEvent(new MouseEvent(kind, {bubbles: true, cancelable: true, view: window, clientX: at.x, clientY: at.y,
                                               screenX: at.x, screenY: at.y, button, buttons}));
  }
  function wheel(at, dx, dy, ctrl) {
    canvas.dispatchEvent(new WheelEvent('wheel', {bubbles: true, cancelable: true, clientX: at.x, clientY: at.y,
                                                  deltaX: dx, deltaY: dy, ctrlKey: ctrl}));
  }
  const at = event => ({x: event.clientX, y: event.clientY});
  const both = () => {
    const [a, b] = [...fingers.values()];
    return [{x: (a.x + b.x) / 2, y: (a.y + b.y) / 2}, Math.hypot(a.x - b.x, a.y - b.y)];
  };

  function press() {
    clearTimeout(waits);
    if (state !== 'waits') return;
    state = 'one';
    mouse('mousedown', from, 0, 1);
  }
  function down(event) {
    fingers.set(event.pointerId, at(event));
    if (fingers.size === 1) {
      state = 'waits';
      from = at(event);
      mouse('mousemove', from, 0, 0);
      // A pencil is alone.
      if (event.pointerType === 'pen') press();
      else waits = setTimeout(press, kPressMs);
      held = setTimeout(() => {
        if (state !== 'one') return;
        state = 'done';
        mouse('mouseup', from, 0, 0);
        mouse('mousedown', from, 2, 2);
        mouse('mouseup', from, 2, 0);
      }, kHoldMs);
    } else if (fingers.size === 2) {
      clearTimeout(held);
      clearTimeout(waits);
      if (state === 'one') mouse('mouseup', from, 0, 0);
      state = 'two';
      [middle, apart] = both();
      left = [0, 0];
    }
  }
  function move(event) {
    if (!fingers.has(event.pointerId)) return;
    fingers.set(event.pointerId, at(event));
    if (state === 'one' || state === 'waits') {
      const here = at(event), moved = Math.hypot(here.x - from.x, here.y - from.y) > kStill;
      if (moved) clearTimeout(held), press();
      if (state === 'one') mouse('mousemove', here, 0, 1);
    } else if (state === 'two' && fingers.size === 2) {
      const [now, wide] = both();
      left[0] += middle.x - now.x, left[1] += middle.y - now.y;
      middle = now;
      mouse('mousemove', now, 0, 0);
      while (wide > apart * kPinch) wheel(now, 0, -100, true), apart *= kPinch;
      while (wide < apart / kPinch) wheel(now, 0, 100, true), apart /= kPinch;
      for (const i of [0, 1])
        while (Math.abs(left[i]) >= kMoveStep) {
          const step = Math.sign(left[i]);
          wheel(now, i === 0 ? step * 100 : 0, i === 1 ? step * 100 : 0, false);
          left[i] -= step * kMoveStep;
        }
    }
  }
  function up(event) {
    if (!fingers.delete(event.pointerId)) return;
    clearTimeout(held);
    press();
    if (state === 'one') {
      const here = at(event);
      mouse('mouseup', here, 0, 0);
      // A finger that left hovers nowhere.
      canvas.dispatchEvent(new MouseEvent('mouseleave', {clientX: here.x, clientY: here.y}));
    }
    if (fingers.size === 0) state = 'none';
    else state = 'done';
  }

  function begin(on) {
    canvas = on;
    const taken = handle => event => {
      if (event.pointerType === 'mouse') return;
      seen ||= event.pointerType === 'touch';
      event.preventDefault();
      handle(event);
    };
    canvas.addEventListener('pointerdown', taken(event => {
      canvas.setPointerCapture(event.pointerId);
      down(event);
    }));
    canvas.addEventListener('pointermove', taken(move));
    canvas.addEventListener('pointerup', taken(up));
    canvas.addEventListener('pointercancel', taken(up));
    // GLFW's own idea of fingers would press twice.
    for (const kind of ['touchstart', 'touchmove', 'touchend', 'touchcancel'])
      addEventListener(kind, event => {
        if (event.target !== canvas) return;
        event.preventDefault();
        event.stopImmediatePropagation();
      }, {capture: true, passive: false});
  }

  return {begin, isSeen: () => seen};
})();
