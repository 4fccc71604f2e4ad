// In motion: what flickers, pops and flashes while the camera moves slowly.

/// False lines by how many frames they live: from `first` frames on, to the next class.
const MOTION_LIVES = [
    {first: 1, text: '1 frame', colour: 'var(--family-full)'},
    {first: 2, text: '2 or 3 frames', colour: 'var(--family-full)', isPale: true},
    {first: 4, text: '4 to 7 frames', colour: 'var(--family-packed)', isPale: true},
    {first: 8, text: '8 frames and more', colour: 'var(--family-packed)'},
];

addSection({
    id: 'motion',
    title: 'In motion',
    intro: 'What a slowly moving camera shows of each method. Flicker: drawn pixels that appear or disappear from ' +
        'one frame to the next with no drawn pixel within 2 px, unless a true line came or went there. Pop: a ' +
        'line of one mesh edge and class that is shown, dropped and shown again although it is visible ' +
        'throughout. False lines: drawn farther than 2 px from every true line; short-lived ones flash, ' +
        'long-lived ones stay.',
    isThere: view => view.run.has('motion.csv'),
    uses: ['sort.motion*'],
    draw(root, view) {
        const lines = view.lines('motion.csv');
        if (lines.length === 0) {
            root.append(element('p', {class: 'note'}, 'The filters leave no sequence.'));
            return;
        }
        const totals = motionTotals(view, lines);
        const first = lines[0];
        root.append(element('p', {class: 'note'},
            `Sequences of ${first.frames} frames at ${first.width} × ${first.height} px, ` +
            `${formatTick(first.frames_per_s)} a second. The image moves by at most ` +
            `${formatNumber(first.step_px)} px a frame.`));
        motionCharts(root, totals);
        motionTable(root, totals);
        root.append(element('h3', {}, 'Flicker by sequence'));
        motionSequences(root, view, lines);
    },
});

/// What each method did over all its sequences that did not fail.
function motionTotals(view, lines) {
    const lives = groupBy(view.lines('lives.csv'), line => line.method);
    const inks = groupBy(view.lines('ink_motion.csv'), line => line.method);
    return byMethod(view.run, lines).map(group => {
        const drawn = group.lines.filter(line => line.status === 'ok');
        const ofMethod = lives.get(group.name) || [];
        const steps = sumOf(drawn, 'feature_steps');
        const ink = inks.get(group.name) || [];
        return {
            ...group, drawn: drawn.length, failed: group.lines.length - drawn.length,
            frames: sumOf(drawn, 'frames'),
            appeared: sumOf(drawn, 'appeared_px'), disappeared: sumOf(drawn, 'disappeared_px'),
            excused: sumOf(drawn, 'excused_px'), counted: sumOf(drawn, 'counted_px'),
            pops: sumOf(drawn, 'pops'), features: sumOf(drawn, 'feature_runs'), steps,
            popsPerMinute: steps > 0 ? (60 * sumOf(drawn, 'pops') * drawn[0].frames_per_s) / steps : null,
            falseLines: sumOf(drawn, 'false_lines'), cut: sumOf(drawn, 'false_lines_cut'),
            inkBeyond: shareOf(sumOf(ink, 'ink_beyond_px'), sumOf(ink, 'ink_true_change_px')),
            lives: ofMethod, medianLife: motionMedianLife(ofMethod),
        };
    });
}

/// The median life of false lines, in frames; of an even number the mean of the middle two.
function motionMedianLife(lives) {
    const total = sumOf(lives, 'count');
    if (total === 0) return null;
    const sorted = [...groupBy(lives, line => line.frames)].map(([frames, group]) => [frames, sumOf(group, 'count')])
        .sort((a, b) => a[0] - b[0]);
    const lifeOf = below => {
        let seen = 0;
        for (const [frames, number] of sorted) {
            seen += number;
            if (seen > below) return frames;
        }
        return null;
    };
    return (lifeOf(Math.floor((total - 1) / 2)) + lifeOf(Math.floor(total / 2))) / 2;
}

/// Lines per class of life.
function motionLifeClasses(lives) {
    const counts = MOTION_LIVES.map(() => 0);
    for (const {frames, count: number} of lives)
        counts[MOTION_LIVES.filter(life => life.first <= frames).length - 1] += number;
    return counts;
}

