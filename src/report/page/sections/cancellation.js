// Cancellation: the misses that declared weights predict, beside those that were measured.

state.define('cancellation.method', '');

/// Kinds of lines with fewer true pixels are left out of the chart and of the sentence.
const CANCELLATION_FEW = 100;

/// Where prediction and measurement agree within two percentage points.
const CANCELLATION_BAND = [[0, 0], [0.02, 0], [1, 0.98], [1, 1], [0.98, 1], [0, 0.02]];

addSection({
    id: 'cancellation',
    title: 'Cancellation: predicted misses',
    intro: 'A sum is blind where its channels cancel: a crease whose change of normal is at right angles to the ' +
        'weights leaves no trace in the code. What a declared code must miss is predicted here from the geometry ' +
        'of the truth and the weights alone, never from the method’s image: the depth and normal at each pixel ' +
        'centre are summed, rounded and filtered where a stencil sees a true line, and the result is thinned and ' +
        'matched like an image. Where prediction and measurement agree, a miss comes from the code, not from the ' +
        'rasterizer, and only other weights, another threshold or a second sum can mend it. Each kind of line has ' +
        'a matching of its own.',
    isThere: view => view.run.has('cancellation.csv'),
    uses: ['cancellation.*', 'sort.cancellation'],
    draw(root, view) {
        const lines = view.lines('cancellation.csv');
        const methods = byMethod(view.run, lines);
        if (methods.length === 0) {
            root.append(element('p', {class: 'note'}, 'No method here declares a code.'));
            return;
        }
        const chosen = methods.find(method => method.name === state.get('cancellation.method')) || methods[0];
        root.append(element('p', {}, cancellationSentence(methods)));
        root.append(element('div', {class: 'tools'}, chooser('Method', methods.map(m => [m.name, m.name]), chosen.name,
            name => state.set({'cancellation.method': name}))), cancellationLegend());
        const kinds = cancellationKinds(chosen.lines).filter(kind => kind.truth >= CANCELLATION_FEW);
        const grid = chartGrid();
        root.append(grid);
        cancellationScatter(grid, chosen, kinds);
        cancellationCurves(grid, chosen, kinds);
        root.append(element('p', {class: 'note'},
            'Dotted: if creases lay in all directions alike, a sum with this threshold would have to miss ' +
            'sin(s/2) / sin(d/2) of those that deviate by d from flat, where s is the largest deviation that it ' +
            'keeps silent in every direction. Creases that are seen do not lie so: both their faces look at the ' +
            'eye, and solids stand upright. A code may do better or worse.'));
        cancellationTable(root, methods);
    },
});

function cancellationLegend() {
    return element('ul', {class: 'legend'}, [
        ...CLASSES.map(name => element('li', {}, element('i', {style: `background:${CLASS_COLOURS[name]}`}), name)),
        element('li', {}, 'wide line: measured'), element('li', {}, 'dashed: predicted'),
            element('li', {}, 'dotted: law of one linear sum')]);
}

/// Sums of the counts of lines: {truth, predicted, measured} and the rates.
function cancellationSums(lines) {
    const sum = field => sumOf(lines, field);
    const truth = sum('n_truth');
    const wrong = sum('predicted_false_negatives') + sum('measured_false_negatives') - 2 * sum('both_false_negatives');
    return {
        truth,
        predicted: truth ? sum('predicted_missed') / truth : 0,
        measured: truth ? sum('measured_missed') / truth : 0,
        agreement: truth ? 1 - wrong / truth : 1,
        rows: lines,
    };
}

/// Kinds of line of one method: a class and ten degrees of dihedral deviation.
function cancellationKinds(lines) {
    return [...groupBy(lines, line => `${line.class} ${line.dihedral_low_deg}`).values()].map(ofKind => ({
        lineClass: ofKind[0].class, low: ofKind[0].dihedral_low_deg, high: ofKind[0].dihedral_high_deg,
            ...cancellationSums(ofKind),
    })).sort((a, b) => CLASSES.indexOf(a.lineClass) - CLASSES.indexOf(b.lineClass) || (a.low ?? -1) - (b.low ?? -1));
}

