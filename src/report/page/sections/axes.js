// Curves over an axis: how the error of every method grows along each axis of a study, all axes beside
// each other and one axis large.

state.define('axes.axis', '');
state.define('axes.log', false);
state.define('axes.own', false);
state.define('axes.soft', false);

/// An error that moves by less than this along an axis counts as steady.
const AXIS_STEADY = 0.02;

/// What is drawn over an axis.
const AXIS_MEASURES = {
    error: {title: 'error 1 − F'},
    soft: {title: 'error 1 − soft F'},
};

addSection({
    id: 'axes',
    title: 'Curves over an axis',
    intro: 'One thing grows at a time, and everything else stays as it is. The error is 1 − F at 2 px: a point ' +
        'pools the counts of all scenes, which stay the same along an axis. ' +
        'Dashed lines: tuned settings, and the baselines “sampled” and “exact_corner”, one exact sample a pixel.',
    isThere: view => view.run.has('axis_summary.csv'),
    uses: ['axes.*', 'sort.axis*'],
    draw(root, view) {
        const axes = axesOf(view);
        axisFaults(root, view, axes);
        if (axes.length === 0) {
            root.append(element('p', {class: 'note'}, 'The filters leave no method that was measured here.'));
            return;
        }
        root.append(axisTools(hasSoftAxes(view)), methodLegend(root, [...new Set(axes.flatMap(axis => axis.curves.map(c => c.info)))]));
        const grid = chartGrid();
        root.append(grid);
        const shared = d3.max(axes, axis => axisMost(axis.curves));
        for (const axis of axes) axisChart(grid, axis, {height: 230, shared});
        root.append(element('h3', {}, 'Which methods lose most, and where'));
        axisLosses(root, axes);
        oneAxis(root, axes);
        root.append(element('p', {class: 'note'}, axisWords(view)));
    },
});

/// Whether grey lines were scored along the axes.
function hasSoftAxes(view) {
    return view.run.table('axis_summary.csv').lines.some(line => isNumber(line.soft_f));
}

/// The axes that have points: {name, measure, title, unit, isLog, sentence, names, lines, curves}, in the run's order.
/// A curve has points {value, y, low, high, line}.
function axesOf(view) {
    const known = new Map(view.run.table('axes.csv').lines.map(line => [line.axis, line]));
    const share = f => (isNumber(f) ? 1 - f : null);
    const isSoft = state.get('axes.soft') && hasSoftAxes(view);
    const pointOf = isSoft
        ? line => ({line, value: line.value, y: share(line.soft_f), low: share(line.soft_hi), high: share(line.soft_lo)})
        : line => ({line, value: line.value, y: share(line.f), low: share(line.f_hi), high: share(line.f_lo)});
    const shown = view.run.table('axis_summary.csv').lines.filter(line => view.isMethodShown(line.method));
    return [...groupBy(shown, line => line.axis)].map(([name, lines]) => {
        const about = known.get(name) || {};
        const curves = byMethod(view.run, lines).map(group => ({
            ...group, points: sortLines(group.lines.map(pointOf), {value: point => point.value}),
        })).filter(curve => curve.points.some(point => isNumber(point.y)) && !['none', 'oracle'].includes(curve.name));
        return {
            name, measure: isSoft ? AXIS_MEASURES.soft : AXIS_MEASURES.error, lines, curves,
            title: about.title || name, unit: about.unit || '',
            isLog: about.is_log ?? false, sentence: about.sentence || '',
            names: about.value_names ? about.value_names.split(';') : [],
        };
    }).filter(axis => axis.curves.length > 0);
}

/// A value of an axis as people read it: "20°", "1e-7", "zbuffer16".
function axisValue(axis, value) {
    if (axis.names.length) return axis.names[value - 1] || String(value);
    const size = Math.abs(value);
    const text = value === 0 || (size >= 1e-3 && size < 1e5) ? String(Number(value.toPrecision(4)))
        : value.toExponential(1).replace('.0e', 'e').replace('e+', 'e');
    if (axis.unit === '') return text;
    return axis.unit === 'deg' ? `${text}°` : `${text} ${axis.unit}`;
}

