// Scaling: how a frame's time grows with triangles, with pixels, and with what is covered.

state.define('scaling.log', true);

const SCALING_AXES = {
    triangles: {noun: 'triangles', title: 'triangles of the sphere'},
    pixels: {noun: 'pixels', title: 'pixels of the image'},
    covered: {noun: 'of the image', title: 'share of the image that is covered'},
};

addSection({
    id: 'scaling',
    title: 'Scaling',
    intro: 'The least time of a frame of a sphere, drawn with more and more triangles, pixels or covered area. An ' +
        'exponent of 1 is linear: twice the work takes twice the time.',
    isThere: view => view.run.has('scaling.csv'),
    uses: ['scaling.*', 'sort.scaling*'],
    isFolded: true,
    draw(root, view) {
        const lines = view.run.joined('scaling.csv').filter(line => view.isMethodShown(line.method));
        const timed = lines.filter(line => line.status === 'ok' && line.draw_ns_min > 0);
        if (timed.length === 0) {
            root.append(element('p', {class: 'note'}, 'No method was timed here.'));
            return;
        }
        const steps = scalingSteps(view, timed);
        root.append(element('p', {class: 'verdict-line'}, scalingSentence(steps)),
            element('p', {class: 'note'},
                'Least times repeat within 10 %, or as well as those of three rounds did where that is worse. A ' +
                'step is worse than linear (bold) if its exponent exceeds 1 by more than this noise can explain.'),
            element('div', {class: 'tools'}, choiceButtons('Scales', [[true, 'Logarithmic'], [false, 'Linear']],
                state.get('scaling.log'), log => state.set({'scaling.log': log}))),
            methodLegend(root, byMethod(view.run, timed).map(group => group.info)));
        for (const [axis, ofAxis] of groupBy(timed, line => line.axis)) {
            scalingChart(root, view, axis, ofAxis);
            scalingExponents(root, view, axis, steps.filter(step => step.axis === axis));
        }
        scalingFailed(root, lines);
    },
});

/// A place on an axis as people read it.
function scalingX(axis, x) {
    if (axis === 'covered') return `${Number((100 * x).toPrecision(3))} %`;
    if (x >= 999500) return `${Number((x / 1e6).toPrecision(3))} M`;
    if (x >= 9995) return `${Number((x / 1e3).toPrecision(3))} k`;
    return x.toFixed(0);
}

function scalingTime(ns) {
    if (ns < 999500) return `${Number((ns / 1e3).toPrecision(3))} µs`;
    if (ns < 999500000) return `${Number((ns / 1e6).toPrecision(3))} ms`;
    return `${Number((ns / 1e9).toPrecision(3))} s`;
}

/// What stays the same along an axis.
function scalingKept(axis, line) {
    const size = `${line.width} × ${line.height} px`;
    const triangles = `${scalingX('triangles', line.triangles)} triangles`;
    if (axis === 'triangles') return `A sphere that covers ${formatPercent(line.covered_share, 0)} of ${size}.`;
    if (axis === 'pixels') return `A sphere of ${triangles} that covers ${formatPercent(line.covered_share, 0)} of ` +
        'the image.';
    return `A sphere of ${triangles} at ${size}, from so far that it is a speck to so near that it fills the image.`;
}

/// Steps between neighbouring points of a method on an axis: {axis, method, from, to, exponent,
/// tolerance}; the tolerance is what noise alone can add to the exponent.
function scalingSteps(view, timed) {
    const steps = [];
    for (const [axis, ofAxis] of groupBy(timed, line => line.axis)) {
        for (const method of byMethod(view.run, ofAxis)) {
            const points = sortLines(method.lines, {value: line => line.x});
            points.slice(1).forEach((to, i) => {
                const from = points[i];
                if (!(to.x > from.x)) return;
                const growth = Math.log(to.x / from.x);
                steps.push({
                    axis, method: method.name, info: method.info, from: from.x, to: to.x,
                    exponent: Math.log(to.draw_ns_min / from.draw_ns_min) / growth,
                    tolerance: Math.log((1 + (from.noise || 0)) * (1 + (to.noise || 0))) / growth,
                });
            });
        }
    }
    return steps;
}

function isWorseThanLinear(step) {
    return step.exponent > 1 + step.tolerance;
}

function scalingSentence(steps) {
    if (steps.length === 0) return 'Each method was timed at one place only.';
    const steepest = [...steps].sort((a, b) => (b.exponent - b.tolerance) - (a.exponent - a.tolerance));
    const worse = steps.filter(isWorseThanLinear).length;
    const words = step => `${step.method} from ${scalingX(step.axis, step.from)} to ` +
        `${scalingX(step.axis, step.to)} ${(SCALING_AXES[step.axis] || {noun: ''}).noun}, exponent ` +
        `${step.exponent.toFixed(2)} (noise alone can make ${(1 + step.tolerance).toFixed(2)})`;
    if (worse === 0) return `No step is worse than linear. The steepest: ${words(steepest[0])}.`;
    return `Worse than linear in ${worse} of ${steps.length} steps. The steepest: ` +
        `${steepest.slice(0, Math.min(3, worse)).map(words).join('; ')}.`;
}

