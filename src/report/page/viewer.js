// The viewer: two images of one view under one slider, with zoom that both share.

const viewer = {zoom: 1, x: 0, y: 0, cut: 0.5, place: ''};

state.define('scene', '');
state.define('view', '');
state.define('left', 'truth');
state.define('right', '');
state.define('rightRun', -1);
state.define('look', 'errors');

/// What stands in the viewer: the reader's choice where there are images of it, else the view that tells
/// the leaders apart and the best method.
function viewerChoice(shown) {
    const run = shown.run;
    const views = viewsWithImages(shown);
    if (views.length === 0) return null;
    const ofScene = views.filter(v => v.scene === state.get('scene'));
    const {scene, view} = ofScene.find(v => v.view === state.get('view')) || tellingView(ofScene.length ? ofScene : views, shown);
    const others = runs.filter(one => viewImages.entry(one, scene, view));
    const other = others.includes(runs[state.get('rightRun')]) ? runs[state.get('rightRun')] : run;
    const names = [...other.methods.keys()].filter(name => viewImages.has(other, scene, view, name));
    const best = shown.best && names.includes(shown.best.method) ? shown.best.method : names.find(n => !BASELINES.includes(n));
    const right = names.includes(state.get('right')) ? state.get('right') : best || 'truth';
    const left = viewImages.has(run, scene, view, state.get('left')) ? state.get('left') : 'truth';
    return {run, other, others, scene, view, left, right, views};
}

/// The answer's method, the most exact one, and the next.
const LEADERS = 4;

/// The view on which the leaders' F differ most; of equal ones that with most errors.
function tellingView(views, shown) {
    const leaders = distinct([shown.best, shown.answer.mostExact, ...shown.ranked].filter(Boolean), s => s.method).slice(0, LEADERS);
    const told = views.map(view => {
        const own = view.rows.filter(row => leaders.includes(row.method) && isScored(row)).map(row => row.f_2px);
        const [low, high] = own.length ? d3.extent(own) : [1, 1];
        return {view, apart: high - low, wrong: 1 - low};
    });
    return told.reduce((a, b) => (b.apart > a.apart || (b.apart === a.apart && b.wrong > a.wrong) ? b : a)).view;
}

/// Shows what the reader asks for elsewhere, and goes there.
function openInViewer(changes) {
    state.set(changes);
    const section = sections.find(s => s.id === 'pictures');
    if (section.isStale) drawSection(section);
    section.node.scrollIntoView();
    section.body.querySelector('.stage')?.focus({preventScroll: true});
}

function viewsWithImages(shown) {
    const views = [];
    for (const [key, rows] of groupBy(shown.allRows, row => `${row.scene}\n${row.view}`)) {
        const {scene, view} = rows[0];
        if (viewImages.entry(shown.run, scene, view)) views.push({key, scene, view, rows});
    }
    return views;
}

function drawViewer(root, shown) {
    const choice = viewerChoice(shown);
    if (viewImages.lostViews) root.append(element('p', {class: 'note'}, viewImages.missingWords()));
    if (!choice) {
        root.append(element('p', {class: 'note'},
            shown.run.rows.length ? 'The run folder holds no images of these views.' : 'This run has no images.'));
        return;
    }
    const canvas = element('canvas', {
        class: 'stage', tabindex: '0', role: 'img',
        'aria-label': `${choice.left} and ${choice.right} on ${choice.scene}; arrow keys move the divider, plus and minus zoom`,
    });
    const slider = element('input', {type: 'range', min: 0, max: 1000, value: viewer.cut * 1000,
                                     'aria-label': 'Divider between the two images', id: 'divider'});
    const side = element('div', {class: 'side'});
    root.append(viewerControls(choice, shown), element('div', {class: 'viewer'},
        element('div', {class: 'stage-box'}, canvas,
            element('div', {class: 'under-stage'},
                element('span', {}, choice.left), slider, element('span', {}, choice.right)),
            imageLegend(state.get('look')), truthLegend()),
        side));
    fillSide(side, choice, shown);
    bindStage(canvas, slider, choice);
}

