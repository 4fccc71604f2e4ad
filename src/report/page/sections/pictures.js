// Pictures first: the viewer, and a grid of scenes by methods with errors in colour.

state.define('grid.views', false);

const THUMB_PX = 132;

addSection({
    id: 'pictures',
    title: 'Images',
    intro: 'Truth and method under one slider: drag it, or click the image and use the wheel to zoom, ' +
        'drag to move, B to blink. Below, every scene and method; a click on one opens it here.',
    isThere: view => view.run.rows.length > 0,
    uses: ['scene', 'view', 'left', 'right', 'rightRun', 'look', 'grid.views'],
    draw(root, view) {
        const stage = element('div', {});
        const grid = element('div', {});
        root.append(stage, grid);
        drawViewer(stage, view);
        if (viewsWithImages(view).length) drawGrid(grid, view);
    },
});

/// Scenes by methods, the worst scene first; thumbnails are drawn when they come into the window.
function drawGrid(root, view) {
    const all = viewsWithImages(view);
    const seen = new Set();
    const isAll = state.get('grid.views');
    const shown = isAll ? all : all.filter(v => !seen.has(v.scene) && seen.add(v.scene));
    const methods = [...view.ranked, ...view.contestants.filter(s => !view.isAffordable(s))];
    const watcher = new IntersectionObserver(entries => {
        for (const entry of entries) {
            if (!entry.isIntersecting) continue;
            watcher.unobserve(entry.target);
            const [scene, viewName, method] = entry.target.dataset.what.split('\n');
            drawThumb(entry.target, view.run, scene, viewName, method, THUMB_PX, state.get('look'));
        }
    }, {rootMargin: '200px'});
    const cellOf = (line, method) => {
        const row = line.rows.find(r => r.method === method);
        if (method !== 'truth' && !row) return element('td', {}, NOTHING);
        const canvas = element('canvas', {class: 'thumb', 'data-what': [line.scene, line.view, method].join('\n'),
            style: `width:${THUMB_PX}px;height:${(THUMB_PX * 9) / 16}px`});
        const hasImage = viewImages.has(view.run, line.scene, line.view, method);
        if (hasImage) watcher.observe(canvas);
        const isBest = row && isScored(row) && d3.max(line.rows.filter(r => view.isMethodShown(r.method) && !view.run.methods.get(r.method).isBaseline && isScored(r)), r => r.f_2px) === row.f_2px;
        const cell = element('td', {class: 'thumb-cell'}, hasImage ? canvas : null,
            row ? element(isBest ? 'b' : 'span', {}, isScored(row) ? formatShare(row.f_2px) : 'failed') : element('span', {}, 'truth'));
        const open = () => state.set({scene: line.scene, view: line.view, ...(row ? {right: method} : {left: 'truth'})});
        if (hasImage) {
            const button = element('button', {type: 'button', class: 'thumb-button',
                'aria-label': `${method} on ${line.scene}`, onclick: () => {
                    open();
                    document.getElementById('pictures').scrollIntoView();
                }}, ...cell.childNodes);
            cell.replaceChildren(button);
            if (row) {
                button.addEventListener('pointerenter', event => {
                    if (event.pointerType !== 'touch' && !card.isPinned) showCard([row], [], event);
                });
                button.addEventListener('pointermove', event => { if (!card.isPinned && card.node) moveCard(event.clientX, event.clientY); });
                button.addEventListener('pointerleave', () => { if (!card.isPinned) hideCard(); });
            }
        }
        return cell;
    };
    const manyViews = all.length > distinct(all, v => v.scene).length;
    root.append(element('div', {class: 'tools'},
        element('h3', {}, 'Scenes by methods'),
        manyViews ? toggleButton('All views', isAll, on => state.set({'grid.views': on})) : null));
    root.append(element('div', {class: 'scroll grid-box', tabindex: '0', role: 'region', 'aria-label': 'Scenes by methods'},
        element('table', {class: 'data thumbs'},
            element('thead', {}, element('tr', {}, element('th', {class: 'text'}, 'scene'), element('th', {}, 'truth'),
                methods.map(s => element('th', {}, methodName(s.info), element('br'),
                    element('small', {}, `${formatShare(s.value)}${s.ms ? ` · ${formatMs(s.ms)} ms` : ''}`))))),
            element('tbody', {}, shown.map(line => element('tr', {},
                element('th', {scope: 'row', class: 'text'}, line.scene, isAll ? element('small', {}, ` ${line.view}`) : null),
                cellOf(line, 'truth'), methods.map(s => cellOf(line, s.method))))))));
}
