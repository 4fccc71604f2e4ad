// Recall by kind of place: how much is found of lines that are flat or sharp, near or far.

state.define('bins.attribute', '');

/// What the attributes of bins.csv are called, with their units and what the values mean.
const BIN_ATTRIBUTES = {
    dihedral_deg: {title: 'dihedral deviation', unit: '°', doc: 'How far the two faces at the line deviate from flat.'},
    relative_gap: {title: 'depth gap', unit: '',
        doc: 'Depth from the line to what lies behind it, over the line’s own depth; the sky apart.'},
    view_angle_deg: {title: 'view angle', unit: '°',
        doc: 'Between the line of sight and the normal of the visible face nearest to edge-on.'},
    relative_distance: {title: 'distance', unit: '',
        doc: 'From the view’s nearest visible line (0) to its farthest (1).'},
};

addSection({
    id: 'bins',
    title: 'Recall by kind of place',
    intro: 'Share of the true pixels found within 2 px. Each bin has a matching of its own. The redder, the more ' +
        'is missed.',
    isThere: view => view.rows.length > 0 && view.run.has('bins.csv'),
    uses: ['bins.*', 'sort.bins*'],
    draw(root, view) {
        const lines = view.lines('bins.csv').filter(line => isScored(line) && line.n_truth > 0);
        const attributes = distinct(lines, line => line.attribute);
        if (attributes.length === 0) {
            root.append(element('p', {class: 'note'}, 'The filters leave no view.'));
            return;
        }
        const chosen = attributes.includes(state.get('bins.attribute')) ? state.get('bins.attribute') : attributes[0];
        const about = BIN_ATTRIBUTES[chosen] || {title: chosen, unit: '', doc: ''};
        root.append(element('div', {class: 'tools'}, choiceButtons('Kind of place', attributes.map(
            name => [name, (BIN_ATTRIBUTES[name] || {title: name}).title]), chosen,
                name => state.set({'bins.attribute': name}))),
            element('p', {class: 'soft'}, about.doc));
        const methods = binMethods(view, lines.filter(line => line.attribute === chosen));
        binChart(root, chosen, about, methods);
        binTable(root, chosen, about, methods);
    },
});

/// An end of a bin; the last one may be infinity, which tables write as "inf".
function binEnd(value) {
    return value === 'inf' ? Infinity : value === null ? Infinity : Number(value);
}

function binName({low, high}, unit) {
    if (low === Infinity) return 'sky';
    return high === Infinity ? `from ${low}${unit}` : `${low}–${high}${unit}`;
}

/// Per method its bins in order: {low, high, k, truth, rows}, the same ones for all methods.
function binMethods(view, lines) {
    const keys = [...groupBy(lines, line => `${line.low} ${line.high}`)].map(([key, ofBin]) => (
        {key, low: binEnd(ofBin[0].low), high: binEnd(ofBin[0].high)})).sort((a, b) => a.low - b.low);
    return byMethod(view.run, lines).filter(method => !['none', 'oracle'].includes(method.name)).map(method => {
        const groups = groupBy(method.lines, line => `${line.low} ${line.high}`);
        return {...method, bins: keys.map(bin => {
            const ofBin = groups.get(bin.key) || [];
            return {...bin, k: sumOf(ofBin, 'k'), truth: sumOf(ofBin, 'n_truth'),
                rows: ofBin.map(line => view.run.cells.get(line.cell))};
        })};
    });
}

function binRecall(bin) {
    return shareOf(bin.k, bin.truth);
}

function binChart(root, attribute, about, methods) {
    if (methods.length === 0) return;
    const lines = methods.map(method => methodLine(method.info, method.bins.map((bin, i) => ({
        x: i, y: binRecall(bin), rows: bin.rows,
        text: [`${method.name}, ${about.title} ${binName(bin, about.unit)}`,
            `recall ${formatShare(binRecall(bin))}: ${bin.k} of ${bin.truth} px`],
    }))));
    makeChart(root, {
        id: `bins-${attribute}`, title: `Recall by ${about.title}`, height: linesHeight(340, lines),
        draw: chart => {
            const bins = methods[0].bins;
            plotLines(chart, {
                lines, x: range => d3.scaleLinear().domain([-0.3, bins.length - 0.7]).range(range),
                y: range => shareScale(lines.flatMap(line => line.points.map(p => p.y)), range),
                left: {title: 'recall'},
                bottom: {title: about.title, ticks: d3.range(bins.length), format: i => binName(bins[i], about.unit)},
            });
        },
        csv: () => [['attribute', 'method', 'low', 'high', 'k', 'n_truth', 'recall'],
            ...methods.flatMap(method => method.bins.map(
            bin => [attribute, method.name, bin.low, bin.high, bin.k, bin.truth, binRecall(bin)]))],
    });
}

function binTable(root, attribute, about, methods) {
    const bins = methods.length ? methods[0].bins : [];
    makeTable(root, {
        name: `bins-${attribute}`, lines: methods, lineClass: baselineClass,
        columns: [
            infoColumn(),
            ...bins.map((bin, i) => shareColumn(`bin_${i}`, binName(bin, about.unit), m => binRecall(m.bins[i]), {
                css: m => errorShade(binRecall(m.bins[i]) === null ? null : 1 - binRecall(m.bins[i]), 0.6),
                hint: m => `${m.bins[i].k} of ${m.bins[i].truth} px`,
                rows: m => m.bins[i].rows,
            })),
        ],
    });
}
