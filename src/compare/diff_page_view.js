// SPDX-License-Identifier: Apache-2.0
// The page's data, and how the pictures of one row are shown: in the stage, and magnified near a changed place.
'use strict';
const data = JSON.parse(document.getElementById('data').textContent);
const $ = selector => document.querySelector(selector);
const make = (tag, properties = {}, ...children) => {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
};
const terms = facts => facts.flatMap(([term, text]) => [make('dt', {textContent: term}), make('dd', {}, text)]);
// Verdicts, the worst first.
const order = ['error', 'different', 'missing', 'new', 'unused', 'near', 'identical'];
const [old, fresh] = [data.reference, data.actual];
const number = value => Number.isInteger(value) ? String(value) : Math.abs(value) < 1e-3 ? value.toExponential(1) : String(+value.toPrecision(3));
const limited = (value, least, most) => Math.min(Math.max(value, least), most);

// ---- The view: place and scale of the pictures, shared by all panes of the stage.
const view = {s: 1, x: 0, y: 0, fit: true};
const stage = $('#stage');
const panes = () => [...stage.querySelectorAll('.pane')];

/// Size around all pictures, in their pixels.
function sizeOf(element) {
  const images = [...element.querySelectorAll('img')];
  return [Math.max(1, ...images.map(i => i.naturalWidth)), Math.max(1, ...images.map(i => i.naturalHeight))];
}

/// Scale at which the whole picture fits; whole multiples for small ones, so that pixels stay squares.
function fitting(width, height, [w, h]) {
  const scale = Math.min(width / w, height / h, 8);
  return scale > 1 ? Math.floor(scale) : scale;
}

function place(element, {s, x, y}) {
  for (const [name, value] of Object.entries({s, x, y})) element.style.setProperty('--' + name, value);
  element.classList.toggle('crisp', s * devicePixelRatio >= 2);
}

function layOut() {
  const all = panes();
  if (!all.length) return;
  const size = sizeOf(stage), {clientWidth: width, clientHeight: height} = stage;
  stage.classList.toggle('stacked', all.length > 1 && fitting(width, height / 2 - 20, size) > fitting(width / 2, height - 20, size));
  const {clientWidth: w, clientHeight: h} = all[0];
  if (view.fit) view.s = fitting(w - 16, h - 16, size);  // with room for frames at the edge
  const [pw, ph] = [size[0] * view.s, size[1] * view.s];
  // A picture that fits is centred; of a larger one no more than half the pane is left empty.
  const along = (extent, room, at) => extent < room + 1 ? Math.round((room - extent) / 2) : limited(at, room / 2 - extent, room / 2);
  view.x = along(pw, w, view.x);
  view.y = along(ph, h, view.y);
  place(stage, view);
  const [left, right] = [Math.max(0, view.x), Math.min(w, view.x + pw)];
  stage.style.setProperty('--edge', left + (right - left) * $('#slider').value / 100 + 'px');
  $('#zoom').textContent = Math.round(100 * view.s) + ' %';
  all.forEach(dim);
}

function zoomTo(s, at) {
  const {clientWidth: w, clientHeight: h} = panes()[0] || stage, [x, y] = at || [w / 2, h / 2];
  s = limited(s, Math.min(.05, view.s), 32);
  Object.assign(view, {x: x - (x - view.x) * s / view.s, y: y - (y - view.y) * s / view.s, s, fit: false});
  layOut();
}

const zooms = {out: () => zoomTo(view.s / 1.5), in: () => zoomTo(view.s * 1.5), one: () => zoomTo(1), fit: () => { view.fit = true; layOut(); }};

/// Brings a box of the picture to the middle of the panes.
function goTo([l, t, w, h], s) {
  const pane = panes()[0];
  Object.assign(view, {s, x: pane.clientWidth / 2 - (l + w / 2) * s, y: pane.clientHeight / 2 - (t + h / 2) * s, fit: false});
  layOut();
}

