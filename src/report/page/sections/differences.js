// Paired differences between methods: each against one that the reader picks.

state.define('against', '');

addSection({
    id: 'differences',
    title: 'Paired differences',
    intro: 'By how much a method is better (right) or worse (left) than the one it is held against, with its interval: ' +
        'scenes are drawn anew, both methods on the same ones. The thin line is the interval that is to hold together with those of ' +
        'all pairs. Solid: that one leaves out 0, so one leads.',
    isThere: view => view.contestants.length > 1,
    uses: ['against', 'sort.differences'],
    draw(root, view) {
        const names = view.contestants.map(s => s.method);
        const against = names.includes(state.get('against')) ? state.get('against') : (view.best || view.contestants[0]).method;
        const other = view.contestants.find(s => s.method === against);
        const others = view.contestants.filter(s => s !== other);
        const lines = others.map(s => ({
            method: s.method, info: s.info, rows: s.rows, difference: view.differenceOf(s.method, against),
        })).filter(line => line.difference).sort((a, b) => b.difference.value - a.difference.value);
        noteSums(root, view);
        makeChart(root, {
            id: 'differences', title: `${MEASURES[view.measure].title} less that of ${against}`,
            height: 24 + 22 * lines.length + 46,
            controls: [chooser('Against', names.map(n => [n, n]), against, name => state.set({against: name}))],
            draw: chart => drawDifferences(chart, lines, `difference in ${MEASURES[view.measure].title}`),
            csv: () => [['method', 'against', 'difference', 'low', 'high', 'low_of_all', 'high_of_all', 'scenes', 'better', 'worse'], ...lines.map(line => [
                line.method, against, line.difference.value, ...rangeCells(line.difference.range),
                ...rangeCells(line.difference.rangeOfAll), line.difference.scenes, line.difference.better, line.difference.worse])],
        });
    },
});

/// Both ends of an interval, or two empty cells.
function rangeCells(range) {
    return range ? [range.low, range.high] : [null, null];
}

/// Lines of {method, info, rows, difference} as points with intervals round 0.
function drawDifferences(chart, lines, title) {
    const {plot, width, height} = plotArea(chart, {left: plotLabelWidth(lines.map(line => line.info)), right: 90, top: 8, bottom: 46});
    const ends = lines.flatMap(({difference: d}) => [d.value, ...[d.range, d.rangeOfAll].filter(Boolean).flatMap(r => [r.low, r.high])]);
    const x = makeScale([0, ...ends], [0, width]);
    drawAxis(plot, x, {side: 'bottom', title, length: width, across: height, format: v => formatSigned(Number(v.toFixed(4)), 3)});
    plot.append('line').attr('class', 'zero').attr('x1', x(0)).attr('x2', x(0)).attr('y1', 0).attr('y2', height);
    const band = height / Math.max(1, lines.length);
    drawNames(plot, lines.map(line => line.info), band);
    lines.forEach((line, i) => {
        const y = (i + 0.5) * band;
        const {difference} = line;
        for (const [range, name] of [[difference.rangeOfAll, 'interval'], [difference.range, 'interval own']]) {
            if (!range) continue;
            plot.append('line').attr('class', name).style('stroke', colourOf(line.info))
                .attr('x1', x(range.low)).attr('x2', x(range.high)).attr('y1', y).attr('y2', y);
        }
        const node = plot.append('g').attr('class', 'point').attr('transform', `translate(${x(difference.value)},${y})`);
        node.append('circle').attr('r', 10).attr('class', 'catch');
        node.append('circle').attr('r', 5).style('stroke', colourOf(line.info)).style('stroke-width', 1.6)
            .style('fill', isLead(difference) ? colourOf(line.info) : 'var(--paper)');
        plot.append('text').attr('class', 'tick').attr('x', width + 8).attr('y', y + 4).text(formatSigned(difference.value, 4));
        answerPointer(node, line.rows, [`${formatSigned(difference.value, 4)}, interval ${formatSignedRange(difference.range, 4)}, ` +
            (difference.rangeOfAll ? `with all others together ${formatSignedRange(difference.rangeOfAll, 4)}, ` : '') + count(difference.scenes, 'scene')]);
    });
}
