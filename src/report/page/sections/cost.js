// Cost: what each method declares of a frame's work, and the time that this work should take.

state.define('cost.log', true);

addSection({
    id: 'cost',
    title: 'Cost',
    intro: 'What each method declares of a frame, by its settings, beside the time it took. Bytes are read, ' +
        'written and cleared ones. Medians over views.',
    isThere: view => costLines(view).length > 0,
    uses: ['cost.*', 'sort.cost*'],
    draw(root, view) {
        const methods = costMethods(view);
        const isPredicted = methods.some(method => method.predictedMs !== null);
        if (isPredicted) costChart(root, methods);
        costTable(root, methods);
        costPrices(root, view, isPredicted);
    },
});

/// Lines of cost.csv that declare something, with the fields of their cells and what is predicted of them.
function costLines(view) {
    const predicted = new Map(view.run.table('predictions.csv').lines.filter(line => line.setting === null)
        .map(line => [line.cell, line]));
    return view.lines('cost.csv').filter(line => line.passes > 0 && line.study === 'compare')
        .map(line => Object.assign(Object.create(line), predicted.get(line.cell)));
}

function costMethods(view) {
    return byMethod(view.run, costLines(view)).map(group => {
        const first = group.lines[0];
        const residuals = ascending(group.lines.map(line => line.cost_residual ?? null));
        const ms = field => medianOf(group.lines.map(line => (isNumber(line[field]) ? line[field] * 1e-6 : null)));
        const spread = field => {
            const sorted = ascending(group.lines.map(line => (isNumber(line[field]) ? line[field] * 1e-6 : null)));
            return [quantile(sorted, 0.25), quantile(sorted, 0.75)];
        };
        return {
            ...group, declared: first,
            fillBytes: first.fill_bytes_read + first.fill_bytes_written,
            frameBytes: first.buffer_bytes_per_px + first.filter_bytes_read + first.filter_bytes_written,
            measuredMs: ms('draw_ns_min'), predictedMs: ms('predicted_ns'),
            measuredRange: spread('draw_ns_min'), predictedRange: spread('predicted_ns'),
            residual: quantile(residuals, 0.5), low: quantile(residuals, 0.25), high: quantile(residuals, 0.75),
        };
    });
}

function costChart(root, methods) {
    const shown = methods.filter(method => method.predictedMs !== null && method.measuredMs !== null);
    root.append(element('div', {class: 'tools'}, choiceButtons('Scales', [[true, 'Logarithmic'], [false, 'Linear']],
        state.get('cost.log'), log => state.set({'cost.log': log}))));
    const isLog = state.get('cost.log');
    makeChart(root, {
        id: 'cost', title: 'Measured against predicted time of a frame', height: 430,
        note: 'On the line, prediction and measurement agree. Above it, a method takes longer than its declared ' +
            'work explains. Bars: quartiles over views. The pointer shows a method’s images.',
        draw: chart => {
            const area = plotArea(chart, {top: 26, right: 20, bottom: 46, left: 56});
            const values = shown.flatMap(m => [m.measuredMs, m.predictedMs, ...m.measuredRange, ...m.predictedRange]);
            const options = {isLog, includesZero: !isLog};
            const x = makeScale(values, [0, area.width], options);
            const y = makeScale(values, [area.height, 0], options);
            const log = isLog ? ', logarithmic' : '';
            drawAxes(area, x, y, {bottom: {isLog, title: `predicted, ms${log}`, format: formatNumber},
                                  left: {isLog, title: `least time measured, ms${log}`, format: formatNumber}});
            const [low, high] = x.domain();
            area.plot.append('line').attr('class', 'zero').attr('x1', x(low)).attr('y1', y(low)).attr('x2', x(high))
                .attr('y2', y(high));
            for (const method of shown) costPoint(area.plot, method, x, y);
            placeLabels(area.plot, shown.map(m => ({x: x(m.predictedMs), y: y(m.measuredMs), text: m.name,
                colour: colourOf(m.info)})),
                        area.width, area.height);
        },
        csv: () => [['method', 'measured_ms', 'predicted_ms', 'residual'], ...shown.map(
            m => [m.name, m.measuredMs, m.predictedMs, m.residual])],
    });
}