stage.addEventListener('wheel', event => {
  const pane = event.target.closest('.pane');
  if (!pane) return;
  event.preventDefault();
  const box = pane.getBoundingClientRect();
  zoomTo(view.s * Math.pow(1.0015, -event.deltaY * (event.deltaMode ? 30 : 1)), [event.clientX - box.left, event.clientY - box.top]);
}, {passive: false});

stage.addEventListener('pointerdown', event => {
  if (event.button) return;
  const from = {x: event.clientX, y: event.clientY}, begin = {...view};
  const frame = event.target.closest('.frame');
  const move = now => {
    if (Math.hypot(now.clientX - from.x, now.clientY - from.y) < 4 && !stage.classList.contains('dragged')) return;
    stage.classList.add('dragged');
    Object.assign(view, {x: begin.x + now.clientX - from.x, y: begin.y + now.clientY - from.y, fit: false});
    layOut();
  };
  const end = () => {
    stage.removeEventListener('pointermove', move);
    if (!stage.classList.contains('dragged') && frame) showPlace(frame.number);
    stage.classList.remove('dragged');
  };
  stage.setPointerCapture(event.pointerId);
  stage.addEventListener('pointermove', move);
  stage.addEventListener('lostpointercapture', end, {once: true});
});
stage.addEventListener('dblclick', event => {
  const box = event.target.closest('.pane').getBoundingClientRect();
  view.fit ? zoomTo(Math.max(1, 2 * view.s), [event.clientX - box.left, event.clientY - box.top]) : zooms.fit();
});

// ---- What a pane shows.
function picture(source, alt) {
  const image = make('img', {alt, draggable: false, decoding: 'async'});
  image.onload = () => { layOut(); layOutNear(); };
  image.onerror = () => {
    const what = source.startsWith('data:') ? 'This picture cannot be shown.' : decodeURIComponent(source) +
      ' cannot be loaded. It is not embedded, so keep the page where it was made, beside its pictures.';
    image.closest('.pane')?.append(make('div', {className: 'lost', textContent: what}));
  };
  image.src = source;
  return image;
}
const sheet = (className, ...images) => make('div', {className: 'sheet ' + className}, ...images);
const layer = (className, ...content) => make('div', {className: 'layer ' + className}, ...content);
const pane = (...content) => make('div', {className: 'pane'}, ...content);
const label = text => make('span', {textContent: text});
const boxed = (element, box) => {
  ['l', 't', 'w', 'h'].forEach((name, k) => element.style.setProperty('--' + name, box[k]));
  return element;
};
const hatches = test => (test?.ignored || []).map(box => boxed(make('div', {className: 'ignored', title: 'ignored: not compared'}), box));
const figure = (labels, ...content) => make('figure', {}, make('figcaption', {}, ...[labels].flat()), pane(...content, ...hatches(state.selected)));
const imagesOf = test => [picture(test.reference, old), picture(test.actual, fresh)];
const both = (test, className) => sheet(className, ...imagesOf(test));

/// The name of a picture, with its size where the two have different ones.
function sized(image) {
  const text = label(image.alt);
  text.tell = () => {
    const sizes = new Set([...stage.querySelectorAll('img')].map(i => i.naturalWidth + '×' + i.naturalHeight));
    if (sizes.size > 1 && image.naturalWidth)
      text.replaceChildren(image.alt + ' ', make('b', {textContent: image.naturalWidth + '×' + image.naturalHeight}));
  };
  return text;
}

function frames(test) {
  return test.places.map((box, i) => {
    const frame = make('button', {className: 'frame', tabIndex: -1, title: placeText(box), number: i});
    boxed(frame, box);
    frame.setAttribute('aria-label', 'place ' + (i + 1));
    frame.onclick = event => { if (!event.detail) showPlace(i); };  // by keyboard; a pointer's is told from a drag
    return frame;
  });
}

