// Vectors as arrays of three, and the matrices of a camera as WebGL takes them: by columns.

function dot(a, b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

function plus(a, b, times = 1) {
    return a.map((value, i) => value + times * b[i]);
}

/// `v` turned by `angle` about the unit vector `axis` (Rodrigues).
function turned(v, axis, angle) {
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    const cross = [axis[1] * v[2] - axis[2] * v[1], axis[2] * v[0] - axis[0] * v[2], axis[0] * v[1] - axis[1] * v[0]];
    return v.map((value, i) => c * value + s * cross[i] + (1 - c) * dot(axis, v) * axis[i]);
}

/// A matrix of four rows by columns.
function columns(rows) {
    return new Float32Array([0, 1, 2, 3].flatMap(column => rows.map(row => row[column])));
}

/// The depth of the scene's centre along the view direction.
function centreDepth(camera) {
    return -dot(plus(DATA.center, camera.eye, -1), camera.rows[2]);
}

/// z of clip space from the depth: 1 at near and 0 at far where the GPU can have it so (`isReversed`), which
/// leaves floats exact far away; else OpenGL's -1 to 1.
function depthRow(isParallel, near, far, isReversed) {
    const span = far - near;
    if (isReversed) return isParallel ? [1 / span, far / span] : [near / span, far * near / span];
    return isParallel ? [-2 / span, -(far + near) / span] : [-(far + near) / span, -2 * far * near / span];
}

/// What the shaders read of a camera and a size: modelViewMatrix, projectionMatrix and normalMatrix, and the
/// distances at which depth is 1 and 0: those of the scene's ball. Nothing is cut off at the far end.
function matricesOf(camera, width, height, isReversed) {
    const {eye, rows, near, isParallel} = camera;
    const depth = centreDepth(camera);
    const far = Math.max(camera.far, depth + DATA.radius, near) + 0.01 * DATA.radius;
    const view = [...rows.map(row => [...row, -dot(row, eye)]), [0, 0, 0, 1]];
    const scale = isParallel ? 2 / camera.height : 1 / Math.tan(camera.fov / 2);
    const projection = [[scale * height / width, 0, 0, 0], [0, scale, 0, 0], [0, 0, ...depthRow(isParallel, near, far, isReversed)],
        isParallel ? [0, 0, 0, 1] : [0, 0, -1, 0]];
    const isAhead = depth + DATA.radius > near;
    const first = isAhead ? Math.max(depth - DATA.radius, near) : near;
    const last = Math.max(isAhead ? depth + DATA.radius : camera.far, first * (1 + 1e-6));
    return {
        modelViewMatrix: columns(view),
        projectionMatrix: columns(projection),
        normalMatrix: new Float32Array([0, 1, 2].flatMap(column => rows.map(row => row[column]))),
        depthRange: [first, last],
    };
}
