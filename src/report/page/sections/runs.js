// Runs beside each other: what was asked differently, and what came out differently.

state.define('base', 0);
state.define('other', 1);

addSection({
    id: 'runs',
    isMain: true,
    title: 'Runs beside each other',
    intro: 'Differences are of the second run less the first, over the views that both have, with intervals (scenes drawn anew, both runs on the same ones).',
    isThere: () => runs.length > 1,
    uses: ['base', 'other', 'sort.runs', 'sort.run-scenes', 'sort.run-settings'],
    draw(root, view) {
        const [a, b] = [runs[state.get('base')] || runs[0], runs[state.get('other')] || runs[1]];
        const choices = runs.map((run, i) => [i, run.label]);
        root.append(element('div', {class: 'tools'},
            chooser('First', choices, a.index, i => state.set({base: Number(i)})),
            chooser('Second', choices, b.index, i => state.set({other: Number(i)}))));
        const [ofA, ofB] = [viewOf(a), viewOf(b)];
        const lines = runLines(ofA, ofB, view.measure);
        if (!lines.length) {
            root.append(element('p', {class: 'note'}, 'These runs have no method in common on the same views.'));
            drawAskedDifferences(root, a, b);
            return;
        }
        const changed = lines.filter(line => !line.isSame);
        root.append(element('p', {class: 'verdict-line'}, changed.length
            ? `Results changed for ${changed.map(line => line.method).join(', ')}; those of ${count(lines.length - changed.length, 'other method')} are the same, bit for bit.`
            : 'All results are the same, bit for bit: these runs differ in times alone.'));
        drawAskedDifferences(root, a, b);
        noteSums(root, ofA);
        const drawn = lines.filter(line => line.difference);
        makeChart(root, {
            id: 'runs', title: `${MEASURES[view.measure].title}: ${b.label} less ${a.label}`, height: 24 + 22 * drawn.length + 46,
            draw: chart => drawDifferences(chart, drawn, `difference in ${MEASURES[view.measure].title}`),
            csv: () => [['method', 'first', 'second', 'difference', 'low', 'high', 'first_ms', 'second_ms', 'same_images'],
                ...lines.map(l => [l.method, l.first, l.second, l.difference && l.difference.value, l.difference && l.difference.range && l.difference.range.low,
                                   l.difference && l.difference.range && l.difference.range.high, l.firstMs, l.secondMs, l.isSame])],
        });
        drawRunTable(root, lines, view);
        drawRunScenes(root, ofA, ofB, changed, view);
    },
});

/// The methods of both runs, those whose results differ first, the largest difference on top.
function runLines(ofA, ofB, measure) {
    const diffs = (ofA.hasAllScenes && PACKED.diffs[ofA.run.index]?.[ofB.run.index]) || {};
    const keyOf = row => `${row.scene}\n${row.view}`;
    return ofA.contestants.map(first => {
        const second = ofB.contestants.find(s => s.method === first.method);
        if (!second) return null;
        // The hash is of edge responses: a threshold alone changes the counts and not the hash.
        const resultOf = row => [row.image_hash, row.k_2px, row.n_pred, row.n_truth, row.false_positives].join();
        const results = new Map(first.rows.map(row => [keyOf(row), resultOf(row)]));
        const both = second.rows.filter(row => results.has(keyOf(row)));
        const differing = both.filter(row => results.get(keyOf(row)) !== resultOf(row));
        const tagged = (differing.length ? differing : both).map(row => Object.assign(Object.create(row), {run: ofB.run.index}));
        const diff = diffs[first.method];
        const difference = pairedDifference(second.rows, first.rows, measure);
        return {
            method: first.method, info: second.info, rows: tagged, isSame: differing.length === 0, differing: differing.length,
            first: first.value, second: second.value, firstMs: first.ms, secondMs: second.ms, timeRatio: diff?.time_ratio ?? null,
            difference: difference && {...difference, range: diff?.[measure] ?? null},
        };
    }).filter(Boolean).sort((a, b) => a.isSame - b.isSame ||
        Math.abs(b.difference ? b.difference.value : 0) - Math.abs(a.difference ? a.difference.value : 0));
}