/// Covers all but the changed places with the colour of the page.
function dim(element) {
  const canvas = element.querySelector('canvas');
  if (!canvas) return;
  const ratio = devicePixelRatio, {clientWidth: w, clientHeight: h} = element, size = sizeOf(element);
  Object.assign(canvas, {width: w * ratio, height: h * ratio});
  const pen = canvas.getContext('2d');
  pen.scale(ratio, ratio);
  pen.globalAlpha = .6;
  pen.fillStyle = getComputedStyle(document.documentElement).getPropertyValue('--paper');
  pen.fillRect(view.x, view.y, size[0] * view.s, size[1] * view.s);
  for (const [l, t, pw, ph] of state.selected.places)
    pen.clearRect(view.x + l * view.s - 5, view.y + t * view.s - 5, pw * view.s + 10, ph * view.s + 10);
}

let timer = 0;
const hasBoth = t => t.reference && t.actual;
const hasPlaces = t => hasBoth(t) && t.places.length;
const modes = {
  changes: ['Changes', hasPlaces, t => {
    const left = t.place_count > t.places.length ? `; the ${t.places.length} largest of ${t.place_count} places are framed` : '';
    return [figure(label(fresh + left), sheet('', picture(t.actual, fresh)), make('canvas'), ...frames(t))];
  }],
  side: ['Side by side', hasBoth, t => imagesOf(t).map(image => figure(sized(image), sheet('', image)))],
  slider: ['Slider', hasBoth, t => {
    const [a, b] = imagesOf(t);
    return [figure([sized(a), sized(b)], layer('', sheet('', a)), layer('fore', sheet('', b)), make('div', {className: 'edge'}))];
  }],
  blink: ['Blink', hasBoth, t => {
    const images = imagesOf(t);
    const layers = images.map(image => layer('', sheet('', image))), labels = images.map(sized);
    let now = 1;
    const turn = () => {
      now = 1 - now;
      layers.forEach((element, i) => element.style.visibility = i === now ? '' : 'hidden');
      labels.forEach((element, i) => element.hidden = i !== now);
    };
    timer = setInterval(turn, 600);
    turn();
    return [figure(labels, ...layers)];
  }],
  overlay: ['Overlay', hasBoth, t => [figure(label('changed pixels, painted over ' + fresh),
    layer('', sheet('pale', picture(t.actual, fresh))), layer('', both(t, 'apart paint')), ...frames(t))]],
  difference: ['Difference', hasBoth, t => [figure(label('difference, 16 times'), both(t, 'apart times'))]],
  flip: ['FLIP', t => t.flip, t => [figure(label('what an eye notices: nothing in black, everything in yellow'), sheet('', picture(t.flip, 'FLIP')))]],
  one: ['Picture', t => !hasBoth(t) && (t.reference || t.actual), t => {
    const name = t.reference ? old : fresh;
    const notes = {identical: `${old} and ${fresh} are identical`, error: name + '; the other picture cannot be read',
      missing: `${name}; missing in ${fresh}`};
    return [figure(label(notes[t.status] || name), sheet('', picture(t.reference || t.actual, name)))];
  }],
};
const usable = test => Object.keys(modes).filter(m => modes[m][1](test));

function show() {
  clearInterval(timer);
  const test = state.selected, choices = usable(test), now = choices.includes(state.mode) ? state.mode : choices[0];
  $('#view h2').textContent = test.title;
  $('#words').replaceChildren(make('span', {className: 'status', textContent: test.status}), test.change && ': ' + test.change);
  $('#words').className = test.status;
  $('#message').textContent = test.message;
  $('#modes').replaceChildren(...choices.map(m => {
    const button = make('button', {textContent: modes[m][0], title: `( ${Object.keys(modes).indexOf(m) + 1} )`, onclick: () => chooseMode(m)});
    button.dataset.mode = m;
    button.setAttribute('aria-pressed', m === now);
    return button;
  }));
  if (shownTest !== test) view.fit = true;
  shownTest = test;
  const nothing = () => [figure('', make('div', {className: 'lost', textContent: 'This entry has no picture.'}))];
  stage.replaceChildren(...(now ? modes[now][2](test) : nothing()));
  $('#slider').hidden = now !== 'slider';
  layOut();
  showFacts(test);
  showNear(test);
  choosePlace();
}
let shownTest = null;
new ResizeObserver(layOut).observe(stage);
stage.addEventListener('load', () => stage.querySelectorAll('figcaption span').forEach(text => text.tell?.()), true);
$('#slider').oninput = layOut;