function motionCharts(root, totals) {
    const grid = chartGrid();
    root.append(grid);
    const perMille = (number, total) => (total > 0 ? (1000 * number) / total : 0);
    motionBars(grid, 'motion-flicker', 'Flicker', '‰ of the drawn pixels of a frame', totals.map(total => ({
        info: total.info,
        pieces: total.counted > 0 ? [
            {value: perMille(total.appeared, total.counted), colour: 'var(--family-packed)',
                text: [total.name, `appeared: ${total.appeared} px`]},
            {value: perMille(total.disappeared, total.counted), colour: 'var(--family-packed)', isPale: true,
                text: [total.name, `disappeared: ${total.disappeared} px`]},
        ] : [],
    })), [['var(--family-packed)', 'appeared'], ['var(--family-packed)', 'disappeared', true]]);
    motionBars(grid, 'motion-pops', 'Pops', 'pops per feature and minute', totals.map(total => ({
        info: total.info,
        pieces: total.popsPerMinute === null ? [] : [{value: total.popsPerMinute, colour: 'var(--family-ids)',
            text: [total.name, `${count(total.pops, 'pop')} of ${count(total.features, 'feature')}`]}],
    })), [['var(--family-ids)', 'shown, dropped and shown again']]);
    motionBars(grid, 'motion-lives', 'False lines by length of life', 'false lines a frame', totals.map(total => ({
        info: total.info,
        pieces: total.frames === 0 ? [] : motionLifeClasses(total.lives).map((number, i) => ({
            value: number / total.frames, colour: MOTION_LIVES[i].colour, isPale: MOTION_LIVES[i].isPale,
            text: [total.name, `${count(number, 'false line')} of ${MOTION_LIVES[i].text}`]})),
    })), MOTION_LIVES.map(life => [life.colour, life.text, life.isPale]));
}

function motionBars(grid, id, title, unit, bars, legend) {
    const box = element('div', {});
    grid.append(box);
    makeChart(box, {
        id, title, height: barsHeight(bars), least: 300,
        draw: chart => drawStackedBars(chart, {bars, title: unit}),
        csv: () => [['method', unit], ...bars.map(bar => [bar.info.name, d3.sum(bar.pieces, piece => piece.value)])],
    });
    box.append(colourLegend(legend));
}

function motionTable(root, totals) {
    const number = (key, title, help, more = {}) => ({key, title, help, value: total => total[key],
        text: total => formatNumber(total[key]), ...more});
    makeTable(root, {
        name: 'motion', lines: totals, lineClass: baselineClass,
        columns: [
            infoColumn(),
            {key: 'drawn', title: 'sequences', value: total => total.drawn,
                text: total => (total.failed ? `${total.drawn} of ${total.drawn + total.failed}` : total.drawn)},
            {key: 'flicker', title: 'flicker ‰', best: 'low',
                value: total => shareOf(1000 * (total.appeared + total.disappeared), total.counted),
             text: total => formatNumber(shareOf(1000 * (total.appeared + total.disappeared), total.counted)),
             help: 'Pixels that appear or disappear, in thousandths of those drawn'},
            {key: 'flicker_px', title: 'flicker px', value: total => total.appeared + total.disappeared,
                text: total => String(total.appeared + total.disappeared)},
            number('excused', 'excused px', 'Pixels like those where a true line came or went',
                {text: total => String(total.excused)}),
            ...(totals.some(total => isNumber(total.inkBeyond)) ? [number('inkBeyond', 'ink beyond',
                'Change of grey pixels beyond that of the true lines, as a share of it', {best: 'low'})] : []),
            number('popsPerMinute', 'pops a minute', 'Per feature that is visible throughout', {best: 'low'}),
            number('pops', 'pops', null, {text: total => String(total.pops)}),
            number('features', 'features', 'Lines of one edge and class, each run of frames in which it is visible',
                {text: total => String(total.features)}),
            number('falseLines', 'false lines', 'Each followed through its frames',
                {text: total => String(total.falseLines), best: 'low'}),
            number('cut', 'of them cut', 'There in the first or last frame: they may live longer',
                {text: total => String(total.cut)}),
            number('medianLife', 'median life, frames', null,
                {text: total => (total.medianLife === null ? NOTHING : String(total.medianLife))}),
        ],
    });
}

function motionSequences(root, view, lines) {
    const sequences = [...groupBy(lines, line => `${line.scene}\n${line.view}`).keys()];
    const find = (group, key) => group.lines.find(line => `${line.scene}\n${line.view}` === key);
    const worst = d3.max(lines.filter(line => !view.run.methods.get(line.method).isBaseline),
        line => line.flicker) || 1;
    makeTable(root, {
        name: 'motion-sequences', lines: byMethod(view.run, lines), lineClass: baselineClass,
        caption: 'Flicker in thousandths of the drawn pixels; the redder, the more.',
        columns: [infoColumn(), ...sequences.map((key, i) => {
            const flicker = group => (find(group, key) || {}).flicker ?? null;
            return {
                key: `sequence_${i}`, title: key.replace('\n', ', '), best: 'low',
                    value: group => (isNumber(flicker(group)) ? 1000 * flicker(group) : null),
                text: group => {
                    const line = find(group, key);
                    return line && line.status !== 'ok' ? 'failed' : formatNumber(isNumber(flicker(group))
                        ? 1000 * flicker(group) : null);
                },
                css: group => errorShade(flicker(group), worst),
                hint: group => {
                    const line = find(group, key);
                    return line && line.status !== 'ok' ? line.status : null;
                },
            };
        })],
    });
}
