// Numbers of rows that are shown together. The definitions are those of summary.csv; a test holds
// the two against each other.

/// F of counts: 1 where nothing is drawn and nothing is there.
function fOf(k, predicted, truth) {
    return predicted + truth === 0 ? 1 : (2 * k) / (predicted + truth);
}

/// What the page can measure a method by. `counts` gives [numerator, denominator] of a row, or null
/// where the row has none; the measure over many rows is the ratio of the sums.
const MEASURES = {
    f_2px: {
        title: 'F at 2 px',
        error: 'Error, 1 − F at 2 px',
        counts: row => row.k_2px === null ? null : [2 * row.k_2px, row.n_pred + row.n_truth],
    },
    soft_f: {
        title: 'soft F',
        error: 'Error, 1 − soft F',
        counts: row => row.ink_matched_px === null ? null : [2 * row.ink_matched_px,
            2 * (row.ink_matched_px + row.ink_misplaced_px) + row.ink_surplus_px + row.ink_missing_px],
    },
    f_1px: {
        title: 'F at 1 px',
        error: 'Error, 1 − F at 1 px',
        counts: row => row.k_1px === null ? null : [2 * row.k_1px, row.n_pred_1px + row.n_truth],
    },
    precision: {
        title: 'Precision',
        error: 'Share of drawn pixels that are false',
        counts: row => row.k_2px === null ? null : [row.k_2px, row.n_pred],
    },
    recall: {
        title: 'Recall',
        error: 'Share of true pixels that are missed',
        counts: row => row.k_2px === null ? null : [row.k_2px, row.n_truth],
    },
};
for (const name of RECALL_GROUPS) {
    const [k, truth] = [`k_${name}`, `truth_px_${name}`];  // once: to make them for every row takes longer than the sum
    MEASURES[name] = {
        title: `Recall of ${groupTitle(name)} lines`,
        error: `Share of ${groupTitle(name)} lines that is missed`,
        counts: row => (row[k] === null || !row[truth] ? null : [row[k], row[truth]]),
    };
}

/// Whether a row counts: failed ones enter no number.
function isScored(row) {
    return row.status === 'ok' && row.k_2px !== null && row.k_2px !== undefined;
}

/// The sums of a measure over rows: [numerator, denominator].
function summed(rows, measure) {
    let over = 0;
    let under = 0;
    for (const row of rows) {
        if (!isScored(row)) continue;
        const counts = MEASURES[measure].counts(row);
        if (!counts) continue;
        over += counts[0];
        under += counts[1];
    }
    return [over, under];
}

/// Whether a measure is an F, which is 1 where nothing is drawn and nothing is there.
function isF(measure) {
    return measure.startsWith('f_');
}

/// A ratio of sums; null where the measure has nothing to say, and 1 for F of two empty images.
function ratio([over, under], measure, hasRows) {
    if (!hasRows) return null;
    if (under === 0) return isF(measure) ? 1 : null;
    return over / under;
}

/// The measure over all of `rows`, their counts pooled; null if none of them has any.
function pooled(rows, measure) {
    return ratio(summed(rows, measure), measure, rows.some(isScored));
}

function quantile(sorted, share) {
    if (sorted.length === 0) return null;
    const place = share * (sorted.length - 1);
    const low = Math.floor(place);
    const high = Math.min(low + 1, sorted.length - 1);
    return sorted[low] + (place - low) * (sorted[high] - sorted[low]);
}

function ascending(values) {
    return values.filter(value => value !== null && Number.isFinite(value)).sort((a, b) => a - b);
}

/// Points that no other beats in both x and y, by x; of equal points the first.
function paretoFront(points, x, y) {
    const sorted = points.filter(p => x(p) !== null && y(p) !== null)
                       .sort((a, b) => x(a) - x(b) || y(a) - y(b));
    const front = [];
    for (const point of sorted)
        if (front.length === 0 || y(point) < y(front[front.length - 1])) front.push(point);
    return front;
}

/// Median and quartiles over views of a frame's time in ms; null without times.
function timeOf(rows) {
    const times = ascending(rows.filter(isScored).map(
        row => row.draw_ns === null || row.draw_ns === undefined ? null : row.draw_ns * 1e-6));
    if (times.length === 0) return null;
    return {median: quantile(times, 0.5), low: quantile(times, 0.25), high: quantile(times, 0.75)};
}

/// What the rows of one method say together.
function summarise(method, rows, measure) {
    const scored = rows.filter(isScored);
    const ofSplit = split => pooled(scored.filter(row => row.split === split), measure);
    const macro = ascending([...groupBy(scored, row => row.scene).values()].map(
        ofScene => pooled(ofScene, measure)));
    const kinds = [...groupBy(scored.filter(row => row.scene_kind), row => row.scene_kind).values()].map(
        ofKind => pooled(ofKind, measure));
    const widths = ascending(scored.map(row => row.mean_width_px));
    const time = timeOf(scored);
    return {
        method: method.name,
        info: method,
        isBaseline: method.isBaseline,
        rows: scored,
        views: scored.length,
        scenes: new Set(scored.map(row => row.scene)).size,
        failed: rows.length - scored.length,
        value: pooled(scored, measure),
        train: ofSplit('train'),
        heldout: ofSplit('heldout'),
        real: ofSplit('real'),
        macro: macro.length ? d3.mean(macro) : null,
        kinds: kinds.length > 1 ? d3.mean(kinds) : null,
        f_2px: pooled(scored, 'f_2px'),
        f_1px: pooled(scored, 'f_1px'),
        precision: pooled(scored, 'precision'),
        recall: pooled(scored, 'recall'),
        classes: Object.fromEntries(RECALL_GROUPS.map(name => [name, pooled(scored, name)])),
        width_px: widths.length ? d3.mean(widths) : null,
        ms: time ? time.median : null,
        msRange: time && scored.length > 1 ? time : null,
        bytes: d3.max(scored, row => row.bytes_per_px) ?? null,
    };
}
