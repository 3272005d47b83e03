// Style and script of the page for a phone. Without the script every step is a form, and the page is loaded anew.

#include "loom/phone_page.h"

namespace weftlight::loom {

const char* const kPhoneStyle = R"css(
:root{--paper:#ece9e3;--card:#f7f5f1;--ink:#26241f;--soft:#6b665c;--line:#d3cec4;--accent:#2f5597;--on:#fff;--warn:#9a5b00}
@media(prefers-color-scheme:dark){:root{--paper:#17181a;--card:#1f2124;--ink:#e9e6e0;--soft:#a09c94;--line:#3a3d43;--accent:#8db0f2;--on:#14181f;--warn:#e3a84f}}
*{box-sizing:border-box;margin:0;padding:0}
[hidden]{display:none!important}
html{background:var(--paper);color:var(--ink);font:18px/1.35 system-ui,-apple-system,"Segoe UI",Roboto,Inter,sans-serif;-webkit-text-size-adjust:100%}
body{min-height:100vh;min-height:100dvh}
main{max-width:46rem;margin:0 auto;min-height:100vh;min-height:100dvh;padding:max(.8rem,env(safe-area-inset-top)) 1rem 0;display:flex;flex-direction:column;gap:.8rem}
header{display:flex;align-items:center;gap:1rem;min-height:2.4rem}
h1{flex:1;font-size:1rem;font-weight:600;color:var(--soft);overflow:hidden;text-overflow:ellipsis;white-space:nowrap}
header button{min-height:2.4rem;padding:0 1rem;font-size:.9rem;border-radius:1.2rem}
header button[aria-pressed=true]{background:var(--ink);color:var(--paper)}
.remark{background:var(--warn);color:var(--paper);border-radius:.7rem;padding:.7rem 1rem}
.remark:empty{display:none}
#step{background:var(--card);border:1px solid var(--line);border-radius:1.2rem;padding:1rem 1.1rem 1.1rem}
#heading,#group{color:var(--soft)}
.count{white-space:nowrap;line-height:1;margin:.1rem 0 .3rem}
#number{font-size:clamp(4rem,min(24vw,13vh),8.5rem);font-weight:700;letter-spacing:-.03em;font-variant-numeric:tabular-nums}
#of{color:var(--soft);font-size:1.2rem}
#what{font-size:clamp(1.6rem,7.4vw,2.6rem);font-weight:650;line-height:1.15;margin:.5rem 0 .9rem}
#shafts,#colors{list-style:none}
#shafts{display:grid;grid-template-columns:repeat(auto-fill,minmax(2.5rem,1fr));gap:.4rem;max-width:27rem}
#shafts li{aspect-ratio:1;max-height:3.6rem;display:grid;place-items:center;border:1.5px solid var(--line);border-radius:.55rem;color:var(--soft);font-variant-numeric:tabular-nums}
#shafts li.up{background:var(--accent);border-color:var(--accent);color:var(--on);font-weight:700}
#shafts:empty,#colors:empty{display:none}
#colors{display:flex;flex-wrap:wrap;gap:.4rem 1rem;margin-top:.9rem;align-items:center}
#colors li{display:flex;align-items:center;gap:.55rem}
#colors svg{width:2.3rem;height:2.3rem;border-radius:.5rem;border:1px solid var(--line)}
#colors li+li{color:var(--soft)}
#colors li+li svg{width:1.5rem;height:1.5rem;border-radius:.35rem}
figure{flex:1 1 auto;display:flex;flex-direction:column;min-height:0}
#picture{display:block;width:100%;max-height:30vh;object-fit:cover;object-position:top right;border-radius:.8rem;border:1px solid var(--line);image-rendering:pixelated}
figcaption{color:var(--soft);font-size:.9rem;padding:.4rem .2rem 0}
nav{position:sticky;bottom:0;margin-top:auto;display:flex;gap:.6rem;background:var(--paper);padding:.6rem 0 max(.8rem,env(safe-area-inset-bottom))}
nav form{flex:1 1 auto}
nav form:last-child{flex:2 1 40%}
button{font:inherit;font-weight:600;width:100%;color:var(--ink);background:var(--card);border:1px solid var(--line);border-radius:1rem;cursor:pointer;touch-action:manipulation;-webkit-tap-highlight-color:transparent}
nav button,.pair button{min-height:4.6rem;padding:0 .6rem;font-size:1.1rem}
header button{width:auto}
button.next{background:var(--accent);border-color:var(--accent);color:var(--on);font-size:1.5rem}
button:active{filter:brightness(.9)}
button:focus-visible,input:focus-visible,a:focus-visible{outline:3px solid var(--ink);outline-offset:2px}
.note{text-align:center;padding-bottom:.8rem}
a{color:var(--accent)}
.lost #step,.lost figure{opacity:.4}
.pair{justify-content:center;max-width:24rem}
.pair h1{flex:none;font-size:1.8rem;color:var(--ink);text-align:center}
.pair form{display:grid;gap:1rem}
.pair label{text-align:center;color:var(--soft)}
.pair input{font:inherit;font-size:2.4rem;letter-spacing:.18em;text-align:center;padding:.7rem .2rem;width:100%;color:var(--ink);background:var(--card);border:1px solid var(--line);border-radius:1rem}
@media(min-width:44rem) and (orientation:landscape){#step{display:grid;grid-template-columns:minmax(19rem,auto) 1fr;column-gap:2rem}#heading,#group{grid-column:1}.count{grid-column:1;grid-row:2}#what{grid-column:2;grid-row:1/3;align-self:end}#shafts,#colors{grid-column:2}}
)css";

const char* const kPhoneScript = R"js('use strict';
(() => {
  const at = id => document.getElementById(id), page = at('page'), speak = at('speak');
  let revision = Number(page.dataset.revision), speaks = false, queue = Promise.resolve();
  const text = (id, words) => { if (at(id).textContent !== words) at(id).textContent = words; };
  const color = c => {
    const li = document.createElement('li'), name = document.createElement('span');
    const ns = 'http://www.w3.org/2000/svg', svg = document.createElementNS(ns, 'svg');
    const rect = document.createElementNS(ns, 'rect');
    svg.setAttribute('viewBox', '0 0 1 1');
    rect.setAttribute('width', 1); rect.setAttribute('height', 1); rect.setAttribute('fill', c.hex);
    name.textContent = c.text;
    svg.append(rect); li.append(svg, name);
    return li;
  };
  const show = s => {
    page.classList.remove('lost');
    const other = s.revision !== revision;
    revision = s.revision;
    for (const id of ['title', 'heading', 'number', 'of', 'group', 'what', 'progress', 'remark']) text(id, s[id]);
    at('shafts').replaceChildren(...s.shafts.map((up, i) => {
      const li = document.createElement('li');
      li.textContent = i + 1;
      if (up) li.className = 'up';
      return li;
    }));
    at('colors').replaceChildren(...s.colors.map(color));
    document.querySelector('form[action="/tabby"]').hidden = !s.tabby;
    at('cloth').hidden = !s.cloth;
    if (other && s.cloth) at('picture').src = '/cloth.png?' + revision;
    for (const field of document.querySelectorAll('input[name=at]')) field.value = revision;
    if (other && speaks) say(s.heading + ' ' + s.number + ': ' + s.what);
  };
  const lost = () => { page.classList.add('lost'); text('remark', page.dataset.lost); };
  const take = async answer => {
    if (answer.status === 200) show(await answer.json());
    else if (answer.status === 403 || answer.status === 421) location.reload();
    else if (answer.status !== 204) lost();
    return answer.status;
  };
  const headers = { Accept: 'application/json' };
  // One step after the other: each is asked for from what the one before it has shown.
  const step = path => {
    queue = queue.then(() => fetch(path, {
      method: 'POST', headers: { ...headers, 'Content-Type': 'application/x-www-form-urlencoded' },
      body: 'at=' + revision })).then(take).catch(lost);
  };
  for (const form of document.forms) form.addEventListener('submit', event => {
    event.preventDefault();
    step(form.getAttribute('action'));
  });
  addEventListener('keydown', event => {
    if (event.target.closest('button') && (event.key === ' ' || event.key === 'Enter')) return;
    if ([' ', 'Enter', 'ArrowRight', 'ArrowDown', 'PageDown'].includes(event.key)) step('/next');
    else if (['Backspace', 'ArrowLeft', 'ArrowUp', 'PageUp'].includes(event.key)) step('/back');
    else if (event.key === 't' || event.key === 'T') step('/tabby');
    else return;
    event.preventDefault();
  });
  // The phone's own voices alone: others send the words to a server.
  const say = words => {
    const own = speechSynthesis.getVoices().filter(v => v.localService);
    if (!own.length) return;
    const saying = new SpeechSynthesisUtterance(words);
    saying.voice = own.find(v => v.lang.startsWith(navigator.language.slice(0, 2))) || own[0];
    speechSynthesis.cancel();
    speechSynthesis.speak(saying);
  };
  if (window.speechSynthesis) {
    const offer = () => { speak.hidden = !speechSynthesis.getVoices().some(v => v.localService); };
    offer();
    speechSynthesis.addEventListener('voiceschanged', offer);
    speak.addEventListener('click', () => {
      speaks = !speaks;
      speak.setAttribute('aria-pressed', speaks);
      if (speaks) say(at('what').textContent);
    });
  }
  const follow = async () => {
    for (;;) {
      try {
        const status = await take(await fetch('/state?after=' + revision, { headers }));
        if (status !== 200 && status !== 204) await new Promise(then => setTimeout(then, 2000));
      } catch {
        lost();
        await new Promise(then => setTimeout(then, 2000));
      }
    }
  };
  follow();
})();
)js";

}  // namespace weftlight::loom
