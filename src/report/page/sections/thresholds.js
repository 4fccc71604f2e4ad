// Other thresholds and tolerances: what a method reaches away from the setting it is scored at.

state.define('thresholds.chart', 'precision');
state.define('tolerances.log', false);

addSection({
    id: 'thresholds',
    title: 'Thresholds and tolerances',
    intro: 'What a method could reach at another threshold, how near its lines lie to the true ones, and what a ' +
        'random image with as many drawn pixels scores. Counts of all views are pooled.',
    isThere: view => view.rows.length > 0 && (view.run.has('curves.csv') || view.run.has('tolerances.csv')),
    uses: ['thresholds.*', 'tolerances.*', 'sort.thresholds'],
    draw(root, view) {
        const methods = thresholdMethods(view);
        if (methods.some(method => method.curve)) thresholdChart(root, methods);
        if (methods.some(method => method.tolerances.size)) toleranceChart(root, methods);
        thresholdTable(root, methods);
        root.append(termList([
            ['random', 'F of a random image with as many drawn pixels'],
            ['threshold', 'the edge response, 1 to 255, from which a pixel counts as drawn when the method is scored'],
            ['best', 'the threshold with the highest F over these views'],
            ['ODS', 'optimal data-set scale: F at that threshold'],
            ['OIS', 'optimal image scale: F if every view had its own best threshold'],
            ['AP', 'average precision: the area under precision over recall, over all thresholds'],
            ['1 px to 4 px', 'F when matches may be at most so far apart'],
        ]));
    },
});

/// The counts of each method over the views that are left: {curve: {k, predicted, truth} per
/// threshold, ois, ods, ap, tolerances, random}.
function thresholdMethods(view) {
    const methods = byMethod(view.run, view.rows.filter(isScored));
    const cells = new Map();
    for (const method of methods) for (const row of method.lines) cells.set(row.cell, method);
    const curves = pooledCurves(view.run.table('curves.csv'), cells);
    const tolerances = pooledTolerances(view.run.table('tolerances.csv'), cells);
    return methods.map(method => ({
        ...method,
        curve: curves.get(method) || null,
        ...(curves.has(method) ? curveSummary(curves.get(method)) : {ods: null, ois: null, ap: null, best: null}),
        tolerances: tolerances.get(method) || new Map(),
        own: distinct(method.lines, row => row.threshold),
        at: {k: sumOf(method.lines, 'k_2px'), predicted: sumOf(method.lines, 'n_pred'), truth: sumOf(method.lines,
            'n_truth')},
        random: method.lines.some(row => isNumber(row.k_random_2px))
            ? fOf(sumOf(method.lines, 'k_random_2px'), sumOf(method.lines, 'n_pred_random'),
                sumOf(method.lines, 'n_truth')) : null,
    }));
}

const THRESHOLDS = 99;

/// Counts per threshold, and those of every cell at the threshold that is best for it alone (the
/// first of equals). The table has 99 lines a cell in a row; it may be long, so columns are read, not lines.
function pooledCurves(table, cells) {
    const pools = new Map();
    const [cell, threshold, k, predicted, truth] = ['cell', 'threshold', 'k', 'n_pred',
        'n_truth'].map(name => table.column(name));
    let best = null;
    const flush = () => {
        if (best) for (const part of ['k', 'predicted', 'truth']) best.pool.bestOfEach[part] += best[part];
        best = null;
    };
    for (let i = 0; i < table.lineCount; ++i) {
        if (i === 0 || cell[i] !== cell[i - 1]) flush();
        const method = cells.get(cell[i]);
        if (!method) continue;
        if (!pools.has(method)) pools.set(method, emptyCurve());
        const pool = pools.get(method);
        const at = threshold[i] - 1;
        pool.k[at] += k[i];
        pool.predicted[at] += predicted[i];
        pool.truth[at] += truth[i];
        const f = fOf(k[i], predicted[i], truth[i]);
        if (!best || f > best.f) best = {pool, f, k: k[i], predicted: predicted[i], truth: truth[i]};
    }
    flush();
    return pools;
}

function emptyCurve() {
    const zeros = () => new Float64Array(THRESHOLDS);
    return {k: zeros(), predicted: zeros(), truth: zeros(), bestOfEach: {k: 0, predicted: 0, truth: 0}};
}

function curveF(curve, at) {
    return fOf(curve.k[at], curve.predicted[at], curve.truth[at]);
}

/// ODS with its threshold (of neighbours with the highest F the middle one), OIS and AP.
function curveSummary(curve) {
    let first = 0;
    for (let at = 1; at < THRESHOLDS; ++at) if (curveF(curve, at) > curveF(curve, first)) first = at;
    let last = first;
    while (last + 1 < THRESHOLDS && curveF(curve, last + 1) === curveF(curve, first)) ++last;
    const middle = Math.floor((first + last) / 2);
    const each = curve.bestOfEach;
    return {ods: curveF(curve, first), best: responseAt(middle), bestAt: middle,
            ois: fOf(each.k, each.predicted, each.truth), ap: averagePrecision(curve)};
}

/// The edge response, 1 to 255, of a place on a curve.
function responseAt(at) {
    return Math.floor((255 * (at + 1) + 99) / 100);
}

/// The area under the envelope of precision over recall, from recall 0.
function averagePrecision(curve) {
    const truth = curve.truth[0];
    if (truth === 0) return curve.predicted.some(number => number > 0) ? 0 : 1;
    const points = curvePoints(curve).sort((a, b) => a.recall - b.recall || a.precision - b.precision);
    let area = 0;
    let precision = 0;
    for (let i = points.length - 1; i >= 0; --i) {
        precision = Math.max(precision, points[i].precision);
        area += (points[i].recall - (i > 0 ? points[i - 1].recall : 0)) * precision;
    }
    return area;
}

/// Recall and precision at the thresholds at which anything is drawn.
function curvePoints(curve) {
    const points = [];
    for (let at = 0; at < THRESHOLDS; ++at) {
        if (curve.predicted[at] === 0) continue;
        points.push({at, recall: curve.truth[at] ? curve.k[at] / curve.truth[at] : 0,
            precision: curve.k[at] / curve.predicted[at], f: curveF(curve, at)});
    }
    return points;
}

/// Per method, F by tolerance in px.
function pooledTolerances(table, cells) {
    const sums = new Map();
    for (const line of table.lines) {
        const method = cells.get(line.cell);
        if (!method) continue;
        if (!sums.has(method)) sums.set(method, new Map());
        const ofMethod = sums.get(method);
        if (!ofMethod.has(line.tolerance_px)) ofMethod.set(line.tolerance_px, [0, 0, 0]);
        [line.k, line.n_pred, line.n_truth].forEach((number, i) => { ofMethod.get(line.tolerance_px)[i] += number; });
    }
    return new Map([...sums].map(([method, ofMethod]) => [method,
        new Map([...ofMethod].sort((a, b) => a[0] - b[0]).map(([tolerance, counts]) => [tolerance, fOf(...counts)]))]));
}
