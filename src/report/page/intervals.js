// Intervals, by the same random numbers, in the same order of sums, as src/statistics has them: where
// the page shows what a table holds, both have the same digits. A test holds them against each other.

const RESAMPLES = 2000;
/// With fewer there is no interval.
const FEWEST_SCENES = 6;
/// Where scenes that all differ by the same would leave rounding for an error.
const NO_ERROR = 1e-12;
/// Of the measured error, the least that a drawing's counts for (statistics/simultaneous.h).
const LEAST_OWN = 0.25;
const LEAST_OF_ALL = 0.5;

/// How many of 100 intervals hold the truth (experiments/intervals.md).
function knownCoverage(scenes) {
    return scenes < 11 ? 80 : scenes < 26 ? 85 : 90;
}

/// Random numbers of 64 bits, those of std::mt19937_64.
function randomNumbers(seed) {
    const size = 312;
    const state = new BigUint64Array(size);
    state[0] = BigInt(seed);
    for (let i = 1; i < size; ++i)
        state[i] = 6364136223846793005n * (state[i - 1] ^ (state[i - 1] >> 62n)) + BigInt(i);
    let at = size;
    const twist = () => {
        for (let i = 0; i < size; ++i) {
            const both = (state[i] & 0xffffffff80000000n) | (state[(i + 1) % size] & 0x7fffffffn);
            state[i] = state[(i + 156) % size] ^ (both >> 1n) ^ (both & 1n ? 0xb5026f5aa96619e9n : 0n);
        }
        at = 0;
    };
    return () => {
        if (at === size) twist();
        let x = state[at++];
        x ^= (x >> 29n) & 0x5555555555555555n;
        x ^= (x << 17n) & 0x71d67fffeda60000n;
        x ^= (x << 37n) & 0xfff7eee000000000n;
        return x ^ (x >> 43n);
    };
}

/// How often each of `count` scenes is drawn, an array a drawing; made once for a seed.
const drawingsMade = new Map();
function drawingsOf(count, seed) {
    const key = `${count} ${seed}`;
    if (!drawingsMade.has(key)) {
        const random = randomNumbers(seed);
        const n = BigInt(count);
        drawingsMade.set(key, Array.from({length: RESAMPLES}, () => {
            const times = new Float64Array(count);
            for (let i = 0; i < count; ++i) times[Number(random() % n)] += 1;
            return times;
        }));
    }
    return drawingsMade.get(key);
}

