// measure.js FILE...: a line of JSON for each file: how many triangles its scene has, and the box round
// them at rest. Or what gltf-transform says against it.

import { NodeIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import draco3d from 'draco3dgltf';
import { MeshoptDecoder } from 'meshoptimizer';

const io = new NodeIO().registerExtensions(ALL_EXTENSIONS).registerDependencies({
    'draco3d.decoder': await draco3d.createDecoderModule(),
    'meshopt.decoder': MeshoptDecoder,
});

// Matrices are 16 numbers, column by column.
function product(a, b) {
    const m = new Array(16).fill(0);
    for (let column = 0; column < 4; ++column)
        for (let row = 0; row < 4; ++row)
            for (let k = 0; k < 4; ++k) m[4 * column + row] += a[4 * k + row] * b[4 * column + k];
    return m;
}

function moved(m, p) {
    return [0, 1, 2].map((r) => m[r] * p[0] + m[4 + r] * p[1] + m[8 + r] * p[2] + m[12 + r]);
}

/** Where vertices of a primitive are in the world: (index) => point. */
function placer(node, primitive) {
    const position = primitive.getAttribute('POSITION');
    const weights = node.getWeights().length > 0 ? node.getWeights() : node.getMesh().getWeights();
    const targets = primitive.listTargets().map((target) => target.getAttribute('POSITION'));
    const skin = node.getSkin();
    const joints = skin?.listJoints().map((joint, j) => {
        const binds = skin.getInverseBindMatrices();
        return binds ? product(joint.getWorldMatrix(), binds.getElement(j, []))
                     : joint.getWorldMatrix();
    });
    return (v) => {
        const p = position.getElement(v, []);
        targets.forEach((target, t) => {
            const delta = target?.getElement(v, []) ?? [0, 0, 0];
            for (let axis = 0; axis < 3; ++axis) p[axis] += (weights[t] ?? 0) * delta[axis];
        });
        if (!skin) return moved(node.getWorldMatrix(), p);
        const sum = new Array(16).fill(0);
        let total = 0;
        for (let set = 0; primitive.getAttribute(`JOINTS_${set}`); ++set) {
            const numbers = primitive.getAttribute(`JOINTS_${set}`).getElement(v, []);
            const shares = primitive.getAttribute(`WEIGHTS_${set}`).getElement(v, []);
            shares.forEach((share, i) => {
                total += share;
                for (let k = 0; share > 0 && k < 16; ++k) sum[k] += share * joints[numbers[i]][k];
            });
        }
        return moved(sum.map((value) => value / total), p);
    };
}

/** The corners of a primitive's triangles, as vertices, three by three. */
function corners(primitive) {
    const count = primitive.getAttribute('POSITION')?.getCount() ?? 0;
    const list = primitive.getIndices()?.getArray() ?? Array.from({ length: count }, (_, i) => i);
    const mode = primitive.getMode();
    if (count === 0 || mode < 4) return [];
    if (mode === 4) return Array.from(list).slice(0, list.length - (list.length % 3));
    const all = [];
    for (let i = 0; i + 2 < list.length; ++i)
        all.push(mode === 5 ? list[i] : list[0], list[i + 1], list[i + 2]);
    return all;
}

function measure(document) {
    const root = document.getRoot();
    const scene = root.getDefaultScene() ?? root.listScenes()[0];
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    let triangles = 0;
    scene.traverse((node) => {
        for (const primitive of node.getMesh()?.listPrimitives() ?? []) {
            const place = placer(node, primitive);
            const list = corners(primitive);
            triangles += list.length / 3;
            for (const v of new Set(list)) {
                place(v).forEach((value, axis) => {
                    low[axis] = Math.min(low[axis], value);
                    high[axis] = Math.max(high[axis], value);
                });
            }
        }
    });
    return { triangles, low, high };
}

for (const file of process.argv.slice(2)) {
    let result;
    try {
        result = measure(await io.read(file));
    } catch (error) {
        result = { error: String(error.message ?? error).slice(0, 200) };
    }
    console.log(JSON.stringify({ file, ...result }));
}
