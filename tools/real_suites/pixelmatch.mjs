// SPDX-License-Identifier: Apache-2.0
// Prints the number of differing pixels by pixelmatch's default options, or "size" for pictures of different size:
//   node pixelmatch.mjs FOLDER <pairs
// FOLDER has the packages: npm install pixelmatch pngjs. Each line of the input is EXPECTED, a tab, and ACTUAL.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const require = createRequire(resolve(process.argv[2]) + '/');
const load = (name) => import(pathToFileURL(require.resolve(name)));
const { default: pixelmatch } = await load('pixelmatch');
const { PNG } = (await load('pngjs')).default;

for (const line of readFileSync(0, 'utf8').split('\n').filter(Boolean)) {
  const [a, b] = line.split('\t').map((path) => PNG.sync.read(readFileSync(path)));
  const same = a.width === b.width && a.height === b.height;
  console.log(same ? pixelmatch(a.data, b.data, null, a.width, a.height) : 'size');
}
