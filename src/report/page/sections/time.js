// Error against time, or against bytes: a point per method, its settings around it, and the front of
// those that nothing beats in both.

state.define('time.x', 'ms');
state.define('time.xlog', true);
state.define('time.ylog', true);
state.define('time.y', 'error');
state.define('time.settings', false);

addSection({
    id: 'time',
    isMain: true,
    title: 'Error against time',
    intro: null,
    isThere: view => view.contestants.some(s => s.ms !== null),
    uses: ['time.*'],
    draw(root, view) {
        const isBytes = state.get('time.x') === 'bytes';
        const hasSettings = !isBytes && SWEPT_MEASURES.includes(view.measure) && isSwept(view);
        const isError = state.get('time.y') === 'error';
        const measure = MEASURES[view.measure];
        const settings = hasSettings && state.get('time.settings') ? settingsOf(view) : [];
        const lines = [...timeLines(view.contestants), ...settings];
        makeChart(root, {
            id: 'error-time',
            title: `${isError ? measure.error : measure.title} against ${isBytes ? 'bytes a pixel' : 'time of a frame'}`,
            isNamed: false,
            height: width => Math.max(360, Math.min(430, width * 0.52)),
            controls: [
                choiceButtons('Horizontal axis', [['ms', 'Time'], ['bytes', 'Bytes']], state.get('time.x'), x => state.set({'time.x': x})),
                choiceButtons('Vertical axis', [['error', 'Error'], ['score', 'Score']], state.get('time.y'), y => state.set({'time.y': y})),
                isBytes ? null : toggleButton('log x', state.get('time.xlog'), on => state.set({'time.xlog': on})),
                isError ? toggleButton('log y', state.get('time.ylog'), on => state.set({'time.ylog': on})) : null,
                hasSettings ? toggleButton('settings', state.get('time.settings'), on => state.set({'time.settings': on})) : null,
            ].filter(Boolean),
            draw: chart => drawTimeChart(chart, view, lines, {isBytes, isError}),
            csv: () => [['method', 'setting', 'draw_ms', 'draw_ms_q25', 'draw_ms_q75', 'bytes_per_px', view.measure, 'low', 'high'],
                ...lines.map(l => [l.method, l.setting, l.ms, l.msRange && l.msRange.low, l.msRange && l.msRange.high,
                                   l.bytes, l.value, l.range && l.range.low, l.range && l.range.high])],
        });
        noteSums(root, view);
        root.append(element('p', {class: 'note'}, ['Lower left is better. The grey stair is the lowest error to be had at each time. ' +
            `Point at a method to see its worst image, the ${view.run.interval} of its error and the quartiles of its time over views; those of ` +
            'the stair are always there. A click keeps the image and blinks the truth over it.',
        settings.length ? 'Small points: other settings of a method, over the views of the sweep.' : '',
        ownClockNote(view)].filter(Boolean).join(' ')));
    },
});

/// Names the methods from outside, whose times are not measured by this program; '' for none.
function ownClockNote(view) {
    const names = view.contestants.filter(s => s.info.hasOwnClock).map(s => s.info.name);
    return names.length ? `Times by their own clock: ${names.join(', ')}.` : '';
}

function timeLines(summaries) {
    return summaries.map(s => ({...s, setting: '', isSetting: false}));
}

/// Sweeps are scored within 2 px alone, all classes together.
const SWEPT_MEASURES = ['f_2px', 'precision', 'recall'];

/// One line per setting that a sweep tried, its views pooled.
function settingsOf(view) {
    const lines = sweptLines(view);
    const swept = sweptParams(view.run);
    return [...groupBy(lines, line => `${line.method}\n${settingKey(view.run, line)}`).values()].map(rows => {
        const info = view.run.methods.get(rows[0].method);
        const made = summarise(info, rows, view.measure);
        return {...made, rows: [], range: null, msRange: null, isSetting: true,
                setting: changedParams(info, swept, rows[0])};
    }).filter(line => line.value !== null && line.ms !== null);
}