function scalingChart(root, view, axis, timed) {
    const isLog = state.get('scaling.log');
    const lines = byMethod(view.run, timed).map(method => methodLine(method.info,
        sortLines(method.lines, {value: line => line.x}).map(line => ({
            x: line.x, y: line.draw_ns_min,
            text: [`${method.name}: ${scalingTime(line.draw_ns_min)}`,
                `${scalingX(axis, line.x)} ${(SCALING_AXES[axis] || {noun: ''}).noun}`,
                   `repeats within ${formatPercent(line.noise, 0)}`],
        }))));
    makeChart(root, {
        id: `scaling-${axis}`, title: `Frame time over ${(SCALING_AXES[axis] || {title: axis}).title}`,
            height: linesHeight(400, lines),
        note: scalingKept(axis, timed[0]),
        draw: chart => {
            const points = lines.flatMap(line => line.points);
            const [options, log] = [{isLog, includesZero: !isLog}, isLog ? ', logarithmic' : ''];
            plotLines(chart, {
                lines, room_px: 62,
                x: range => makeScale(points.map(p => p.x), range, options),
                y: range => makeScale(points.map(p => p.y), range, options),
                bottom: {isLog, title: (SCALING_AXES[axis] || {title: axis}).title + log, format: x => scalingX(axis,
                    x)},
                left: {isLog, title: `least time of a frame${log}`, format: scalingTime},
                under: (area, x, y) => { if (isLog) scalingGuide(area, x, y); },
            });
        },
        csv: () => [['axis', 'method', 'x', 'draw_ns_min', 'noise'], ...timed.map(
            line => [axis, line.method, line.x, line.draw_ns_min, line.noise])],
    });
}

/// A dashed line of slope 1 through the middle of a logarithmic plot.
function scalingGuide({plot, width, height}, x, y) {
    const [lx, ly] = [x, y].map(scale => scale.domain().map(Math.log10));
    const reach = Math.min(lx[1] - lx[0], ly[1] - ly[0]) / 2;
    const [mx, my] = [(lx[0] + lx[1]) / 2, (ly[0] + ly[1]) / 2];
    const [x1, y1, x2, y2] = [x(10 ** (mx - reach)), y(10 ** (my - reach)), x(10 ** (mx + reach)),
        y(10 ** (my + reach))];
    plot.append('line').attr('x1', x1).attr('y1', y1).attr('x2', x2).attr('y2', y2)
        .style('stroke', 'var(--rule)').style('stroke-width', 1.4).style('stroke-dasharray', '6 5');
    const isFlat = x2 > width - 60;
    plot.append('text').attr('class', 'tick').attr('x', isFlat ? x2 - 4 : x2 + 8)
        .attr('y', isFlat ? y2 + 26 : Math.min(height - 4, y2 + 14))
        .attr('text-anchor', isFlat ? 'end' : 'start').text('linear');
}

function scalingExponents(root, view, axis, steps) {
    if (steps.length === 0) return;
    const stretches = [...groupBy(steps, step => `${step.from} ${step.to}`).values()].map(group => group[0])
        .sort((a, b) => a.from - b.from || a.to - b.to);
    const find = (group, stretch) => group.lines.find(step => step.from === stretch.from && step.to === stretch.to);
    makeTable(root, {
        name: `scaling-${axis}`, lines: byMethod(view.run, steps), lineClass: baselineClass,
        caption: 'Exponents: bold where a step is worse than linear.',
        columns: [infoColumn(), ...stretches.map((stretch, i) => ({
            key: `step_${i}`, title: `${scalingX(axis, stretch.from)} to ${scalingX(axis, stretch.to)}`,
            value: group => (find(group, stretch) ? find(group, stretch).exponent : null),
            node: group => {
                const step = find(group, stretch);
                if (!step) return NOTHING;
                const text = formatSigned(step.exponent, 2).replace('+', '');
                return isWorseThanLinear(step) ? element('strong', {}, text) : text;
            },
            hint: group => (find(group, stretch) ? `noise alone can add ${find(group, stretch).tolerance.toFixed(2)}`
                : null),
        }))],
    });
}

function scalingFailed(root, lines) {
    const failed = lines.filter(line => line.status !== 'ok');
    if (failed.length === 0) return;
    root.append(warningBox('Not everything was timed.', 'These have no time:',
        failed.map(line => `${line.method}, ${line.view}: ${line.status}`)));
}