/// Value and error of a difference of two sides to first order, where scene i counts `times[i]`, into
/// `out`. A side is {over, under}, a number a scene, and its value the ratio of the sums; without `b` it
/// is the value of `a` itself. This is where a page with many methods spends its time: no arrays here.
function estimate(a, b, times, out) {
    let overA = 0;
    let underA = 0;
    let overB = 0;
    let underB = 0;
    const n = times.length;
    for (let i = 0; i < n; ++i) {
        overA += times[i] * a.over[i];
        underA += times[i] * a.under[i];
        if (!b) continue;
        overB += times[i] * b.over[i];
        underB += times[i] * b.under[i];
    }
    const valueA = underA > 0 ? overA / underA : 1;
    const valueB = !b ? 0 : underB > 0 ? overB / underB : 1;
    const perA = underA > 0 ? 1 / underA : 0;
    const perB = underB > 0 ? 1 / underB : 0;
    let squares = 0;
    for (let i = 0; i < n; ++i) {
        const one = (a.over[i] - valueA * a.under[i]) * perA - (b ? (b.over[i] - valueB * b.under[i]) * perB : 0);
        squares += times[i] * one * one;
    }
    out.value = valueA - valueB;
    out.error = Math.sqrt(squares * n / (n - 1));
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

/// A pair as it was measured, and how many errors away each drawing has it; raises the largest
/// distance of each drawing.
function distancesOf(pair, drawings, largest) {
    const count = pair.at.length;
    const times = new Float64Array(count).fill(1);
    const drawn = {value: 0, error: 0};
    estimate(pair.a, pair.b, times, drawn);
    const {value, error} = drawn;
    if (!(error > NO_ERROR)) return {value, error, own: null};
    const own = new Float64Array(RESAMPLES);
    for (let d = 0; d < RESAMPLES; ++d) {
        for (let i = 0; i < count; ++i) times[i] = drawings[d][pair.at[i]];
        estimate(pair.a, pair.b, times, drawn);
        const away = drawn.value - value;
        own[d] = away / Math.max(drawn.error, LEAST_OWN * error);
        largest[d] = Math.max(largest[d], Math.abs(away) / Math.max(drawn.error, LEAST_OF_ALL * error));
    }
    return {value, error, own: own.sort()};
}

/// 95 % intervals of pairs {a, b, at}, where `at` says which of all scenes: each by itself, and such
/// as are to hold all together; null with fewer than six scenes. statistics/simultaneous.h says how.
function pairedIntervals(pairs, sceneCount, seed) {
    const none = {range: null, rangeOfAll: null};
    if (sceneCount < FEWEST_SCENES) return pairs.map(() => none);
    const drawings = drawingsOf(sceneCount, seed);
    const largest = new Float64Array(RESAMPLES);
    const isKnown = pair => pair.at.length >= FEWEST_SCENES;
    const distances = pairs.map(pair => (isKnown(pair) ? distancesOf(pair, drawings, largest) : null));
    const reach = quantile(largest.sort(), 0.95);
    return pairs.map((pair, p) => {
        if (!isKnown(pair)) return none;
        const {value, error, own} = distances[p];
        const around = (below, above) => ({
            low: Math.max(pair.b ? -1 : 0, value - below * error),
            high: Math.min(1, value + above * error),
        });
        const half = own ? students(reach, pair.at.length - 1) : 0;
        return {
            range: own ? around(quantile(own, 0.975), -quantile(own, 0.025)) : around(0, 0),
            rangeOfAll: around(half, half),
        };
    });
}

/// Sums of a measure by scene as a side.
function sideOf(sums) {
    return {over: Float64Array.from(sums, s => s[0]), under: Float64Array.from(sums, s => s[1])};
}

/// The 95 % interval of the pooled measure: scenes are drawn anew, each with all its views, for views
/// of one scene are hard or easy together.
function pooledInterval(rows, measure) {
    const sums = [...groupBy(rows.filter(isScored), row => row.scene).values()].map(
        ofScene => summed(ofScene, measure)).filter(sum => isF(measure) || sum[1] > 0);
    if (sums.length < FEWEST_SCENES) return null;
    const pair = {a: sideOf(sums), b: null, at: sums.map((_, i) => i)};
    return pairedIntervals([pair], sums.length, rows[0].seed)[0].range;
}

/// Rows `a` and `b` over the views that both have, summed by scene, scenes in alphabetical order;
/// null without such a view.
function pairUp(a, b, measure) {
    const keyOf = row => `${row.scene}\n${row.view}`;
    const ofB = new Map(b.filter(isScored).map(row => [keyOf(row), row]));
    const pairs = a.filter(row => isScored(row) && ofB.has(keyOf(row)));
    if (pairs.length === 0) return null;
    const sums = [...groupBy(pairs, row => row.scene)].sort(([s], [t]) => (s < t ? -1 : 1)).map(
        ([scene, rows]) => [scene, summed(rows, measure), summed(rows.map(row => ofB.get(keyOf(row))), measure)]);
    return {names: sums.map(s => s[0]), views: pairs.length, a: sideOf(sums.map(s => s[1])), b: sideOf(sums.map(s => s[2]))};
}

/// By how much a side of a pair exceeds the other, on how many scenes; without intervals.
function differenceOf({names, views, a, b}, measure) {
    const total = side => ratio([d3.sum(side.over), d3.sum(side.under)], measure, true);
    const own = (side, i) => ratio([side.over[i], side.under[i]], measure, true);
    const [ofA, ofB] = [total(a), total(b)];
    if (ofA === null || ofB === null) return null;
    return {
        value: ofA - ofB, views, scenes: names.length,
        better: names.filter((_, i) => own(a, i) > own(b, i)).length,
        worse: names.filter((_, i) => own(a, i) < own(b, i)).length,
    };
}

/// By how much the measure of rows `a` exceeds that of rows `b`, over the views that both have, with
/// its 95 % interval; null if they have none in common.
function pairedDifference(a, b, measure) {
    const pair = pairUp(a, b, measure);
    const difference = pair && differenceOf(pair, measure);
    if (!difference) return null;
    const [{range}] = pairedIntervals([{...pair, at: pair.names.map((_, i) => i)}], pair.names.length, a[0].seed);
    return {...difference, range};
}

/// The same of b less a.
function turnedRound(difference) {
    const opposite = range => range && {low: -range.high, high: -range.low};
    return {...difference, value: -difference.value, range: opposite(difference.range),
            rangeOfAll: opposite(difference.rangeOfAll), better: difference.worse, worse: difference.better};
}

/// The differences of all pairs of methods, as a function of two names; null for two without a view
/// in common. `summaries` are of methods with a value, the best first.
function allDifferences(summaries, measure) {
    const pairs = summaries.flatMap((a, i) => summaries.slice(i + 1).map(b => {
        const pair = pairUp(a.rows, b.rows, measure);
        const difference = pair && differenceOf(pair, measure);
        return difference && {...pair, key: `${a.method}\n${b.method}`, difference};
    })).filter(Boolean);
    const scenes = [...new Set(pairs.flatMap(pair => pair.names))].sort();
    const place = new Map(scenes.map((name, i) => [name, i]));
    const ranges = pairs.length ? pairedIntervals(
        pairs.map(pair => ({...pair, at: pair.names.map(name => place.get(name))})), scenes.length, summaries[0].rows[0].seed) : [];
    const made = new Map(pairs.map((pair, i) => [pair.key, {...pair.difference, ...ranges[i]}]));
    return (a, b) => {
        const turned = made.get(`${b}\n${a}`);
        return made.get(`${a}\n${b}`) ?? (turned ? turnedRound(turned) : null);
    };
}

/// The same from differences.csv, which is over all scenes and methods of the run.
function tabledDifferences(run) {
    const range = (low, high) => (low === null ? null : {low, high});
    const made = new Map(run.table('differences.csv').lines.map(line => [`${line.method}\n${line.other}`, {
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
