// Stress: how the error grows along each axis of difficulty, all axes beside each other and one
// axis large.

state.define('stress.axis', '');
state.define('stress.log', false);
state.define('stress.own', false);

/// An error that moves by less than this along an axis counts as steady.
const STRESS_STEADY = 0.02;

addSection({
    id: 'stress',
    title: 'Stress',
    intro: 'One difficulty at a time. Each point pools the counts of two to four scenes, which stay the same along ' +
        'an axis. The error is 1 − F at 2 px. Dashed lines: tuned settings, and the baselines “sampled” and ' +
        '“exact_corner”, one exact sample a pixel.',
    isThere: view => view.run.has('stress_summary.csv'),
    uses: ['stress.*', 'sort.stress*'],
    draw(root, view) {
        const axes = stressAxes(view);
        stressFaults(root, view, axes);
        if (axes.length === 0) {
            root.append(element('p', {class: 'note'}, 'The filters leave no method of this study.'));
            return;
        }
        root.append(stressTools(), methodLegend(root, stressMethods(axes)));
        const grid = chartGrid();
        root.append(grid);
        const shared = d3.max(axes, axis => stressMost(axis.curves));
        for (const axis of axes) stressChart(grid, axis, {height: 230, shared});
        root.append(element('h3', {}, 'Which methods lose most, and where'));
        stressLosses(root, axes);
        stressOneAxis(root, axes);
        root.append(element('p', {class: 'note'}, stressWords(view)));
    },
});

/// The axes that have points: {name, title, unit, isLog, sentence, names, curves}, in the run's order.
function stressAxes(view) {
    const shown = view.run.table('stress_summary.csv').lines.filter(line => view.isMethodShown(line.method));
    const known = new Map(view.run.table('stress_axes.csv').lines.map(line => [line.axis, line]));
    return [...groupBy(shown, line => line.axis)].map(([name, lines]) => {
        const about = known.get(name) || {};
        const curves = byMethod(view.run, lines).map(group => ({
            ...group, points: sortLines(group.lines, {value: line => line.value}),
        })).filter(curve => curve.points.some(point => isNumber(point.f)) && !['none', 'oracle'].includes(curve.name));
        return {
            name, curves, lines, title: about.title || name, unit: about.unit || lines[0].unit || '',
            isLog: about.is_log ?? isSpreadOverDecades(lines), sentence: about.sentence || '',
            names: about.value_names ? about.value_names.split(';') : [],
        };
    }).filter(axis => axis.curves.length > 0);
}

/// Whether values lie so far apart that only a logarithmic scale tells them apart.
function isSpreadOverDecades(lines) {
    const [low, high] = d3.extent(lines, line => line.value);
    return low > 0 && high / low >= 1000;
}

function stressMethods(axes) {
    return [...new Set(axes.flatMap(axis => axis.curves.map(curve => curve.info)))];
}

function stressError(point) {
    return isNumber(point.f) ? 1 - point.f : null;
}

/// A value of an axis as people read it: "20°", "1e-7", "zbuffer16".
function stressValue(axis, value) {
    if (axis.names.length) return axis.names[value - 1] || String(value);
    const size = Math.abs(value);
    const text = value === 0 || (size >= 1e-3 && size < 1e5) ? String(Number(value.toPrecision(4)))
        : value.toExponential(1).replace('.0e', 'e').replace('e+', 'e');
    if (axis.unit === '') return text;
    return axis.unit === 'deg' ? `${text}°` : `${text} ${axis.unit}`;
}

/// The least and the greatest error along a curve, and by how much they differ.
function stressRange(curve) {
    const scored = curve.points.filter(point => isNumber(point.f));
    const best = scored.reduce((a, b) => (b.f > a.f ? b : a));
    const worst = scored.reduce((a, b) => (b.f < a.f ? b : a));
    return {curve, best, worst, loss: best.f - worst.f};
}