function costPoint(plot, method, x, y) {
    const group = plot.append('g').attr('class', 'point');
    const [px, py] = [x(method.predictedMs), y(method.measuredMs)];
    const bar = (x1, y1, x2, y2) => group.append('line').attr('class', 'interval').attr('x1', x1).attr('y1', y1)
        .attr('x2', x2).attr('y2', y2)
        .style('stroke', colourOf(method.info)).style('opacity', 0.35);
    bar(x(method.predictedRange[0]), py, x(method.predictedRange[1]), py);
    bar(px, y(method.measuredRange[0]), px, y(method.measuredRange[1]));
    group.append('circle').attr('class', 'catch').attr('cx', px).attr('cy', py).attr('r', 12)
        .style('fill', 'transparent');
    group.append('path').attr('d', markerOf(method.info)).attr('transform', `translate(${px},${py})`)
        .call(markerStyle, method.info);
    answerPointer(group, method.lines,
        [`measured ${formatMs(method.measuredMs)} ms, predicted ${formatMs(method.predictedMs)} ms`,
                                        `residual ${costPercent(method.residual)}`]);
}

/// "+12.3 %", without a sign at 0.
function costPercent(share) {
    return isNumber(share) ? `${formatSigned(100 * share, 1)} %` : NOTHING;
}

function costTable(root, methods) {
    const declared = (key, title, field, more) => ({key, title, value: m => m.declared[field],
        text: m => formatTick(m.declared[field]), ...more});
    makeTable(root, {
        name: 'cost', lines: methods, lineClass: baselineClass,
        columns: [
            infoColumn(),
            declared('passes', 'passes', 'passes', {group: 'geometry', text: m => String(m.declared.passes),
                help: 'Times the triangles are drawn'}),
            declared('values_per_vertex', 'values a vertex', 'values_per_vertex',
                {group: 'geometry', text: m => String(m.declared.values_per_vertex),
                help: 'Numbers computed at a vertex to be interpolated'}),
            declared('interpolants', 'interpolants a triangle', 'interpolants',
                {group: 'geometry', text: m => String(m.declared.interpolants),
                help: 'Planes set up per triangle, beside that of the depth'}),
            {key: 'fill_bytes', title: 'bytes', group: 'per covered pixel', value: m => m.fillBytes,
                text: m => formatTick(m.fillBytes)},
            {key: 'frame_bytes', title: 'bytes', group: 'per pixel of the image', value: m => m.frameBytes,
                text: m => formatTick(m.frameBytes)},
            {key: 'measured', title: 'measured', group: 'least draw ms', value: m => m.measuredMs,
                text: m => formatMs(m.measuredMs), best: 'low', rows: m => m.lines},
            {key: 'predicted', title: 'predicted', group: 'least draw ms', value: m => m.predictedMs,
                text: m => formatMs(m.predictedMs)},
            {key: 'residual', title: 'median', group: 'residual', value: m => m.residual,
                text: m => costPercent(m.residual),
             help: 'Least measured time over the predicted one, less 1'},
            {key: 'quartiles', title: 'quartiles', group: 'residual', value: m => m.low,
                text: m => (m.low === null ? NOTHING : `${costPercent(m.low)} to ${costPercent(m.high)}`)},
        ],
    });
}

/// What one unit of each kind of work costs.
function costPrices(root, view, isPredicted) {
    const lines = view.run.table('cost_fit.csv').lines;
    if (lines.length === 0) {
        if (!isPredicted) {
            root.append(element('p', {class: 'note'},
                'Too few cells to fit the prices and to leave any out: nothing is predicted.'));
        }
        return;
    }
    const {cells, left_out: leftOut} = lines[0];
    root.append(element('h3', {}, 'What a unit of work costs'), element('p', {class: 'soft'},
        `One price per kind of work, the same for all methods, fitted to ${cells} cells of this run, sweeps ` +
        'included: least squares of the relative error, no price below 0. Each row is predicted from a fit that ' +
        `left out all cells of its ${leftOut}, so the residual is ` +
        'out of sample. A price of 0 means that the other prices explain these times as well, not that the work ' +
        'is free.'));
    makeTable(root, {
        name: 'cost-prices', lines,
        columns: [
            {key: 'unit', title: 'one', isText: true, value: line => line.unit},
            {key: 'ns_per_unit', title: 'ns', value: line => line.ns_per_unit,
                text: line => (isNumber(line.ns_per_unit) ? String(Number(line.ns_per_unit.toPrecision(3))) : NOTHING)},
            {key: 'doc', title: 'is', isText: true, value: line => line.doc},
        ],
    });
}
