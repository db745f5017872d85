// SPDX-License-Identifier: Apache-2.0
// The rows of the page: sorted, filtered, marked, linked to; keys. Follows diff_page_view.js.
// ---- The list: rows are made once; sorting moves them and filtering hides them.
const groups = data.groups.map(({kind, members}) => ({kind, tests: members.map(i => data.entries[i])}));
groups.forEach(group => group.tests.forEach(test => test.group = group));
// Without groups, the last order is not offered.
const sorts = [['Worst first', t => order.indexOf(t.status)], [data.entry + ' name', t => t.name], ['Largest difference', t => t.max_difference ?? -1],
  ['Differing pixels', t => t.differing_pixels ?? -1], ['FLIP mean', t => t.flip_mean ?? -1], ['FLIP max', t => t.flip_max ?? -1],
  ['Alike changes', t => t.group ? groups.indexOf(t.group) : groups.length]];
const byGroup = sorts.length - 1;
const worstFirst = data.entries.some(t => t.status !== 'identical');
const state = {sort: 0, down: false, hidden: new Set(worstFirst ? ['identical'] : []), selected: null, mode: 'changes', place: 0, approved: new Set(), rejected: new Set(), unfolded: new Set()};

function rowOf(test) {
  test.title = data.curve ? `${data.entry} ${test.name}` : test.name;
  const row = make('li', {role: 'option', className: test.status, onclick: () => select(test)},
    make('span', {className: 'name', textContent: test.title, title: test.name}), make('span', {className: 'figure'}));
  if (canApprove(test)) {
    const onclick = event => { event.stopPropagation(); decide(test, 'approved'); };
    test.box = make('input', {type: 'checkbox', title: 'approve ( a )', tabIndex: -1, onclick});
    test.box.setAttribute('aria-label', 'approve ' + test.name);
    row.append(test.box);
  }
  const why = test.change || test.message;
  row.append(make('span', {className: 'why'}, make('span', {className: 'status', textContent: test.status}), why && ' · ' + why));
  row.dataset.name = test.name;
  test.sought = [test.name, test.change, test.message].join('\n').toLowerCase();
  return row;
}

const shown = () => sorted().filter(t => !t.row.hidden);

function sorted() {
  const key = sorts[state.sort][1], sign = state.down ? -1 : 1;
  const compare = (a, b) => typeof a === 'string' ? a.localeCompare(b, undefined, {numeric: true}) : a - b;
  // Among equal rows, the one that an eye notices most comes first.
  const rest = (a, b) => (b.flip_mean ?? -1) - (a.flip_mean ?? -1) || compare(a.name, b.name);
  return [...data.entries].sort((a, b) => sign * compare(key(a), key(b)) || rest(a, b));
}

function sortBy(column, down) {
  Object.assign(state, {sort: column, down});
  $('#turn').textContent = down ? '↓' : '↑';
  const value = column === byGroup ? sorts[4][1] : sorts[column][1];
  for (const test of data.entries) test.row.children[1].textContent = column > 1 && value(test) >= 0 ? number(value(test)) : '';
  $('#rows').append(...sorted().flatMap(t => t.group?.tests[0] === t ? [t.group.head, t.row] : [t.row]));
  filter();
}

/// Whether a row is one of many alike, of which the list shows only the most and the least changed.
function isFolded(test) {
  const tests = state.sort === byGroup && !state.unfolded.has(test.group) && test.group?.tests;
  return Boolean(tests) && test !== tests[0] && test !== tests.at(-1);
}

function filter() {
  const words = $('#find').value.toLowerCase().split(/\s+/).filter(Boolean);
  for (const test of data.entries)
    test.row.hidden = state.hidden.has(test.status) || !words.every(w => test.sought.includes(w)) || (!words.length && isFolded(test));
  for (const group of groups) {
    group.head.hidden = state.sort !== byGroup || group.tests.every(t => t.row.hidden);
    group.head.setAttribute('aria-expanded', !isFolded(group.tests[1]));
  }
  $('#none').hidden = data.entries.some(t => !t.row.hidden);
  for (const chip of $('#chips').children) chip.setAttribute('aria-pressed', !state.hidden.has(chip.dataset.status));
}

function makeChips() {
  for (const status of order) {
    const count = data.entries.filter(t => t.status === status).length;
    if (!count) continue;
    const onclick = () => { state.hidden.delete(status) || state.hidden.add(status); filter(); };
    const chip = make('button', {className: status, onclick}, make('b', {textContent: count}), ' ' + status);
    chip.dataset.status = status;
    $('#chips').append(chip);
  }
}