function cancellationKindName(kind) {
    return isNumber(kind.low) ? `${kind.lineClass} of ${kind.low} to ${kind.high}°` : kind.lineClass;
}

/// How well the prediction holds over every kind that has enough pixels.
function cancellationSentence(methods) {
    const all = methods.flatMap(method => cancellationKinds(method.lines)
        .map(kind => ({...kind, method: method.name})));
    const kinds = all.filter(kind => kind.truth >= CANCELLATION_FEW);
    if (kinds.length === 0) return `No kind of line has ${CANCELLATION_FEW} true pixels here.`;
    const off = kind => Math.abs(kind.predicted - kind.measured);
    const worst = kinds.reduce((a, b) => (off(b) > off(a) ? b : a));
    const few = all.length - kinds.length;
    const leftOut = few === 0
        ? '' : ` Kinds of fewer than ${CANCELLATION_FEW} px (${few} of ${all.length} pairs) are ` +
        'left out of this sentence and of the charts, not of the table.';
    return `${kinds.filter(kind => off(kind) <= 0.02).length} of ${kinds.length} pairs of method and kind of line ` +
        '(class and ten degrees of dihedral deviation) agree within two percentage points. Farthest off: ' +
        `${worst.method}, ${cancellationKindName(worst)}, ${formatPercent(worst.predicted)} predicted, ` +
        `${formatPercent(worst.measured)} measured of ${worst.truth} px. Only what is drawn along true lines is ` +
        'predicted. What a code draws besides, between the facets of round things, may lie within reach of a missed ' +
        `line and be matched to it, or run together with a visible line and be thinned away with it.${leftOut}`;
}

/// An axis of shares in percent.
function percentAxis(title) {
    return {title, ticks: [0, 0.25, 0.5, 0.75, 1], format: share => `${Math.round(100 * share)} %`};
}

function cancellationText(method, kind) {
    return [`${method.name}, ${cancellationKindName(kind)}`,
        `${formatPercent(kind.predicted)} predicted, ${formatPercent(kind.measured)} measured`, `of ${kind.truth} px`];
}

function cancellationScatter(grid, method, kinds) {
    makeChart(grid, {
        id: `cancellation-${method.name}`, title: `${method.name}, measured and predicted`, height: 330,
            least: 300,
        note: 'One disc per kind of line; larger ones have more pixels. Grey band: agreement within two percentage ' +
            'points.',
        draw: chart => {
            const area = plotArea(chart, {top: 26, right: 24, bottom: 46, left: 50});
            const x = d3.scaleLinear().domain([0, 1]).range([0, area.width]);
            const y = d3.scaleLinear().domain([0, 1]).range([area.height, 0]);
            area.plot.append('path')
                .attr('d', `${pathThrough(CANCELLATION_BAND, p => x(p[0]), p => y(p[1]))}Z`)
                .style('fill', 'var(--line)').style('stroke', 'none');
            drawAxes(area, x, y, {bottom: percentAxis('missed, predicted'), left: percentAxis('missed, measured')});
            for (const kind of [...kinds].sort((a, b) => b.truth - a.truth)) {
                const disc = area.plot.append('circle').attr('cx', x(kind.predicted)).attr('cy', y(kind.measured))
                    .attr('r', 3 + 1.5 * Math.log10(kind.truth / CANCELLATION_FEW))
                        .style('fill', CLASS_COLOURS[kind.lineClass])
                    .style('fill-opacity', 0.75).style('stroke', 'var(--paper)');
                answerText(disc, cancellationText(method, kind));
            }
        },
        csv: () => cancellationCsv(method, kinds),
    });
}

function cancellationCsv(method, kinds) {
    return [['method', 'class', 'dihedral_low_deg', 'dihedral_high_deg', 'n_truth', 'missed_predicted',
        'missed_measured'], ...kinds.map(
        kind => [method.name, kind.lineClass, kind.low, kind.high, kind.truth, kind.predicted, kind.measured])];
}

