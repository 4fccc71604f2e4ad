// Charts of the stress study: the error of all methods along one axis.


function stressTools() {
    return element('div', {class: 'tools'},
        choiceButtons('Scale of the error', [[false, 'Linear error'], [true, 'Logarithmic error']],
            state.get('stress.log'), log => state.set({'stress.log': log})),
        choiceButtons('Range of the error', [[false, 'Same range'], [true, 'Own range']],
            state.get('stress.own'), own => state.set({'stress.own': own})));
}

function stressX(axis, range) {
    const values = distinct(axis.lines, line => line.value).sort((a, b) => a - b);
    if (axis.names.length) return d3.scalePoint().domain(values).range(range).padding(0.3);
    const canLog = axis.isLog && values[0] > 0;
    return makeScale(values, range, {isLog: canLog});
}

function stressLines(axis) {
    return axis.curves.map(curve => methodLine(curve.info, curve.points.map(point => ({
        x: point.value, y: stressError(point),
        low: isNumber(point.f_hi) ? 1 - point.f_hi : null, high: isNumber(point.f_lo) ? 1 - point.f_lo : null,
        text: stressPointText(axis, curve, point),
    }))));
}

function stressPointText(axis, curve, point) {
    return [`${curve.name} at ${stressValue(axis, point.value)}`,
            `error ${formatShare(stressError(point))}` + (isNumber(point.f_lo)
                ? `, 95 % interval ${formatShare(1 - point.f_hi)} to ${formatShare(1 - point.f_lo)}` : ''),
            `${count(point.cases, 'scene')}, ${point.truth_px} true px`];
}

/// Error along one axis. `labels` writes names at the ends of lines.
function stressChart(parent, axis, {height, shared, intervals = false, labels = false}) {
    const lines = stressLines(axis);
    const isLog = state.get('stress.log');
    const most = Math.min(1, state.get('stress.own') || !shared ? stressMost(axis.curves) : shared);
    const foot = axis.names.length ? 106 : 46;
    const unit = axis.unit ? `, ${axis.unit === 'deg' ? 'degrees' : axis.unit}` : '';
    makeChart(parent, {
        id: `stress-${axis.name}${labels ? '-large' : ''}`, title: axis.name.replace(/_/g, ' '), least: 300,
        note: labels || axis.title === axis.name ? null : axis.title,
        height: height + foot - 46,
        draw: chart => {
            plotLines(chart, {
                lines, markers: labels, intervals, labels, foot_px: foot, x: range => stressX(axis, range),
                y: range => (isLog ? makeScale(lines.flatMap(l => l.points.map(p => p.y)), range, {isLog, least: 1e-4})
                    : d3.scaleLinear().domain([0, 1.03 * most]).range(range).clamp(true)),
                left: {title: `error 1 − F${isLog ? ', logarithmic' : ''}`, isLog},
                under: (area, x) => stressXAxis(area, axis, x,
                    `${axis.title}${unit}${axis.isLog ? ', logarithmic' : ''}`),
            });
        },
        csv: () => stressCsv(axis),
    });
}

/// The values of an axis whose labels have room beside each other.
function stressTicks(axis, x) {
    const ticks = [];
    for (const value of distinct(axis.lines, line => line.value).sort((a, b) => a - b)) {
        if (ticks.length === 0 || x(value) - x(ticks[ticks.length - 1]) >= 52) ticks.push(value);
    }
    return ticks;
}

function stressXAxis({plot, width, height}, axis, x, title) {
    if (!axis.names.length) {
        drawAxis(plot, x, {
            side: 'bottom', title: width < 420 ? '' : title, length: width, across: height, ticks: stressTicks(axis, x),
            format: value => stressValue({...axis, unit: axis.unit === 'deg' ? 'deg' : ''}, value),
        });
        return;
    }
    for (const value of x.domain()) {
        plot.append('line').attr('class', 'grid').attr('x1', x(value)).attr('x2', x(value)).attr('y1', 0)
            .attr('y2', height);
        const name = stressValue(axis, value);
        plot.append('text').attr('class', 'tick').attr('text-anchor', 'end')
            .text(name.length > 20 ? `${name.slice(0, 19)}…` : name)
            .attr('transform', `translate(${x(value) + 4},${height + 14}) rotate(-38)`);
    }
}

function stressCsv(axis) {
    const fields = ['axis', 'value', 'unit', 'method', 'cases', 'f', 'f_lo', 'f_hi', 'precision', 'recall', 'truth_px',
                    ...STRESS_FAULTS.map(fault => fault[0])];
    return [fields, ...axis.lines.map(line => fields.map(field => line[field]))];
}
