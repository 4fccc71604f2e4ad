// What the page was given: the scene as one mesh, and its views.

const DATA = JSON.parse(document.getElementById('data').textContent);

/// The bytes of all parts of the mesh. Their texts are let go.
function meshBytes() {
    const parts = [...document.querySelectorAll('script.mesh')].map(node => {
        const text = atob(node.textContent);
        node.remove();
        const bytes = new Uint8Array(text.length);
        for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
        return bytes;
    });
    const whole = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
    let at = 0;
    for (const part of parts) {
        whole.set(part, at);
        at += part.length;
    }
    return whole;
}

async function inflated(bytes) {
    return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'))).arrayBuffer());
}

/// Reads arrays one after the other, as report/packed_mesh.cpp writes them.
class ArrayReader {
    constructor(bytes) {
        this.bytes = bytes;
        this.at = 0;
    }

    /// So many numbers, each to be added to the one `stride` before and to that of `base`.
    take(Type, count, stride = count, base = null) {
        const Word = {1: Uint8Array, 2: Uint16Array, 4: Uint32Array}[Type.BYTES_PER_ELEMENT];
        const words = new Word(count);
        for (let shift = 0; shift < 8 * Word.BYTES_PER_ELEMENT; shift += 8)
            for (let i = 0; i < count; ++i) words[i] |= this.bytes[this.at++] << shift;
        for (let i = 0; i < count; ++i) words[i] = words[i] >>> 1 ^ -(words[i] & 1);
        for (let i = stride; i < count; ++i) words[i] += words[i - stride];
        if (base) for (let i = 0; i < count; ++i) words[i] += base[i];
        return new Type(words.buffer);
    }

    /// Numbers that lie so far below the next new one.
    takeBelowNext(count) {
        const numbers = this.take(Uint32Array, count);
        for (let i = 0, next = 0; i < count; ++i) {
            numbers[i] = next - numbers[i];
            next = Math.max(next, numbers[i] + 1);
        }
        return numbers;
    }
}

/// Of each edge of a face the other's that joins the same points, which is to be so of two; -1 of none.
function matesOf(corners) {
    const count = corners.length;
    const mates = new Int32Array(count).fill(-1);
    const slots = new Int32Array(2 ** Math.ceil(Math.log2(2 * count))).fill(-1);
    const next = edge => (edge % 3 === 2 ? edge - 2 : edge + 1);
    const isSame = (a, b) => {
        const [p, q, r, s] = [corners[a], corners[next(a)], corners[b], corners[next(b)]];
        return (p === r && q === s) || (p === s && q === r);
    };
    for (let edge = 0; edge < count; ++edge) {
        const [p, q] = [corners[edge], corners[next(edge)]];
        let slot = (Math.imul(Math.min(p, q), 0x9e3779b1) ^ Math.imul(Math.max(p, q), 0x85ebca6b)) >>> 0;
        slot = (slot ^ slot >>> 15) & slots.length - 1;
        while (slots[slot] >= 0 && !isSame(slots[slot], edge)) slot = slot + 1 & slots.length - 1;
        if (slots[slot] < 0) {
            slots[slot] = edge;
        } else {
            mates[edge] = slots[slot];
            mates[slots[slot]] = edge;
        }
    }
    return mates;
}

/// Eight words a face.
function takeFaces(arrays, count) {
    const corners = arrays.takeBelowNext(3 * count);
    const patches = arrays.take(Uint32Array, count, 1);
    const rests = arrays.take(Uint32Array, count, 1);
    const twins = arrays.take(Uint32Array, 3 * count);
    const mates = matesOf(corners);
    const faces = new Uint32Array(8 * count);
    for (let edge = 0; edge < 3 * count; ++edge) {
        const [face, i, mate] = [Math.floor(edge / 3), edge % 3, mates[edge]];
        const isLine = (rests[face] >>> 3 * i & 7) !== 0;
        const guess = mate < 0 ? -1 : Math.floor(mate / 3) << 2 | mate % 3 |
            (corners[mate] === corners[edge] ? 0x80000000 : 0) | (isLine ? 0x40000000 : 0);
        faces[8 * face + i] = corners[edge];
        faces[8 * face + 4 + i] = twins[edge] ^ guess;
    }
    for (let face = 0; face < count; ++face) {
        faces[8 * face + 3] = patches[face];
        faces[8 * face + 7] = rests[face];
    }
    return faces;
}

/// Floats of whole numbers in their order.
function floatsOf(numbers) {
    return new Float32Array(numbers.map(number => number ^ (number >> 31 & 0x7fffffff)).buffer);
}