function drawRunTable(root, lines, view) {
    const title = MEASURES[view.measure].title;
    makeTable(root, {
        name: 'runs', lines, order: '', lineClass: line => (line.isSame ? 'baseline' : 'changed'), columns: [
            methodColumn(line => line.info, {rows: line => line.rows}),
            {key: 'results', title: 'results', isText: true, value: line => line.differing,
             text: line => (line.isSame ? 'the same' : `${count(line.differing, 'view')} differ`)},
            {key: 'first', title: `${title}, first`, value: line => line.first, text: line => formatShare(line.first, 4)},
            {key: 'second', title: 'second', value: line => line.second, text: line => formatShare(line.second, 4)},
            {key: 'difference', title: 'difference', value: line => line.difference && line.difference.value,
             text: line => formatSigned(line.difference && line.difference.value, 4),
             css: line => (line.difference && isLead(line.difference) ? 'font-weight:700' : null)},
            {key: 'range', title: 'interval', value: line => line.difference && line.difference.range && line.difference.range.low,
             text: line => formatSignedRange(line.difference && line.difference.range, 4)},
            {key: 'firstMs', title: 'ms, first', value: line => line.firstMs, text: line => formatMs(line.firstMs)},
            {key: 'secondMs', title: 'second', value: line => line.secondMs, text: line => formatMs(line.secondMs)},
            {key: 'times', title: 'ratio', value: line => line.timeRatio, help: 'Second over first: geometric mean over views of the ratios of least times; none where machine or compiler differ',
             text: line => (line.timeRatio === null ? NOTHING : line.timeRatio.toFixed(2))},
        ],
    });
}

/// Per scene, for the methods whose results differ.
function drawRunScenes(root, ofA, ofB, changed, view) {
    if (!changed.length) return;
    const lines = ofA.scenes.filter(scene => ofB.scenes.includes(scene)).map(scene => ({scene}));
    const inScene = (shown, scene, method) => shown.rows.filter(row => row.scene === scene && row.method === method);
    const difference = (line, method) => {
        const [a, b] = [pooled(inScene(ofA, line.scene, method), view.measure), pooled(inScene(ofB, line.scene, method), view.measure)];
        return a === null || b === null ? null : b - a;
    };
    const values = lines.flatMap(line => changed.map(c => Math.abs(difference(line, c.method) ?? 0)));
    const most = Math.max(1e-4, d3.max(values) || 0);
    root.append(element('h3', {}, 'By scene, methods whose results differ'));
    makeTable(root, {
        name: 'run-scenes', lines, order: '', columns: [
            {key: 'scene', title: 'scene', isText: true, value: line => line.scene},
            ...changed.map(({method}) => ({
                key: method, title: method, value: line => difference(line, method),
                text: line => formatSigned(difference(line, method), 4),
                css: line => {
                    const value = difference(line, method);
                    if (!value) return null;
                    return `background: color-mix(in srgb, var(--${value < 0 ? 'bad' : 'good'}) ${(55 * Math.min(1, Math.abs(value) / most)).toFixed(0)}%, var(--paper))`;
                },
                rows: line => inScene(ofB, line.scene, method).map(row => Object.assign(Object.create(row), {run: ofB.run.index})),
            })),
        ],
    });
}

/// What was asked differently: parameters of methods first, for they change images; then the rest.
function drawAskedDifferences(root, a, b) {
    const lines = [];
    for (const [name, info] of a.methods) {
        const other = b.methods.get(name);
        if (!other) {
            lines.push({what: name, first: 'takes part', second: NOTHING});
            continue;
        }
        for (const key of new Set([...Object.keys(info.params), ...Object.keys(other.params)])) {
            if (info.params[key] !== other.params[key])
                lines.push({what: `${name}.${key}`, first: info.params[key] ?? NOTHING, second: other.params[key] ?? NOTHING});
        }
    }
    for (const name of b.methods.keys()) if (!a.methods.has(name)) lines.push({what: name, first: NOTHING, second: 'takes part'});
    for (const key of ['command', 'build', 'kind', 'state']) {
        if (a.record[key] !== b.record[key]) lines.push({what: key, first: a.record[key], second: b.record[key]});
    }
    const [rowA, rowB] = [a.table('rows.csv').lines[0] || {}, b.table('rows.csv').lines[0] || {}];
    for (const key of ['width', 'height', 'threads', 'cpu', 'simd', 'compiler', 'flags', 'embree', 'seed']) {
        if (rowA[key] !== rowB[key]) lines.push({what: key, first: String(rowA[key] ?? NOTHING), second: String(rowB[key] ?? NOTHING)});
    }
    root.append(element('h3', {}, 'What was asked differently'));
    if (!lines.length) {
        root.append(element('p', {class: 'note'}, 'Nothing: the same methods and settings, build and machine.'));
        return;
    }
    makeTable(root, {name: 'run-settings', lines, order: '', most: 12, columns: [
        {key: 'what', title: 'what', isText: true, value: line => line.what},
        {key: 'first', title: a.label, isText: true, value: line => line.first},
        {key: 'second', title: b.label, isText: true, value: line => line.second},
    ]});
}