function drawTimeChart(chart, view, lines, {isBytes, isError}) {
    const area = plotArea(chart, {left: 52, right: 24, top: 28, bottom: 46});
    const {plot, width, height} = area;
    const xOf = line => (isBytes ? line.bytes : line.ms);
    const errorOf = line => (isError ? 1 - line.value : line.value);
    const shown = lines.filter(line => isNumber(xOf(line)) && isNumber(errorOf(line)));
    const isXLog = !isBytes && state.get('time.xlog');
    const isYLog = isError && state.get('time.ylog');
    // No error at all stands where the axis begins: a logarithmic one has no 0.
    const smallest = isYLog ? Math.max(1e-4, (d3.min(shown.filter(l => errorOf(l) > 0), errorOf) || 1e-3) / 1.5) : null;
    const yOf = line => (isYLog ? Math.max(errorOf(line), smallest) : errorOf(line));
    const bars = shown.filter(line => line.range).flatMap(line => [line.range.low, line.range.high].map(v => (isError ? 1 - v : v)));
    const times = isBytes ? [] : shown.filter(line => line.msRange).flatMap(line => [line.msRange.low, line.msRange.high]);
    const x = makeScale([...shown.map(xOf), ...times], [0, width], {isLog: isXLog, includesZero: !isXLog});
    const y = makeScale([...shown.map(yOf), ...bars], [height, 0], {isLog: isYLog, least: smallest});
    const py = line => y(yOf(line));
    const px = line => x(xOf(line));
    drawAxis(plot, x, {side: 'bottom', title: isBytes ? 'bytes a pixel, all buffers' : 'time of a frame, ms', isLog: isXLog, length: width, across: height});
    drawAxis(plot, y, {side: 'left', title: isError ? MEASURES[view.measure].error : MEASURES[view.measure].title, isLog: isYLog, length: height, across: width});
    drawFront(plot, shown, {px, py, xOf, error: line => 1 - line.value, width, x});
    const budget = state.get('budget');
    if (budget && !isBytes) {
        plot.append('line').attr('class', 'budget').attr('x1', x(budget)).attr('x2', x(budget)).attr('y1', 0).attr('y2', height);
        plot.append('text').attr('class', 'tick').attr('x', x(budget) + 4).attr('y', 10).text(`budget ${formatMs(budget)} ms`);
    }
    for (const line of shown.filter(l => l.isSetting)) {
        const point = plot.append('path').attr('d', markerOf(line.info)).attr('class', 'setting')
            .attr('transform', `translate(${px(line)},${py(line)}) scale(.55)`).style('fill', colourOf(line.info));
        point.append('title').text(`${line.method}: ${line.setting || 'its own setting'}\n${MEASURES[view.measure].title} ${formatShare(line.value)}, ${formatMs(line.ms)} ms`);
    }
    const methods = shown.filter(l => !l.isSetting);
    const isAnswer = line => line.method === view.best?.method;
    const front = paretoFront(methods, xOf, line => 1 - line.value);
    const crosses = new Map(methods.map(line => [line, crossOf(line, {px, py, x, y, isBytes, isError, smallest, height})]));
    const layer = plot.append('g');
    for (const line of methods) {
        const cross = layer.append('g').attr('class', `cross${front.includes(line) ? ' kept' : ''}`).style('stroke', colourOf(line.info));
        for (const [x1, y1, x2, y2] of crosses.get(line))
            cross.append('line').attr('class', 'interval').attr('x1', x1).attr('y1', y1).attr('x2', x2).attr('y2', y2);
        const node = plot.append('g').attr('class', 'point').attr('data-method', line.method)
            .attr('transform', `translate(${px(line)},${py(line)})`);
        node.append('circle').attr('r', 11).attr('class', 'catch');
        node.append('path').attr('d', markerOf(line.info)).call(markerStyle, line.info);
        if (isAnswer(line)) node.append('circle').attr('r', 10).attr('class', 'answer');
        if (!view.isAffordable(line)) node.attr('opacity', 0.35);
        for (const [event, isOn] of [['pointerenter', true], ['focus', true], ['pointerleave', false], ['blur', false]])
            node.on(event, () => cross.classed('pointed', isOn));
        answerPointer(node, line.rows, [
            `${line.method}: ${MEASURES[view.measure].title} ${formatShare(line.value)}` +
            (line.range ? ` (${formatRange(line.range)})` : '') +
            (line.ms ? `, ${formatMs(line.ms)} ms` : '') + (line.bytes ? `, ${line.bytes} B/px` : '')]);
    }
    placeLabels(plot, methods.map(line => ({x: px(line), y: py(line), colour: colourOf(line.info),
        text: isAnswer(line) ? `${line.method}, the answer` : line.method, isFirst: front.includes(line) || isAnswer(line)})), width, height, front.flatMap(line => crosses.get(line)));
}

/// The bars of a method, of its error and of its time: [x1, y1, x2, y2] each.
function crossOf(line, {px, py, x, y, isBytes, isError, smallest, height}) {
    const bars = [];
    if (line.range) {
        const ends = [line.range.low, line.range.high].map(v => (isError ? 1 - v : v)).map(v => (smallest ? Math.max(v, smallest) : v));
        const [y1, y2] = ends.map(end => Math.max(0, Math.min(height, y(end))));
        bars.push([px(line), y1, px(line), y2]);
    }
    if (line.msRange && !isBytes) bars.push([x(line.msRange.low), py(line), x(line.msRange.high), py(line)]);
    return bars;
}

/// The stair of what nothing beats in both, over methods and their settings.
function drawFront(plot, shown, {px, py, xOf, error, width}) {
    const front = paretoFront(shown, xOf, error);
    if (front.length === 0) return;
    let path = `M${px(front[0])},${py(front[0])}`;
    for (let i = 1; i < front.length; ++i) path += `H${px(front[i])}V${py(front[i])}`;
    plot.append('path').attr('class', 'front').attr('d', `${path}H${width}`);
}