function select(test) {
  if (state.selected) state.selected.row.setAttribute('aria-selected', false);
  Object.assign(state, {selected: test, place: 0});
  if (test.row.hidden) { state.hidden.delete(test.status); state.unfolded.add(test.group); $('#find').value = ''; filter(); }
  test.row.setAttribute('aria-selected', true);
  test.row.scrollIntoView({block: 'nearest'});
  if (hashName() !== test.name) history.replaceState(null, '', '#' + encodeURIComponent(test.name));
  placeCursor();
  show();
}

/// The name behind # in the address.
function hashName() {
  try { return decodeURIComponent(location.hash.slice(1)); } catch { return ''; }  // not written by this page
}

function selectByHash() {
  const name = hashName(), test = data.entries.find(t => t.name === name);
  if (test && test !== state.selected) select(test);
  return Boolean(test);
}

function step(by) {
  const tests = shown(), next = tests[tests.indexOf(state.selected) + by];
  if (next) select(next);
}

// ---- Approval, row by row. The page itself changes no file: it gives a command and a patch.
const hasFiles = data.entries.some(test => test.files);
/// Whether the command of the page can approve a row. `golden approve` needs the row's files.
function canApprove(test) { return Boolean(data.approve && test?.approve && (test.files || !hasFiles)); }

/// Marks a row as approved or rejected, or takes the same mark away.
function decide(test, mark) {
  if (!canApprove(test)) return false;
  const other = mark === 'approved' ? 'rejected' : 'approved';
  state[other].delete(test);
  const isNew = !state[mark].delete(test);
  if (isNew) state[mark].add(test);
  showDecisions();
  return isNew;
}

/// Marks the selected row, and goes to the next one that is still open.
function decideAndGoOn(mark) {
  if (!decide(state.selected, mark)) return;
  const tests = shown(), at = tests.indexOf(state.selected);
  const next = [...tests.slice(at + 1), ...tests.slice(0, at)].find(isOpen);
  if (next) select(next);
}

/// Marks all rows of a group, or takes the same mark away from all of them.
function decideGroup(group, mark) {
  const tests = group.tests.filter(canApprove), other = mark === 'approved' ? 'rejected' : 'approved';
  const isNew = !tests.every(test => state[mark].has(test));
  for (const test of tests) {
    state[other].delete(test);
    isNew ? state[mark].add(test) : state[mark].delete(test);
  }
  showDecisions();
  return isNew;
}

/// Marks the group of the selected row, and goes to the next row that is still open.
function decideGroupAndGoOn(mark) {
  if (!state.selected.group || !decideGroup(state.selected.group, mark)) return;
  const next = shown().find(isOpen);
  if (next) select(next);
}

/// The line above the rows of a group. A click shows or hides its members.
function headOf(group) {
  const [most, least] = [group.tests[0], group.tests.at(-1)].map(test => number(test.flip_mean));
  const onclick = () => { state.unfolded.delete(group) || state.unfolded.add(group); filter(); };
  const head = make('li', {className: 'group-head', onclick, title: 'show or hide the pictures between the most and the least changed'},
    make('b', {textContent: `${group.tests.length} alike`}), make('span', {className: 'why', textContent: `${group.kind} · FLIP mean ${most} to ${least}`}));
  if (group.tests.some(canApprove)) {
    group.box = make('input', {type: 'checkbox', title: 'approve all ( A )', tabIndex: -1,
      onclick: event => { event.stopPropagation(); decideGroup(group, 'approved'); }});
    group.box.setAttribute('aria-label', `approve all ${group.tests.length} alike`);
    head.append(group.box);
  }
  return head;
}

const isOpen = test => canApprove(test) && !state.approved.has(test) && !state.rejected.has(test);
const approvedTests = () => data.entries.filter(test => state.approved.has(test));

function showDecisions() {
  for (const test of data.entries) {
    if (test.box) test.box.checked = state.approved.has(test);
    test.row.classList.toggle('rejected', state.rejected.has(test));
  }
  for (const group of groups.filter(group => group.box)) {
    const count = group.tests.filter(test => state.approved.has(test)).length;
    group.box.checked = count === group.tests.filter(canApprove).length;
    group.box.indeterminate = count && !group.box.checked;
  }
  const tests = approvedTests(), left = tests.filter(test => !canPatch(test)).length;
  const counts = [[tests.length, 'approved'], [state.rejected.size, 'rejected'], [data.entries.filter(isOpen).length, 'open']];
  $('footer').hidden = !tests.length && !state.rejected.size;
  $('footer b').textContent = counts.filter(([count]) => count).map(([count, word]) => `${count} ${word}`).join(', ');
  $('footer input').value = tests.length ? [data.approve, ...tests.map(test => test.approve)].join(' ') : '';
  $('#copy').disabled = !tests.length;
  $('#copy').textContent = 'Copy';
  $('#patch').hidden = !hasFiles;
  $('#patch').disabled = left === tests.length;
  $('#patch').textContent = left && left < tests.length ? `Save patch (${left} not embedded)` : 'Save patch';
}
$('#copy').onclick = async () => {
  const box = $('footer input');
  box.select();
  try { await navigator.clipboard.writeText(box.value); } catch { document.execCommand('copy'); }
  $('#copy').textContent = 'Copied';
};
$('#patch').onclick = () => {
  const address = URL.createObjectURL(new Blob([patchOf(approvedTests())], {type: 'text/x-diff'}));
  make('a', {href: address, download: 'approved.patch'}).click();
  setTimeout(() => URL.revokeObjectURL(address), 60000);
};
$('#unmark').onclick = () => { state.approved.clear(); state.rejected.clear(); showDecisions(); };

