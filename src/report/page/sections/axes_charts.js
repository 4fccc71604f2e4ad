// Charts of curves over an axis, and how steeply times grow along one.

function axisTools(hasSoft) {
    return element('div', {class: 'tools'},
        choiceButtons('Scale of the error', [[false, 'Linear error'], [true, 'Logarithmic error']],
            state.get('axes.log'), log => state.set({'axes.log': log})),
        choiceButtons('Range of the error', [[false, 'Same range'], [true, 'Own range']],
            state.get('axes.own'), own => state.set({'axes.own': own})),
        hasSoft ? choiceButtons('Measure of the error', [[false, 'F at 2 px'], [true, 'Soft F']],
            state.get('axes.soft'), soft => state.set({'axes.soft': soft})) : null);
}

function axisPointText(axis, curve, {line, value, y, low, high, noise}) {
    if (axis.measure === AXIS_MEASURES.time) return [`${curve.name}: ${axisTime(y)}`,
        `at ${axisValue(axis, value)}, ${line.width} × ${line.height} px, ${count(line.triangles, 'triangle')}`,
        `repeats within ${formatPercent(noise, 0)}`];
    return [`${curve.name} at ${axisValue(axis, value)}`,
            `error ${formatShare(y)}` + (isNumber(high)
                ? `, interval ${formatShare(low)} to ${formatShare(high)}` : ''),
            `${count(line.cases, 'scene')}, ${line.truth_px} true px`];
}

/// Every curve along one axis. `labels` writes names at the ends of lines.
function axisChart(parent, axis, {height, shared, intervals = false, labels = false}) {
    const isTime = axis.measure === AXIS_MEASURES.time;
    const lines = axis.curves.map(curve => methodLine(curve.info, curve.points.map(point => ({
        x: point.value, y: point.y, low: point.low, high: point.high, text: axisPointText(axis, curve, point)}))));
    const [xs, ys] = ['x', 'y'].map(key => lines.flatMap(line => line.points.map(point => point[key])));
    const isLog = isTime || state.get('axes.log');
    const isLogX = axis.isLog && d3.min(xs) > 0;
    const most = Math.min(1, state.get('axes.own') || !shared ? axisMost(axis.curves) : shared);
    const foot = axis.names.length ? 106 : 46;
    const unit = axis.unit ? `, ${axis.unit === 'deg' ? 'degrees' : axis.unit}` : '';
    makeChart(parent, {
        id: `${axis.measure.id}-${axis.name}${labels ? '-large' : ''}`, title: axis.name.replace(/_/g, ' '), least: 300,
        note: labels || axis.title === axis.name ? null : axis.title,
        height: height + foot - 46,
        draw: chart => plotLines(chart, {
            lines, markers: labels, intervals, labels, foot_px: foot, room_px: isTime ? 62 : 52,
            x: range => (axis.names.length ? d3.scalePoint().domain(distinct(xs, x => x).sort((a, b) => a - b))
                .range(range).padding(0.3) : makeScale(xs, range, {isLog: isLogX})),
            y: range => (isTime ? makeScale(ys, range, {isLog}) : isLog ? makeScale(ys, range, {isLog, least: 1e-4})
                : d3.scaleLinear().domain([0, 1.03 * most]).range(range).clamp(true)),
            left: {title: `${axis.measure.title}${isLog ? ', logarithmic' : ''}`, isLog,
                ...(isTime ? {format: axisTime} : {})},
            under: (area, x, y) => {
                axisBottom(area, axis, x, xs, `${axis.title}${unit}${isLogX ? ', logarithmic' : ''}`);
                if (isTime) axisGuide(area, x, y);
            },
        }),
        csv: () => axisCsv(axis),
    });
}

/// The values of an axis whose labels have room beside each other.
function axisTicks(xs, x) {
    const ticks = [];
    for (const value of distinct(xs, v => v).sort((a, b) => a - b)) {
        if (ticks.length === 0 || x(value) - x(ticks[ticks.length - 1]) >= 52) ticks.push(value);
    }
    return ticks;
}

function axisBottom({plot, width, height}, axis, x, xs, title) {
    if (!axis.names.length) {
        drawAxis(plot, x, {
            side: 'bottom', title: width < 420 ? '' : title, length: width, across: height, ticks: axisTicks(xs, x),
            format: value => axisValue({...axis, unit: axis.unit === 'deg' ? 'deg' : ''}, value),
        });
        return;
    }
    for (const value of x.domain()) {
        plot.append('line').attr('class', 'grid').attr('x1', x(value)).attr('x2', x(value)).attr('y1', 0)
            .attr('y2', height);
        const name = axisValue(axis, value);
        plot.append('text').attr('class', 'tick').attr('text-anchor', 'end')
            .text(name.length > 20 ? `${name.slice(0, 19)}…` : name)
            .attr('transform', `translate(${x(value) + 4},${height + 14}) rotate(-38)`);
    }
}

