// Makes a tree of a preset of ez-tree and writes it as OBJ: node tree.mjs PRESET.json TREE.obj, in a
// folder with the packages @dgreenheck/ez-tree and three under node_modules.

import {createRequire} from 'node:module';
import {readFileSync, writeFileSync} from 'node:fs';
import {pathToFileURL} from 'node:url';

// The generator loads textures as soon as it is loaded; outlines need none.
const image = () => ({addEventListener() {}, removeEventListener() {}, style: {}});
globalThis.document = {createElementNS: image, createElement: image};

const [preset, file] = process.argv.slice(2);
const require = createRequire(pathToFileURL(process.cwd() + '/'));
const {Tree} = await import(pathToFileURL(require.resolve('@dgreenheck/ez-tree').replace('umd', 'es')));
const tree = new Tree();
tree.loadFromJson(JSON.parse(readFileSync(preset, 'utf-8')));
const lines = [];
let first = 1;
for (const [name, mesh] of [['branches', tree.branchesMesh], ['leaves', tree.leavesMesh]]) {
    const points = mesh.geometry.getAttribute('position');
    lines.push(`o ${name}`);
    for (let i = 0; i < points.count; ++i)
        lines.push(`v ${[points.getX(i), points.getY(i), points.getZ(i)].map(x => x.toFixed(6)).join(' ')}`);
    const corners = mesh.geometry.getIndex().array;
    for (let i = 0; i < corners.length; i += 3)
        lines.push(`f ${first + corners[i]} ${first + corners[i + 1]} ${first + corners[i + 2]}`);
    first += points.count;
}
writeFileSync(file, lines.join('\n') + '\n');