/// The point of least and that of greatest error along a curve, and by how much they differ.
function axisRange(curve) {
    const scored = curve.points.filter(point => isNumber(point.y));
    const best = scored.reduce((a, b) => (b.y < a.y ? b : a));
    const worst = scored.reduce((a, b) => (b.y > a.y ? b : a));
    return {curve, best, worst, loss: worst.y - best.y};
}

/// What the methods lose, the most first.
function axisRanges(axis) {
    return axis.curves.filter(curve => !curve.isBaseline).map(axisRange).sort((a, b) => b.loss - a.loss);
}

/// The largest error of the methods on an axis, intervals included.
function axisMost(curves) {
    return d3.max(curves.filter(curve => !curve.isBaseline).flatMap(curve => curve.points),
                  point => point.high ?? point.y) || 0.1;
}

// ---- What must not happen -----------------------------------------------------------------

const AXIS_FAULTS = [
    ['non_finite', 'numbers that are not finite',
        'vertices placed and projected, normals, full buffers in every depth encoding, the curves of the truth, ' +
        'or scores'],
    ['overflow', 'codes that overflow',
        'depths outside 0 to 1, or pixels at which a packed code made to fit its bits comes out otherwise when it ' +
        'may wrap'],
    ['lost_cells', 'lost cells', 'cells without a result'],
    ['differing', 'images that differ', 'on axes along which no image may change'],
];

function axisFaults(root, view, axes) {
    const lines = view.run.table('axis_summary.csv').lines;
    const items = AXIS_FAULTS.filter(([field]) => sumOf(lines, field) > 0).map(([field, words, meaning]) => {
        const where = distinct(lines.filter(line => line[field] > 0), line => `${line.axis} (${line.method})`);
        return `${words}, ${sumOf(lines, field)}: ${meaning}. Where: ${where.slice(0, 12).join(', ')}` +
            (where.length > 12 ? ` and ${where.length - 12} more` : '');
    });
    const failed = view.run.table('rows.csv').lines.filter(row => row.axis && row.status !== 'ok');
    items.push(...failed.map(row => `${row.method} on ${row.scene}, ${row.view}: ${row.status}`));
    if (items.length) {
        root.append(warningBox('Something went wrong that must not.', 'Faults, and cells without a result:', items));
    } else if (view.run.has('stress.csv')) {
        root.append(element('p', {},
            `No fault in ${count(view.run.table('stress.csv').lineCount, 'cell')} along ${axes.length} ` +
            `${axes.length === 1 ? 'axis' : 'axes'}: nothing crashed, no code overflowed, every number is finite, ` +
            'and images that must be the same are the same.'));
    }
}

// ---- Tables and sentences -----------------------------------------------------------------

function axisLosses(root, axes) {
    const lines = axes.map(axis => {
        const ranges = axisRanges(axis);
        const sampled = axis.curves.find(curve => curve.name === 'sampled');
        return {axis, first: ranges[0] || null, second: ranges[1] || null, methods: ranges.length,
                steady: ranges.filter(range => range.loss < AXIS_STEADY).length,
                oneSample: sampled ? axisRange(sampled).loss : null};
    });
    const isMoving = range => range && range.loss >= AXIS_STEADY;
    const end = (key, title, which) => [
        {key, title, value: line => line.first && line.first[which].y,
            text: line => formatShare(line.first && line.first[which].y)},
        {key: `${which}_at`, title: 'at', isText: true, value: line => line.first && line.first[which].value,
            text: line => (isMoving(line.first) ? axisValue(line.axis, line.first[which].value) : NOTHING)}];
    makeTable(root, {
        name: 'axis-losses', lines, order: 'loss.down',
        columns: [
            {key: 'axis', title: 'axis', isText: true, value: line => line.axis.name, node: line => element('button', {
                type: 'button', class: 'quiet', onclick: () => axisGoTo(line.axis.name)},
                    line.axis.name.replace(/_/g, ' '))},
            {key: 'method', title: 'loses most', isText: true, value: line => line.first && line.first.curve.name,
             node: line => (isMoving(line.first) ? methodName(line.first.curve.info) : 'none: all are steady')},
            {key: 'loss', title: 'error grows by', value: line => line.first && line.first.loss,
                text: line => formatShare(line.first && line.first.loss)},
            ...end('from', 'from', 'best'), ...end('to', 'to', 'worst'),
            {key: 'second', title: 'next', isText: true, value: line => line.second && line.second.curve.name,
             text: line => (isMoving(line.second)
                 ? `${line.second.curve.name}, by ${formatShare(line.second.loss)}` : NOTHING)},
            {key: 'steady', title: 'steady methods', value: line => line.steady,
                text: line => `${line.steady} of ${line.methods}`,
             help: `The error moves by less than ${AXIS_STEADY}`},
            {key: 'one_sample', title: 'sampled moves by', value: line => line.oneSample,
                text: line => formatShare(line.oneSample),
             help: 'One exact sample a pixel: where it moves, what falls between pixel centres moves it'},
        ],
    });
}

