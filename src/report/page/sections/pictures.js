// Pictures first: the viewer, and a grid of scenes by methods with errors in colour.

state.define('grid.views', false);

const THUMB_PX = 132;

addSection({
    id: 'pictures',
    isMain: true,
    title: 'Images',
    intro: 'Truth and method under one slider: drag it, or click the image and use the wheel to zoom, ' +
        'drag to move, B to blink.',
    isThere: view => view.run.rows.length > 0,
    uses: ['scene', 'view', 'left', 'right', 'rightRun', 'look'],
    draw: drawViewer,
});

// A section of its own, so that a choice in the viewer leaves the grid and its scroll position alone.
addSection({
    id: 'grid',
    isMain: true,
    title: 'Scenes by methods',
    intro: 'Every scene and method, errors in colour; a click on one opens it in the viewer above.',
    isThere: view => viewsWithImages(view).length > 0,
    uses: ['look', 'grid.views'],
    draw: drawGrid,
});

/// Scenes by methods, in the order of the run; thumbnails are drawn when they come into the window.
function drawGrid(root, view) {
    const views = viewsWithImages(view);
    const scenes = [...groupBy(views, line => line.scene).values()];
    const isAll = state.get('grid.views');
    const shown = isAll ? views : scenes.map(lines => lines[0]);
    const methods = [...view.ranked, ...view.contestants.filter(s => !view.isAffordable(s))];
    const box = element('div', {class: 'scroll grid-box', tabindex: '0', role: 'group', 'aria-label': 'Scenes by methods'});
    const watcher = watchSeen(box, 200, drawGridThumb);
    if (views.length > scenes.length) {
        root.append(element('div', {class: 'tools'},
            toggleButton('All views', isAll, on => state.set({'grid.views': on}))));
    }
    box.append(element('table', {class: 'data thumbs'},
        element('thead', {}, element('tr', {}, element('th', {class: 'text'}, 'scene'), element('th', {}, 'truth'),
            methods.map(s => element('th', {}, methodName(s.info), element('br'),
                element('small', {}, `${formatShare(s.value)}${s.ms ? ` · ${formatMs(s.ms)} ms` : ''}`))))),
        element('tbody', {}, shown.map(line => gridLine(view, line, methods, watcher, isAll)))));
    root.append(box);
}

function drawGridThumb(canvas) {
    return drawThumb(canvas, cachedView().run, ...canvas.dataset.what.split('\n'), THUMB_PX, state.get('look'));
}

function gridLine(view, line, methods, watcher, isViewNamed) {
    const best = d3.max(line.rows.filter(row => isScored(row) && view.isMethodShown(row.method) &&
        !view.run.methods.get(row.method).isBaseline), row => row.f_2px);
    const rowOf = new Map(line.rows.map(row => [row.method, row]));
    return element('tr', {},
        element('th', {scope: 'row', class: 'text'}, line.scene, isViewNamed ? element('small', {}, ` ${line.view}`) : null),
        gridCell(view, line, 'truth', element('span', {}, 'truth'), null, watcher),
        methods.map(({method}) => {
            const row = rowOf.get(method);
            if (!row) return element('td', {}, NOTHING);
            const caption = element(isScored(row) && row.f_2px === best ? 'b' : 'span', {},
                isScored(row) ? formatShare(row.f_2px) : 'failed');
            return gridCell(view, line, method, caption, row, watcher);
        }));
}

/// One image, or its caption alone where the run kept none; a click opens it in the viewer.
function gridCell(view, line, method, caption, row, watcher) {
    if (!viewImages.has(view.run, line.scene, line.view, method)) return element('td', {class: `thumb-cell${row && !isScored(row) ? ' unscored' : ''}`}, caption);
    const canvas = element('canvas', {class: 'thumb', 'data-what': [line.scene, line.view, method].join('\n'),
        style: `width:${THUMB_PX}px;height:${(THUMB_PX * 9) / 16}px`});
    watcher.observe(canvas);
    const button = element('button', {type: 'button', class: 'thumb-button', 'aria-label': `${method} on ${line.scene}: ${caption.textContent}`,
        onclick: () => openInViewer({scene: line.scene, view: line.view, ...(row ? {right: method} : {left: 'truth'})})}, canvas, caption);
    if (row) answerHover(button, [row], []);
    return element('td', {class: `thumb-cell${row && !isScored(row) ? ' unscored' : ''}`}, button);
}
