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

/// The arrays of the mesh by what they hold, as report/live_page.cpp puts them in a row.
function readMesh() {
    const {buffer} = meshBytes();
    const vertices = DATA.vertex_count;
    let at = 0;
    const take = (Type, count) => {
        const values = new Type(buffer, at, count);
        at += values.byteLength;
        return values;
    };
    const takeMoving = () => ({position: take(Float32Array, 3 * vertices), normal: take(Int16Array, 4 * vertices),
        hull_normal: take(Int16Array, 4 * vertices)});
    return {
        ...takeMoving(),
        poses: Array.from({length: DATA.motion?.count ?? 0}, takeMoving),
        id: take(Uint32Array, vertices),
        indices: take(Uint32Array, 3 * DATA.triangle_count),
        faces: take(Uint32Array, 8 * DATA.face_count),
        points: take(Float32Array, 4 * DATA.point_count),
        surface8: take(Uint8Array, vertices),
        label8: take(Uint8Array, vertices),
    };
}
