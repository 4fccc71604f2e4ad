// Pointer, wheel, touch and keys: they turn, move and zoom the camera, and move the divider.

/// The camera as the reader moved it: no view of the program's any more.
function moveCamera(changed) {
    camera = changed;
    if (state.view !== '') {
        state.view = '';
        drawControls();
    }
    forgetTimes();
    redraw();
}

function followPointers() {
    const down = new Map();
    const middleOf = points => [0, 1].map(i => points.reduce((sum, p) => sum + p[i], 0) / points.length);
    const spread = points => Math.hypot(points[0][0] - points[1][0], points[0][1] - points[1][1]);
    canvas.addEventListener('pointerdown', event => {
        canvas.setPointerCapture(event.pointerId);
        down.set(event.pointerId, [event.clientX, event.clientY]);
    });
    canvas.addEventListener('pointermove', event => {
        if (!down.has(event.pointerId)) return;
        const before = [...down.values()];
        down.set(event.pointerId, [event.clientX, event.clientY]);
        const after = [...down.values()];
        const {width, height} = canvas.getBoundingClientRect();
        const [from, to] = [middleOf(before), middleOf(after)];
        const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
        if (before.length > 1) {
            const closer = zoomed(camera, spread(before) / Math.max(1, spread(after)));
            moveCamera(moved(closer, -dx / height, dy / height));
        } else if (event.shiftKey || event.buttons === 2) moveCamera(moved(camera, -dx / height, dy / height));
        else moveCamera(orbited(camera, -dx / width * 2 * Math.PI, -dy / height * Math.PI));
    });
    for (const name of ['pointerup', 'pointercancel'])
        canvas.addEventListener(name, event => down.delete(event.pointerId));
    canvas.addEventListener('contextmenu', event => event.preventDefault());
    frame.addEventListener('wheel', event => {
        event.preventDefault();
        moveCamera(zoomed(camera, Math.exp(Math.sign(event.deltaY) * 0.1)));
    }, {passive: false});
}

function followKeys() {
    const step = 5 * Math.PI / 180;
    const ways = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};
    canvas.addEventListener('keydown', event => {
        const way = ways[event.key];
        const factor = {'+': 0.9, '=': 0.9, '-': 1 / 0.9}[event.key];
        if (event.ctrlKey || event.altKey || event.metaKey || (!way && !factor)) return;
        event.preventDefault();
        if (factor) moveCamera(zoomed(camera, factor));
        else if (event.shiftKey) moveCamera(moved(camera, way[0] * 0.05, way[1] * 0.05));
        else moveCamera(orbited(camera, way[0] * step, -way[1] * step));
    });
}

function followDivider() {
    const cutAt = share => {
        state.cut = Math.min(1, Math.max(0, share));
        redraw();
    };
    divider.addEventListener('pointerdown', event => divider.setPointerCapture(event.pointerId));
    divider.addEventListener('pointermove', event => {
        if (!divider.hasPointerCapture(event.pointerId)) return;
        const {left, width} = canvas.getBoundingClientRect();
        cutAt((event.clientX - left) / width);
    });
    divider.addEventListener('keydown', event => {
        const step = {ArrowLeft: -0.02, ArrowRight: 0.02, PageDown: -0.1, PageUp: 0.1}[event.key];
        const end = {Home: 0, End: 1}[event.key];
        if (step === undefined && end === undefined) return;
        event.preventDefault();
        cutAt(end ?? state.cut + step);
    });
}