/// A dashed line of slope 1 through the middle of a logarithmic plot.
function axisGuide({plot, width, height}, x, y) {
    const [lx, ly] = [x, y].map(scale => scale.domain().map(Math.log10));
    const reach = Math.min(lx[1] - lx[0], ly[1] - ly[0]) / 2;
    const [mx, my] = [(lx[0] + lx[1]) / 2, (ly[0] + ly[1]) / 2];
    const [x1, y1, x2, y2] = [x(10 ** (mx - reach)), y(10 ** (my - reach)), x(10 ** (mx + reach)),
        y(10 ** (my + reach))];
    if (![x1, y1, x2, y2].every(isNumber)) return;
    plot.append('line').attr('x1', x1).attr('y1', y1).attr('x2', x2).attr('y2', y2)
        .style('stroke', 'var(--rule)').style('stroke-width', 1.4).style('stroke-dasharray', '6 5');
    const isFlat = x2 > width - 60;
    plot.append('text').attr('class', 'tick').attr('x', isFlat ? x2 - 4 : x2 + 8)
        .attr('y', isFlat ? y2 + 26 : Math.min(height - 4, y2 + 14))
        .attr('text-anchor', isFlat ? 'end' : 'start').text('linear');
}

function axisCsv(axis) {
    const fields = axis.measure === AXIS_MEASURES.time
        ? ['axis', 'value', 'method', 'width', 'height', 'triangles', 'draw_ns_min', 'draw_ns', 'draw_n']
        : ['axis', 'value', 'method', 'cases', 'f', 'f_lo', 'f_hi', 'precision', 'recall', 'truth_px',
            ...(axis.measure === AXIS_MEASURES.soft ? ['soft_f'] : []), ...AXIS_FAULTS.map(fault => fault[0])];
    return [fields, ...axis.lines.map(line => fields.map(field => line[field]))];
}

// ---- How steeply times grow ---------------------------------------------------------------

/// Steps between neighbouring points of a method: {method, info, from, to, exponent, tolerance}; the
/// tolerance is what noise alone can add to the exponent.
function axisSteps(axis) {
    return axis.curves.flatMap(({name, info, points}) => points.slice(1).flatMap((to, i) => {
        const from = points[i];
        if (!(to.value > from.value && from.y > 0 && to.y > 0)) return [];
        const growth = Math.log(to.value / from.value);
        return [{method: name, info, from: from.value, to: to.value, exponent: Math.log(to.y / from.y) / growth,
            tolerance: Math.log((1 + from.noise) * (1 + to.noise)) / growth}];
    }));
}

function isWorseThanLinear(step) {
    return step.exponent > 1 + step.tolerance;
}

function axisGrowth(axis, steps) {
    if (steps.length === 0) return 'Each method was timed at one place only.';
    const steepest = [...steps].sort((a, b) => (b.exponent - b.tolerance) - (a.exponent - a.tolerance));
    const worse = steps.filter(isWorseThanLinear).length;
    const words = step => `${step.method} from ${axisValue(axis, step.from)} to ${axisValue(axis, step.to)}, exponent ` +
        `${step.exponent.toFixed(2)} (noise alone can make ${(1 + step.tolerance).toFixed(2)})`;
    const noise = 'An exponent of 1 is linear: twice the work takes twice the time. Least times repeat within 10 %, ' +
        'or as well as their lower quartile lies above them where that is worse.';
    if (worse === 0) return `No step is worse than linear. The steepest: ${words(steepest[0])}. ${noise}`;
    return `Worse than linear in ${worse} of ${steps.length} steps. The steepest: ` +
        `${steepest.slice(0, Math.min(3, worse)).map(words).join('; ')}. ${noise}`;
}

function axisExponents(root, axis, steps) {
    const stretches = [...groupBy(steps, step => `${step.from} ${step.to}`).values()].map(group => group[0])
        .sort((a, b) => a.from - b.from || a.to - b.to);
    const find = (group, stretch) => group.lines.find(step => step.from === stretch.from && step.to === stretch.to);
    makeTable(root, {
        name: `axis-steps-${axis.name}`, lines: [...groupBy(steps, step => step.method)].map(
            ([name, lines]) => ({name, info: lines[0].info, lines})), lineClass: baselineClass,
        caption: 'Exponents: bold where a step is worse than linear by more than noise can explain.',
        columns: [infoColumn(), ...stretches.map((stretch, i) => ({
            key: `step_${i}`, title: `${axisValue(axis, stretch.from)} to ${axisValue(axis, stretch.to)}`,
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