function viewerControls(choice, shown) {
    const scenes = distinct(choice.views, view => view.scene);
    const ofScene = choice.views.filter(view => view.scene === choice.scene);
    const names = run => ['truth', ...[...run.methods.keys()].filter(
        name => name !== 'oracle' && viewImages.has(run, choice.scene, choice.view, name))];
    const blink = element('button', {type: 'button', class: 'toggle', id: 'blink', 'aria-pressed': 'false',
                                     title: 'Shows the two images in turns (key B)'}, 'Blink');
    return element('div', {class: 'tools'},
        chooser('Scene', scenes.map(s => [s, s]), choice.scene, scene => state.set({scene, view: ''})),
        ofScene.length > 1 ? chooser('View', ofScene.map(v => [v.view, v.view]), choice.view,
            view => state.set({scene: choice.scene, view})) : null,
        chooser('Left', names(choice.run).map(n => [n, n]), choice.left, left => state.set({left})),
        chooser('Right', names(choice.other).map(n => [n, n]), choice.right, right => state.set({right})),
        choice.others.length > 1 ? chooser('Right of run', choice.others.map(run => [run.index, run.label]), choice.other.index,
            index => state.set({rightRun: Number(index)})) : null,
        choiceButtons('Colours', [['errors', 'Errors'], ['causes', 'Causes'], ['drawn', 'Lines']],
            state.get('look'), look => state.set({look})),
        blink,
        element('button', {type: 'button', class: 'quiet', id: 'fit'}, 'Fit'),
        element('button', {type: 'button', class: 'quiet', id: 'nearer', 'aria-label': 'Zoom in'}, '+'),
        element('button', {type: 'button', class: 'quiet', id: 'farther', 'aria-label': 'Zoom out'}, '−'),
        choice.run.live.has(choice.scene)
            ? element('a', {href: choice.run.live.get(choice.scene), id: 'live'}, 'On your GPU') : null);
}

/// Every method's number on this view; a click shows it on the right.
function fillSide(side, choice, shown) {
    const here = choice.views.find(v => v.scene === choice.scene && v.view === choice.view);
    const rows = sortLines(here.rows.filter(row => shown.isMethodShown(row.method)),
                           {value: row => row.f_2px}, true);
    side.append(element('h3', {}, `${choice.scene}, ${choice.view}`));
    for (const row of rows) {
        if (!viewImages.has(shown.run, row.scene, row.view, row.method)) continue;
        const name = methodName(shown.run.methods.get(row.method));
        if (row.method === shown.best?.method) name.append(element('b', {}, 'answer'));
        side.append(element('button', {
            type: 'button', class: 'side-line', 'aria-pressed': row.method === choice.right ? 'true' : 'false',
            onclick: () => state.set({scene: choice.scene, view: choice.view, right: row.method}),
        }, name,
            element('span', {class: 'number'}, formatShare(row.f_2px)),
            element('span', {class: 'number soft'}, row.draw_ns ? `${formatMs(row.draw_ns * 1e-6)} ms` : '')));
    }
}