/// The largest error of the methods on an axis, intervals included.
function stressMost(curves) {
    return d3.max(curves.filter(curve => !curve.isBaseline).flatMap(curve => curve.points),
                  point => (isNumber(point.f_lo) ? 1 - point.f_lo : stressError(point))) || 0.1;
}

// ---- What must not happen -----------------------------------------------------------------

const STRESS_FAULTS = [
    ['non_finite', 'numbers that are not finite',
        'vertices placed and projected, normals, full buffers in every depth encoding, the curves of the truth, ' +
        'or scores'],
    ['overflow', 'codes that overflow',
        'depths outside 0 to 1, or pixels at which a packed code made to fit its bits comes out otherwise when it ' +
        'may wrap'],
    ['lost_cells', 'lost cells', 'cells without a result'],
    ['differing', 'images that differ', 'on axes along which no image may change'],
];

function stressFaults(root, view, axes) {
    const lines = view.run.table('stress_summary.csv').lines;
    const items = STRESS_FAULTS.filter(([field]) => sumOf(lines, field) > 0).map(([field, words, meaning]) => {
        const where = distinct(lines.filter(line => line[field] > 0), line => `${line.axis} (${line.method})`);
        return `${words}, ${sumOf(lines, field)}: ${meaning}. Where: ${where.slice(0, 12).join(', ')}` +
            (where.length > 12 ? ` and ${where.length - 12} more` : '');
    });
    const failed = view.run.table('rows.csv').lines.filter(row => row.study === 'stress' && row.status !== 'ok');
    items.push(...failed.map(row => `${row.method} on ${row.scene}, ${row.view}: ${row.status}`));
    if (items.length) {
        root.append(warningBox('Something went wrong that must not.', 'This study counts faults:', items));
        return;
    }
    root.append(element('p', {},
        `No fault in ${count(view.run.table('stress.csv').lineCount, 'cell')} along ${axes.length} ` +
        `${axes.length === 1 ? 'axis' : 'axes'}: nothing crashed, no code overflowed, every number is finite, and ` +
        'images that must be the same are the same.'));
}

// ---- Tables and sentences -----------------------------------------------------------------

function stressLosses(root, axes) {
    const lines = axes.map(axis => {
        const ranges = axis.curves.filter(c => !c.isBaseline).map(stressRange).sort((a, b) => b.loss - a.loss);
        const sampled = axis.curves.find(curve => curve.name === 'sampled');
        return {axis, first: ranges[0] || null, second: ranges[1] || null, methods: ranges.length,
                steady: ranges.filter(range => range.loss < STRESS_STEADY).length,
                oneSample: sampled ? stressRange(sampled).loss : null};
    });
    const isMoving = line => line.first && line.first.loss >= STRESS_STEADY;
    const at = (line, end) => (isMoving(line) ? stressValue(line.axis, line.first[end].value) : NOTHING);
    makeTable(root, {
        name: 'stress-losses', lines, order: 'loss.down',
        columns: [
            {key: 'axis', title: 'axis', isText: true, value: line => line.axis.name, node: line => element('button', {
                type: 'button', class: 'quiet', onclick: () => stressGoTo(line.axis.name)},
                    line.axis.name.replace(/_/g, ' '))},
            {key: 'method', title: 'loses most', isText: true, value: line => line.first && line.first.curve.name,
             node: line => (isMoving(line) ? methodName(line.first.curve.info) : 'none: all are steady')},
            {key: 'loss', title: 'error grows by', value: line => line.first && line.first.loss,
                text: line => formatShare(line.first && line.first.loss)},
            {key: 'from', title: 'from', value: line => line.first && stressError(line.first.best),
                text: line => formatShare(line.first && stressError(line.first.best))},
            {key: 'best_at', title: 'at', isText: true, value: line => line.first && line.first.best.value,
                text: line => at(line, 'best')},
            {key: 'to', title: 'to', value: line => line.first && stressError(line.first.worst),
                text: line => formatShare(line.first && stressError(line.first.worst))},
            {key: 'worst_at', title: 'at', isText: true, value: line => line.first && line.first.worst.value,
                text: line => at(line, 'worst')},
            {key: 'second', title: 'next', isText: true, value: line => line.second && line.second.curve.name,
             text: line => (line.second && line.second.loss >= STRESS_STEADY
                 ? `${line.second.curve.name}, by ${formatShare(line.second.loss)}` : NOTHING)},
            {key: 'steady', title: 'steady methods', value: line => line.steady,
                text: line => `${line.steady} of ${line.methods}`,
             help: `The error moves by less than ${STRESS_STEADY}`},
            {key: 'one_sample', title: 'sampled moves by', value: line => line.oneSample,
                text: line => formatShare(line.oneSample),
             help: 'One exact sample a pixel: where it moves, what falls between pixel centres moves it'},
        ],
    });
}

