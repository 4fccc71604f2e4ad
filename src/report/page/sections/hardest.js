// The hardest views: for each method that was searched the five worst, and a line per scene.

const WORST_SHOWN = 5;
const WORST_CAUSES = 4;
const WORST_PX = 230;

addSection({
    id: 'hardest',
    isMain: true,
    title: 'Hardest views',
    intro: 'A search moved eye, target, field of view and, of animated scenes, the moment to where a method is worst. ' +
        'All other parts of this page are of the views that it kept: no mean over them says how good a method is.',
    isThere: view => view.run.has('hardest.csv'),
    uses: ['look', 'sort.hardest'],
    draw(root, view) {
        const lines = view.run.table('hardest.csv').lines;
        for (const [method, looks] of groupBy(lines, line => line.method)) {
            const worst = looks.filter(line => line.rank !== null).sort((a, b) => a.value - b.value).slice(0, WORST_SHOWN);
            root.append(element('h3', {}, `${method}${looks[0].against ? ` against ${looks[0].against}` : ''}`));
            if (!worst.length) root.append(element('p', {class: 'note'}, 'No view was a candidate.'));
            root.append(element('div', {class: 'worst-views'}, worst.map((look, i) => worstView(view, look, i + 1))));
        }
        root.append(imageLegend(state.get('look')));
        hardestTable(root, lines);
    },
});

/// F of a look, that of the other method there, and which F that is: soft F if that was searched.
const lookF = look => look.soft_f ?? look.f_2px;
const lookOtherF = look => look.soft_f_against ?? look.f_against;
const lookMeasure = look => (isNumber(look.soft_f) ? 'soft F' : 'F');

/// "surface8 falls to 0.312 on rocket": of the worst view of all.
function hardestWords(run) {
    const worst = d3.least(run.table('hardest.csv').lines.filter(line => line.rank !== null), line => line.value);
    if (!worst) return 'No view was a candidate';
    const other = worst.against ? `, where ${worst.against} has ${formatShare(lookOtherF(worst))}` : '';
    return `${worst.method} falls to ${lookMeasure(worst)} ${formatShare(lookF(worst))} on ${worst.shown_as}${other}`;
}

/// Where a look is, as commands take it.
function lookWords(look) {
    const point = name => ['x', 'y', 'z'].map(axis => look[`${name}_${axis}`]).join(',');
    const moment = look.time_s === null ? '' : ` --time ${look.time_s}`;
    return `--eye ${point('eye')} --target ${point('target')} --fov ${look.fov_deg}${moment}`;
}

/// The causes of most wrong pixels, and what a found line has too much or too little of.
function worstCauses(row) {
    const causes = CAUSES.map(({kind, name, rgb, text}) => ({rgb, text, px: row[`${kind}_${name}`] || 0}));
    const unmatched = ['duplicates', 'truth'].map(name => ({rgb: IGNORED_RGB, text: `unmatched ${name}`, px: row[`unmatched_${name}`] || 0}));
    return [...causes, ...unmatched].filter(one => one.px > 0).sort((a, b) => b.px - a.px).slice(0, WORST_CAUSES);
}

function worstView(view, look, place) {
    const row = view.run.rows.find(one => one.scene === look.shown_as && one.view === look.view && one.method === look.method);
    const canvas = element('canvas', {class: 'thumb'});
    const open = () => openInViewer({scene: look.shown_as, view: look.view, left: 'truth', right: look.method});
    drawThumb(canvas, view.run, look.shown_as, look.view, look.method, WORST_PX, state.get('look'));
    const other = isNumber(lookOtherF(look)) ? `, ${look.against} ${formatShare(lookOtherF(look))}` : '';
    return element('figure', {class: 'worst-view'},
        element('button', {type: 'button', class: 'thumb-button', 'aria-label': `Worst view ${place}: ${look.shown_as}`, onclick: open}, canvas),
        element('figcaption', {}, element('strong', {}, `${place}. ${look.shown_as}`), `: ${lookMeasure(look)} ${formatShare(lookF(look))}${other}, ${formatNumber(look.n_truth)} true px`,
            row && !isScored(row) ? element('p', {class: 'note'}, row.status) : null,
            row ? element('ul', {class: 'legend'}, worstCauses(row).map(({rgb, text, px}) => element('li', {},
                element('i', {style: `background:${rgbText(rgb)}`}), `${formatNumber(px)} px ${text}`))) : null,
            element('code', {}, lookWords(look).split(/ (?=--)/).flatMap(word => [element('span', {}, word), ' ']))));
}

/// Counts of several looks pooled; null for none with a score.
function pooledLooks(looks) {
    const total = name => d3.sum(looks, look => look[name]);
    const [matched, other] = [2 * total('ink_matched_px'), total('ink_surplus_px') + total('ink_missing_px')];
    if (matched + other > 0) return matched / (matched + 2 * total('ink_misplaced_px') + other);
    const all = total('n_pred') + total('n_truth');
    return all > 0 ? 2 * total('k_2px') / all : null;
}

function hardestTable(root, lines) {
    const found = [...groupBy(lines, line => `${line.scene}\n${line.method}`).values()].map(looks => {
        const usual = looks.filter(look => look.phase === 'usual');
        const searched = looks.filter(look => look.phase !== 'usual');
        const worst = searched.find(look => look.rank === 1) || null;
        return {scene: looks[0].scene, method: looks[0].method, usual: pooledLooks(usual), worst, f: worst && lookF(worst),
                against: worst && lookOtherF(worst), looked: searched.length, candidates: searched.filter(look => look.status === 'ok').length};
    });
    makeTable(root, {
        name: 'hardest', lines: found, order: 'f.up', caption: 'By scene and method',
        columns: [
            {key: 'scene', title: 'scene', isText: true, value: line => line.scene},
            {key: 'method', title: 'method', isText: true, value: line => line.method},
            shareColumn('usual', 'usual views', line => line.usual, {help: `${lookMeasure(lines[0])} over the scene’s own views, pooled`}),
            shareColumn('f', 'hardest view', line => line.f, {help: `${lookMeasure(lines[0])} on the worst view that was found`}),
            shareColumn('against', 'the other there', line => line.against),
            {key: 'truth', title: 'true px', value: line => line.worst && line.worst.n_truth, text: line => (line.worst ? formatNumber(line.worst.n_truth) : NOTHING)},
            {key: 'looked', title: 'views looked at', value: line => line.looked},
            {key: 'candidates', title: 'with a score', value: line => line.candidates},
        ].filter(column => column.key !== 'against' || found.some(line => isNumber(line.against))),
    });
}
