// Charts and the table of thresholds and tolerances.

function thresholdChart(root, methods) {
    const kind = state.get('thresholds.chart');
    const shown = methods.filter(method => method.curve && !['none', 'oracle'].includes(method.name));
    root.append(element('div', {class: 'tools'}, choiceButtons('Chart', [['precision', 'Precision over recall'],
        ['f', 'F over threshold']],
        kind, chart => state.set({'thresholds.chart': chart}))), methodLegend(root, shown.map(method => method.info)));
    const isPrecision = kind === 'precision';
    const lines = shown.map(method => thresholdLine(method, isPrecision));
    makeChart(root, {
        id: `thresholds-${kind}`, title: isPrecision ? 'Precision over recall' : 'F over threshold',
            height: linesHeight(440, lines),
        note: isPrecision ? 'One point per threshold. Rings: where the method is scored. Grey curves join places ' +
            'of equal F.'
            : 'Rings: where the method is scored.',
        draw: chart => {
            const points = lines.flatMap(line => line.points);
            plotLines(chart, {
                lines, markers: false, labels: !isPrecision,
                x: range => (isPrecision ? shareScale(points.map(p => p.x), range) : d3.scaleLinear().domain([0, 255])
                    .range(range)),
                y: range => shareScale(points.map(p => p.y), range),
                bottom: {title: isPrecision ? 'recall' : 'threshold of the edge response'},
                left: {title: isPrecision ? 'precision' : 'F at 2 px'},
                under: (area, x, y) => { if (isPrecision) equalF(area, x, y); },
                over: (area, x, y) => { for (const method of shown) ownThreshold(area.plot, method, isPrecision, x,
                    y); },
            });
        },
        csv: () => [['method', 'threshold', 'recall', 'precision', 'f'],
            ...shown.flatMap(method => curvePoints(method.curve).map(
            point => [method.name, responseAt(point.at), point.recall, point.precision, point.f]))],
    });
}

function thresholdLine(method, isPrecision) {
    return methodLine(method.info, curvePoints(method.curve).map(point => ({
        x: isPrecision ? point.recall : responseAt(point.at), y: isPrecision ? point.precision : point.f,
            rows: method.lines,
        text: [`${method.name} at threshold ${responseAt(point.at)}`,
               `precision ${formatShare(point.precision)}, recall ${formatShare(point.recall)}, F ` +
               `${formatShare(point.f)}`],
    })));
}

/// An axis of shares that begins where the values do, at a round number, and ends at 1.
function shareScale(values, range) {
    const low = d3.min(values.filter(isNumber)) ?? 0;
    return d3.scaleLinear().domain([Math.max(0, Math.floor(low * 20) / 20), 1.005]).range(range).clamp(true);
}

/// Curves of equal F on a plot of precision over recall.
function equalF({plot, width, height}, x, y) {
    for (const f of [0.5, 0.6, 0.7, 0.8, 0.9, 0.95]) {
        const points = d3.range(f / (2 - f), 1.0005, 0.005).map(recall => [recall, (f * recall) / (2 * recall - f)])
            .filter(([recall, precision]) => precision <= 1 && recall >= x.domain()[0] && precision >= y.domain()[0]);
        if (points.length < 2) continue;
        plot.append('path').attr('d', pathThrough(points, p => x(p[0]), p => y(p[1]))).style('fill', 'none')
            .style('stroke', 'var(--rule)')
            .style('stroke-dasharray', '2 4');
        const last = points[points.length - 1];
        plot.append('text').attr('class', 'tick').attr('x', Math.min(width, x(last[0])) - 4)
            .attr('y', Math.min(height, y(last[1])) - 4)
            .attr('text-anchor', 'end').text(`F ${f}`);
    }
}

/// A ring where the method is scored; the pointer shows its images.
function ownThreshold(plot, method, isPrecision, x, y) {
    const {k, predicted, truth} = method.at;
    if (predicted === 0 || truth === 0 ||
        (!isPrecision && !(method.own.length === 1 && isNumber(method.own[0])))) return;
    const ring = plot.append('circle').attr('r', 5.5).style('fill', 'var(--paper)').style('fill-opacity', 0.6)
        .style('stroke', colourOf(method.info))
        .style('stroke-width', 2)
        .attr('cx', x(isPrecision ? k / truth : method.own[0]))
            .attr('cy', y(isPrecision ? k / predicted : fOf(k, predicted, truth)));
    answerPointer(ring, method.lines,
        [`scored at threshold ${method.own.join(', ')}: precision ${formatShare(k / predicted)}, recall ` +
            `${formatShare(k / truth)}`]);
}

function toleranceChart(root, methods) {
    const isLog = state.get('tolerances.log');
    const shown = methods.filter(method => method.tolerances.size && !['none', 'oracle'].includes(method.name));
    root.append(element('div', {class: 'tools'},
        choiceButtons('Scale', [[false, 'F, linear'], [true, 'Error 1 − F, logarithmic']],
        isLog, log => state.set({'tolerances.log': log})), methodLegend(root, shown.map(method => method.info))));
    const lines = shown.map(method => methodLine(method.info, [...method.tolerances].map(([tolerance, f]) => ({
        x: tolerance, y: isLog ? 1 - f : f, rows: method.lines,
            text: [method.name, `F ${formatShare(f)} within ${tolerance} px`],
    }))));
    makeChart(root, {
        id: 'tolerances', title: isLog ? 'Error over tolerance' : 'F over tolerance', height: linesHeight(380, lines),
        note: 'A steep line means that the method’s lines lie beside the true ones.',
        draw: chart => {
            const points = lines.flatMap(line => line.points);
            const values = points.map(p => p.y);
            plotLines(chart, {
                lines, labels: false, x: range => makeScale(points.map(p => p.x), range),
                y: range => (isLog ? makeScale(values, range, {isLog, least: 1e-4}) : shareScale(values, range)),
                bottom: {title: 'tolerance of a match, px', ticks: distinct(points, p => p.x), format: String},
                left: {isLog, title: isLog ? 'error 1 − F, logarithmic' : 'F'},
            });
        },
        csv: () => [['method', 'tolerance_px', 'f'],
            ...shown.flatMap(method => [...method.tolerances].map(([t, f]) => [method.name, t, f]))],
    });
}

function thresholdTable(root, methods) {
    const tolerances = [...new Set(methods.flatMap(method => [...method.tolerances.keys()]))].sort((a, b) => a - b);
    const rows = method => (method.isBaseline ? null : method.lines);
    const hasCurves = methods.some(method => method.curve);
    makeTable(root, {
        name: 'thresholds', lines: methods, lineClass: baselineClass, order: hasCurves ? 'ods.down' : '',
        columns: [
            methodColumn(line => line.info, {rows}),
            shareColumn('random', 'random', m => m.random,
                {best: null, help: 'F of a random image with as many drawn pixels'}),
            {key: 'threshold', title: 'threshold', value: m => m.own[0],
                text: m => m.own.filter(isNumber).join(', ') || NOTHING},
            ...(hasCurves ? [
                {key: 'best', title: 'best', value: m => m.best, text: m => m.best ?? NOTHING,
                    help: 'The threshold with the highest F over these views'},
                shareColumn('ods', 'ODS', m => m.ods), shareColumn('ois', 'OIS', m => m.ois),
                    shareColumn('ap', 'AP', m => m.ap)] : []),
            ...tolerances.map(tolerance => shareColumn(`f_${String(tolerance).replace('.', '_')}px`, `${tolerance} px`,
                m => m.tolerances.get(tolerance) ?? null, {group: 'F by tolerance'})),
        ],
    });
}
