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

/// How many of 100 intervals hold the truth (experiments/notes/intervals.md).
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

/// What a drawing makes of a side, a number `over` and one `under` a scene: its value, the ratio of the
/// sums, and into `rest` what each scene adds to its error, to first order. Without a drawing all scenes
/// count once.
function weigh(side, drawing) {
    const {over, under, at, times, rest} = side;
    const count = over.length;
    let overAll = 0;
    let underAll = 0;
    for (let i = 0; i < count; ++i) {
        times[i] = drawing ? drawing[at[i]] : 1;
        overAll += times[i] * over[i];
        underAll += times[i] * under[i];
    }
    const value = underAll > 0 ? overAll / underAll : 1;
    const per = underAll > 0 ? 1 / underAll : 0;
    for (let i = 0; i < count; ++i) rest[i] = (over[i] - value * under[i]) * per;
    side.value = value;
}

/// The error of a difference of two weighed sides. This is where a page with many methods spends its time.
function errorOf({rest, times}, {rest: other}) {
    const n = rest.length;
    let squares = 0;
    for (let i = 0; i < n; ++i) {
        const one = rest[i] - other[i];
        squares += times[i] * one * one;
    }
    return Math.sqrt(squares * n / (n - 1));
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

/// Pairs {a, b} as they were measured, and how many errors away each drawing has them; `largest` are the
/// largest distances of each drawing. A side that stands in many pairs is weighed once a drawing.
function distancesOf(pairs, drawings) {
    const sides = [...new Set(pairs.flatMap(pair => [pair.a, pair.b]))].filter(side => side.over);
    for (const side of sides) weigh(side, null);
    const measured = pairs.map(({a, b}) => ({a, b, value: a.value - b.value, error: errorOf(a, b), own: null}));
    const moving = measured.filter(pair => pair.error > NO_ERROR);
    for (const pair of moving) pair.own = new Float64Array(RESAMPLES);
    const largest = new Float64Array(RESAMPLES);
    for (let d = 0; d < RESAMPLES; ++d) {
        for (const side of sides) weigh(side, drawings[d]);
        for (const {a, b, value, error, own} of moving) {
            const away = a.value - b.value - value;
            const drawn = errorOf(a, b);
            own[d] = away / Math.max(drawn, LEAST_OWN * error);
            largest[d] = Math.max(largest[d], Math.abs(away) / Math.max(drawn, LEAST_OF_ALL * error));
        }
    }
    return {measured, largest: largest.sort()};
}

/// 95 % intervals of pairs {a, b} of sides, as a function of a pair; where it has no `b` the interval is
/// that of `a` itself. Each has one by itself and one that is to hold together with all; null with fewer
/// than six scenes. statistics/simultaneous.h says how.
function pairedIntervals(pairs, sceneCount, seed) {
    const none = {range: null, rangeOfAll: null};
    const known = pairs.filter(pair => pair.a.over.length >= FEWEST_SCENES);
    if (sceneCount < FEWEST_SCENES || !known.length) return () => none;
    const {measured, largest} = distancesOf(known.map(({a, b}) => ({a, b: b || nothingBeside(a)})), drawingsOf(sceneCount, seed));
    const reach = quantile(largest, 0.95);
    const distances = new Map(known.map((pair, p) => [pair, measured[p]]));
    return pair => {
        if (!distances.has(pair)) return none;
        const {value, error, own} = distances.get(pair);
        const around = (below, above) => ({
            low: Math.max(pair.b ? -1 : 0, value - below * error),
            high: Math.min(1, value + above * error),
        });
        own?.sort();
        const half = own ? students(reach, pair.a.over.length - 1) : 0;
        return {
            range: own ? around(quantile(own, 0.975), -quantile(own, 0.025)) : around(0, 0),
            rangeOfAll: around(half, half),
        };
    };
}

/// A side whose value is 0 however scenes are drawn.
function nothingBeside(side) {
    return {value: 0, rest: new Float64Array(side.over.length)};
}

/// A side of so many scenes: `sumsOf` gives both sums of one, `at` says which of all scenes they are.
function sideOf(count, sumsOf, at) {
    const sums = Array.from({length: count}, (_, i) => sumsOf(i));
    return {over: Float64Array.from(sums, s => s[0]), under: Float64Array.from(sums, s => s[1]), at,
            value: 0, times: new Float64Array(count), rest: new Float64Array(count)};
}

/// The 95 % interval of the pooled measure: scenes are drawn anew, each with all its views, for views
/// of one scene are hard or easy together.
function pooledInterval(rows, measure) {
    const sums = [...groupBy(rows.filter(isScored), row => row.scene).values()].map(
        ofScene => summed(ofScene, measure)).filter(sum => isF(measure) || sum[1] > 0);
    if (sums.length < FEWEST_SCENES) return null;
    const a = sideOf(sums.length, i => sums[i], d3.range(sums.length));
    const pair = {a, b: null};
    return pairedIntervals([pair], sums.length, rows[0].seed)(pair).range;
}

/// Scored rows as a side over `scenes`, where they stand in alphabetical order; `key` says of which views.
function scenesOf(rows, measure, scenes) {
    const scored = rows.filter(isScored);
    const names = scenes.filter(name => scored.some(row => row.scene === name));
    const ofScene = groupBy(scored, row => row.scene);
    return {
        names, views: scored.length, key: scored.map(viewKey).sort().join(),
        side: sideOf(names.length, i => summed(ofScene.get(names[i]), measure), names.map(name => scenes.indexOf(name))),
    };
}

function viewKey(row) {
    return `${row.scene}\n${row.view}`;
}

/// The names of the scenes of rows, in alphabetical order.
function sceneNames(rows) {
    return distinct(rows.filter(isScored), row => row.scene).sort();
}

/// Rows `a` and `b` over the views that both have, as a pair of sides; null without such a view.
function pairUp(a, b, measure, scenes) {
    const [ofA, ofB] = [a, b].map(rows => new Set(rows.filter(isScored).map(viewKey)));
    const first = scenesOf(a.filter(row => ofB.has(viewKey(row))), measure, scenes);
    const second = scenesOf(b.filter(row => ofA.has(viewKey(row))), measure, scenes);
    return first.views ? {names: first.names, views: first.views, a: first.side, b: second.side} : null;
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
    const common = sceneNames(a).filter(name => sceneNames(b).includes(name));
    const pair = pairUp(a, b, measure, common);
    const difference = pair && differenceOf(pair, measure);
    if (!difference) return null;
    return {...difference, range: pairedIntervals([pair], pair.names.length, a[0].seed)(pair).range};
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
    const views = groupBy(summaries.flatMap(s => s.rows.filter(isScored)), viewKey);
    const scenes = sceneNames([...views.values()].filter(rows => rows.length > 1).map(([row]) => row));
    const own = new Map(summaries.map(s => [s, scenesOf(s.rows, measure, scenes)]));
    // Where methods have the same views, as most have, one side serves all pairs of a method.
    const both = (a, b) => (own.get(a).key === own.get(b).key
        ? {...own.get(a), a: own.get(a).side, b: own.get(b).side} : pairUp(a.rows, b.rows, measure, scenes));
    const pairs = new Map(summaries.flatMap((a, i) => summaries.slice(i + 1).map(b => [`${a.method}\n${b.method}`, both(a, b)]))
        .filter(([, pair]) => pair && differenceOf(pair, measure)));
    const intervals = pairedIntervals([...pairs.values()], scenes.length, summaries[0]?.rows[0].seed);
    const made = pair => {
        const difference = pair && differenceOf(pair, measure);
        return difference && {...difference, ...intervals(pair)};
    };
    return (a, b) => {
        const pair = pairs.get(`${a}\n${b}`);
        const turned = pair ? null : made(pairs.get(`${b}\n${a}`));
        return turned ? turnedRound(turned) : made(pair) ?? null;
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
