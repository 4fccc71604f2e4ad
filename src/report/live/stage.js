// The picture: two methods under one divider, or all of them side by side, and their labels over it.

/// The size that the page was made for.
const ASKED_SIZE = [DATA.views[0].width_px, DATA.views[0].height_px];

/// What the reader has chosen. `view` is the name of a view, '' once the camera was moved; `size` null is as
/// large as the picture stands on the screen.
const state = {
    left: 'chords', right: 'surface_lookup', layout: 'two', cut: 0.5, view: DATA.views[0].name,
    size: null, lineWidthPx: 1, colour: '#000000', hasClasses: false,
    hasFill: true, hasLines: true, hasExactLines: false, theme: 'auto', times: {}, card: null, isPlaying: false, time: null,
};
let camera = cameraOfView(DATA.views[0]);
let renderer = null;
let motion = null;

const canvas = element('canvas', {class: 'live', tabindex: 0, role: 'img',
    'aria-label': `${DATA.scene}, drawn: drag or arrow keys turn it, wheel or + and - zoom, Shift moves it`});
const divider = element('div', {class: 'divider', role: 'slider', tabindex: 0, 'aria-label': 'Divider',
    'aria-valuemin': 0, 'aria-valuemax': 100, 'aria-orientation': 'horizontal'});
const labels = element('div', {class: 'labels', 'aria-hidden': 'true'});
const exactLines = document.querySelector('svg.exact');
const frame = element('div', {class: 'live-frame'}, canvas, exactLines, labels, divider);

/// What the run says of a method here: {f, soft_f}, or {why} there is none.
function scoreOf(method) {
    return DATA.scores?.[state.view]?.[method] ?? {};
}

function scoreText(method) {
    const {f, soft_f: softF} = scoreOf(method);
    if (METHODS[method].isInk && softF !== undefined) return ` soft F ${softF.toFixed(3)}`;
    return f === undefined ? '' : ` F ${f.toFixed(3)}`;
}

/// "#rrggbb" as three numbers of 0..1.
function rgbOf(hex) {
    return [1, 3, 5].map(at => parseInt(hex.slice(at, at + 2), 16) / 255);
}

/// The size to draw in, px.
function drawnSize() {
    if (state.size) return state.size;
    const width = Math.max(64, Math.min(Math.round(frame.clientWidth * devicePixelRatio), renderer.mostPx));
    return [width, Math.max(1, Math.round(width * ASKED_SIZE[1] / ASKED_SIZE[0]))];
}

/// The parts of the picture, and of each what is seen of it, from the lower left corner; and the size of all.
function partsOfPicture() {
    const [width, height] = drawnSize();
    if (state.layout === 'two') {
        const part = {x: 0, y: 0, width, height};
        const cut = Math.round(state.cut * width);
        return {width, height, parts: [
            {method: state.left, part, seen: {...part, width: cut}},
            {method: state.right, part, seen: {...part, x: cut, width: width - cut}}]};
    }
    const across = innerWidth < 720 ? 2 : 4;
    const down = Math.ceil(METHOD_NAMES.length / across);
    const [w, h] = [Math.max(1, Math.floor(width / across)), Math.max(1, Math.floor(height / across))];
    const band = Math.round(26 * width / Math.max(1, frame.clientWidth)); // for a label over each
    return {width: w * across, height: (h + band) * down, parts: METHOD_NAMES.map((method, i) => {
        const part = {x: w * (i % across), y: (h + band) * (down - 1 - Math.floor(i / across)), width: w, height: h};
        return {method, part, seen: part, top: part.y + h + band};
    })};
}

function labelOf(method) {
    const ms = state.times[method];
    return element('span', {}, element('b', {}, method), scoreText(method), ms === undefined ? '' : ` ${digitsOf(ms)} ms`);
}

function placeLabels({width, height, parts}) {
    labels.replaceChildren(...parts.map(({method, part, top = height}, i) => {
        const label = labelOf(method);
        const isRight = state.layout === 'two' && i === 1;
        label.style[isRight ? 'right' : 'left'] = `${isRight ? 0 : 100 * part.x / width}%`;
        label.style.top = `${100 * (1 - top / height)}%`;
        return label;
    }));
    const why = parts.map(({method}) => scoreOf(method).why).find(reason => reason);
    document.getElementById('why').textContent = why ? `No F at this view. ${why[0].toUpperCase()}${why.slice(1)}.` : '';
    divider.hidden = state.layout !== 'two';
    divider.style.left = `${100 * state.cut}%`;
    divider.setAttribute('aria-valuenow', Math.round(100 * state.cut));
    divider.setAttribute('aria-valuetext', `${state.left} left of ${Math.round(100 * state.cut)} %, ${state.right} right of it`);
}

