// Numbers of rows that are shown together. The definitions are those of summary.csv; a test holds
// the two against each other.

const RESAMPLES = 1000;
/// With fewer the error of a difference is hardly known.
const FEWEST_SCENES = 6;

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
    MEASURES[name] = {
        title: `Recall of ${groupTitle(name)} lines`,
        error: `Share of ${groupTitle(name)} lines that is missed`,
        counts: row => row[`k_${name}`] === null || !row[`truth_px_${name}`]
            ? null : [row[`k_${name}`], row[`truth_px_${name}`]],
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

/// A ratio of sums; null where the measure has nothing to say, and 1 for F of two empty images.
function ratio([over, under], measure, hasRows) {
    if (!hasRows) return null;
    if (under === 0) return measure.startsWith('f_') ? 1 : null;
    return over / under;
}

/// The measure over all of `rows`, their counts pooled; null if none of them has any.
function pooled(rows, measure) {
    return ratio(summed(rows, measure), measure, rows.some(isScored));
}

/// Random numbers below 2^32, the same for the same seed (xorshift32).
function randomNumbers(seed) {
    let state = (seed * 2654435761 + 1) >>> 0 || 1;
    return () => {
        state ^= state << 13;
        state >>>= 0;
        state ^= state >>> 17;
        state ^= state << 5;
        state >>>= 0;
        return state;
    };
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

/// The 95 % interval of `statistic` over clusters drawn anew with replacement; null with fewer than
/// two clusters. `statistic` is given the indices that were drawn.
function bootstrap(clusterCount, statistic) {
    if (clusterCount < 2) return null;
    const random = randomNumbers(clusterCount);
    const values = [];
    const drawn = new Int32Array(clusterCount);
    for (let i = 0; i < RESAMPLES; ++i) {
        for (let j = 0; j < clusterCount; ++j) drawn[j] = random() % clusterCount;
        const value = statistic(drawn);
        if (value !== null) values.push(value);
    }
    if (values.length === 0) return null;
    const sorted = ascending(values);
    return {low: quantile(sorted, 0.025), high: quantile(sorted, 0.975)};
}

/// The 95 % interval of the pooled measure: scenes are drawn anew, each with all its views, for
/// views of one scene are hard or easy together.
function pooledInterval(rows, measure) {
    const sums = [...groupBy(rows.filter(isScored), row => row.scene).values()].map(
        ofScene => summed(ofScene, measure));
    return bootstrap(sums.length, drawn => {
        let over = 0;
        let under = 0;
        for (const scene of drawn) {
            over += sums[scene][0];
            under += sums[scene][1];
        }
        return ratio([over, under], measure, true);
    });
}

/// Rows `a` and `b` over the views that both have, summed by scene; `difference` is that of the
/// measure over the scenes it is given (names, any of them several times). Null without such a view.
function pairUp(a, b, measure) {
    const keyOf = row => `${row.scene}\n${row.view}`;
    const ofB = new Map(b.filter(isScored).map(row => [keyOf(row), row]));
    const pairs = a.filter(row => isScored(row) && ofB.has(keyOf(row)));
    if (pairs.length === 0) return null;
    const sums = new Map([...groupBy(pairs, row => row.scene)].map(([scene, rows]) => [scene, [
        ...summed(rows, measure),
        ...summed(rows.map(row => ofB.get(keyOf(row))), measure),
    ]]));
    const difference = drawn => {
        const total = [0, 0, 0, 0];
        for (const scene of drawn) {
            const sum = sums.get(scene);
            if (sum) for (let i = 0; i < 4; ++i) total[i] += sum[i];
        }
        const ofA = ratio(total.slice(0, 2), measure, true);
        const ofOther = ratio(total.slice(2), measure, true);
        return ofA === null || ofOther === null ? null : ofA - ofOther;
    };
    return {scenes: [...sums.keys()], views: pairs.length, difference};
}

function differenceOf(pair) {
    const value = pair && pair.difference(pair.scenes);
    if (value === null) return null;
    const range = bootstrap(pair.scenes.length, drawn => pair.difference(Array.from(drawn, i => pair.scenes[i])));
    return {value, range, views: pair.views, scenes: pair.scenes.length};
}

/// By how much the measure of rows `a` exceeds that of rows `b`, over the views that both have, with
/// its 95 % interval; null if they have none in common.
function pairedDifference(a, b, measure) {
    return differenceOf(pairUp(a, b, measure));
}

/// The quantile of Student's distribution at which the normal one has `z`: the expansion 26.7.5 of
/// Abramowitz and Stegun.
function students(z, freedom) {
    const z2 = z * z;
    const first = (z2 + 1) / 4;
    const second = ((5 * z2 + 16) * z2 + 3) / 96;
    const third = (((3 * z2 + 19) * z2 + 17) * z2 - 15) / 384;
    return z * (1 + (first + (second + third / freedom) / freedom) / freedom);
}

/// The same of each of several lists of rows over `b`. Each has `rangeOfAll` too: the intervals that
/// hold all together in 95 % of cases, found as statistics/simultaneous.h says.
function pairedDifferences(lists, b, measure) {
    const pairs = lists.map(a => pairUp(a, b, measure));
    const differences = pairs.map(differenceOf);
    const asked = differences.map((d, i) => ({d, pair: pairs[i]})).filter(({d}) => d && d.range);
    if (asked.length < 2) return differences;
    const scenes = [...new Set(asked.flatMap(({pair}) => pair.scenes))];
    const random = randomNumbers(scenes.length);
    for (const one of asked) one.values = [];
    for (let i = 0; i < RESAMPLES; ++i) {
        const drawn = scenes.map(() => scenes[random() % scenes.length]);
        for (const one of asked) one.values.push(one.pair.difference(drawn));
    }
    const largest = new Float64Array(RESAMPLES);
    for (const one of asked) {
        const known = one.values.filter(value => value !== null);
        const mean = known.reduce((sum, value) => sum + value, 0) / known.length;
        one.error = Math.sqrt(known.reduce((sum, value) => sum + (value - mean) ** 2, 0) / Math.max(1, known.length - 1));
        if (!(one.error > 0) || one.d.scenes < FEWEST_SCENES) continue;
        one.values.forEach((value, i) => {
            if (value !== null) largest[i] = Math.max(largest[i], Math.abs(value - one.d.value) / one.error);
        });
    }
    const reach = quantile(largest.sort(), 0.95);
    for (const {d, error} of asked) {
        const half = d.scenes < FEWEST_SCENES ? 1 : students(reach, d.scenes - 1) * error;
        d.rangeOfAll = {low: Math.max(-1, d.value - half), high: Math.min(1, d.value + half)};
    }
    return differences;
}

/// Whether chance in the choice of scenes, and of the pair where many were looked at, does not
/// explain a difference.
function isSignificant(difference) {
    const range = difference && (difference.rangeOfAll || difference.range);
    return Boolean(range && (range.low > 0 || range.high < 0));
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
        range: pooledInterval(scored, measure),
        train: ofSplit('train'),
        heldout: ofSplit('heldout'),
        real: ofSplit('real'),
        macro: macro.length ? d3.mean(macro) : null,
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
