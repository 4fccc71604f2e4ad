// Charts of curves over an axis.

function axisTools(hasSoft) {
    return element('div', {class: 'tools'},
        choiceButtons('Scale of the error', [[false, 'Linear error'], [true, 'Logarithmic error']],
            state.get('axes.log'), log => state.set({'axes.log': log})),
        choiceButtons('Range of the error', [[false, 'Same range'], [true, 'Own range']],
            state.get('axes.own'), own => state.set({'axes.own': own})),
        hasSoft ? choiceButtons('Measure of the error', [[false, 'F at 2 px'], [true, 'Soft F']],
            state.get('axes.soft'), soft => state.set({'axes.soft': soft})) : null);
}

function axisPointText(axis, curve, {line, value, y, low, high}) {
    return [`${curve.name} at ${axisValue(axis, value)}`,
            `error ${formatShare(y)}` + (isNumber(high)
                ? `, interval ${formatShare(low)} to ${formatShare(high)}` : ''),
            `${count(line.cases, 'scene')}, ${line.truth_px} true px`];
}

/// Every curve along one axis. `labels` writes names at the ends of lines.
function axisChart(parent, axis, {height, shared, intervals = false, labels = false}) {
    const lines = axis.curves.map(curve => methodLine(curve.info, curve.points.map(point => ({
        x: point.value, y: point.y, low: point.low, high: point.high, text: axisPointText(axis, curve, point)}))));
    const [xs, ys] = ['x', 'y'].map(key => lines.flatMap(line => line.points.map(point => point[key])));
    const isLog = state.get('axes.log');
    const isLogX = axis.isLog && d3.min(xs) > 0;
    const most = Math.min(1, state.get('axes.own') || !shared ? axisMost(axis.curves) : shared);
    const foot = axis.names.length ? 106 : 46;
    const unit = axis.unit ? `, ${axis.unit === 'deg' ? 'degrees' : axis.unit}` : '';
    makeChart(parent, {
        id: `stress-${axis.name}${labels ? '-large' : ''}`, title: axis.name.replace(/_/g, ' '), least: 300,
        note: labels || axis.title === axis.name ? null : axis.title,
        height: height + foot - 46,
        draw: chart => plotLines(chart, {
            lines, markers: labels, intervals, labels, foot_px: foot, room_px: 52,
            x: range => (axis.names.length ? d3.scalePoint().domain(distinct(xs, x => x).sort((a, b) => a - b))
                .range(range).padding(0.3) : makeScale(xs, range, {isLog: isLogX})),
            y: range => (isLog ? makeScale(ys, range, {isLog, least: 1e-4})
                : d3.scaleLinear().domain([0, 1.03 * most]).range(range).clamp(true)),
            left: {title: `${axis.measure.title}${isLog ? ', logarithmic' : ''}`, isLog},
            under: (area, x) => axisBottom(area, axis, x, xs, `${axis.title}${unit}${isLogX ? ', logarithmic' : ''}`),
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

function axisCsv(axis) {
    const fields = ['axis', 'value', 'method', 'cases', 'f', 'f_lo', 'f_hi', 'truth_px',
        ...(axis.measure === AXIS_MEASURES.soft ? ['soft_f'] : []), ...AXIS_FAULTS.map(fault => fault[0])];
    return [fields, ...axis.lines.map(line => fields.map(field => line[field]))];
}
