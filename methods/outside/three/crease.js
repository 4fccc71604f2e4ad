// Normals and surfaces of a mesh, by what three.js has for that.

import * as THREE from 'three';
import {mergeVertices, toCreasedNormals} from 'three/addons/utils/BufferGeometryUtils.js';

const kCrease_rad = 40 * Math.PI / 180;

// toCreasedNormals takes corners within 1/100 for one, mergeVertices within 1/10000: the model is
// made so large for them that this is far below its details, and so small that their integers hold it.
const kExtent = 1e5;

// The least corner of each corner's connected component.
function componentsOf(index) {
    const parent = new Uint32Array(index.length).map((_, i) => i);
    const find = i => {
        while (parent[i] !== i) i = parent[i] = parent[parent[i]];
        return i;
    };
    for (let i = 0; i < index.length; i += 3) {
        for (const j of [i + 1, i + 2]) {
            const [a, b] = [find(index[i]), find(index[j])];
            if (a < b) parent[b] = a;
            else parent[a] = b;
        }
    }
    return index.map(find);
}

// The geometry without an index, with normals that break at creases and the number of the surface
// that each corner belongs to; and how many surfaces there are.
//
// Corners with one position and one normal are one vertex, and triangles that are connected
// through such vertices are one surface.
export function creased(geometry) {
    const corners = geometry.index ? geometry.toNonIndexed() : geometry;
    const large = corners.clone();
    large.computeBoundingSphere();
    const {center, radius} = large.boundingSphere;
    large.translate(-center.x, -center.y, -center.z);
    large.scale(...new Array(3).fill(kExtent / (radius || 1)));
    const withNormals = toCreasedNormals(large, kCrease_rad);
    corners.setAttribute('normal', withNormals.attributes.normal);

    const components = componentsOf(mergeVertices(withNormals).index.array);
    const numbers = new Map();
    const surface = new Float32Array(components.length);
    components.forEach((component, i) => {
        if (!numbers.has(component)) numbers.set(component, numbers.size);
        surface[i] = numbers.get(component);
    });
    corners.setAttribute('surface', new THREE.BufferAttribute(surface, 1));
    return {geometry: corners, surfaces: numbers.size};
}