// ---- The curve over time: a click chooses the entry that is next to it.
const shareOf = entry => data.curve.left + (data.curve.right - data.curve.left) * data.curve.places[data.entries.indexOf(entry)];

function placeCursor() {
  if (!data.curve || !state.selected) return;
  $('#curve i').hidden = false;
  $('#curve i').style.left = 100 * shareOf(state.selected) + '%';
}

function showCurve() {
  $('#curve').hidden = !data.curve;
  if (!data.curve) return;
  $('#curve img').src = data.curve.picture;
  $('#curve').onclick = event => {
    const box = $('#curve').getBoundingClientRect(), share = (event.clientX - box.left) / box.width;
    const distance = entry => Math.abs(shareOf(entry) - share);
    if (data.entries.length) select(data.entries.reduce((a, b) => distance(b) < distance(a) ? b : a));
  };
}

// ---- Keys.
const keys = {
  ArrowDown: () => step(1), j: () => step(1), ArrowUp: () => step(-1), k: () => step(-1),
  n: () => showPlace(state.place + 1), p: () => showPlace(state.place - 1),
  b: () => chooseMode('blink'), a: () => decideAndGoOn('approved'), r: () => decideAndGoOn('rejected'),
  A: () => decideGroupAndGoOn('approved'), R: () => decideGroupAndGoOn('rejected'), '/': () => $('#find').focus(),
  '+': zooms.in, '=': zooms.in, '-': zooms.out, 0: zooms.fit, z: zooms.one,
};
Object.keys(modes).slice(0, 7).forEach((mode, i) => keys[i + 1] = () => chooseMode(mode));
function chooseMode(mode) {
  if (state.selected && usable(state.selected).includes(mode)) { state.mode = mode; show(); }
}
document.addEventListener('keydown', event => {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const typing = event.target.matches('input:not([type=checkbox]), select');
  if (typing && event.key === 'Escape') {
    if (event.target === $('#find')) { event.target.value = ''; filter(); }
    event.target.blur();
  }
  if (typing || !keys[event.key] || !data.entries.length) return;
  event.preventDefault();
  keys[event.key]();
});

// ---- The page.
function showRun() {
  const facts = new Map(data.run);
  $('#run').hidden = !facts.size;
  $('#run summary').textContent = [facts.get('date'), facts.get('commit')?.slice(0, 10), facts.get('machine')].filter(Boolean).join(' · ');
  $('#run dl').replaceChildren(...terms(data.run));
}

document.title = data.title + ': ' + data.verdict;
$('#title').textContent = data.title;
$('#verdict').textContent = data.verdict;
$('#verdict').classList.add({passed: 'identical', failed: 'different'}[data.verdict] || data.verdict);
$('#note').textContent = data.note;
$('#counts').textContent = data.counts;
$('#markhint').hidden = !data.approve;
$('#figures').open = innerHeight >= 900;
showRun();
showCurve();
$('main').hidden = !data.entries.length;
$('main').classList.toggle('single', data.entries.length === 1);
$('main').classList.toggle('filmed', Boolean(data.curve));
if (data.entries.length) {
  for (const test of data.entries) test.row = rowOf(test);
  for (const group of groups) group.head = headOf(group);
  $('#grouphint').hidden = !data.approve || !groups.length;
  makeChips();
  $('#sort').append(...sorts.slice(0, groups.length ? undefined : byGroup).map(([title], i) => make('option', {textContent: title, value: i})));
  $('#sort').onchange = () => sortBy(+$('#sort').value, +$('#sort').value > 1 && +$('#sort').value < byGroup);
  $('#turn').onclick = () => sortBy(state.sort, !state.down);
  $('#find').oninput = filter;
  for (const button of document.querySelectorAll('[data-zoom]')) button.onclick = zooms[button.dataset.zoom];
  for (const button of document.querySelectorAll('#place button')) button.onclick = () => showPlace(state.place + +button.dataset.step);
  $('#sort').value = groups.some(group => group.tests.length > 2) ? byGroup : 0;
  sortBy(+$('#sort').value, false);
  if (!selectByHash()) select(data.entries.find(t => t.name === data.first) || shown()[0]);
  addEventListener('hashchange', selectByHash);
}