/// As angle_rad in report/packed_mesh.cpp, bit by bit: of two vectors with these dot products and this cross product.
function angleOf(uu, vv, uv, cross) {
    const tangent = cross / (Math.sqrt(uu * vv) + uv);
    const isSteep = !(tangent <= 1);
    const t = isSteep ? 1 / tangent : tangent;
    const tt = t * t;
    const arc = t * (0.9998660 + tt * (-0.3302995 + tt * (0.1801410 + tt * (-0.0851330 + tt * 0.0208351))));
    return 2 * (isSteep ? 1.5707963 - arc : arc);
}

/// As told_normals there: what the triangles round the vertices' places tell of their normals.
function toldNormals(p, indices, placeOf) {
    const sums = new Float64Array(3 * DATA.place_count);
    const add = (vertex, x, y, z, share) => {
        const at = 3 * placeOf[vertex];
        sums[at] += x * share;
        sums[at + 1] += y * share;
        sums[at + 2] += z * share;
    };
    const dot = (x, y, z, u, v, w) => x * u + y * v + z * w;
    for (let at = 0; at < indices.length; at += 3) {
        const a = 3 * indices[at], b = 3 * indices[at + 1], c = 3 * indices[at + 2];
        const ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2]; // from a to b
        const vx = p[c] - p[b], vy = p[c + 1] - p[b + 1], vz = p[c + 2] - p[b + 2]; // from b to c
        const wx = p[a] - p[c], wy = p[a + 1] - p[c + 1], wz = p[a + 2] - p[c + 2]; // from c to a
        const x = wy * uz - uy * wz, y = wz * ux - uz * wx, z = wx * uy - ux * wy;
        const length = Math.sqrt(dot(x, y, z, x, y, z));
        if (!(length > 0)) continue;
        const uu = dot(ux, uy, uz, ux, uy, uz), vv = dot(vx, vy, vz, vx, vy, vz), ww = dot(wx, wy, wz, wx, wy, wz);
        add(indices[at], x, y, z, angleOf(uu, ww, -dot(ux, uy, uz, wx, wy, wz), length) / length);
        add(indices[at + 1], x, y, z, angleOf(vv, uu, -dot(vx, vy, vz, ux, uy, uz), length) / length);
        add(indices[at + 2], x, y, z, angleOf(ww, vv, -dot(wx, wy, wz, vx, vy, vz), length) / length);
    }
    for (let at = 0; at < sums.length; at += 3) {
        const length = Math.sqrt(dot(sums[at], sums[at + 1], sums[at + 2], sums[at], sums[at + 1], sums[at + 2]));
        for (let k = at; k < at + 3; ++k) sums[k] *= length > 0 ? 1 / length : 0;
    }
    const told = new Int16Array(4 * placeOf.length);
    for (let i = 0; i < told.length; ++i) {
        const value = i % 4 < 3 ? 32767 * sums[3 * placeOf[i >> 2] + i % 4] : 0;
        told[i] = Math.sign(value) * Math.round(Math.abs(value)); // halves away from 0
    }
    return told;
}

/// The arrays of the mesh by what they hold.
async function readMesh() {
    const arrays = new ArrayReader(await inflated(meshBytes()));
    const count = DATA.vertex_count;
    const faces = takeFaces(arrays, DATA.face_count);
    const places = arrays.take(Int32Array, 3 * DATA.place_count, 3);
    const placeOf = arrays.take(Uint32Array, count, 1);
    const indices = arrays.takeBelowNext(3 * DATA.triangle_count);
    const takeMoved = numbers => {
        const position = floatsOf(numbers);
        const hull = arrays.take(Int16Array, 4 * count, 4, toldNormals(position, indices, placeOf));
        return {position, hull_normal: hull, normal: arrays.take(Int16Array, 4 * count, 4, hull)};
    };
    let numbers = new Int32Array(3 * count).map((_, i) => places[3 * placeOf[Math.floor(i / 3)] + i % 3]);
    const rest = takeMoved(numbers);
    const poses = Array.from({length: DATA.motion?.count ?? 0}, () => {
        numbers = arrays.take(Int32Array, 3 * count, 3, numbers);
        return takeMoved(numbers);
    });
    const at = floatsOf(places);
    const points = new Float32Array(4 * DATA.point_count).map((_, i) => (i % 4 < 3 ? at[3 * Math.floor(i / 4) + i % 4] : 1));
    return {
        ...rest, poses, faces, points, indices,
        id: arrays.take(Uint32Array, count, 1),
        surface8: arrays.take(Uint8Array, count, 1),
        label8: arrays.take(Uint8Array, count, 1),
    };
}