function colourOf(name) {
    return DATA.classes.find(each => each.name === name).over;
}

/// The view's exact lines by class, as paths; none once the camera or the model has moved.
function exactPaths() {
    const view = state.layout === 'two' && DATA.views.find(({name}) => name === state.view);
    return Object.entries(view?.lines ?? {});
}

/// Lays them over the picture: as high as it, in its middle.
function placeExactLines() {
    const paths = state.hasExactLines ? exactPaths() : [];
    exactLines.replaceChildren(...paths.map(([name, d]) => {
        const path = document.createElementNS(exactLines.namespaceURI, 'path');
        path.style.stroke = colourOf(name);
        path.setAttribute('d', d);
        return path;
    }));
    const names = state.hasClasses ? DATA.classes.map(({name}) => name) : paths.map(([name]) => name);
    document.getElementById('exact').replaceChildren(...names.length === 0 ? [] : [state.hasClasses ? 'Classes:' : 'Exact lines:',
        ...names.flatMap(name => [' ', element('span', {style: `--of-class: ${colourOf(name)}`}, name)])]);
    if (paths.length === 0) return;
    const {width_px: width, height_px: height} = DATA.views.find(({name}) => name === state.view);
    exactLines.setAttribute('viewBox', `0 0 ${width} ${height}`);
    exactLines.setAttribute('preserveAspectRatio', `xMidYMid ${canvas.width * height < width * canvas.height ? 'slice' : 'meet'}`);
}

let shownSize = '';

function drawPicture() {
    const picture = partsOfPicture();
    const {width, height, parts} = picture;
    const sizes = [width, height, parts[0].part.width].join();
    if (sizes !== shownSize) {
        renderer.forgetTargets();
        [canvas.width, canvas.height] = [width, height];
        frame.style.setProperty('--aspect', width / height);
        shownSize = sizes;
    }
    const colours = [state.colour, ...DATA.classes.map(({over}) => over)];
    const looks = {lineWidthPx: state.lineWidthPx, 'lineColors[0]': colours.flatMap(rgbOf), hasFill: Number(state.hasFill),
        hasLines: Number(state.hasLines)};
    const {width: w, height: h} = parts[0].part;
    renderer.clear();
    const fill = renderer.drawFill(camera, w, h);
    for (const {method, part, seen} of parts)
        if (seen.width > 0) {
            const lines = renderer.drawLines(method, camera, w, h, '', state.lineWidthPx, state.hasClasses);
            renderer.show(fill, lines, part, seen, METHODS[method].isInk ? {...looks, lineWidthPx: 1} : looks);
        }
    placeLabels(picture);
    placeExactLines();
}

/// Near and far of all cameras hold every pose from here on; scores and exact lines are of the model at rest.
function leaveRest() {
    Object.assign(DATA, {center: DATA.motion.center, radius: DATA.motion.radius, scores: null});
    for (const view of DATA.views) {
        const {near, far} = fitted(cameraOfView(view));
        Object.assign(view, {near, far, lines: {}});
    }
    camera = fitted(camera);
}

/// Shows the model as it is at a time, in seconds.
function poseAt(time) {
    if (state.time === null) leaveRest();
    state.time = time;
    motion.pose(renderer, time);
    moveCamera(camera);
}

function play(isPlaying) {
    choose({isPlaying});
    let before = null;
    const step = now => {
        if (!state.isPlaying) return;
        attempt(() => poseAt(state.time + (before === null ? 0 : now - before) / 1000));
        before = now;
        requestAnimationFrame(step);
    };
    if (isPlaying) requestAnimationFrame(step);
}

let isAsked = false;

/// Draws the picture in the browser's next frame, once however often it is asked for.
function redraw() {
    if (isAsked) return;
    isAsked = true;
    requestAnimationFrame(() => {
        isAsked = false;
        attempt(drawPicture);
    });
}

/// Calls it; what it throws is shown to the reader.
function attempt(call) {
    try {
        return call();
    } catch (error) {
        showTrouble(error.message);
        return null;
    }
}

function showTrouble(text) {
    const box = document.getElementById('trouble');
    box.textContent = text;
    box.hidden = !text;
}