function axisGoTo(name) {
    state.set({'axes.axis': name});
    const place = document.getElementById('axes-one');
    if (place) place.scrollIntoView({behavior: 'smooth'});
}

function oneAxis(root, axes) {
    const axis = axes.find(a => a.name === state.get('axes.axis')) || axes[0];
    root.append(element('div', {class: 'tools', id: 'axes-one'},
        chooser('One axis large', axes.map(a => [a.name, a.name.replace(/_/g, ' ')]),
        axis.name, name => state.set({'axes.axis': name}))));
    if (axis.sentence) root.append(element('p', {class: 'soft'}, axis.sentence));
    root.append(element('p', {}, axisSentence(axis)));
    axisChart(root, axis, {height: 440, shared: null, intervals: true, labels: true});
    const values = distinct(axis.curves.flatMap(curve => curve.points), point => point.value).sort((a, b) => a - b);
    const pointAt = (curve, value) => curve.points.find(point => point.value === value) || {};
    makeTable(root, {
        name: `axis-${axis.name}`, lines: axis.curves, lineClass: baselineClass,
        caption: `Error 1 − ${axis.measure === AXIS_MEASURES.soft ? 'soft F' : 'F at 2 px'}, with its interval where several scenes were drawn.`,
        columns: [infoColumn(), ...values.map((value, i) => ({
            key: `at_${i}`, title: axisValue(axis, value), best: 'low',
            value: curve => pointAt(curve, value).y ?? null, text: curve => formatShare(pointAt(curve, value).y),
            css: curve => errorShade(pointAt(curve, value).y ?? null, 0.6),
            hint: curve => (isNumber(pointAt(curve, value).y) ? axisPointText(axis, curve,
                pointAt(curve, value)).join('\n') : ''),
        }))],
    });
}

function axisSentence(axis) {
    const ranges = axisRanges(axis);
    const moving = ranges.filter(range => range.loss >= AXIS_STEADY);
    const words = ({curve, best, worst}) =>
        `${curve.name}, from ${formatShare(best.y, 2)} (at ${axisValue(axis, best.value)}) to ` +
        `${formatShare(worst.y, 2)} (at ${axisValue(axis, worst.value)})`;
    if (moving.length === 0) return `Every method is steady: no error moves by ${AXIS_STEADY} or more.`;
    const steady = ranges.length - moving.length;
    return `${steady} of ${ranges.length} methods are steady (their error moves by less than ${AXIS_STEADY}). ` +
        `The error grows most for ${moving.slice(0, 3).map(words).join('; ')}.`;
}

function axisWords(view) {
    const row = view.run.table('rows.csv').lines.find(line => line.study === 'stress');
    const size = row ? `Images are ${row.width} × ${row.height} px. ` : '';
    return `${size}The truth is of the polyhedron as given. Intervals come from drawing the ` +
        'scenes of a point anew; with two to four scenes they are wide and rough.';
}