async function bindStage(canvas, slider, choice) {
    const look = state.get('look');
    const [left, right] = await Promise.all([
        viewImages.codes(choice.run, choice.scene, choice.view, choice.left),
        viewImages.codes(choice.other, choice.scene, choice.view, choice.right),
    ]);
    const size = left || right;
    // The reader may have chosen anew while the images were decoded: another stage stands here then.
    if (!size || !canvas.isConnected) return;
    const sharp = [left, right].map(image => image && paintCodes(image, look));
    const fat = [left, right].map(image => image && paintCodes(thickenCodes(image), look));
    const context = canvas.getContext('2d');
    const fit = () => Object.assign(viewer, {zoom: 1, x: 0, y: 0});
    // Methods are compared at one place; what was enlarged of one view says nothing about another.
    const place = `${choice.scene}\n${choice.view}`;
    if (viewer.place !== place) fit();
    viewer.place = place;
    let stopBlinking = null;
    let isRightShown = true;
    const draw = () => {
        const width = canvas.parentElement.clientWidth;
        if (width === 0) return; // hidden: there is no scale between the image and nothing
        const height = Math.min((width * size.height) / size.width, Math.max(260, innerHeight * 0.72));
        const dense = window.devicePixelRatio || 1;
        canvas.style.height = `${height}px`;
        canvas.width = Math.round(width * dense);
        canvas.height = Math.round(height * dense);
        const base = Math.min(canvas.width / size.width, canvas.height / size.height);
        const scale = base * viewer.zoom;
        viewer.scale = scale / dense;
        const clamp = (at, seen, all) => Math.max(0, Math.min(at, Math.max(0, all - seen)));
        viewer.x = clamp(viewer.x, canvas.width / scale, size.width);
        viewer.y = clamp(viewer.y, canvas.height / scale, size.height);
        const dx = Math.max(0, (canvas.width - size.width * scale) / 2) - viewer.x * scale;
        const dy = Math.max(0, (canvas.height - size.height * scale) / 2) - viewer.y * scale;
        context.fillStyle = '#fff';
        context.fillRect(0, 0, canvas.width, canvas.height);
        const images = scale / dense < 0.8 ? fat : sharp;
        context.imageSmoothingEnabled = scale < 1;
        const cut = stopBlinking ? (isRightShown ? 0 : 1) : viewer.cut;
        [[images[0], 0, cut], [images[1], cut, 1]].forEach(([image, from, to]) => {
            if (!image || from >= to) return;
            context.save();
            context.beginPath();
            context.rect(from * canvas.width, 0, (to - from) * canvas.width, canvas.height);
            context.clip();
            context.drawImage(image, dx, dy, size.width * scale, size.height * scale);
            context.restore();
        });
        if (!stopBlinking) {
            context.fillStyle = 'rgb(0, 114, 178)';
            context.fillRect(cut * canvas.width - dense, 0, 2 * dense, canvas.height);
        }
        canvas.dataset.drawn = `${choice.left}|${choice.right}|${choice.scene}|${choice.view}`;
        canvas.dataset.cut = cut.toFixed(3);
    };
    const zoomAt = (factor, px, py) => {
        const before = viewer.scale;
        const zoom = Math.max(1, Math.min(40, viewer.zoom * factor));
        const after = (before * zoom) / viewer.zoom;
        viewer.x += px / before - px / after;
        viewer.y += py / before - py / after;
        viewer.zoom = zoom;
        draw();
    };
    const setCut = cut => {
        if (stopBlinking) blink();
        viewer.cut = Math.max(0, Math.min(1, cut));
        slider.value = viewer.cut * 1000;
        draw();
    };
    slider.addEventListener('input', () => setCut(slider.value / 1000));
    canvas.addEventListener('wheel', event => {
        // The wheel belongs to the page until the image was clicked.
        if (document.activeElement !== canvas && !event.ctrlKey) return;
        event.preventDefault();
        const box = canvas.getBoundingClientRect();
        zoomAt(event.deltaY < 0 ? 1.25 : 0.8, event.clientX - box.left, event.clientY - box.top);
    }, {passive: false});
    let held = null;
    canvas.addEventListener('pointerdown', event => {
        const box = canvas.getBoundingClientRect();
        const isDivider = Math.abs(event.clientX - box.left - viewer.cut * box.width) < 14;
        held = {isDivider: isDivider || viewer.zoom === 1, x: event.clientX, y: event.clientY};
        canvas.setPointerCapture(event.pointerId);
        if (held.isDivider) setCut((event.clientX - box.left) / box.width);
    });
    canvas.addEventListener('pointermove', event => {
        if (!held) return;
        if (held.isDivider) {
            const box = canvas.getBoundingClientRect();
            setCut((event.clientX - box.left) / box.width);
            return;
        }
        viewer.x -= (event.clientX - held.x) / viewer.scale;
        viewer.y -= (event.clientY - held.y) / viewer.scale;
        Object.assign(held, {x: event.clientX, y: event.clientY});
        draw();
    });
    for (const name of ['pointerup', 'pointercancel']) canvas.addEventListener(name, () => { held = null; });
    const blinkButton = document.getElementById('blink');
    const blink = () => {
        if (stopBlinking) {
            stopBlinking();
            stopBlinking = null;
        } else {
            stopBlinking = tickWhileThere(canvas, 600, () => {
                isRightShown = !isRightShown;
                draw();
            });
        }
        blinkButton.setAttribute('aria-pressed', stopBlinking ? 'true' : 'false');
        draw();
    };
    blinkButton.addEventListener('click', blink);
    const middle = () => [canvas.clientWidth / 2, canvas.clientHeight / 2];
    document.getElementById('nearer').addEventListener('click', () => zoomAt(1.6, ...middle()));
    document.getElementById('farther').addEventListener('click', () => zoomAt(1 / 1.6, ...middle()));
    document.getElementById('fit').addEventListener('click', () => { fit(); draw(); });
    canvas.addEventListener('keydown', event => {
        const keys = {
            ArrowLeft: () => setCut(viewer.cut - 0.02), ArrowRight: () => setCut(viewer.cut + 0.02),
            '+': () => zoomAt(1.6, ...middle()), '-': () => zoomAt(1 / 1.6, ...middle()),
            0: () => { fit(); draw(); }, b: blink,
        };
        if (!keys[event.key]) return;
        event.preventDefault();
        keys[event.key]();
    });
    watchWidth(canvas.parentElement, draw);
}