function showFacts(test) {
  const facts = test.facts.slice();
  if (test.worst) {
    const [x, y] = test.worst;
    const go = () => { showNear(test, [x, y, 1, 1]); goTo([x, y, 1, 1], 8); };
    facts.push(['worst pixel', make('button', {id: 'worst', textContent: `(${x}, ${y})`, onclick: go})]);
  }
  $('#figures').hidden = !facts.length;
  $('#figures dl').replaceChildren(...terms(facts));
}

// ---- Both pictures near one changed place, at 1:1 or a whole multiple.
const near = [...document.querySelectorAll('#near .pane')];
let nearBox = null;
const placeText = ([l, t, w, h, pixels]) => `${pixels} ${pixels === 1 ? 'pixel' : 'pixels'}, ${w}×${h} px at (${l}, ${t})`;

function showNear(test, box = hasPlaces(test) && test.places[state.place]) {
  nearBox = box;
  $('#near').hidden = !box;
  $('#view').classList.toggle('alone', !box);
  if (!box) return;
  const index = test.places.indexOf(box), count = test.place_count;
  const which = count > 1 ? `place ${index + 1} of ${count}: ` : '';
  $('#place span').textContent = index < 0 ? `worst pixel (${box[0]}, ${box[1]})` : which + placeText(box);
  $('#place span').title = $('#place span').textContent;
  for (const button of document.querySelectorAll('#place button')) button.hidden = test.places.length < 2;
  [[old, test.reference], [fresh, test.actual]].forEach(([name, source], i) => {
    if (near[i].firstChild?.firstChild?.getAttribute('src') !== source)
      near[i].replaceChildren(sheet('', picture(source, name)), make('div', {className: 'frame'}));
    near[i].parentNode.title = 'show this place in the picture';
    near[i].parentNode.onclick = () => goTo(nearBox, Math.max(view.s, near[i].scale));
  });
  layOutNear();
}

function layOutNear() {
  if (!nearBox || $('#near').hidden) return;
  const [l, t, w, h] = nearBox, {clientWidth: width, clientHeight: height} = near[0];
  const s = limited(Math.floor(Math.min(width / (w + 8), height / (h + 8))), 1, 8);
  near.forEach((element, i) => {
    // If a place is larger than the pane, its worst pixel is shown, or else its top left corner.
    const at = (room, begin, extent, worst, whole) => {
      const hasWorst = worst >= begin && worst < begin + extent;
      const middle = extent * s <= room ? begin + extent / 2 : hasWorst ? worst : begin + room / 2 / s - 4;
      const free = room / 2 - middle * s;
      return Math.round(whole * s > room + 16 ? limited(free, room - whole * s - 8, 8) : free);
    };
    const [worstX, worstY] = state.selected.worst || [];
    const [wholeX, wholeY] = sizeOf(element);
    place(element, {s, x: at(width, l, w, worstX, wholeX), y: at(height, t, h, worstY, wholeY)});
    boxed(element.children[1], nearBox);
    element.previousSibling.textContent = `${i ? fresh : old}, ${s === 1 ? '1:1' : s + ' times'}`;
    element.scale = s;
  });
}
new ResizeObserver(layOutNear).observe(near[0]);

function choosePlace() {
  const several = state.selected.places.length > 1;
  stage.querySelectorAll('.frame').forEach(frame => frame.classList.toggle('chosen', several && frame.number === state.place));
}

function showPlace(index) {
  const test = state.selected;
  if (!test || !hasPlaces(test)) return;
  state.place = (index + test.places.length) % test.places.length;
  showNear(test);
  choosePlace();
  if (!view.fit) goTo(test.places[state.place], view.s);
}