function cancellationCurves(grid, method, kinds) {
    const silent = distinct(method.lines, line => line.silent_deg);
    makeChart(grid, {
        id: `cancellation-curves-${method.name}`, title: `${method.name}, by dihedral deviation`, height: 330,
            least: 300,
        note: silent.length === 1 && isNumber(silent[0])
            ? `Keeps deviations of up to ${silent[0].toFixed(1)}° silent in every direction.` : null,
        draw: chart => {
            const area = plotArea(chart, {top: 26, right: 24, bottom: 46, left: 50});
            const x = d3.scaleLinear().domain([0, 180]).range([0, area.width]);
            const y = d3.scaleLinear().domain([0, 1]).range([area.height, 0]);
            drawAxes(area, x, y, {left: percentAxis('missed'), bottom: {
                title: 'how far the two faces deviate from flat', ticks: d3.range(0, 181, 30),
                    format: deg => `${deg}°`}});
            if (silent.length === 1 && isNumber(silent[0])) cancellationLaw(area.plot, silent[0], x, y);
            for (const [lineClass, ofClass] of groupBy(kinds.filter(kind => isNumber(kind.low)),
                kind => kind.lineClass))
                cancellationClassCurve(area.plot, method, lineClass, ofClass, x, y);
        },
        csv: () => cancellationCsv(method, kinds),
    });
}

/// The share of creases in all directions that one linear sum must miss.
function cancellationLaw(plot, silentDeg, x, y) {
    const half = deg => Math.sin((deg * Math.PI) / 360);
    const points = d3.range(0, 181, 2).map(deg => [deg, deg === 0 ? 1 : Math.min(1, half(silentDeg) / half(deg))]);
    plot.append('path').attr('d', pathThrough(points, p => x(p[0]), p => y(p[1]))).style('fill', 'none')
        .style('stroke', 'var(--soft)')
        .style('stroke-width', 1.2).style('stroke-dasharray', '1.5 3');
}

/// Measured (wide) and predicted (dashed) misses of one class; bins without pixels interrupt both.
function cancellationClassCurve(plot, method, lineClass, kinds, x, y) {
    const colour = CLASS_COLOURS[lineClass];
    const placed = d3.range(0, 180, 10).map(low => kinds.find(kind => kind.low === low) || null);
    const path = (field, width, dash, opacity) => plot.append('path').attr('d',
        pathThrough(placed, (kind, i) => x(10 * i + 5), kind => y(kind[field])))
        .style('fill', 'none').style('stroke', colour).style('stroke-width', width).style('stroke-dasharray', dash)
            .style('opacity', opacity);
    path('measured', 4, null, 0.4);
    path('predicted', 1.6, '5 3', 1);
    for (const kind of kinds) {
        const at = x(kind.low + 5);
        plot.append('circle').attr('cx', at).attr('cy', y(kind.predicted)).attr('r', 3).style('fill', 'none')
            .style('stroke', colour);
        answerText(plot.append('circle').attr('cx', at).attr('cy', y(kind.measured)).attr('r', 4)
            .style('fill', colour).style('fill-opacity', 0.5),
                   cancellationText(method, kind));
    }
}

function cancellationTable(root, methods) {
    const lines = methods.flatMap(method => [...groupBy(method.lines, line => line.class)].map(([lineClass,
        ofClass]) => ({
        info: method.info, lineClass, ...cancellationSums(ofClass)})));
    makeTable(root, {
        name: 'cancellation', lines, most: 30,
        columns: [
            infoColumn(), {key: 'class', title: 'class', isText: true, value: line => line.lineClass},
            {key: 'truth', title: 'true px', value: line => line.truth},
            {key: 'predicted', title: 'missed, predicted', value: line => line.predicted,
                text: line => formatPercent(line.predicted, 2)},
            {key: 'measured', title: 'missed, measured', value: line => line.measured,
                text: line => formatPercent(line.measured, 2)},
            {key: 'difference', title: 'difference, points', value: line => line.predicted - line.measured,
                text: line => formatSigned(100 * (line.predicted - line.measured), 2)},
            {key: 'agreement', title: 'pixels predicted rightly', value: line => line.agreement,
                text: line => formatPercent(line.agreement, 2),
             help: 'Of single pixels: whether anything is drawn within 2 px'},
        ],
    });
}
