// What the reader chooses by: methods above the picture, the rest below it.

const SIZES = [[1280, 720], [1920, 1080], [2560, 1440], [3840, 2160]];

/// A choice was made: the controls show it, and the picture follows.
function choose(changes) {
    if ('left' in changes && changes.left === state.right) changes.right = state.left;
    if ('right' in changes && changes.right === state.left) changes.left = state.right;
    Object.assign(state, changes);
    if ('view' in changes && changes.view !== '')
        camera = cameraOfView(DATA.views.find(view => view.name === changes.view));
    if ('view' in changes || 'size' in changes) forgetTimes();
    showTrouble('');
    drawControls();
    redraw();
}

function chooseProjection(isParallel) {
    camera = projected(camera, isParallel);
    state.view = '';
    forgetTimes();
    drawControls();
    redraw();
}

function forgetTimes() {
    if (Object.keys(state.times).length === 0) return;
    state.times = {};
    state.card = null;
    document.getElementById('times').textContent = '';
}

/// Times what is shown, and says by which clock.
async function measure() {
    const said = document.getElementById('times');
    const methods = state.layout === 'two' ? [state.left, state.right] : METHOD_NAMES;
    const {width, height} = partsOfPicture().parts[0].part;
    const card = await measuredCard({methods, camera, view: state.view, width, height, say: method => {
        said.textContent = `Measuring ${method} …`;
    }});
    state.times = Object.fromEntries(card.methods.map(times => [times.method, millisecondsOf(times)]));
    state.card = card;
    const {frames, lines, coarse} = cardWords(card, methods);
    said.textContent = `${frames}: the mesh and the lines of one frame at ${width} × ${height}, ${new Clock(renderer).words}. ` +
        `The lines alone: ${lines}.${coarse} Drawn by ${renderer.name}.`;
    drawControls();
    redraw();
}

function copyButton(method) {
    return element('button', {type: 'button', title: 'The shader as text: GLSL ES 3.00, all its passes',
        onclick: event => copyText(SHADERS[method].text, `${method}.glsl`, event.currentTarget)}, `Copy ${method}.glsl`);
}

/// Of what was measured last.
function cardButtons() {
    const text = cardText(state.card);
    return [
        element('button', {type: 'button', title: 'GPU and times as JSON', onclick: event => copyText(text, 'card.json', event.currentTarget)}, 'Copy card'),
        element('button', {type: 'button', title: 'GPU and times as JSON', onclick: () => saveFile('card.json', 'application/json', text)}, 'Save card'),
    ];
}

function rangeField(label, value, least, most, onInput) {
    return element('label', {class: 'field'}, element('span', {}, label), element('input', {type: 'range', min: least,
        max: most, step: 1, value, 'aria-label': label, oninput: event => onInput(Number(event.target.value))}),
    element('b', {}, `${value} px`));
}

function methodControls() {
    const methods = METHOD_NAMES.map(name => [name, name]);
    const isTwo = state.layout === 'two';
    return [
        choiceButtons('Layout', [['two', 'Two methods'], ['all', 'All methods']], state.layout, layout => {
            state.times = {};
            choose({layout});
        }),
        ...isTwo ? [chooser('Left', methods, state.left, left => choose({left})),
            chooser('Right', methods, state.right, right => choose({right})),
            copyButton(state.left), copyButton(state.right)] : [],
        element('button', {type: 'button', class: 'main', onclick: () => measure()}, 'Measure'),
        ...state.card ? cardButtons() : [],
    ];
}

function pictureControls() {
    const sizes = [ASKED_SIZE, ...SIZES].filter((size, i, all) => all.findIndex(other => String(other) === String(size)) === i)
        .filter(size => Math.max(...size) <= renderer.mostPx);
    const views = [...DATA.views.map(({name}) => [name, name]), ...state.view === '' ? [['', 'as turned']] : []];
    return [
        chooser('View', views, state.view, view => choose({view})),
        choiceButtons('Projection', [[false, 'Perspective'], [true, 'Parallel']], camera.isParallel, chooseProjection),
        chooser('Size', [['', 'as shown'], ...sizes.map(size => [size.join('x'), size.join(' × ')])],
            state.size ? state.size.join('x') : '', size => choose({size: size ? size.split('x').map(Number) : null})),
        rangeField('Line width', state.lineWidthPx, 1, 4, lineWidthPx => choose({lineWidthPx})),
        element('label', {class: 'field'}, element('span', {}, 'Colour'), element('input', {type: 'color', value: state.colour,
            'aria-label': 'Colour', oninput: event => choose({colour: event.target.value})})),
        toggleButton('Classes', state.hasClasses, hasClasses => choose({hasClasses}), `Lines of ${METHOD_NAMES.filter(name =>
            METHODS[name].hasClasses).join(' and ')} in the colours of their classes`),
        ...motion ? [toggleButton('Play', state.isPlaying, play)] : [],
        toggleButton('Fill', state.hasFill, hasFill => choose({hasFill})),
        toggleButton('Lines', state.hasLines, hasLines => choose({hasLines})),
        ...exactPaths().length > 0 ? [toggleButton('Exact lines', state.hasExactLines, hasExactLines => choose({hasExactLines}),
            'What a ray tracer finds at this view')] : [],
        chooser('Theme', [['auto', 'as the system'], ['light', 'light'], ['dark', 'dark']], state.theme, theme => {
            choose({theme});
            applyTheme();
        }),
    ];
}

function drawControls() {
    for (const [id, controls] of [['methods', methodControls], ['controls', pictureControls]]) {
        const root = document.getElementById(id);
        redrawInPlace(root, () => root.replaceChildren(...controls()));
    }
}
