// Intervals and paired differences. Intervals are those of the run folder (summary.csv, differences.csv),
// over all its scenes: the program resamples, and the page does not. What filters leave has sums alone.

/// The interval of a method's measure; null where the run has none, or scenes are left out.
function rangeOf(run, {method}, measure, hasAllScenes) {
    const line = hasAllScenes && run.table('summary.csv').lines.find(one => one.method === method);
    const key = {f_2px: 'f', soft_f: 'soft'}[measure] || `recall_${measure}`;
    return line && isNumber(line[`${key}_lo`]) ? {low: line[`${key}_lo`], high: line[`${key}_hi`]} : null;
}

function viewKey(row) {
    return `${row.scene}\n${row.view}`;
}

/// By how much the measure of rows `a` exceeds that of rows `b`, over the views that both have, and on
/// how many scenes; null if they have none in common.
function pairedDifference(a, b, measure) {
    const [ofA, ofB] = [a, b].map(rows => new Set(rows.filter(isScored).map(viewKey)));
    const both = [a.filter(row => ofB.has(viewKey(row))), b.filter(row => ofA.has(viewKey(row)))].map(rows => rows.filter(isScored));
    const [first, second] = both.map(rows => pooled(rows, measure));
    if (first === null || second === null) return null;
    const [scenesA, scenesB] = both.map(rows => groupBy(rows, row => row.scene));
    const apart = [...scenesA].map(([name, rows]) => pooled(rows, measure) - pooled(scenesB.get(name), measure));
    return {
        value: first - second, scenes: apart.length, better: apart.filter(d => d > 0).length, worse: apart.filter(d => d < 0).length,
        range: null, rangeOfAll: null,
    };
}

/// The table of the differences of a measure, if the run has one.
function differencesTable(run, measure) {
    return run.table({f_2px: 'differences.csv', soft_f: 'soft_differences.csv'}[measure] ?? '');
}

/// Its differences, as a function of two names; null for two without a view in common.
function tabledDifferences(table) {
    const range = (low, high) => (low === null ? null : {low, high});
    const made = new Map(table.lines.map(line => [`${line.method}\n${line.other}`, {
        value: line.difference, scenes: line.scenes, better: line.better, worse: line.worse,
        range: range(line.lo, line.hi), rangeOfAll: range(line.lo_of_all, line.hi_of_all),
    }]));
    return (a, b) => made.get(`${a}\n${b}`) ?? null;
}

/// Whether one leads: chance in the choice of scenes, and of the pair where many were looked at, does
/// not explain the difference.
function isLead(difference) {
    const range = difference && (difference.rangeOfAll || difference.range);
    return Boolean(range && (range.low > 0 || range.high < 0));
}

/// Says why there are no intervals, where filters are why.
function noteSums(root, {hasAllScenes, measure}) {
    const words = !hasAllScenes ? 'Scenes are filtered: these are sums alone. Intervals are of all scenes.'
        : ['f_1px', 'precision', 'recall'].includes(measure) ? `Intervals are of F at 2 px, ${hasInk() ? 'of soft F, ' : ''}and of recall by class.` : '';
    if (words) root.append(element('p', {class: 'note sums'}, words));
}
