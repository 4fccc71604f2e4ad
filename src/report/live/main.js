// Starts the page, and what programs call: window.inkbench.

function applyTheme() {
    const isDark = state.theme === 'dark' || (state.theme === 'auto' && matchMedia('(prefers-color-scheme: dark)').matches);
    document.documentElement.className = isDark ? 'dark-theme' : 'light-theme';
}

/// A camera as programs name it: a view's name, or {view_from_world, clip_from_view} by rows.
function cameraAsked(view) {
    if (typeof view !== 'string') return cameraOfMatrices(view.view_from_world, view.clip_from_view);
    const found = DATA.views.find(({name}) => name === view);
    if (!found) throw new Error(`no view is called ${view} (${DATA.views.map(({name}) => name).join(', ')})`);
    return cameraOfView(found);
}

function checkMethod(method) {
    if (!METHODS[method]) throw new Error(`no method is called ${method} (${METHOD_NAMES.join(', ')})`);
}

function checkSize({width, height}) {
    const isSize = side => Number.isInteger(side) && side >= 1 && side <= renderer.mostPx;
    if (!isSize(width) || !isSize(height)) throw new Error(`no size: ${width} x ${height} (1..${renderer.mostPx})`);
}

/// For programs: the lines of a method at one view as bytes by rows from the top, 255 in a line, of ink its share;
/// how long they take, in milliseconds, and by which clock.
const API = {
    methods: METHOD_NAMES,
    views: DATA.views.map(({name}) => name),
    draw({method, width, height, view, lineWidthPx = 1}) {
        checkMethod(method);
        checkSize({width, height});
        return renderer.bytesOf(renderer.drawLines(method, cameraAsked(view), width, height, 'asked', lineWidthPx), red => red);
    },
    /// The same of what the model covers.
    cover({width, height, view}) {
        checkSize({width, height});
        return renderer.bytesOf(renderer.drawFill(cameraAsked(view), width, height), red => (red < 255 ? 255 : 0));
    },
    /// Poses a model that moves, as it is after so many seconds.
    pose(time) {
        if (!motion) throw new Error('the model does not move');
        poseAt(time);
    },
    async time({method, width, height, view}) {
        checkMethod(method);
        checkSize({width, height});
        const clock = new Clock(renderer);
        const times = await clock.time(method, cameraAsked(view), width, height);
        return {ms: times && millisecondsOf(times), ...times, clock: clock.words, renderer: renderer.name};
    },
    /// All methods' times, as `Copy card` gives them.
    card({width, height, view}) {
        checkSize({width, height});
        return measuredCard({methods: METHOD_NAMES, camera: cameraAsked(view), view: typeof view === 'string' ? view : '', width, height});
    },
};

async function start() {
    applyTheme();
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', applyTheme);
    document.getElementById('title').textContent = DATA.scene;
    const count = (number, noun) => `${number.toLocaleString('en')} ${noun}`;
    document.getElementById('facts').textContent = `${count(DATA.triangle_count, 'triangles')}, ${count(DATA.vertex_count, 'vertices')}, ` +
        `${count(DATA.added_count, 'of them')} for the codes alone.${DATA.run ? ` F (2 px) is that of the program's methods in the run ${DATA.run}.` : ''}`;
    document.getElementById('foot').textContent = `Made by inkbench ${DATA.version}. This page needs no other file and no network.`;
    const size = [...document.scripts].reduce((sum, script) => sum + script.textContent.length, 0);
    document.getElementById('stage').append(frame);
    const mesh = await readMesh();
    renderer = attempt(() => new Renderer(canvas, mesh));
    if (!renderer) {
        frame.remove();
        return;
    }
    if (DATA.motion) motion = new Motion(mesh);
    canvas.addEventListener('webglcontextlost', () => showTrouble('The browser took the GPU away from this page. Load it again.'));
    window.inkbench = API;
    if (frame.clientWidth * devicePixelRatio > 0.75 * ASKED_SIZE[0]) state.size = ASKED_SIZE;
    followPointers();
    followKeys();
    followDivider();
    addEventListener('resize', redraw);
    drawControls();
    attempt(drawPicture);
    document.getElementById('foot').append(` It has ${(size / 1e6).toFixed(1)} MB and was ready after ${(performance.now() / 1000).toFixed(1)} s.`);
}

start().finally(() => {
    document.documentElement.dataset.ready = '1';
});
