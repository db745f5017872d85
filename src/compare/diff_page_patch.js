// SPDX-License-Identifier: Apache-2.0
// Makes a patch for `git apply` from the pictures that the page embeds. Comes before diff_page.js.
const digits85 = '0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz!#$%&()*+-;<=>?@^_`{|}~';

/// Content of a file after approval; null if the page does not have it.
function contentOf(test, file) {
  if (!file.new) return new Uint8Array();
  if (file.text) return new TextEncoder().encode(file.text);
  return file.embedded ? Uint8Array.from(atob(test.actual.slice(test.actual.indexOf(',') + 1)), c => c.charCodeAt(0)) : null;
}

/// Wraps bytes in the format of zlib, without compression, because PNG files are compressed already.
function zlibOf(bytes) {
  const most = 65535, blocks = Math.max(1, Math.ceil(bytes.length / most));
  const all = new Uint8Array(2 + 5 * blocks + bytes.length + 4);
  all.set([0x78, 0x01]);
  let end = 2;
  for (let i = 0; i < blocks; ++i) {
    const block = bytes.subarray(i * most, (i + 1) * most), size = block.length;
    all.set([i === blocks - 1 ? 1 : 0, size & 255, size >> 8, ~size & 255, ~size >> 8 & 255], end);
    all.set(block, end + 5);
    end += 5 + size;
  }
  let [a, b] = [1, 0];
  for (const byte of bytes) { a = (a + byte) % 65521; b = (b + a) % 65521; }
  all.set([b >> 8, b & 255, a >> 8, a & 255], end);
  return all;
}

/// Lines of git's base 85: the number of bytes as a letter, then five digits for each four bytes.
function linesOf(bytes) {
  const lines = [];
  for (let at = 0; at < bytes.length; at += 52) {
    const part = bytes.subarray(at, at + 52), size = part.length;
    let line = String.fromCharCode(size <= 26 ? 64 + size : 70 + size);
    for (let i = 0; i < size; i += 4) {
      let value = 0, group = '';
      for (let k = 0; k < 4; ++k) value = value * 256 + (part[i + k] || 0);
      for (let k = 0; k < 5; ++k) { group = digits85[value % 85] + group; value = Math.floor(value / 85); }
      line += group;
    }
    lines.push(line);
  }
  return lines;
}

/// Path as git writes it: in quotes, with escapes, unless it is plain ASCII.
function quoted(path) {
  if (/^[\x21\x23-\x5b\x5d-\x7e ]*$/.test(path)) return path;
  const bytes = [...new TextEncoder().encode(path)];
  return `"${bytes.map(b => b < 32 || b > 126 || b === 34 || b === 92 ? '\\' + b.toString(8).padStart(3, '0') : String.fromCharCode(b)).join('')}"`;
}

function patchOfFile(file, content) {
  const none = '0'.repeat(40), mode = file.old && file.new ? ' 100644' : '';
  const lines = [`diff --git ${quoted('a/' + file.place)} ${quoted('b/' + file.place)}`];
  if (!file.old) lines.push('new file mode 100644');
  if (!file.new) lines.push('deleted file mode 100644');
  lines.push(`index ${file.old?.git ?? none}..${file.new?.git ?? none}${mode}`, 'GIT binary patch', `literal ${content.length}`);
  return [...lines, ...linesOf(zlibOf(content)), '', ''].join('\n');
}

/// Whether the page has everything for a patch of these rows.
const canPatch = test => Boolean(test.files) && test.files.every(file => !file.new || file.text || file.embedded);

const patchOf = tests => tests.filter(canPatch).flatMap(test => test.files.filter(file => file.old?.git !== file.new?.git)
  .map(file => patchOfFile(file, contentOf(test, file)))).join('');
