// Recall by class of line: which kinds of line a method misses.

state.define('classes.zero', false);

addSection({
    id: 'classes',
    title: 'Line classes',
    intro: view => `Share of the true pixels of each class that a method found within 2 px, with its ${view.run.interval}.`,
    isThere: view => view.contestants.some(s => RECALL_GROUPS.some(name => s.classes[name] !== null)),
    uses: ['classes.*', 'sort.classes'],
    draw(root, view) {
        const classes = RECALL_GROUPS.filter(name => view.summaries.some(s => s.classes[name] !== null));
        const methods = [...view.contestants].sort((a, b) => (b.recall ?? 0) - (a.recall ?? 0));
        const points = methods.flatMap(s => classes.map(name => ({
            method: s, name, value: s.classes[name], range: rangeOf(view.run, s, name, view.hasAllScenes),
        }))).filter(p => p.value !== null);
        noteSums(root, {...view, measure: null});
        makeChart(root, {
            id: 'classes', title: 'Recall by class of line',
            height: 46 + 22 * methods.length + 40,
            least: 150 + 110 * classes.length,
            controls: [toggleButton('axis from 0', state.get('classes.zero'), on => state.set({'classes.zero': on}))],
            draw: chart => drawClassChart(chart, methods, classes, points),
            csv: () => [['method', 'class', 'recall', 'low', 'high'], ...points.map(p => [
                p.method.method, p.name, p.value, p.range && p.range.low, p.range && p.range.high])],
        });
    },
});

/// A panel a class, side by side; methods from top to bottom.
function drawClassChart(chart, methods, classes, points) {
    const {plot, width, height} = plotArea(chart, {left: plotLabelWidth(methods.map(s => s.info)), right: 12, top: 30, bottom: 34});
    const gap = 22;
    const wide = (width - gap * (classes.length - 1)) / classes.length;
    const band = height / methods.length;
    drawNames(plot, methods.map(s => s.info), band);
    classes.forEach((name, index) => {
        const panel = plot.append('g').attr('transform', `translate(${index * (wide + gap)},0)`);
        const ofClass = points.filter(p => p.name === name);
        const least = state.get('classes.zero') ? 0 : Math.max(0, (d3.min(ofClass, p => (p.range ? p.range.low : p.value)) ?? 0) - 0.02);
        const x = d3.scaleLinear().domain([least, 1]).range([0, wide]);
        panel.append('text').attr('class', 'axis-title').attr('y', -12).style('fill', CLASS_COLOURS[name]).text(groupTitle(name));
        drawAxis(panel, x, {side: 'bottom', title: '', length: wide, across: height, format: v => Number(v.toFixed(3)),
                            ticks: x.ticks(Math.max(2, Math.floor(wide / 50)))});
        for (const point of ofClass) {
            const y = (methods.indexOf(point.method) + 0.5) * band;
            if (point.range) {
                panel.append('line').attr('class', 'interval').style('stroke', colourOf(point.method.info))
                    .attr('x1', x(Math.max(least, point.range.low))).attr('x2', x(point.range.high)).attr('y1', y).attr('y2', y);
            }
            const node = panel.append('g').attr('class', 'point').attr('transform', `translate(${x(point.value)},${y})`);
            node.append('circle').attr('r', 9).attr('class', 'catch');
            node.append('path').attr('d', markerOf(point.method.info)).attr('transform', 'scale(.8)').call(markerStyle, point.method.info);
            answerPointer(node, worstOfClass(point.method.rows, name), [
                `${point.method.method}, ${groupTitle(name)}: recall ${formatShare(point.value)}` + (point.range ? ` (${formatRange(point.range)})` : '')]);
        }
    });
}

/// The rows that have lines of a class.
function worstOfClass(rows, name) {
    return rows.filter(row => row[`truth_px_${name}`] > 0);
}