function stressGoTo(name) {
    state.set({'stress.axis': name});
    const place = document.getElementById('stress-one');
    if (place) place.scrollIntoView({behavior: 'smooth'});
}

function stressOneAxis(root, axes) {
    const axis = axes.find(a => a.name === state.get('stress.axis')) || axes[0];
    root.append(element('div', {class: 'tools', id: 'stress-one'},
        chooser('One axis large', axes.map(a => [a.name, a.name.replace(/_/g, ' ')]),
        axis.name, name => state.set({'stress.axis': name}))));
    if (axis.sentence) root.append(element('p', {class: 'soft'}, axis.sentence));
    root.append(element('p', {}, stressSentence(axis)));
    stressChart(root, axis, {height: 440, shared: null, intervals: true, labels: true});
    const values = distinct(axis.lines, line => line.value).sort((a, b) => a - b);
    const pointAt = (curve, value) => curve.points.find(point => point.value === value) || {};
    makeTable(root, {
        name: `stress-${axis.name}`, lines: axis.curves, lineClass: baselineClass,
        caption: 'Error 1 − F at 2 px, with its 95 % interval where several scenes were drawn.',
        columns: [infoColumn(), ...values.map((value, i) => ({
            key: `at_${i}`, title: stressValue(axis, value), best: 'low',
            value: curve => stressError(pointAt(curve, value)),
                text: curve => formatShare(stressError(pointAt(curve, value))),
            css: curve => errorShade(stressError(pointAt(curve, value)), 0.6),
            hint: curve => (isNumber(pointAt(curve, value).f) ? stressPointText(axis, curve,
                pointAt(curve, value)).join('\n') : ''),
        }))],
    });
}

function stressSentence(axis) {
    const ranges = axis.curves.filter(c => !c.isBaseline).map(stressRange).sort((a, b) => b.loss - a.loss);
    const moving = ranges.filter(range => range.loss >= STRESS_STEADY);
    const words = ({curve, best, worst}) =>
        `${curve.name}, from ${formatShare(stressError(best), 2)} (at ${stressValue(axis, best.value)}) to ` +
        `${formatShare(stressError(worst), 2)} (at ${stressValue(axis, worst.value)})`;
    if (moving.length === 0) return `Every method is steady: no error moves by ${STRESS_STEADY} or more.`;
    const steady = ranges.length - moving.length;
    return `${steady} of ${ranges.length} methods are steady (their error moves by less than ${STRESS_STEADY}). ` +
        `The error grows most for ${moving.slice(0, 3).map(words).join('; ')}.`;
}

function stressWords(view) {
    const row = view.run.table('rows.csv').lines.find(line => line.study === 'stress');
    const size = row ? `Images are ${row.width} × ${row.height} px. ` : '';
    return `${size}Nothing here is timed. The truth is of the polyhedron as given. Intervals come from drawing the ` +
        'scenes of a point anew; with two to four scenes they are wide and rough.';
}
