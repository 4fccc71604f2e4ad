// Cameras: those of the views, and how one turns, comes nearer and changes its projection.
// {eye, rows: right, up, back, isParallel, fov: rad, height: world units, near, far, pivot}

function cameraOfView(view) {
    return {
        eye: view.eye,
        rows: view.view_from_world,
        isParallel: view.height_world > 0,
        fov: view.fov_y_rad,
        height: view.height_world,
        near: view.near,
        far: view.far,
        pivot: DATA.center,
    };
}

/// A camera from the matrices of view.json, by rows. They are of the file's own coordinates.
function cameraOfMatrices(view, clip) {
    const rows = view.slice(0, 3).map(row => row.slice(0, 3));
    const moved = view.slice(0, 3).map(row => row[3]);
    const isParallel = clip[3][3] === 1;
    const [a, b] = clip[2].slice(2);
    return {
        rows,
        eye: [0, 1, 2].map(axis => -dot(rows.map(row => row[axis]), moved) - DATA.origin[axis]),
        isParallel,
        fov: isParallel ? 0 : 2 * Math.atan(1 / clip[1][1]),
        height: isParallel ? 2 / clip[1][1] : 0,
        near: isParallel ? (b + 1) / a : b / (a - 1),
        far: isParallel ? (b - 1) / a : b / (a + 1),
        pivot: DATA.center,
    };
}

/// Near and far as the program fits them to the scene (scene/camera.h).
function fitted(camera) {
    const depth = centreDepth(camera);
    const near = Math.max(depth - DATA.radius, 1e-4 * DATA.radius);
    return {...camera, near, far: Math.max(depth + DATA.radius, 2 * near)};
}

/// Turned about its pivot: by `yaw` about the world's vertical, by `pitch` about its own right.
function orbited(camera, yaw, pitch) {
    const right = camera.rows[0];
    const turn = v => turned(turned(v, right, pitch), [0, 1, 0], yaw);
    const away = turn(plus(camera.eye, camera.pivot, -1));
    return fitted({...camera, rows: camera.rows.map(turn), eye: plus(camera.pivot, away)});
}

/// Nearer to its pivot by a factor below 1, farther by one above.
function zoomed(camera, factor) {
    if (camera.isParallel) return {...camera, height: camera.height * factor};
    const away = plus(camera.eye, camera.pivot, -1);
    return fitted({...camera, eye: plus(camera.pivot, away.map(value => value * factor))});
}

/// Moved along its right and up by shares of the height that it sees at its pivot.
function moved(camera, right, up) {
    const depth = -dot(plus(camera.pivot, camera.eye, -1), camera.rows[2]);
    const height = camera.isParallel ? camera.height : 2 * Math.max(depth, camera.near) * Math.tan(camera.fov / 2);
    const way = plus(camera.rows[0].map(value => value * right * height), camera.rows[1], up * height);
    return fitted({...camera, eye: plus(camera.eye, way), pivot: plus(camera.pivot, way)});
}

/// The camera with that projection, from the same place, that sees as much at the scene's middle.
function projected(camera, isParallel) {
    if (camera.isParallel === isParallel) return camera;
    const depth = centreDepth(camera) > camera.near ? centreDepth(camera) : Math.max(camera.near, DATA.radius);
    if (isParallel) return {...camera, isParallel, height: 2 * depth * Math.tan(camera.fov / 2)};
    const fov = 2 * Math.atan(camera.height / 2 / depth);
    return {...camera, isParallel, height: 0, fov: Math.min(Math.max(fov, Math.PI / 180), 170 * Math.PI / 180)};
}
